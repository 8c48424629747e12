// Sliders for the coordinates. A quaternion has three sliders: a rotation about each axis. Mimic joints are shown
// without sliders.

const TURN = Math.PI;

// A configuration as text in a language; each number reads back as it is.
const SPELLED = (() => {
  const real = (value) => (/[.e]/.test(String(value)) ? String(value) : `${value}.0`);
  const list = (q) => q.map(real).join(", ");
  return {
    JSON: (q) => JSON.stringify({ states: [{ q }] }),
    Rust: (q) => `let q: [f64; ${q.length}] = [${list(q)}];`,
    C: (q) => `const double q[${q.length}] = {${list(q)}};`,
    Python: (q) => `q = [${list(q)}]`,
  };
})();

// The first configuration: zero, or as near as limits allow; the identity for a quaternion.
function rest(skeleton) {
  let quaternion = 0;
  return skeleton.coordinates.map((entry) => {
    if (entry.kind === "quaternion") {
      quaternion += 1;
      // The last entry of a quaternion is its scalar.
      return quaternion % 4 === 0 ? 1 : 0;
    }
    const [low, high] = entry.range || [0, 0];
    return entry.range ? Math.min(Math.max(0, low), high) : 0;
  });
}

// The sliders of a robot, in the order of q, with joints and limits.
function slidersOf(skeleton, reach) {
  const sliders = [];
  const { coordinates } = skeleton;
  for (let k = 0; k < coordinates.length; k += 1) {
    const entry = coordinates[k];
    if (entry.kind === "quaternion") {
      const { joint } = entry;
      for (const axis of [0, 1, 2]) {
        sliders.push({ name: joint, joint, part: `turn ${"xyz"[axis]}`, quaternion: k, axis, low: -TURN, high: TURN, unit: "rad", free: true });
      }
      k += 3;
      continue;
    }
    const [low, high] = entry.range || (entry.kind === "rotation" ? [-TURN, TURN] : [-reach, reach]);
    sliders.push({ name: entry.name, joint: entry.joint, coordinate: k, low, high, unit: entry.unit, free: !entry.range });
  }
  return sliders;
}

// With one decimal, and without the sign of a zero.
const tenth = (value) => value.toFixed(1).replace(/^-(0\.0)$/, "$1").replace("-", "−");
const degrees = (angle) => `${tenth((angle * 180) / Math.PI)}°`;
const metres = (length) => `${tenth(length * 1000)} mm`;

// The section; `changed` is called with every new q, and with the velocities of all joints.
function jointSection(data, reach, changed) {
  const { skeleton, report } = data;
  const q = rest(skeleton);
  const sliders = slidersOf(skeleton, reach);
  const turns = new Map();
  const rows = sliders.map((slider, number) => {
    const id = `slider-${number}`;
    const kind = report.details.joints.find((joint) => joint.name === slider.joint)?.kind;
    const input = el("input", {
      type: "range", id, min: String(slider.low), max: String(slider.high), step: "any",
      disabled: slider.low === slider.high,
      oninput: () => move([slider], () => Number(input.value)),
      ondblclick: () => move([slider], nearest),
    });
    const output = el("input", { class: "typed", inputmode: "decimal", "aria-label": `${slider.name} ${slider.part || ""}`,
      onchange: () => {
        const wanted = typed(output.value, slider.unit);
        if (Number.isFinite(wanted)) move([slider], () => Math.min(Math.max(wanted, slider.low), slider.high));
        output.value = said(get(slider), slider.unit);
      },
      onfocus: () => output.select() });
    const row = el("div", { class: "slider", "data-kind": kind },
      el("label", { for: id }, named(slider.name), slider.part ? el("small", {}, ` ${slider.part}`) : null),
      input, output);
    return { slider, input, output, row };
  });
  const followers = report.mimicked.map((mimic) => {
    const output = el("output");
    return { mimic, output, row: el("div", { class: "slider follower" },
      el("span", {}, named(mimic.joint)),
      el("small", {}, `${short(mimic.multiplier)} × `, named(mimic.of), mimic.offset ? ` + ${short(mimic.offset)}` : null), output) };
  });
  const set = (slider, value) => {
    if (slider.quaternion === undefined) {
      q[slider.coordinate] = value;
      return;
    }
    const turned = turns.get(slider.quaternion) || [0, 0, 0];
    turned[slider.axis] = value;
    turns.set(slider.quaternion, turned);
    quaternionOf(turned).forEach((entry, k) => { q[slider.quaternion + k] = entry; });
  };
  const nearest = ({ low, high }) => Math.min(Math.max(0, low), high);
  // Moves some sliders; if loops are kept closed the other joints move along, or nothing moves.
  const move = (moved, value) => {
    const before = [...q];
    for (const slider of moved) set(slider, value(slider));
    if (close.checked) {
      const held = moved.flatMap((slider) => (slider.quaternion === undefined ? [slider.coordinate] : [0, 1, 2, 3].map((k) => slider.quaternion + k)));
      const all = moved.length === sliders.length;
      const found = closed(skeleton, q, all ? [] : held);
      take(found || before, found && !all ? held : []);
    }
    update();
  };
  // Coordinates as given; the sliders of a held quaternion keep their positions.
  const take = (values, held = []) => {
    values.forEach((entry, k) => { q[k] = entry; });
    for (const { quaternion } of sliders) {
      if (quaternion !== undefined && !held.includes(quaternion)) turns.set(quaternion, turnOf(q.slice(quaternion, quaternion + 4)));
    }
  };
  const close = el("input", { type: "checkbox", onchange: () => move([], null) });
  close.checked = skeleton.loops.length > 0;
  // Null if the rates are not those of the box.
  const moving = el("input", { type: "checkbox", id: "moving", onchange: () => update() });
  const rate = () => (data.values ? null : moving.checked ? 1 : 0);
  const units = el("button", { type: "button", title: "Degrees or radians", onclick: () => {
    inDegrees = !inDegrees;
    units.textContent = inDegrees ? "°" : "rad";
    update();
  } }, "°");
  const get = (slider) => slider.quaternion === undefined ? q[slider.coordinate] : (turns.get(slider.quaternion) || [0, 0, 0])[slider.axis];
  // Angles are shown in degrees or radians; a typed number may have a unit of its own.
  let inDegrees = true;
  const said = (value, unit) => (unit === "m" ? metres(value) : inDegrees ? degrees(value) : `${short(value)} rad`);
  const typed = (text, unit) => {
    const [, number, own] = /^\s*([-+.\de]+)\s*(\S*)\s*$/i.exec(text.replace("−", "-").replace(",", ".")) || [];
    const factors = { "°": TURN / 180, deg: TURN / 180, rad: 1, mm: 1e-3, cm: 1e-2, m: 1 };
    return Number(number) * (factors[own || (unit === "m" ? "mm" : inDegrees ? "°" : "rad")] ?? NaN);
  };
  const state = el("code", { id: "q", class: "state" });
  const language = el("select", { id: "language-of-q", "aria-label": "Language", onchange: () => update() }, Object.keys(SPELLED).map((name) => el("option", { value: name }, name)));
  const copy = el("button", { type: "button", id: "copy-q", onclick: async () => {
    const copied = await navigator.clipboard?.writeText(state.textContent).then(() => true, () => false);
    copy.textContent = copied ? "Copied" : "No clipboard";
    setTimeout(() => { copy.textContent = "Copy"; }, 1500);
  } }, "Copy");
  const update = () => {
    for (const { slider, input, output } of rows) {
      const value = get(slider);
      if (Number(input.value) !== value) input.value = String(value);
      if (document.activeElement !== output) output.value = said(value, slider.unit);
      output.title = `${short(value, 6)} ${slider.unit}`;
    }
    for (const { mimic, output } of followers) {
      const mimicked = skeleton.coordinates.findIndex((entry) => entry.joint === mimic.of);
      const value = mimic.multiplier * q[mimicked] + mimic.offset;
      const kind = report.details.joints.find((joint) => joint.name === mimic.joint)?.kind;
      output.textContent = mimicked < 0 ? "" : said(value, kind === "prismatic" ? "m" : "rad");
    }
    state.textContent = SPELLED[language.value](q);
    changed(q, rate());
  };
  const random = ({ low, high, free }) => low + (high - low) * (free ? 0.5 + (Math.random() - 0.5) * 0.5 : Math.random());
  const button = (text, title, value) => el("button", { type: "button", title, onclick: () => move(sliders, value) }, text);
  const beyond = sliders.filter((slider) => nearest(slider) !== 0).length;
  const section = [
    el("div", { class: "title" },
      el("h2", { id: "joints-title" }, "Joints"),
      el("div", { class: "buttons" },
        button("Zero", "All coordinates zero, or as near as their limits allow", nearest),
        button("Middle", "All coordinates in the middle of their range", ({ low, high }) => (low + high) / 2),
        button("Random", "A random configuration", random),
        units)),
    beyond ? el("p", { class: "small" }, `${counted(beyond, "coordinate")} cannot be 0 within the limits; Zero takes the nearest.`) : null,
    el("div", { class: "sliders" }, rows.map(({ row }) => row), followers.map(({ row }) => row)),
    skeleton.loops.length ? el("p", { class: "note" }, el("label", {}, close, ` Keep ${counted(skeleton.loops.length, "loop")} closed: the other joints move along.`),
      " Functions are of the tree of joints, but for those of loops.") : null,
    data.values ? null : el("p", { class: "note" }, el("label", {}, moving, " Show values of names with every rate at 1 (rad/s, m/s), and not at rest.")),
    el("details", { class: "small" },
      el("summary", {}, "This configuration as text"),
      el("div", { class: "plotted" }, language, copy, "JSON is a file of states for ", el("code", {}, "homogen eval"), "."), state),
    el("div", { id: "pose" }),
  ];
  const put = (values) => {
    take(values);
    update();
  };
  const start = () => move([], null);
  return { section, start, put };
}

// A pose as a matrix.
function poseTable(pose) {
  const rows = [0, 4, 8].map((row) => [0, 1, 2, 3].map((column) => pose[row + column]));
  return el("div", { class: "matrix numbers", id: "tip-pose", "data-pose": JSON.stringify(pose) },
    [...rows.flat(), 0, 0, 0, 1].map((entry, k) => el("span", { class: k % 4 === 3 && k < 12 ? "meant" : null }, k < 12 ? entry.toFixed(4).replace("-", "−") : String(entry))));
}
