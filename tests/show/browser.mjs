// Headless browser, controlled through a pipe by the DevTools protocol; needs no package.
//
// In: the path of Chromium. Out: pages to open, evaluate expressions in, point at and take pictures of. It collects
// the complaints of a page (console output, log entries), and never judges them.

import { spawn } from "node:child_process";
import { mkdtempSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";

// Time limit for an answer of the browser \[ms\].
const PATIENCE = 60_000;

export class Browser {
  constructor(path) {
    this.folder = mkdtempSync(join(tmpdir(), "show-"));
    const words = ["--headless=new", "--no-sandbox", "--disable-gpu", "--hide-scrollbars", "--no-first-run", "--disable-extensions",
      "--disable-background-networking", "--remote-debugging-pipe", `--user-data-dir=${this.folder}`, "about:blank"];
    this.process = spawn(path, words, { stdio: ["ignore", "ignore", "ignore", "pipe", "pipe"] });
    this.sent = 0;
    this.waiting = new Map();
    this.listeners = [];
    let rest = "";
    this.process.stdio[4].setEncoding("utf8").on("data", (text) => {
      const messages = (rest + text).split("\0");
      rest = messages.pop();
      for (const message of messages) this.hear(JSON.parse(message));
    });
  }

  hear(message) {
    const waiting = this.waiting.get(message.id);
    if (!waiting) {
      for (const listener of this.listeners) listener(message);
      return;
    }
    this.waiting.delete(message.id);
    if (message.error) waiting.fail(new Error(message.error.message));
    else waiting.done(message.result);
  }

  send(method, parameters = {}, sessionId = undefined) {
    const id = (this.sent += 1);
    this.process.stdio[3].write(`${JSON.stringify({ id, method, params: parameters, sessionId })}\0`);
    return new Promise((done, fail) => {
      const late = setTimeout(() => fail(new Error(`${method}: no answer`)), PATIENCE);
      this.waiting.set(id, { done: (result) => { clearTimeout(late); done(result); }, fail });
    });
  }

  // A new page of a width and height; `touch` is true for phones.
  async open(url, { width, height, ratio = 1, touch = false, dark = false }) {
    const { targetId } = await this.send("Target.createTarget", { url: "about:blank" });
    const { sessionId } = await this.send("Target.attachToTarget", { targetId, flatten: true });
    const page = new Page(this, targetId, sessionId);
    for (const domain of ["Page", "Runtime", "Log", "Network"]) await page.send(`${domain}.enable`);
    await page.send("Emulation.setDeviceMetricsOverride", { width, height, deviceScaleFactor: ratio, mobile: touch });
    await page.send("Emulation.setTouchEmulationEnabled", { enabled: touch });
    await page.send("Emulation.setEmulatedMedia", { features: [{ name: "prefers-color-scheme", value: dark ? "dark" : "light" }] });
    const loaded = page.next("Page.loadEventFired");
    const start = performance.now();
    await page.send("Page.navigate", { url });
    await loaded;
    // After the first drawing.
    await page.ask("new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done)))");
    page.took = performance.now() - start;
    return page;
  }

  async close() {
    const gone = new Promise((done) => this.process.once("exit", done));
    await this.send("Browser.close").catch(() => this.process.kill());
    await gone;
    rmSync(this.folder, { recursive: true, force: true, maxRetries: 5 });
  }
}

class Page {
  constructor(browser, target, session) {
    Object.assign(this, { browser, target, session, complaints: [], requests: [] });
    browser.listeners.push(({ method, params, sessionId }) => {
      if (sessionId !== session) return;
      if (method === "Runtime.exceptionThrown") this.complaints.push(params.exceptionDetails.exception?.description || params.exceptionDetails.text);
      if (method === "Log.entryAdded" && params.entry.level !== "verbose") this.complaints.push(params.entry.text);
      if (method === "Runtime.consoleAPICalled") this.complaints.push(params.args.map((one) => one.value).join(" "));
      if (method === "Network.requestWillBeSent") this.requests.push(params.request.url);
    });
  }

  send(method, parameters) {
    return this.browser.send(method, parameters, this.session);
  }

  next(wanted) {
    return new Promise((done) => {
      const listener = ({ method, sessionId }) => {
        if (method === wanted && sessionId === this.session) done();
      };
      this.browser.listeners.push(listener);
    });
  }

  // The value of an expression in the page, awaited.
  async ask(expression) {
    const { result, exceptionDetails } = await this.send("Runtime.evaluate", { expression, awaitPromise: true, returnByValue: true });
    if (exceptionDetails) throw new Error(`${expression}: ${exceptionDetails.exception?.description || exceptionDetails.text}`);
    return result.value;
  }

  // Waits until an expression is true, for some time \[ms\].
  async until(expression, patience = PATIENCE) {
    const end = performance.now() + patience;
    while (!(await this.ask(expression))) {
      if (performance.now() > end) throw new Error(`never: ${expression}`);
      await new Promise((done) => setTimeout(done, 20));
    }
  }

  // Scrolls an element into view; returns its center.
  spot(selector) {
    return this.ask(`(() => {
      const element = document.querySelector(${JSON.stringify(selector)});
      element.scrollIntoView({ block: "center", behavior: "instant" });
      const box = element.getClientRects()[0];
      return { x: box.x + box.width / 2, y: box.y + box.height / 2 };
    })()`);
  }

  async mouse(type, { x, y }, more = {}) {
    await this.send("Input.dispatchMouseEvent", { type, x, y, ...more });
  }

  async hover(selector) {
    await this.mouse("mouseMoved", await this.spot(selector));
  }

  async click(selector) {
    const at = await this.spot(selector);
    for (const type of ["mousePressed", "mouseReleased"]) await this.mouse(type, at, { button: "left", clickCount: 1 });
  }

  async tap(selector) {
    const at = await this.spot(selector);
    await this.send("Input.dispatchTouchEvent", { type: "touchStart", touchPoints: [at] });
    await this.send("Input.dispatchTouchEvent", { type: "touchEnd", touchPoints: [] });
  }

  async key(key) {
    for (const type of ["keyDown", "keyUp"]) await this.send("Input.dispatchKeyEvent", { type, key, code: key });
  }

  async picture(path, format = "png") {
    const { data } = await this.send("Page.captureScreenshot", { format, ...(format === "png" ? {} : { quality: 82 }) });
    writeFileSync(path, Buffer.from(data, "base64"));
  }

  // Prints the page to a PDF of as many pages as needed.
  async paper(path) {
    const { data } = await this.send("Page.printToPDF", { printBackground: true });
    writeFileSync(path, Buffer.from(data, "base64"));
  }
}
