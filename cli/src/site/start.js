// The page: takes a description, opens it with the chosen options, and shows the robot with its functions, one after
// the other. `window.site` is an interface for scripts.

// Engines with the same robot: one for what is looked at, and others that expand the other functions meanwhile: two even
// on two processors, for the first one waits most of the time. Each takes the memory of all that it has expanded.
const front = new Engine();
const backs = Array.from({ length: Math.max(2, Math.min(3, (navigator.hardwareConcurrency || 2) - 1)) }, () => new Engine());

// Robots with a button: names of files in `robots`, and options. Links open the others in that folder, too.
const SAMPLES = [
  ["two_link.urdf", "two links", []],
  ["panda_class.urdf", "Panda", [["tip", "link8"]]],
  ["ur5_class.urdf", "UR5", []],
  ["quadruped.urdf", "quadruped", [["floating", ""], ["tip", "fl_foot"]]],
  ["humanoid.urdf", "humanoid", [["tip", "left_arm_7"]]],
  ["stanford_class.dh", "Stanford arm (DH)", []],
];

// Number of velocities beyond which second derivatives wait until they are opened: they take longer than all others.
const MANY = 24;

// The largest file that the engine reads.
const LARGEST = 64 * 1024 * 1024;

// The description: name, bytes, and whether it is a sample of this page.
let file = null;
// Files with meshes, of the last drop.
let meshes = [];
let fields = null;
let view = null;
let shownTimes = {};
let began = 0;

const place = by("view-of-robot");
const said = (text) => { by("state").textContent = text; };

// Text of the bytes, as far as it is shown.
const textOf = (bytes) => new TextDecoder().decode(bytes.length > 2_000_000 ? bytes.subarray(0, 2_000_000) : bytes);

// Operation counts of the functions of the description with the options before, by name.
let before = new Map();

// Says why a description is not opened.
function refuse(message) {
  by("messages").replaceChildren(...messagesOf({ errors: [{ line: null, message }] }, "", () => {}));
}

// Opens another description.
async function take(name, bytes, { options = [], q = null, sample = false } = {}) {
  if (bytes.length > LARGEST) {
    refuse(`${name} is larger than 64 MB`);
    return;
  }
  await ready;
  by("messages").replaceChildren();
  file = { name, bytes, sample };
  before = new Map();
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
  for (const engine of backs) engine.clear();
  for (const { name, of, count } of view?.data?.functions ?? []) if (count) before.set(`${name} ${of}`, count);
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
  for (const engine of backs) engine.ask(request, { file: file.bytes }).catch(() => {});
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
  const data = { ...answer, layouts: [], values: true, shapes: shapesOf(textOf(file.bytes), meshes) };
  const many = data.skeleton.velocities.length > MANY;
  for (const function_ of data.functions) function_.waits = many && function_.name.endsWith("_hessian");
  for (const function_ of data.functions) function_.before = before.get(`${function_.name} ${function_.of}`);
  const here = () => view === own;
  const indexOf = (function_) => data.functions.indexOf(function_);
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
    const before = asked.get(function_);
    if (before) return before.promise;
    const entry = { engine };
    entry.promise = answered(engine.ask({ do: "function", index: indexOf(function_) }, { urgent })).then((found) => (found ? filled(function_, found) : function_));
    asked.set(function_, entry);
    return entry.promise;
  };
  // The engine that computes values has to have expanded the function itself.
  const known = new Map();
  const expanded = (function_) => {
    if (!backs.includes(asked.get(function_)?.engine)) return complete(function_);
    if (!known.has(function_)) known.set(function_, answered(front.ask({ do: "function", index: indexOf(function_) })));
    return known.get(function_);
  };
  // Code is printed when it is looked at.
  const explain = async (function_) => {
    await expanded(function_);
    if (!function_.count || function_.code) return function_;
    const found = await answered(front.ask({ do: "explain", index: indexOf(function_) }, { urgent: true }));
    return Object.assign(function_, found?.code ? found : {});
  };
  const compute = async (function_, states, scalar = "f64") => {
    await expanded(function_);
    const found = await answered(front.ask({ do: "values", indices: [indexOf(function_)], states, scalar }));
    return found?.values?.map(([of]) => of?.[0] ?? null) ?? null;
  };

  // Values of the present state: only the newest is asked for.
  const valued = VALUED.map((name) => data.functions.find((function_) => function_.name === name)).filter(Boolean);
  // The engine expands the first one while the page is built.
  if (valued[0]) complete(valued[0], { urgent: false });
  let state = null;
  let asking = false;
  const evaluate = async () => {
    if (asking || !state || !own.valued) return;
    asking = true;
    while (state && here()) {
      const [now, { frame }] = [state, own];
      state = null;
      const ready = valued.filter((function_) => function_.count);
      const indices = [...ready.map(indexOf), ...(frame ? frame.indices : [])];
      const found = await answered(front.ask({ do: "values", indices, states: [now] }, { urgent: true }));
      if (!here() || !found?.values) break;
      const [results] = found.values;
      own.values = Object.fromEntries(ready.flatMap(({ name }, k) => (results[k] ? [[name, results[k][0]]] : [])));
      values.show(own.values);
      for (const { name, count, left_out: lacking } of valued) if (!count && lacking) values.lack(name, lacking[0].reason);
      if (frame && frame === own.frame) {
        const [pose, rows] = results.slice(ready.length).map((of) => of?.[0]);
        if (rows) {
          Object.assign(own.values, { forward_kinematics: pose, geometric_jacobian: rows });
          jacobian.show(frame.name, rows);
        }
      }
    }
    asking = false;
  };
  const choose = async (link) => {
    const found = await answered(front.ask({ do: "frame", link }, { urgent: true }));
    if (!here() || !found?.indices || own.interface.chosen() !== link) return;
    own.frame = { name: data.skeleton.links[link].name, indices: found.indices };
    state = own.interface.given();
    await evaluate();
  };
  const remember = later(() => toAddress({ robot: file.sample ? file.name : null, options: given(), q: own.interface.q() }), 300);
  let plot = null;
  const moved = (arguments_) => {
    state = arguments_;
    evaluate();
    plot?.update(arguments_);
    if (own.interface) remember();
  };

  const measure = (function_) => medianErrors(data.skeleton, (states, scalar) => compute(function_, states, scalar));
  own.interface = present(data, { complete, explain, measure, moved, chosen: choose, signal: own.ending.signal });
  own.data = data;
  window.homogen = own.interface;
  if (q && q.length === data.skeleton.coordinates.length) own.interface.move(q);
  const values = valueSection(data, (rates) => own.interface.give(rates));
  const jacobian = jacobianSection(data, own.interface.reach, (axes) => own.interface.ellipsoid(axes));
  const trajectory = trajectorySection(data, {
    present: () => own.interface.q(),
    go: ({ q: at, ...rates }) => {
      values.set(rates);
      own.interface.give(rates);
      own.interface.move(at);
    },
    changed: () => plot?.follow(),
  });
  plot = plotSection(data, compute, trajectory);
  own.plot = plot;
  own.choose = choose;
  const joints = by("joints");
  joints.querySelector(".sliders")?.addEventListener("input", () => trajectory?.pause());
  joints.after(el("section", { id: "values", "aria-labelledby": "values-title" }, values.section,
    own.interface.chosen() === null ? null : jacobian.section, trajectory?.section, plot?.section));
  plot?.update(own.interface.given());
  const files = fileSection(data, (request) => front.ask(request));
  by("functions").after(el("section", { id: "files", "aria-labelledby": "files-title" }, files.section));
  const links = document.querySelector("#head nav");
  links.querySelector("[href='#joints']").after(el("a", { href: "#values" }, "Values"));
  links.querySelector("[href='#functions']").after(el("a", { href: "#files" }, "Code"));
  said("");
  shownTimes = { robot: performance.now() - began };
  expandAll(own, data, complete, valued, evaluate, files);
}

// Expands all functions, those with values first, and then makes the files that are shown.
async function expandAll(own, data, complete, valued, evaluate, files) {
  const here = () => view === own;
  const progress = el("progress", { max: String(data.functions.filter(({ waits }) => !waits).length), "aria-label": "Functions that have been generated" });
  by("functions").querySelector("h2").append(progress);
  let count = 0;
  const step = async (function_, engine) => {
    await complete(function_, { engine, urgent: false });
    count += 1;
    progress.value = count;
    shownTimes.first ??= performance.now() - began;
  };
  const show = async (function_) => {
    await step(function_, front);
    if (!here()) return;
    own.valued = true;
    own.interface.give({});
    await evaluate();
  };
  const first = (async () => {
    const late = valued.filter(({ name }) => name === "mass_matrix_inverse");
    for (const function_ of valued.filter((other) => !late.includes(other))) {
      await show(function_);
      if (!here()) return;
    }
    shownTimes.values = performance.now() - began;
    const link = own.interface.chosen();
    if (link !== null) await own.choose(link);
    if (here()) await files.make();
    for (const function_ of late) if (here()) await show(function_);
  })();
  const rest = data.functions.filter((function_) => !valued.includes(function_) && !function_.waits);
  // One engine begins with the first functions, the others with the last, which take longest.
  const work = async (engine, number) => {
    while (rest.length && here()) await step(number === 0 ? rest.shift() : rest.pop(), engine);
  };
  await Promise.all(backs.map(work));
  if (!here()) return;
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
  if (!answer.ok) {
    refuse(`this page has no robot ${name}`);
    warm();
    return;
  }
  await take(name, new Uint8Array(await answer.arrayBuffer()), { options, q, sample: true });
}

// The name of a file, with its folders where they are known.
const nameOf = (own) => own.path || own.webkitRelativePath || own.name;

// The files in a folder that was dropped, with their paths.
async function filesIn(entry) {
  if (entry.isFile) {
    const own = await new Promise((done, failed) => entry.file(done, failed));
    return [Object.assign(own, { path: entry.fullPath })];
  }
  const reader = entry.createReader();
  const entries = [];
  // A browser lists a hundred at a time.
  for (let some = [null]; some.length; entries.push(...some)) some = await new Promise((done, failed) => reader.readEntries(done, failed));
  return (await Promise.all(entries.map(filesIn))).flat();
}

// Opens a file, or several together with what they include. Meshes alone belong to the robot that is shown.
async function dropped(files) {
  const isMesh = ({ name, size }) => MESH.test(name) && size <= LARGEST;
  const shapes = [...files].filter(isMesh);
  const list = [...files].filter((own) => !isMesh(own));
  if (shapes.length || list.length) meshes = await Promise.all(shapes.map(async (own) => ({ name: nameOf(own), buffer: await own.arrayBuffer() })));
  if (list.length === 0) {
    if (shapes.length && file) await open(view?.interface?.q());
    return;
  }
  if (list.length === 1) {
    const [first] = list;
    await take(first.name, first.size > LARGEST ? { length: first.size } : new Uint8Array(await first.arrayBuffer()));
    return;
  }
  const texts = list.filter(({ name, size }) => /\.(urdf|xacro|xml|mjcf|sdf|dh)$/i.test(name) && size <= LARGEST);
  const read = await Promise.all(texts.map(async (own) => ({ name: nameOf(own), text: await own.text() })));
  if (!read.length) {
    await take(list[0].name, new Uint8Array(await list[0].arrayBuffer()));
    return;
  }
  // A folder has other files in XML, too.
  const robots = read.filter(({ text }) => /<(robot|mujoco|sdf)[\s>]/.test(text));
  const { name, text } = joined(robots.length ? robots : read);
  await take(name, new TextEncoder().encode(text));
}

// The table of options comes from the engine.
const ready = (async () => {
  // The other engines start meanwhile.
  for (const engine of backs) engine.ask({ do: "options" }).catch(() => {});
  const answer = await answered(front.ask({ do: "options" }));
  fields = optionFields(answer.options || [], () => open());
  by("options").append(...fields.section);
})();

// Compiles the engine's code while the page waits for a description: browsers optimise what has run.
async function warm() {
  await ready;
  if (file) return;
  const [name] = SAMPLES[0];
  const bytes = new Uint8Array(await (await fetch(`robots/${name}`)).arrayBuffer());
  for (const engine of [front, ...backs]) {
    const ask = (request, more) => (file ? null : engine.ask(request, more).catch(() => null));
    (async () => {
      const robot = await ask({ do: "open", file: name, options: [] }, { file: bytes });
      const wanted = robot?.functions?.map((own, index) => ({ own, index })) ?? [];
      wanted.sort((a, b) => VALUED.indexOf(b.own.name) - VALUED.indexOf(a.own.name));
      for (const { index } of wanted) await ask({ do: "function", index });
    })();
  }
}

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
  const entries = [...event.dataTransfer.items].map((item) => item.webkitGetAsEntry?.()).filter(Boolean);
  if (entries.some(({ isDirectory }) => isDirectory)) Promise.all(entries.map(filesIn)).then((files) => dropped(files.flat()));
  else dropped(event.dataTransfer.files);
});
document.addEventListener("paste", (event) => {
  if (event.target.matches("input, textarea")) return;
  const text = event.clipboardData.getData("text");
  if (event.clipboardData.files.length) dropped(event.clipboardData.files);
  else if (text.trim()) take(text.trimStart().startsWith("<") ? "robot.urdf" : "robot.dh", new TextEncoder().encode(text));
});

const address = ofAddress();
if (address.robot && /^\w[\w.]*$/.test(address.robot)) sample([address.robot, "", address.options], address.q);
else warm();

window.site = {
  take: (name, text, options = []) => take(name, new TextEncoder().encode(text), { options }),
  times: () => ({ ...shownTimes }),
  // Bytes of memory of all engines.
  memory: () => [front, ...backs].reduce((sum, { memory }) => sum + memory, 0),
  values: () => view?.values ?? null,
  plot: () => view?.plot?.shown() ?? null,
  // True if all functions have been expanded, or there was an error.
  settled: () => shownTimes.all !== undefined,
  error: () => by("messages").querySelector(".error")?.textContent ?? null,
};
