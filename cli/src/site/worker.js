// Worker: the engine as a WebAssembly module.
//
// In: messages { id, file, request }, where `file` are the bytes of a file or null. Out: { id, answer }, or { id, stopped }
// with a reason if the module stopped; then the next message finds a new one.

"use strict";

let compiled = null;
let engine = null;

async function running() {
  compiled ??= await WebAssembly.compileStreaming(fetch("homogen.wasm"));
  engine ??= (await WebAssembly.instantiate(compiled)).exports;
  return engine;
}

// Copies bytes into the module.
function put(own, bytes) {
  const at = own.allocate(bytes.length);
  new Uint8Array(own.memory.buffer, at, bytes.length).set(bytes);
}

self.addEventListener("message", async ({ data: { id, file, request } }) => {
  try {
    const own = await running();
    if (file) {
      put(own, file);
      own.take();
    }
    put(own, new TextEncoder().encode(JSON.stringify(request)));
    const length = own.answer();
    const answer = new TextDecoder().decode(new Uint8Array(own.memory.buffer, own.text(), length));
    self.postMessage({ id, answer: JSON.parse(answer) });
  } catch (reason) {
    engine = null;
    self.postMessage({ id, stopped: String(reason) });
  }
});
