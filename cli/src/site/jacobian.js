// The Jacobian of the chosen frame: as a table, with manipulability, singular values and their directions.

// Names of the rows: of an angular and of a linear velocity in the axes of frame 0.
const SIX = ["ωx", "ωy", "ωz", "vx", "vy", "vz"];

// Share of the largest singular value below which a direction counts as singular.
const NEARLY = 0.01;

// Size of the ellipsoid, in the size of the robot.
const OF_REACH = 0.22;

// The section; `draw` takes the axes of an ellipsoid. `show` takes the name of a link and the rows of its Jacobian.
function jacobianSection(data, reach, draw) {
  const { velocities } = data.skeleton;
  const box = el("div", { class: "doings", id: "jacobian" });
  const ellipsoid = el("input", { type: "checkbox", id: "ellipsoid", onchange: () => paint() });
  ellipsoid.checked = true;
  let axes = null;
  const paint = () => draw(ellipsoid.checked ? axes : null);
  const section = el("details", { class: "part", open: true },
    el("summary", {}, el("h3", {}, "Jacobian")), box,
    el("p", { class: "note" }, el("label", {}, ellipsoid, " Draw the ellipsoid of its linear velocities for q̇ of length 1; directions in which it hardly moves are dashed.")));
  const show = (name, rows) => {
    const moving = velocities.flatMap((entry, k) => (rows.some((row) => row[k] !== 0) ? [{ entry, k }] : []));
    const columns = rows.map((row) => moving.map(({ k }) => row[k]));
    const [linear, all] = [singular(columns.slice(3)), singular(columns)];
    const largest = linear[0].value;
    const isSingular = ({ value }) => !(value > NEARLY * largest);
    axes = largest > 0 ? linear.map((one) => ({
      direction: one.direction, length: (OF_REACH * reach * one.value) / largest, singular: isSingular(one), mark: OF_REACH * reach,
    })) : null;
    paint();
    const number = (value) => el("span", { title: String(value) }, value.toFixed(4).replace(/^-(0\.0*)$/, "$1").replace("-", "−"));
    box.replaceChildren(
      el("p", {}, "Velocity of ", named(name), ", about its origin and in the axes of frame 0, for each q̇.", moving.length < velocities.length ? " Joints that do not move it are left out." : null),
      table("The Jacobian", ["joint", ...SIX], moving.map(({ entry }, k) => [named(entry.name), ...columns.map((row) => number(row[k]))]), [1, 2, 3, 4, 5, 6]),
      table("Manipulability", ["", "manipulability", "", "singular values"], [
        measured("linear", linear, moving.length), measured("all six", all, moving.length)], [1]),
      table("Singular directions", ["σ of v", "direction in frame 0", ""], linear.map((one) => [
        number(one.value), one.direction.map((entry) => entry.toFixed(3).replace("-", "−")).join(", "), isSingular(one) ? el("b", {}, "singular") : null]), [0]));
  };
  return { section, show };
}

// Manipulability, the volume of the ellipsoid of velocities: the product of the singular values. With fewer joints than
// rows J Jᵗ is singular, and the product is that of Jᵗ J.
function measured(what, found, joints) {
  const values = found.slice(0, Math.max(1, Math.min(joints, found.length))).map(({ value }) => value);
  const volume = values.reduce((product, value) => product * value, 1);
  return [what, el("output", { "data-value": String(volume) }, short(volume, 5)), joints < found.length ? "√det(Jᵗ J)" : "√det(J Jᵗ)", values.map((value) => short(value, 4)).join(", ")];
}
