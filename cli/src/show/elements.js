// Elements of the page. Texts of the robot become text nodes: no string is parsed as HTML.

// The element with an id.
const by = (id) => document.getElementById(id);

// An element with properties (`class`, `data-…`, `aria-…`, handlers such as `onclick`) and children, which are elements
// or texts; null is skipped.
function el(name, properties = {}, ...children) {
  const element = document.createElement(name);
  for (const [key, value] of Object.entries(properties)) {
    if (value === null || value === undefined || value === false) continue;
    if (key.startsWith("on")) element.addEventListener(key.slice(2), value);
    else if (key === "value") element.value = value;
    else element.setAttribute(key, value === true ? "" : value);
  }
  element.append(...children.flat(Infinity).filter((child) => child !== null && child !== undefined));
  return element;
}

// A table: heads of columns, and rows of cells. The columns in `numbers` are aligned right.
function table(caption, heads, rows, numbers = []) {
  const cell = (kind) => (content, column) =>
    el(kind, { class: numbers.includes(column) ? "number" : null, scope: kind === "th" ? "col" : null }, content);
  return el("div", { class: "table", tabindex: "0", role: "region", "aria-label": caption },
    el("table", {},
      el("thead", {}, el("tr", {}, heads.map(cell("th")))),
      el("tbody", {}, rows.map((row) => el("tr", {}, row.map(cell("td")))))));
}

// A name of the robot.
const named = (text) => el("span", { class: "name" }, text);

// A number with few digits.
function short(value, digits = 4) {
  if (value === null || value === undefined) return "—";
  if (value === 0) return "0";
  const size = Math.abs(value);
  const text = size >= 1e5 || size < 1e-3 ? value.toExponential(digits - 2) : String(Number(value.toPrecision(digits)));
  return text.replace("-", "−").replace(/e[-−]/, "e−").replace("e+", "e");
}

// `1 link`, `3 links`.
const counted = (number, one, many = one + "s") => `${number} ${number === 1 ? one : many}`;

// A number in groups of three digits.
const grouped = (number) => String(number).replace(/\B(?=(\d{3})+$)/g, "\u202f");
