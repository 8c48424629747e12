// Worker: the engine as a WebAssembly module.
//
// In: first the compiled module, then messages { file, request }, where `file` are the bytes of a file or null. Out:
// { answer, memory } with the bytes of the module's memory, or { stopped } with a reason if the module stopped; then the
// next message finds a new instance.

"use strict";

let compiled = null;
let engine = null;

// Copies bytes into the module.
function put(own, bytes) {
  const at = own.allocate(bytes.length);
  new Uint8Array(own.memory.buffer, at, bytes.length).set(bytes);
}

self.addEventListener("message", ({ data }) => {
  if (data instanceof WebAssembly.Module) {
    compiled = data;
    return;
  }
  const { file, request } = data;
  try {
    engine ??= new WebAssembly.Instance(compiled).exports;
    const own = engine;
    if (file) {
      put(own, file);
      own.take();
    }
    put(own, new TextEncoder().encode(JSON.stringify(request)));
    const length = own.answer();
    const answer = new TextDecoder().decode(new Uint8Array(own.memory.buffer, own.text(), length));
    self.postMessage({ answer: JSON.parse(answer), memory: own.memory.buffer.byteLength });
  } catch (reason) {
    engine = null;
    self.postMessage({ stopped: String(reason) });
  }
});
