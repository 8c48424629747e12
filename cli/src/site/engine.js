// An engine in a worker: answers one request after the other, urgent ones first.

class Engine {
  constructor() {
    this.waiting = [];
    this.running = null;
    this.file = null;
    this.begin();
  }

  begin() {
    this.worker = new Worker("worker.js");
    this.worker.addEventListener("message", ({ data }) => {
      const { done, fail } = this.running;
      this.running = null;
      if (data.stopped) fail(new Error(data.stopped));
      else done(data.answer);
      this.next();
    });
    this.worker.addEventListener("error", (event) => {
      this.running?.fail(new Error(event.message || "the worker did not start"));
      this.running = null;
      this.next();
    });
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
    this.worker.postMessage({ id: 0, request, file });
  }

  // Drops everything that waits. A request that takes long is stopped with its worker.
  clear() {
    const dropped = this.waiting.splice(0);
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
