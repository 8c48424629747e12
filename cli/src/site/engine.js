// An engine in a worker: answers one request after the other, urgent ones first.

// The module, compiled once for all workers; a server may not know its type.
const compiled = WebAssembly.compileStreaming(fetch("homogen.wasm"))
  .catch(async () => WebAssembly.compile(await (await fetch("homogen.wasm")).arrayBuffer()));

class Engine {
  constructor() {
    this.waiting = [];
    this.running = null;
    // The request that opened the robot, which a new instance of the module repeats.
    this.opened = null;
    // Bytes of memory of the module.
    this.memory = 0;
    this.begin();
  }

  begin() {
    const worker = new Worker("worker.js");
    this.worker = worker;
    compiled.then((module) => worker.postMessage(module), () => {});
    worker.addEventListener("message", ({ data }) => {
      if (data.stopped) {
        this.stop(new Error(data.stopped));
        return;
      }
      this.memory = data.memory;
      const { done, request, file } = this.running;
      if (request.do === "open") this.opened = { request, file };
      this.running = null;
      done(data.answer);
      this.next();
    });
    worker.addEventListener("error", (event) => this.stop(new Error(event.message || "the worker did not start")));
  }

  // Ends the request that runs with an error, and opens the robot again.
  stop(reason) {
    this.running?.fail(reason);
    if (this.running?.request.do === "open") this.opened = null;
    this.running = null;
    if (this.opened) this.waiting.unshift({ ...this.opened, done() {}, fail() {} });
    this.next();
  }

  // The answer to a request; rejected if the module stopped or the robot was closed.
  ask(request, { file = null, urgent = false } = {}) {
    return new Promise((done, fail) => {
      const asked = { request, file, done, fail };
      if (urgent) this.waiting.unshift(asked);
      else this.waiting.push(asked);
      this.next();
    });
  }

  next() {
    if (this.running || !this.waiting.length) return;
    this.running = this.waiting.shift();
    const { request, file } = this.running;
    const { worker } = this;
    // After the module.
    compiled.then(() => worker.postMessage({ request, file }), (reason) => this.stop(reason));
  }

  // Drops everything that waits. A request that takes long is stopped with its worker.
  clear() {
    const dropped = this.waiting.splice(0);
    this.opened = null;
    if (this.running) {
      dropped.push(this.running);
      this.running = null;
      this.worker.terminate();
      this.begin();
    }
    for (const { fail } of dropped) fail(new Closed());
  }
}

// The robot that was asked about is no longer open.
class Closed extends Error {}
