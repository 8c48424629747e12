// The summary of the description, as in `homogen check`, and the letters.

// Joints and links, with all changes.
function readSection(data) {
  const { report, skeleton } = data;
  const followers = new Map(report.mimicked.map((mimic) => [mimic.joint, mimic]));
  const joints = report.details.joints.map((joint) => {
    const follows = followers.get(joint.name);
    const is = (entry) => !follows && entry.joint === joint.name;
    const first = skeleton.coordinates.findIndex(is);
    const own = skeleton.coordinates.filter(is);
    const { unit, range } = own.length === 1 ? own[0] : { unit: "", range: null };
    const rate = joint.limits && own.length === 1 ? joint.limits.velocity : null;
    const several = () => [`${first + 1} to ${first + own.length}: `, own.map((entry) => entry.name.slice(joint.name.length + 1)).join(", ")];
    return [
      named(joint.name),
      el("span", { class: "kind", "data-kind": joint.kind }, joint.kind),
      [named(joint.parent), " → ", named(joint.child)],
      follows ? [`${short(follows.multiplier)} × `, named(follows.of), follows.offset ? ` + ${short(follows.offset)}` : null]
        : own.length === 1 ? String(first + 1) : several(),
      range ? `${short(range[0])} … ${short(range[1])} ${unit}` : "—",
      rate ? `${short(rate)} ${unit}/s` : "—",
      `${short(joint.mass)}`,
    ];
  });
  const into = new Map(report.merged.map(({ link, into: carrier }) => [link, carrier]));
  const links = skeleton.links.map((link) => [
    named(link.name),
    link.name === skeleton.base ? "the base, frame 0" : into.has(link.name) ? ["merged into ", named(into.get(link.name))]
      : link.body === null ? "fixed to the base" : `link ${link.body + 1}`,
    link.mass === null ? "—" : short(link.mass),
    link.center ? link.center.map((entry) => short(entry, 3)).join(", ") : "—",
  ]);
  const total = skeleton.links.reduce((sum, link) => sum + (link.mass || 0), 0);
  return [
    el("h2", { id: "read-title" }, "What was read"),
    el("p", {}, data.facts.map((fact) => fact[0].toUpperCase() + fact.slice(1)).join(". "), "."),
    data.formulation.length ? el("p", {}, "Formulation: ", el("code", {}, data.formulation.join(", ")), ".") : null,
    table("Joints", ["joint", "kind", "from → to", "q", "limits", "rate", "mass / kg"], joints, [6]),
    table("Links", ["link", "is", "mass / kg", "centre of mass / m"], links, [2]),
    el("p", { class: "small" }, `${counted(skeleton.links.length, "link")}, ${short(total)} kg together. Centres of mass are in the frame of each link; the mass of a joint is that of the body that it carries, with all that is fixed to it.`,
      report.file ? [" The hash (FNV-1a) of ", named(report.file), ` is ${report.details.hash}.`] : null),
    doings(report),
  ];
}

// A list, if it is not empty.
const noted = (title, items, show) => items && items.length
  ? [el("h3", {}, title, " ", el("small", {}, String(items.length))), el("ul", {}, items.map((item) => el("li", {}, show(item))))] : null;

// Multiples of π/2 as text.
function turnsOf(quarters) {
  const sign = quarters < 0 ? "−" : "";
  const size = Math.abs(quarters);
  if (size === 0) return "0";
  const count = size % 2 ? size : size / 2;
  return `${sign}${count === 1 ? "" : `${count} `}π${size % 2 ? "/2" : ""}`;
}

const spot = ({ line, column }) => (line === null ? null : el("small", { class: "spot" }, `line ${line}:${column} `));

function doings(report) {
  const lists = [
    noted("Warnings", report.warnings, (warning) => [spot(warning), warning.message, warning.hint ? el("small", {}, ` — ${warning.hint}`) : null]),
    noted("Merged", report.merged, ({ link, into }) => [named(link), " into ", named(into)]),
    noted("Locked", report.locked, ({ joint, q }) => [named(joint), ` at ${short(q)}`]),
    noted("Left out", report.dropped, (link) => named(link)),
    noted("Mimic joints", report.mimicked, ({ joint, of, multiplier, offset }) => [named(joint), ` is ${short(multiplier)} × `, named(of), offset ? ` + ${short(offset)}` : null]),
    noted("Read as right angles or zero", report.snapped, (angle) => [spot(angle), `${angle.written} of `, named(angle.item), ` is ${turnsOf(angle.quarter_turns)}`]),
    noted("Read as rotations by right angles", report.turned, (turned) => [spot(turned), `${turned.written.join(" ")} of `, named(turned.item), ` is ${turned.meant.join(" ")}`]),
    noted("Loops", report.loops, ({ name, kind, from, to }) => [named(name), `: ${kind}, holds `, named(from), " and ", named(to), " together"]),
    noted("Constraints that hold in every configuration", report.closed, (name) => named(name)),
  ].filter(Boolean);
  const nothing = el("p", {}, "Nothing was merged, locked or left out, and there are no warnings.");
  return el("div", { class: "doings" }, lists.length ? lists.map((list) => el("div", {}, list)) : nothing);
}

// The letters of the paper, with their equations.
function letterSection(letters) {
  const cards = Object.entries(letters.matrices).map(([letter, matrix]) =>
    el("div", { class: "letter" },
      el("h3", {}, el("var", {}, el("b", {}, letter)), " ", matrix.noun),
      grid(matrix, ""),
      el("p", { class: "equation" }, matrix.is, el("br"), el("span", {}, matrix.moves))));
  return [
    el("h2", { id: "letters-title" }, "Letters"),
    el("p", {}, "Names in the code are entries of these matrices, with the subscripts of the paper: ",
      el("code", {}, "w_0_3_in_2_z"), " is ω", el("sub", {}, "z"), " of W", el("sub", {}, "0,3(2)"),
      ", the motion of link 3 as seen from frame 0, written in frame 2: along its axes, with its origin as the pole. An underlined vector is its skew-symmetric matrix. ",
      "Numbers in parentheses are equations of G. Legnani, F. Casolo, P. Righettini, B. Zappa, “A homogeneous matrix approach to 3D kinematics and dynamics”, Mechanism and Machine Theory 31, 1996."),
    el("div", { class: "cards" }, cards),
  ];
}
