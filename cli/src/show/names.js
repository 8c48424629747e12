// Meaning of a name in generated code: the matrix that it is an entry of, with its subscripts; or the argument, the
// angle or the sum.

const ARGUMENTS = {
  q: { letter: "q", space: "coordinates", noun: "Coordinate" },
  qd: { letter: "q̇", space: "velocities", noun: "Velocity" },
  qdd: { letter: "q̈", space: "velocities", noun: "Acceleration" },
  tau: { letter: "τ", space: "velocities", noun: "Force or torque" },
  weights: { letter: "λ", space: "velocities", noun: "Weight" },
  q_change: { letter: "δq", space: "velocities", noun: "Change along the velocity" },
  qd_change: { letter: "δq̇", space: "velocities", noun: "Change of the velocity" },
  qdd_change: { letter: "δq̈", space: "velocities", noun: "Change of the acceleration" },
  tau_change: { letter: "δτ", space: "velocities", noun: "Change of the force or torque" },
  wrench: { letter: "Φ", noun: "Entry of the wrench" },
};

const UNITS = {
  q: { rotation: "rad", translation: "m", quaternion: "1" },
  qd: { rotation: "rad/s", translation: "m/s" },
  qdd: { rotation: "rad/s²", translation: "m/s²" },
  tau: { rotation: "N m", translation: "N" },
  weights: { rotation: "rad", translation: "m" },
  q_change: { rotation: "rad", translation: "m" },
  qd_change: { rotation: "rad/s", translation: "m/s" },
  qdd_change: { rotation: "rad/s²", translation: "m/s²" },
  tau_change: { rotation: "N m", translation: "N" },
  wrench: { rotation: "N m", translation: "N" },
};

const WRENCH = ["c_x", "c_y", "c_z", "f_x", "f_y", "f_z"].map((name, k) => ({ name, kind: k < 3 ? "rotation" : "translation" }));

// Kinds of names that are numbers.
const NUMBERS = ["entry", "argument", "action", "sum", "angle", "part"];

// The meaning of a name of an open function; `kind` decides which of the following fields exist.
function meaning(robot, { names, of }, name) {
  const said = names.get(name);
  switch (said?.kind) {
    case undefined: return { kind: "other" };
    case "entry": return { ...said, form: robot.letters.forms[said.form], frame: of };
    case "argument": {
      const { space } = ARGUMENTS[said.argument];
      return { ...said, entry: (space ? robot.skeleton[space] : WRENCH)[said.index - 1] };
    }
    default: return said;
  }
}

// A name as in the paper, with subscripts.
function written(robot, open, name) {
  const said = meaning(robot, open, name);
  const sub = (text) => el("sub", {}, text);
  const sign = said.negative ? "−" : "";
  switch (said.kind) {
    case "entry": {
      if (!said.form.letter) return el("var", {}, `${sign}${said.entry}`, sub(subscript(said)));
      const [symbol, axes] = said.entry.split("_");
      return el("var", {}, sign, el("b", {}, said.form.letter), sub(subscript(said)), "\u2009", symbol, axes ? sub(axes) : null);
    }
    case "argument":
      return el("var", {}, ARGUMENTS[said.argument].letter, sub(String(said.index)));
    case "action":
      return el("var", {}, "Φ", sub(`${said.index}`), `\u2009${said.entry[0]}`, sub(said.entry[1]));
    case "sum":
      return el("var", {}, "q", sub(said.coordinates.join("+")));
    case "angle":
      return el("var", {}, said.sine ? "s" : "c", sub(said.coordinates.join("+") || said.of));
    case "part":
      return el("var", {}, "t", sub(String(said.index)));
    default:
      return el("code", {}, name);
  }
}

// The subscripts of an entry's matrix: 0,2(2).
const subscript = ({ form, i, k }) => form.subscript.replace("{i}", i).replace("{i}", i).replace("{k}", k);

// The body of a number.
function bodyName(robot, number) {
  if (number === 0) return `frame 0 (${robot.skeleton.base})`;
  const body = robot.skeleton.bodies[number - 1];
  if (!body) return `link ${number}`;
  return body.link === null ? `body ${number} (beyond ${body.name})` : `link ${number} (${body.link})`;
}

// The sentence of an entry's matrix.
function described(robot, { form, i, k, frame }) {
  const words = { i: bodyName(robot, i), k: k === null ? "" : bodyName(robot, k).replace(/^link/, "frame"), 0: bodyName(robot, 0), n: frame, row: i, column: k };
  return form.sentence.replace(/\{(\w+)\}/g, (_, which) => words[which]);
}

// The indices of the bodies of a name.
function bodiesOf(robot, said) {
  if (said.kind === "entry") return new Set([said.i, said.k].filter((number) => number > 0).map((number) => number - 1));
  const of = (coordinate) => robot.skeleton.bodies.flatMap((body, k) => (body.by && carries(robot, body, coordinate - 1) ? [k] : []));
  if (said.kind === "argument") {
    if (said.argument === "q") return new Set(of(said.index));
    return new Set(robot.skeleton.bodies.flatMap((body, k) => (body.velocity === said.index - 1 ? [k] : [])));
  }
  if (said.coordinates) return new Set(said.coordinates.flatMap(of));
  return new Set();
}

// True if a coordinate moves a body directly.
function carries(robot, body, coordinate) {
  const count = { planar: 3, spherical: 4, floating: 7 }[body.by.manifold] || 1;
  return coordinate >= body.by.coordinate && coordinate < body.by.coordinate + count;
}
