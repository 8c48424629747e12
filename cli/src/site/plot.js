// A plot of a torque over the range of one joint, with all other joints where they are.

// Number of steps over the range.
const STEPS = 72;

// Size of the picture, in its own units.
const [WIDTH, HEIGHT, MARGIN] = [640, 200, 26];

// An element of SVG.
function shape(name, properties, text = "") {
  const element = document.createElementNS("http://www.w3.org/2000/svg", name);
  for (const [key, value] of Object.entries(properties)) element.setAttribute(key, value);
  element.textContent = text;
  return element;
}

// The section, null if no joint has a range; `compute` resolves to the torques of a state, or null. `update` takes the
// present state.
function plotSection(data, compute) {
  const { coordinates, velocities } = data.skeleton;
  const movable = coordinates.flatMap((entry, k) => (["rotation", "translation"].includes(entry.kind) ? [{ entry, k }] : []));
  if (!movable.length || !velocities.length) return null;
  let state = null;
  let last = 0;
  const choice = (label, names) => el("select", { "aria-label": label, onchange: () => draw() }, names.map((name, k) => el("option", { value: String(k) }, name)));
  const of = choice("Torque", velocities.map(({ name }) => name));
  const over = choice("Joint that moves", movable.map(({ entry }) => entry.name));
  // The second joint with limits, which gravity mostly acts on, and its own torque.
  const limited = movable.filter(({ entry }) => entry.range);
  const first = limited[1] || limited[0] || movable[0];
  over.value = String(movable.indexOf(first));
  of.value = String(Math.max(0, velocities.findIndex(({ name }) => name === first.entry.name)));
  const picture = shape("svg", { viewBox: `0 0 ${WIDTH} ${HEIGHT}`, role: "img", class: "plot" });
  const section = el("details", { class: "mass", ontoggle: () => draw() },
    el("summary", {}, el("h3", {}, "Over the range of a joint")),
    el("p", { class: "plotted" }, "τ of ", of, " over ", over), picture);

  async function draw() {
    if (!section.open || !state) return;
    const own = (last += 1);
    const { entry, k } = movable[Number(over.value)];
    const [low, high] = entry.range || (entry.kind === "rotation" ? [-Math.PI, Math.PI] : [-1, 1]);
    const points = [];
    for (let step = 0; step <= STEPS; step += 1) {
      const at = low + ((high - low) * step) / STEPS;
      const torques = await compute({ ...state, q: state.q.map((value, other) => (other === k ? at : value)) });
      if (own !== last) return;
      if (!torques) return;
      points.push([at, torques[Number(of.value)]]);
    }
    paintPlot(points, entry, state.q[k], velocities[Number(of.value)]);
  }

  function paintPlot(points, entry, now, { kind, name }) {
    // Rounding is no torque.
    const values = points.map(([, value]) => (Math.abs(value) < 1e-12 ? 0 : value));
    const [bottom, top] = [Math.min(0, ...values), Math.max(0, ...values)];
    const size = top - bottom || 1;
    const [[low], [high]] = [points[0], points[points.length - 1]];
    const x = (at) => MARGIN + ((WIDTH - 2 * MARGIN) * (at - low)) / (high - low || 1);
    const y = (value) => HEIGHT - MARGIN - ((HEIGHT - 2 * MARGIN) * (value - bottom)) / size;
    const position = (at) => (entry.kind === "rotation" ? degrees(at) : `${short(at)} m`);
    const unit = kind === "translation" ? "N" : "N m";
    const near = points.reduce((best, point) => (Math.abs(point[0] - now) < Math.abs(best[0] - now) ? point : best));
    picture.setAttribute("aria-label", `Torque of ${name} from ${short(Math.min(...values))} to ${short(Math.max(...values))} ${unit} while ${entry.name} moves from ${position(low)} to ${position(high)}`);
    picture.replaceChildren(
      shape("line", { x1: x(low), x2: x(high), y1: y(0), y2: y(0), class: "axis" }),
      shape("line", { x1: x(now), x2: x(now), y1: MARGIN, y2: HEIGHT - MARGIN, class: "now" }),
      shape("polyline", { points: points.map(([at, value]) => `${x(at).toFixed(1)},${y(value).toFixed(1)}`).join(" ") }),
      shape("circle", { cx: x(now), cy: y(near[1]), r: 4 }),
      shape("text", { x: MARGIN, y: HEIGHT - 7 }, position(low)),
      shape("text", { x: WIDTH - MARGIN, y: HEIGHT - 7, "text-anchor": "end" }, position(high)),
      shape("text", { x: MARGIN, y: 15 }, `${short(Math.max(...values))} ${unit} at most, ${short(Math.min(...values))} ${unit} at least`));
  }

  const soon = later(() => draw(), 120);
  return { section, update: (given) => { state = given; soon(); } };
}
