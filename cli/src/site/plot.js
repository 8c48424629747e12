// A plot of entries of a function over the range of one joint, with all other joints where they are, or over the time of
// the trajectory.

// Number of steps over the range.
const STEPS = 72;

// Largest number of curves in one plot.
const CURVES = 12;

// Size of the picture, in its own units.
const [WIDTH, HEIGHT, MARGIN] = [640, 220, 26];

// The functions that are results of torques, in N m or N.
const OF_TORQUES = ["gravity", "inverse_dynamics", "bias"];

// An element of SVG.
function shape(name, properties, text = "") {
  const element = document.createElementNS("http://www.w3.org/2000/svg", name);
  for (const [key, value] of Object.entries(properties)) element.setAttribute(key, value);
  element.textContent = text;
  return element;
}

// The section, null for a robot without functions; `compute` resolves to the results of a function in states, or null;
// `trajectory` is null for a robot that has none. `update` takes the present state, `follow` shows the trajectory, `shown`
// returns curves with their states.
function plotSection(data, compute, trajectory) {
  const { coordinates, velocities } = data.skeleton;
  const movable = coordinates.flatMap((entry, k) => (["rotation", "translation"].includes(entry.kind) ? [{ entry, k }] : []));
  const functions = data.functions.filter((own) => own.of === null);
  if (!movable.length || !functions.length) return null;
  let state = null;
  let last = 0;
  let sample = null;
  let painted = null;

  const fill = (select, names, wanted = select.value) => {
    select.replaceChildren(...names.map(([value, text]) => el("option", { value }, text)));
    select.hidden = names.length < 2;
    if (names.some(([value]) => value === wanted)) select.value = wanted;
  };
  const choice = (label, id, change) => el("select", { "aria-label": label, id, onchange: change });
  const of = choice("Function", "plot-function", () => {
    [sample, painted] = [null, null];
    for (const other of [part, row, column]) other.replaceChildren();
    draw();
  });
  const [part, row, column] = [["Part", "plot-part"], ["Row", "plot-row"], ["Column", "plot-column"]].map(([label, id]) => choice(label, id, () => { offer(); painted = null; draw(); }));
  const over = choice("Over", "plot-over", () => { painted = null; draw(); });
  fill(of, functions.map(({ name }) => [name, name]), functions.some(({ name }) => name === "inverse_dynamics") ? "inverse_dynamics" : functions[0].name);
  const offerOver = () => fill(over, [...movable.map(({ entry }, number) => [String(number), entry.name]), ...(trajectory?.at(0) ? [["time", "the trajectory"]] : [])]);
  offerOver();
  // The second joint with limits, which gravity mostly acts on.
  const limited = movable.filter(({ entry }) => entry.range);
  const first = limited[1] || limited[0] || movable[0];
  over.value = String(movable.indexOf(first));

  const picture = shape("svg", { viewBox: `0 0 ${WIDTH} ${HEIGHT}`, role: "img", class: "plot" });
  const legend = el("p", { class: "legend" });
  const section = el("details", { class: "part", ontoggle: () => draw() },
    el("summary", {}, el("h3", {}, "Plot")),
    el("p", { class: "plotted" }, of, part, row, column, " over ", over), picture, legend);

  // The names of so many rows or columns.
  const names = (count, isRow) => {
    if (isRow && count === 6 && /jacobian|momentum/.test(of.value)) return SIX;
    if (count === velocities.length) return velocities.map(({ name }) => name);
    if (count === coordinates.length) return coordinates.map(({ name }) => name);
    return Array.from({ length: count }, (_, k) => String(k + 1));
  };
  const numbered = (count, isRow) => names(count, isRow).map((name, k) => [String(k), name]);
  // A part of a result: a number, a vector, or rows, of several matrices one after the other.
  const parted = (result) => {
    const own = result !== null && typeof result === "object" && !Array.isArray(result) ? result[part.value] : result;
    return Array.isArray(own?.[0]?.[0]) ? own.flat() : own;
  };
  // Offers the entries of the sample.
  function offer() {
    const parts = sample !== null && typeof sample === "object" && !Array.isArray(sample) ? Object.keys(sample) : [];
    fill(part, parts.map((name) => [name, name]));
    const own = parted(sample);
    const count = Array.isArray(own) ? own.length : 0;
    const isMatrix = count > 0 && Array.isArray(own[0]);
    fill(row, [...(count > 1 && count <= CURVES && !isMatrix ? [["", "all"]] : []), ...numbered(count, true)]);
    fill(column, isMatrix ? numbered(own[0].length, false) : []);
  }
  // The entries that are shown, by name.
  const entries = (result) => {
    const own = parted(result);
    if (!Array.isArray(own)) return [[of.value, own]];
    if (Array.isArray(own[0])) return [[`${row.selectedOptions[0]?.text}, ${column.selectedOptions[0]?.text}`, own[Number(row.value)]?.[Number(column.value)]]];
    if (row.value === "") return names(own.length, true).map((name, k) => [name, own[k]]);
    return [[row.selectedOptions[0]?.text, own[Number(row.value)]]];
  };

  // The states of the plot, with their positions on the axis and its ends.
  function axis() {
    const steps = Array.from({ length: STEPS + 1 }, (_, step) => step / STEPS);
    if (over.value === "time") {
      const seconds = trajectory.seconds();
      return { at: steps.map((share) => share * seconds), states: steps.map((share) => trajectory.at(share * seconds)), now: trajectory.time(), said: (time) => `${short(time)} s`, name: "time" };
    }
    const { entry, k } = movable[Number(over.value)];
    const [low, high] = entry.range || (entry.kind === "rotation" ? [-Math.PI, Math.PI] : [-1, 1]);
    const at = steps.map((share) => low + (high - low) * share);
    return {
      at, states: at.map((value) => ({ ...state, q: state.q.map((other, l) => (l === k ? value : other)) })),
      now: state.q[k], said: (value) => (entry.kind === "rotation" ? degrees(value) : `${short(value)} m`), name: entry.name,
    };
  }

  async function draw() {
    if (!section.open || !state) return;
    const own = (last += 1);
    const function_ = functions.find(({ name }) => name === of.value);
    const along = axis();
    const results = await compute(function_, along.states);
    if (own !== last) return;
    if (!results || results[0] === null) {
      picture.replaceChildren(shape("text", { x: MARGIN, y: 40 }, function_.left_out ? function_.left_out[0].reason : "no values"));
      legend.replaceChildren();
      return;
    }
    if (sample === null) {
      sample = results[0];
      offer();
    }
    const found = results.map(entries);
    const curves = found[0].map(([name], number) => ({ name, points: along.at.map((at, step) => [at, found[step][number][1]]) }));
    painted = { curves, along };
    paintPlot(curves, along);
  }

  function paintPlot(curves, { now, said, name }) {
    // Rounding is no value.
    const size = Math.max(...curves.flatMap(({ points }) => points.map(([, value]) => Math.abs(value))));
    const plain = (value) => (Math.abs(value) < Math.max(1e-12, 1e-14 * size) ? 0 : value);
    const values = curves.flatMap(({ points }) => points.map(([, value]) => plain(value)));
    const [bottom, top] = [Math.min(0, ...values), Math.max(0, ...values)];
    const [[low], [high]] = [curves[0].points[0], curves[0].points[STEPS]];
    const x = (at) => MARGIN + ((WIDTH - 2 * MARGIN) * (at - low)) / (high - low || 1);
    const y = (value) => HEIGHT - MARGIN - ((HEIGHT - 2 * MARGIN) * (plain(value) - bottom)) / (top - bottom || 1);
    const kinds = new Set(velocities.map(({ kind }) => kind));
    const unit = !OF_TORQUES.includes(of.value) ? "" : kinds.size > 1 ? " N m or N" : kinds.has("translation") ? " N" : " N m";
    const [most, least] = [Math.max(...values), Math.min(...values)].map((value) => short(value));
    picture.setAttribute("aria-label", `${of.value} of ${curves.map((curve) => curve.name).join(", ")} from ${least} to ${most}${unit} while ${name} goes from ${said(low)} to ${said(high)}`);
    const colour = (number) => (curves.length === 1 ? "var(--accent)" : `hsl(${Math.round((360 * number) / curves.length + 180) % 360} 60% 50%)`);
    const lines = curves.map(({ points }, number) => {
      const line = shape("polyline", { points: points.map(([at, value]) => `${x(at).toFixed(1)},${y(value).toFixed(1)}`).join(" ") });
      line.style.stroke = colour(number);
      return line;
    });
    const near = (points) => points.reduce((best, point) => (Math.abs(point[0] - now) < Math.abs(best[0] - now) ? point : best));
    picture.replaceChildren(
      shape("line", { x1: x(low), x2: x(high), y1: y(0), y2: y(0), class: "axis" }),
      shape("line", { x1: x(now), x2: x(now), y1: MARGIN, y2: HEIGHT - MARGIN, class: "now" }),
      ...lines,
      ...(curves.length === 1 ? [shape("circle", { cx: x(now), cy: y(near(curves[0].points)[1]), r: 4 })] : []),
      shape("text", { x: MARGIN, y: HEIGHT - 7 }, said(low)),
      shape("text", { x: WIDTH - MARGIN, y: HEIGHT - 7, "text-anchor": "end" }, said(high)),
      shape("text", { x: MARGIN, y: 15 }, `${most}${unit} at most, ${least}${unit} at least`));
    legend.replaceChildren(...(curves.length < 2 ? [] : curves.map((curve, number) => {
      const sign = el("i", {});
      sign.style.background = colour(number);
      return el("span", {}, sign, named(curve.name));
    })));
  }

  const soon = later(() => draw(), 120);
  // Offers the trajectory, and shows it.
  const follow = () => {
    offerOver();
    if (trajectory.at(0)) {
      over.value = "time";
      section.open = true;
    }
    painted = null;
    soon();
  };
  const update = (given) => {
    state = given;
    // A trajectory does not depend on the state: the time moves along it.
    if (over.value === "time" && painted) paintPlot(painted.curves, { ...painted.along, now: trajectory.time() });
    else soon();
  };
  return { section, update, follow, shown: () => painted && { curves: painted.curves, states: painted.along.states } };
}
