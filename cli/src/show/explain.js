// The panel about the selected name: its matrix and entry, links and frames, the equation of the paper, its definition,
// its present value, and the names that read it.

// Maximum number of operations of a value that is written out.
const LONG = 14;

// A value as a formula; short parts without a name of their own are written out.
function mathematics(robot, open, own) {
  const { analysis, helpers } = open;
  let left = LONG;
  const strength = { add: 1, sub: 1, neg: 2, mul: 2, div: 2, mul_add: 1 };
  const show = (value, least) => {
    if (value === null) return [];
    if ("number" in value) return [value.number < 0 ? "−" : "", String(Math.abs(value.number))];
    if ("name" in value) {
      const inner = analysis.names.get(value.name);
      if (inner && left > 0 && meaning(robot, open, value.name).kind === "part") {
        left -= 1;
        return show(tree(analysis.tokens, inner.from, inner.to, helpers), least);
      }
      return [nameButton(robot, open, value.name)];
    }
    const [a, b, c] = value.of;
    const bracket = (parts) => ((strength[value.call] || 3) < least ? ["(", parts, ")"] : parts);
    switch (value.call) {
      case "add": return bracket([show(a, 1), " + ", show(b, 1)]);
      case "sub": return bracket([show(a, 1), " − ", show(b, 2)]);
      case "mul": return bracket([show(a, 2), "\u2009·\u2009", show(b, 2)]);
      case "div": return bracket([show(a, 2), "\u2009/\u2009", show(b, 3)]);
      case "neg": return bracket(["−", show(a, 2)]);
      case "mul_add": {
        // a b − c reads better than a b + −c.
        const turned = c.call === "neg" ? c.of[0] : c.number < 0 ? { number: -c.number } : null;
        return bracket([show(a, 2), "\u2009·\u2009", show(b, 2), turned ? " − " : " + ", show(turned || c, turned ? 2 : 1)]);
      }
      case "entry": return [show(a, 3), value.of.slice(1).map((index) => ["[", show(index, 0), "]"])];
      case "sqrt": return ["√(", show(a, 0), ")"];
      default: return [value.call, "(", value.of.map((part, k) => [k ? ", " : "", show(part, 0)]), ")"];
    }
  };
  try {
    return show(tree(analysis.tokens, own.from, own.to, helpers), 0);
  } catch {
    return [analysis.tokens.slice(own.from, own.to).join("")];
  }
}

// A name as a button that points at it.
const nameButton = (robot, open, name) =>
  el("button", { type: "button", class: "reference", "data-name": name, title: name }, written(robot, open, name));

// The entries of a matrix, with one marked.
function grid(matrix, entry) {
  const isMeant = (cell) => cell.split(" ").some((part) => part.replace("−", "") === entry);
  const text = (cell) => {
    const parts = cell.split(/(_[a-z]+)/);
    return parts.map((part) => (part.startsWith("_") ? el("sub", {}, part.slice(1)) : part));
  };
  return el("div", { class: "matrix", "aria-hidden": "true" },
    matrix.cells.map((cell) => el("span", { class: isMeant(cell) ? "meant" : null }, text(cell))));
}

// The meaning of a name in a sentence or two, and the matrix that it is an entry of.
function saying(robot, open, said, owner) {
  const coordinates = (numbers) => numbers.map((k) => robot.skeleton.coordinates[k - 1]?.name || k).join(", ");
  switch (said.kind) {
    case "entry": {
      const matrix = robot.letters.matrices[said.form.letter];
      const what = matrix ? `An entry of the ${matrix.noun} matrix${said.negative ? ", with the other sign" : ""}. ` : said.negative ? "With the other sign. " : "";
      return [what + described(robot, said)];
    }
    case "argument": {
      const { noun, letter } = ARGUMENTS[said.argument];
      const unit = UNITS[said.argument][said.entry.kind];
      return [`${noun} ${letter} of `, named(said.entry.name), `, number ${said.index}${unit === "1" ? "" : `, in ${unit}`}: an argument.`];
    }
    case "action":
      return [`Entry ${said.entry} of external wrench ${said.index}: an argument.`];
    case "sum":
      return ["The sum of the coordinates ", named(coordinates(said.coordinates)), ", whose axes are parallel."];
    case "angle": {
      const noun = said.sine ? "Sine" : "Cosine";
      if (!said.coordinates.length) return [`${noun} of `, nameButton(robot, open, said.of), "."];
      return [`${noun} of ${said.coordinates.length > 1 ? "the sum of the coordinates" : "the coordinate"} `, named(coordinates(said.coordinates)), "."];
    }
    case "part":
      return ["A part of a sum that has no name of its own."];
    case "table":
      return ["A table: each iteration of the loop below reads a column and replaces it by results."];
    case "loop":
      return ["Counts the columns, from 0."];
    default:
      if (owner === "constant") return ["Makes a number of the description one of the type T."];
      if (owner === "mul_add") return ["a · b + c, rounded once where the processor can."];
      return ["A list whose entries are named below."];
  }
}

// The panel for a name of an open function.
function explanation(robot, open, name, given) {
  const { analysis, helpers } = open;
  const own = analysis.names.get(name);
  const said = meaning(robot, open, name);
  const isNumber = (one) => NUMBERS.includes(meaning(robot, open, one).kind);
  const helper = helpers.get(name);
  const matrix = said.kind === "entry" ? robot.letters.matrices[said.form.letter] : undefined;
  const computed = own && ["entry", "part", "sum"].includes(said.kind);
  const readers = own ? [...own.readers] : [];
  const shown = readers.filter((reader) => reader !== "" && isNumber(reader));
  const list = shown.slice(0, 24).map((reader) => [nameButton(robot, open, reader), " "]);
  if (shown.length > 24) list.push(`and ${shown.length - 24} more`);
  if (readers.includes("")) list.push(shown.length ? "and the result" : "the result");
  // Values of a configuration are kept for the next name.
  if (open.given !== given) Object.assign(open, { given, worth: worth(open, given) });
  const value = !helper && isNumber(name) ? open.worth(name) : NaN;
  return [
    el("header", {},
      el("h2", {}, written(robot, open, name)),
      el("code", {}, name),
      el("button", { type: "button", id: "unpin", title: "Close (Escape)", "aria-label": "Close" }, "×")),
    el("p", { class: "saying" }, saying(robot, open, said, helper)),
    matrix ? el("p", { class: "equation" }, matrix.is, el("br"), el("span", {}, matrix.moves)) : null,
    matrix ? grid(matrix, said.entry) : null,
    el("dl", {},
      computed ? [el("dt", {}, "is"), el("dd", { class: "mathematics" }, mathematics(robot, open, own))] : null,
      Number.isFinite(value) ? [el("dt", {}, "now"), el("dd", {}, el("output", { id: "worth", "data-value": String(value) }, short(value, 6)),
        el("small", {}, " with the joints where they are", open.moves ? (given.qd.some(Boolean) ? ", moving" : ", at rest") : null,
          own?.loop ? ", in the first column" : null))] : null,
      own ? [el("dt", {}, "line"), el("dd", {}, el("button", { type: "button", class: "reference", "data-name": name, "data-go": "1" }, String(analysis.lines[own.at] + 1)))] : null,
      list.length ? [el("dt", {}, "read by"), el("dd", {}, list)] : null),
  ];
}

// The text before a name is selected.
const invitation = () => [
  el("p", { class: "hint" }, "Open a function and point at a name in its code: this panel shows its matrix of the paper, its frame, its value, and the names that read it."),
];
