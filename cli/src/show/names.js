// What a name in generated code says.
//
// In: a name, the table of letters, the robot. Out: the matrix that it is an entry of, with its
// subscripts; or the argument, the angle or the sum that it is. It never looks at the code around it.

// The forms of names, ready to be compared with.
function formsOf(letters) {
  return letters.forms.map((form) => {
    const entries = Object.keys(form.entries).sort((a, b) => b.length - a.length);
    const seen = new Set();
    const pattern = form.form.replace(/\{(\w)\}/g, (_, which) => {
      if (which === "e") return `(?<e>${entries.join("|")})`;
      if (seen.has(which)) return `\\k<${which}>`;
      seen.add(which);
      return `(?<${which}>\\d+)`;
    });
    return { ...form, pattern: new RegExp(`^${pattern}$`) };
  });
}

const ARGUMENTS = {
  q: { letter: "q", space: "coordinates", noun: "Coordinate" },
  qd: { letter: "q̇", space: "velocities", noun: "Velocity" },
  qdd: { letter: "q̈", space: "velocities", noun: "Acceleration" },
  tau: { letter: "τ", space: "velocities", noun: "Force or torque" },
};

const UNITS = {
  q: { turn: "rad", slide: "m", quaternion: "1" },
  qd: { turn: "rad/s", slide: "m/s" },
  qdd: { turn: "rad/s²", slide: "m/s²" },
  tau: { turn: "N m", slide: "N" },
};

// What a name is, of a function of that frame: `kind` says which of the following there is.
function meaning(robot, name, frame) {
  // Underscores behind a name only tell it from another of the same matrix.
  let bare = name.replace(/_+$/, "");
  const negative = bare.startsWith("minus_");
  if (negative) bare = bare.slice("minus_".length);
  for (const form of robot.forms) {
    const found = form.pattern.exec(bare);
    if (found) {
      const { i, k, e } = found.groups;
      return { kind: "entry", negative, form, entry: form.entries[e], i, k, frame };
    }
  }
  let found = /^(q|qd|qdd|tau)_(\d+)$/.exec(bare);
  if (found) {
    const entry = robot.skeleton[ARGUMENTS[found[1]].space][found[2] - 1];
    if (entry) return { kind: "argument", argument: found[1], entry, index: Number(found[2]) };
  }
  found = /^action_(\d+)_([cf][xyz])$/.exec(bare);
  if (found) return { kind: "action", index: Number(found[1]), entry: found[2] };
  found = /^q((?:_\d+){2,})$/.exec(bare);
  if (found) return { kind: "sum", coordinates: numbersOf(found[1]) };
  found = /^([sc])((?:_\d+)+)$/.exec(bare);
  if (found) return { kind: "angle", sine: found[1] === "s", coordinates: numbersOf(found[2]) };
  found = /^([sc])_(.+)$/.exec(bare);
  if (found) return { kind: "angle", sine: found[1] === "s", of: found[2] };
  found = /^t_(\d+)$/.exec(bare);
  if (found) return { kind: "part", index: Number(found[1]) };
  return { kind: "other" };
}

const numbersOf = (text) => text.split("_").filter(Boolean).map(Number);

// A name as the paper would write it, with subscripts.
function written(robot, name) {
  const said = meaning(robot, name);
  const sub = (text) => el("sub", {}, text);
  const sign = said.negative ? "−" : "";
  switch (said.kind) {
    case "entry": {
      if (!said.form.letter) {
        const letter = said.form.form.startsWith("d") ? "d" : "ℓ";
        return el("var", {}, `${sign}${letter}`, sub([said.i, said.k].filter(Boolean).join(",")));
      }
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
      return el("var", {}, said.sine ? "s" : "c", sub(said.coordinates ? said.coordinates.join("+") : said.of));
    case "part":
      return el("var", {}, "t", sub(String(said.index)));
    default:
      return el("code", {}, name);
  }
}

// The subscripts of an entry's matrix: 0,2(2).
const subscript = ({ form, i, k }) => form.subscript.replace("{i}", i).replace("{i}", i).replace("{k}", k);

// Which body a number stands for.
function bodyName(robot, number) {
  if (Number(number) === 0) return `frame 0 (${robot.skeleton.base})`;
  const body = robot.skeleton.bodies[number - 1];
  if (!body) return `link ${number}`;
  return body.link === null ? `body ${number} (beyond ${body.name})` : `link ${number} (${body.link})`;
}

// The sentence of an entry's matrix.
function told(robot, { form, i, k, frame }) {
  const words = { i: bodyName(robot, i), k: k === undefined ? "" : bodyName(robot, k).replace(/^link/, "frame"), 0: bodyName(robot, 0), n: frame };
  if (!form.letter) Object.assign(words, { i: /^Row/.test(form.tells) ? i : words.i, k });
  return form.tells.replace(/\{(\w)\}/g, (_, which) => words[which]);
}

// The bodies that a name is about, by their indices.
function bodiesOf(robot, said) {
  if (said.kind === "entry") return new Set([said.i, said.k].filter((number) => Number(number) > 0).map((number) => number - 1));
  const of = (coordinate) => robot.skeleton.bodies.flatMap((body, k) => (body.by && carries(robot, body, coordinate - 1) ? [k] : []));
  if (said.kind === "argument") {
    if (said.argument === "q") return new Set(of(said.index));
    return new Set(robot.skeleton.bodies.flatMap((body, k) => (body.velocity === said.index - 1 ? [k] : [])));
  }
  if (said.coordinates) return new Set(said.coordinates.flatMap(of));
  return new Set();
}

// Whether a coordinate moves a body by itself.
function carries(robot, body, coordinate) {
  const count = { planar: 3, spherical: 4, floating: 7 }[body.by.posture] || 1;
  return coordinate >= body.by.coordinate && coordinate < body.by.coordinate + count;
}
