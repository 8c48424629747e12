// The page: takes a description, opens it with the chosen options, and shows the robot with its functions, one after
// the other. `window.site` is an interface for scripts.

// Two engines with the same robot: one for what is looked at, one that expands the other functions meanwhile.
const [front, back] = [new Engine(), new Engine()];

// The samples of the page: names of files in `robots`, and options.
const SAMPLES = [
  ["two_link.urdf", "two links", []],
  ["panda_class.urdf", "Panda", [["tip", "link8"]]],
  ["ur5_class.urdf", "UR5", []],
  ["quadruped.urdf", "quadruped", [["floating", ""], ["tip", "fl_foot"]]],
  ["humanoid.urdf", "humanoid", [["tip", "left_arm_7"]]],
  ["stanford_class.dh", "Stanford arm (DH)", []],
];

// The largest file that the engine reads.
const LARGEST = 64 * 1024 * 1024;

// The description: name, bytes, and whether it is a sample of this page.
let file = null;
let fields = null;
let view = null;
let shownTimes = {};
let began = 0;

const place = by("view-of-robot");
const said = (text) => { by("state").textContent = text; };

// Text of the bytes, as far as it is shown.
const textOf = (bytes) => new TextDecoder().decode(bytes.length > 2_000_000 ? bytes.subarray(0, 2_000_000) : bytes);

// Opens another description.
async function take(name, bytes, { options = [], q = null, sample = false } = {}) {
  if (bytes.length > LARGEST) {
    by("messages").replaceChildren(...messagesOf({ errors: [{ line: null, message: `${name} is larger than 64 MB` }] }, "", () => {}));
    return;
  }
  await ready;
  by("messages").replaceChildren();
  file = { name, bytes, sample };
  const text = by("text-of-robot");
  text.value = textOf(bytes);
  text.readOnly = bytes.length > 2_000_000;
  fields.set(options);
  const set = (option) => options.find(([own]) => own === option)?.[1];
  by("floating").checked = set("floating") !== undefined;
  for (const id of ["base", "tip"]) by(id).replaceChildren(el("option", { value: set(id) || "" }, set(id) || "as in the file"));
  await open(q);
}

// Names and values of all options.
function given() {
  const pairs = [];
  for (const id of ["base", "tip"]) if (by(id).value) pairs.push([id, by(id).value]);
  if (by("floating").checked) pairs.push(["floating", ""]);
  return [...pairs, ...fields.pairs()];
}

// Reads the description with the options, and shows the robot.
async function open(q = null) {
  began = performance.now();
  shownTimes = {};
  front.clear();
  back.clear();
  view?.end();
  const own = { ending: new AbortController() };
  own.end = () => own.ending.abort();
  view = own;
  const here = () => view === own;
  document.body.classList.add("opened");
  by("bar").hidden = false;
  by("name").textContent = file.name;
  said("reading…");
  const options = given();
  const request = { do: "open", file: file.name, options };
  const answer = await answered(front.ask(request, { file: file.bytes }));
  if (!here() || !answer) return;
  by("messages").replaceChildren(...messagesOf(answer, textOf(file.bytes), goTo));
  if (answer.errors) {
    said("");
    place.classList.add("stale");
    if (answer.errors.some(({ line }) => line !== null)) expand("editor", true);
    return;
  }
  back.ask(request, { file: file.bytes }).catch(() => {});
  choicesOf("base", answer.every_link, `the root (${answer.report.base})`);
  choicesOf("tip", answer.every_link, answer.report.tip ? `the end (${answer.report.tip})` : "none: several ends");
  show(own, answer, q);
}

// The answer, or a message if the engine stopped.
async function answered(promise) {
  try {
    return await promise;
  } catch (reason) {
    if (reason instanceof Closed) return null;
    return { errors: [{ line: null, message: "the engine stopped", hint: `${reason.message}; a large robot may need more memory than the browser gives` }] };
  }
}

// Links to choose from; the first is the default.
function choicesOf(id, links, byDefault) {
  const { value } = by(id);
  by(id).replaceChildren(el("option", { value: "" }, byDefault), ...links.map((link) => el("option", { value: link }, link)));
  by(id).value = links.includes(value) ? value : "";
}

// Puts a robot on the page and asks for its functions.
function show(own, answer, q) {
  place.classList.remove("stale");
  place.replaceChildren(by("robot-template").content.cloneNode(true));
  const data = { ...answer, layouts: [], values: true };
  const here = () => view === own;
  // Each function is expanded once, by whichever engine.
  const asked = new Map();
  const filled = (function_, found) => {
    if (found.errors) Object.assign(function_, { left_out: found.errors.map(({ message, hint }) => ({ reason: message, hint })) });
    else if (found.left_out) Object.assign(function_, { left_out: found.left_out });
    else {
      const { layout, ...rest } = found;
      const text = JSON.stringify(layout);
      let at = data.layouts.findIndex((other) => JSON.stringify(other) === text);
      if (at < 0) at = data.layouts.push(layout) - 1;
      Object.assign(function_, rest, { layout: at });
    }
    if (here()) own.interface?.fill(function_);
    return function_;
  };
  const complete = (function_, { engine = front, urgent = true } = {}) => {
    const known = asked.get(function_);
    // A value needs the function in the front engine.
    if (known && !(engine === front && known.engine === back && !known.done)) return known.promise;
    const index = data.functions.indexOf(function_);
    const entry = { engine, done: false };
    entry.promise = answered(engine.ask({ do: "function", index }, { urgent })).then((found) => {
      entry.done = true;
      return found ? filled(function_, found) : function_;
    });
    asked.set(function_, entry);
    return entry.promise;
  };

  // Values of the present state: only the newest is asked for.
  const valued = VALUED.map((name) => data.functions.find((function_) => function_.name === name)).filter(Boolean);
  let state = null;
  let asking = false;
  const values = valueSection(data, (rates) => own.interface.give(rates));
  const torques = data.functions.findIndex((function_) => function_.name === "inverse_dynamics");
  const plot = torques < 0 ? null : plotSection(data, async (at) => {
    const found = await answered(front.ask({ do: "values", indices: [torques], ...at }));
    return found?.values?.[0]?.[0] ?? null;
  });
  const evaluate = async () => {
    if (asking || !state || !own.valued) return;
    asking = true;
    while (state && here()) {
      const now = state;
      state = null;
      const indices = valued.map((function_) => data.functions.indexOf(function_));
      const found = await answered(front.ask({ do: "values", indices, ...now }, { urgent: true }));
      if (!here() || !found?.values) break;
      const results = {};
      found.values.forEach((value, k) => { if (value) [results[valued[k].name]] = value; });
      values.show(results);
      own.values = results;
    }
    asking = false;
  };
  const remember = later(() => toAddress({ robot: file.sample ? file.name : null, options: given(), q: own.interface.q() }), 300);
  const moved = (arguments_) => {
    state = arguments_;
    evaluate();
    plot?.update(arguments_);
    if (own.interface) remember();
  };

  own.interface = present(data, { complete, moved, signal: own.ending.signal });
  own.data = data;
  window.homogen = own.interface;
  const joints = by("joints");
  joints.after(el("section", { id: "values", "aria-labelledby": "values-title" }, values.section, plot?.section));
  const files = fileSection(data, (request) => front.ask(request));
  by("functions").after(el("section", { id: "files", "aria-labelledby": "files-title" }, files.section));
  const links = document.querySelector("#head nav");
  links.querySelector("[href='#joints']").after(el("a", { href: "#values" }, "Torques"));
  links.querySelector("[href='#functions']").after(el("a", { href: "#files" }, "Code"));
  if (q && q.length === data.skeleton.coordinates.length) own.interface.move(q);
  said("");
  shownTimes = { robot: performance.now() - began };
  expandAll(own, data, complete, valued, evaluate, files);
}

// Expands all functions, those with values first, and then makes the files that are shown.
async function expandAll(own, data, complete, valued, evaluate, files) {
  const here = () => view === own;
  const progress = el("progress", { max: String(data.functions.length), "aria-label": "Functions that have been generated" });
  by("functions").querySelector("h2").append(progress);
  let count = 0;
  const step = async (function_, engine) => {
    await complete(function_, { engine, urgent: false });
    count += 1;
    progress.value = count;
    shownTimes.first ??= performance.now() - began;
  };
  const first = (async () => {
    for (const function_ of valued) {
      await step(function_, front);
      if (!here()) return;
      own.valued = true;
      own.interface.give({});
      await evaluate();
    }
    shownTimes.values = performance.now() - began;
    await files.make();
  })();
  const rest = data.functions.filter((function_) => !valued.includes(function_));
  for (const function_ of rest) {
    await step(function_, back);
    if (!here()) return;
  }
  await first;
  progress.remove();
  shownTimes.all = performance.now() - began;
}

// The function, called once some time after its last call.
function later(act, milliseconds) {
  let timer = 0;
  return () => {
    clearTimeout(timer);
    timer = setTimeout(act, milliseconds);
  };
}

// Puts the cursor of the editor at a place.
function goTo(line, column) {
  expand("editor", true);
  const text = by("text-of-robot");
  const lines = text.value.split("\n");
  const at = lines.slice(0, line - 1).reduce((sum, own) => sum + own.length + 1, 0) + [...lines[line - 1] || ""].slice(0, column - 1).join("").length;
  text.focus();
  text.setSelectionRange(at, at);
  text.scrollTop = Math.max(0, (line - 5) * parseFloat(getComputedStyle(text).lineHeight));
}

function expand(id, wanted) {
  const button = by(id === "editor" ? "show-text" : "show-options");
  const opened = wanted ?? by(id).hidden;
  by(id).hidden = !opened;
  button.setAttribute("aria-expanded", String(opened));
}

async function sample([name, , options], q = null) {
  const answer = await fetch(`robots/${name}`);
  await take(name, new Uint8Array(await answer.arrayBuffer()), { options, q, sample: true });
}

async function dropped(list) {
  const [first] = list;
  if (first) await take(first.name, first.size > LARGEST ? { length: first.size } : new Uint8Array(await first.arrayBuffer()));
}

// The table of options comes from the engine.
const ready = (async () => {
  // The other engine starts meanwhile.
  back.ask({ do: "options" }).catch(() => {});
  const answer = await answered(front.ask({ do: "options" }));
  fields = optionFields(answer.options || [], () => open());
  by("options").append(...fields.section);
})();

for (const one of SAMPLES) by("samples").append(el("button", { type: "button", "data-sample": one[0], onclick: () => sample(one) }, one[1]));
by("choose").addEventListener("click", () => by("file").click());
by("name").addEventListener("click", () => by("file").click());
by("file").addEventListener("change", ({ target }) => { dropped(target.files); target.value = ""; });
by("write").addEventListener("click", () => {
  document.body.classList.add("opened");
  by("bar").hidden = false;
  file ??= { name: "robot.urdf", bytes: new Uint8Array(), sample: false };
  by("name").textContent = file.name;
  expand("editor", true);
  by("text-of-robot").focus();
});
by("link").addEventListener("click", async () => {
  toAddress({ robot: file.sample ? file.name : null, options: given(), q: view?.interface?.q() });
  const copied = await navigator.clipboard?.writeText(location.href).then(() => true, () => false);
  by("link").textContent = copied ? "Copied" : "It is in the address bar";
  setTimeout(() => { by("link").textContent = "Copy link"; }, 1500);
});
by("show-options").addEventListener("click", () => expand("options"));
by("show-text").addEventListener("click", () => expand("editor"));
for (const id of ["base", "tip", "floating"]) by(id).addEventListener("change", () => open());
by("text-of-robot").addEventListener("input", later(() => {
  const text = by("text-of-robot").value;
  // The name decides the format of what is not XML.
  const name = file.sample || file.bytes.length ? file.name : text.trimStart().startsWith("<") ? "robot.urdf" : "robot.dh";
  file = { name, bytes: new TextEncoder().encode(text), sample: false };
  ready.then(() => open());
}, 400));
for (const kind of ["dragover", "dragenter"]) {
  document.addEventListener(kind, (event) => {
    event.preventDefault();
    document.body.classList.add("dragging");
  });
}
document.addEventListener("dragleave", (event) => { if (!event.relatedTarget) document.body.classList.remove("dragging"); });
document.addEventListener("drop", (event) => {
  event.preventDefault();
  document.body.classList.remove("dragging");
  dropped(event.dataTransfer.files);
});
document.addEventListener("paste", (event) => {
  if (event.target.matches("input, textarea")) return;
  const text = event.clipboardData.getData("text");
  if (event.clipboardData.files.length) dropped(event.clipboardData.files);
  else if (text.trim()) take(text.trimStart().startsWith("<") ? "robot.urdf" : "robot.dh", new TextEncoder().encode(text));
});

const address = ofAddress();
const linked = SAMPLES.find(([name]) => name === address.robot);
if (linked) sample([linked[0], "", address.options], address.q);

window.site = {
  take: (name, text, options = []) => take(name, new TextEncoder().encode(text), { options }),
  times: () => ({ ...shownTimes }),
  values: () => view?.values ?? null,
  // True if all functions have been expanded, or there was an error.
  settled: () => shownTimes.all !== undefined,
  error: () => by("messages").querySelector(".error")?.textContent ?? null,
};
