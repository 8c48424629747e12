// The section of functions: sentence, operation count, error bound, code. Code is unpacked when a function is opened,
// and put on the page in portions of lines.

// Number of lines that are put on the page at once.
const PAGE = 160;

// A bound with two digits.
const bound = (value) => (value === null || value === undefined ? "—" : value === 0 ? "0" : value.toExponential(1).replace("e-", "e−").replace("e+", "e"));

// The largest bound of a function in a type, with units.
function worst(errors, type) {
  const parts = errors.filter((error) => error[type]).flatMap((error) =>
    Object.entries(error[type]).filter(([, value]) => value !== null).map(([unit, value]) => `${bound(value)}${unit === "1" ? "" : ` ${unit}`}`));
  return parts.length ? parts.join(", ") : null;
}

const OF = {
  results: "", diagonal: "beside the diagonal entries, at most", tau: "as if τ were off by at most", M: "each column exact for an M of its own, off by at most",
  "unit forces": "each column exact for a unit force, off by at most", "tau derivatives": "as if the derivatives of τ were off by at most",
};

// The bounds of a function for each joint; `medians` are errors of f32 that were measured, one for each result, or null.
function errorsOf(errors, medians) {
  return errors.map((error) => {
    if (error.unknown) return el("p", { class: "small" }, `Error: no bound: ${error.unknown}.`);
    const about = [error.range ? `For ${error.range}.` : null, error.lacks ? `No bound: ${error.lacks}.` : null].filter(Boolean).join(" ");
    const measured = error.of === "results" && medians?.length === error.joints.length ? medians : null;
    const rows = error.joints.map((one, k) => [one.joint === null ? "the result" : named(one.joint), one.unit, bound(one.f64), bound(one.f32), ...(measured ? [bound(measured[k])] : [])]);
    return [
      el("h4", {}, "Error, proved: ", OF[error.of] || "at most"),
      table("Error bounds", ["of", "unit", "in f64", "in f32", ...(measured ? ["in f32, measured"] : [])], rows, [2, 3, 4]),
      measured ? el("p", { class: "small" }, "Bounds hold for every configuration in the range. Measured is the median of the errors at 64 random configurations with velocities and accelerations up to 1.") : null,
      about ? el("p", { class: "small" }, about) : null,
    ];
  });
}

const COUNTS = [["mul", "products"], ["add", "sums"], ["div", "quotients"], ["sqrt", "roots"], ["sin", "sines"], ["cos", "cosines"],
  ["sign", "signs"], ["neg", "changes of sign"], ["fused", "fused multiply-adds possible"], ["depth", "operations in the longest dependent chain"], ["literals", "literals"], ["cycles", "cycles by the model of the processor"]];

function countOf(count) {
  const parts = COUNTS.filter(([key]) => count[key]).map(([key, noun]) => [el("b", {}, grouped(count[key])), ` ${noun}`]);
  const dense = count.naive.mul + count.naive.add;
  return el("p", { class: "count" },
    parts.map((part, k) => [k ? el("span", { class: "dot" }, " · ") : null, part]), ".",
    dense ? [" With dense 4×4 products: ", el("b", {}, grouped(count.naive.mul)), " products, ", el("b", {}, grouped(count.naive.add)), " sums."] : null);
}

// The lines of a function's code, put on the page when needed.
class Lines {
  constructor(robot, open, element) {
    Object.assign(this, { robot, open, element, next: 0, spots: new Map(), order: [] });
    const { tokens, lines } = open.analysis;
    this.starts = [0];
    for (let k = 1; k < tokens.length; k += 1) if (lines[k] !== lines[k - 1]) this.starts[lines[k]] = k;
    // Several lines may end in one token of white space.
    for (let line = lines[lines.length - 1]; line >= 0; line -= 1) this.starts[line] ??= this.starts[line + 1];
    this.total = lines[lines.length - 1] + 1;
    this.more();
  }

  // Puts the next lines on the page, at least up to `line`.
  more(wanted = 0) {
    const { analysis } = this.open;
    while (this.next < this.total && this.next <= wanted + PAGE) {
      const chunk = el("div", { class: "chunk" });
      const end = Math.min(this.next + PAGE, this.total);
      const [from, to] = [this.starts[this.next], end < this.total ? this.starts[end] : analysis.tokens.length];
      for (let k = from; k < to; k += 1) chunk.append(this.piece(analysis.tokens[k], k));
      this.element.append(chunk);
      this.next = end;
      if (wanted === 0) break;
    }
  }

  piece(token, k) {
    const { names } = this.open.analysis;
    const own = names.get(token);
    if (own && this.open.analysis.tokens[k - 1] !== "::") {
      const spot = el("span", { class: own.at === k ? "n d" : "n", "data-n": token }, token);
      if (!this.spots.has(token)) this.spots.set(token, []);
      this.spots.get(token).push(spot);
      this.order.push(spot);
      return spot;
    }
    if (/^(let|pub|fn|as|mut)$/.test(token)) return el("span", { class: "w" }, token);
    if (/^\d/.test(token)) return el("span", { class: "c" }, token);
    if (/^#|^\/\//.test(token)) return el("span", { class: "q" }, token);
    return document.createTextNode(token);
  }

  // Marks a name at each occurrence, and the names that read it at their definitions.
  mark(name) {
    for (const spot of this.marked || []) spot.classList.remove("same", "reader", "read");
    this.marked = [];
    const add = (of, kind, only) => {
      for (const spot of this.spots.get(of) || []) {
        if (only && !spot.classList.contains("d")) continue;
        spot.classList.add(kind);
        this.marked.push(spot);
      }
    };
    const own = this.open.analysis.names.get(name);
    if (!own) return;
    add(name, "same");
    for (const reader of own.readers) if (reader !== name) add(reader, "reader", true);
    for (const read of own.reads) add(read, "read", true);
  }

  // Scrolls to the definition of a name.
  go(name) {
    const own = this.open.analysis.names.get(name);
    if (!own) return null;
    this.more(this.open.analysis.lines[own.at] + 1);
    const spot = (this.spots.get(name) || []).find((one) => one.classList.contains("d"));
    if (spot) spot.scrollIntoView({ block: "center", behavior: "smooth" });
    return spot;
  }
}

// The section. `point` is called with the open function, the selected name, and true if it stays selected; `complete`
// resolves to a function with its count, `explain` to one with its code, `measure` to errors that were measured, or null.
// `fill` shows the count of a function that has been completed.
function functionSection(robot, data, point, { complete, explain, measure }) {
  const all = data.functions;
  const cards = new Map(all.map((own) => [own, functionCard(robot, own, point, { complete, explain, measure })]));
  const fill = (...some) => {
    const most = Math.max(...all.map(({ count }) => (count ? count.mul + count.add : 0)), 1);
    for (const own of some) if (own.count || own.left_out) cards.get(own).fill();
    for (const { bar } of cards.values()) bar(most);
  };
  fill(...all);
  const processed = all.some(({ count }) => count?.cycles);
  const lacking = data.left_out.map(({ functions, reason, hint }) =>
    el("li", {}, functions.map((name, k) => [k ? ", " : "", el("code", {}, name)]), ": ", reason, hint ? el("small", {}, ` — ${hint}`) : null));
  const section = [
    el("h2", { id: "functions-title" }, "Functions ", el("small", {}, String(all.length))),
    el("p", {}, "Operations are counted in the code shown; the last column is their share of what dense 4×4 products need. ",
      processed ? "Cycles are those of the processor's model, without sines and cosines; nothing was timed." : "No times are shown: they need a compiler and your machine. Where a processor is named, cycles by its model stand beside."),
    el("div", { class: "heads", "aria-hidden": "true" }, el("span", {}, "function"), el("span", {}, "mul"), el("span", {}, "add"), el("span", {}, "of dense")),
    el("div", { class: "cards-of-functions" }, [...cards.values()].map(({ card }) => card)),
    lacking.length ? [el("h3", {}, "Not available"), el("ul", {}, lacking)] : null,
  ];
  return { section, fill };
}

function functionCard(robot, own, point, { complete, explain, measure }) {
  const inside = el("div", { class: "inside" });
  const bar = el("span", { class: "bar" });
  const number = (title) => el("span", { class: "number", title }, "…");
  const [products, sums, ofDense] = [number("products"), number("sums"), number("of the operations of dense 4×4 products")];
  const before = el("small", { class: "before" }, own.waits ? "takes long, and is generated when it is opened" : null);
  const card = el("details", { class: "function", "data-function": own.name },
    el("summary", {},
      el("span", { class: "what" }, el("code", {}, own.name), el("span", { class: "sentence" }, own.sentence), before, bar), products, sums, ofDense),
    inside);
  const fill = () => {
    const { count } = own;
    for (const one of [products, sums, ofDense]) one.textContent = "—";
    card.classList.toggle("lacking", !count);
    if (!count) return;
    const dense = count.naive.mul + count.naive.add;
    const share = dense ? (100 * (count.mul + count.add)) / dense : null;
    products.textContent = grouped(count.mul);
    sums.textContent = grouped(count.add);
    // Counts with the options before.
    const { mul, add } = own.before || count;
    before.textContent = mul === count.mul && add === count.add ? "" : `before: ${grouped(mul)} mul, ${grouped(add)} add`;
    if (share !== null) ofDense.textContent = `${share < 9.95 ? share.toFixed(1) : share.toFixed(0)} %`;
  };
  card.addEventListener("toggle", async () => {
    if (!card.open || inside.childElementCount) return;
    inside.append(el("p", { class: "small" }, "…"));
    await complete(own);
    if (!own.count) {
      inside.replaceChildren(...own.left_out.map(({ reason, hint }) => el("p", {}, reason, hint ? el("small", {}, ` — ${hint}`) : null)));
      return;
    }
    const medians = await measure(own);
    inside.replaceChildren(countOf(own.count), ...[errorsOf(own.count.errors, medians)].flat(Infinity).filter(Boolean));
    const error = worst(own.count.errors, "f64");
    if (error) inside.querySelector("h4")?.append(el("span", { class: "worst" }, ` ${error}`));
    openCode(robot, await explain(own), inside, point);
  });
  // The bar is relative to the most expensive function.
  const scale = (most) => { if (own.count) bar.style.width = `${Math.max(0.6, (100 * (own.count.mul + own.count.add)) / most)}%`; };
  return { card, fill, bar: scale };
}

// A function on the page: its text, doc comment, parts of the code, meanings of names, and its frame.
async function opened(robot, own) {
  const [text, names] = await Promise.all([unpacked(own.code), unpacked(own.names)]);
  const { said, code } = parted(text);
  const meanings = new Map(Object.entries(JSON.parse(names)));
  const analysis = analysed(code, meanings);
  return { own, text, said, analysis, names: meanings, helpers: helpersOf(analysis), of: own.of || robot.tip || "", moves: own.arguments.includes("qd") };
}

// Puts the code of a function on the page.
async function openCode(robot, own, inside, point) {
  const open = await opened(robot, own);
  const { text, said } = open;
  const box = el("pre", { class: "code", tabindex: "0", role: "group", "aria-label": `The code of ${own.name}. Left and right go from name to name, up and down from line to line, Enter to where a name is defined.` });
  const copy = el("button", { type: "button", onclick: async () => {
    // A browser may refuse the clipboard to a file.
    const copied = await navigator.clipboard?.writeText(text).then(() => true, () => false);
    copy.textContent = copied ? "Copied" : "No clipboard";
    setTimeout(() => { copy.textContent = "Copy"; }, 1500);
  } }, "Copy");
  inside.append(
    el("div", { class: "title" }, el("h4", {}, "Code, as it is printed"), el("div", { class: "buttons" }, el("small", {}, `${grouped(own.lines)} lines`), copy)),
    el("details", { class: "small comment" }, el("summary", {}, "Its doc comment"), el("p", {}, said.map((line) => [line, el("br")]))),
    box);
  open.lines = new Lines(robot, open, box);
  box.addEventListener("scroll", () => {
    if (box.scrollTop + box.clientHeight > box.scrollHeight - 600) open.lines.more(open.lines.next);
  }, { passive: true });
  const nameAt = (event) => event.target.closest?.("[data-n]");
  box.addEventListener("mouseover", (event) => {
    const spot = nameAt(event);
    if (spot) point(open, spot.dataset.n, false);
  });
  box.addEventListener("click", (event) => {
    const spot = nameAt(event);
    if (spot) point(open, spot.dataset.n, true);
  });
  walkByKeys(box, open, point);
}

// Connects keys to the names.
function walkByKeys(box, open, point) {
  let current = null;
  const { lines } = open;
  const choose = (spot) => {
    current?.classList.remove("current");
    current = spot;
    current.classList.add("current");
    current.scrollIntoView({ block: "nearest", inline: "nearest" });
    point(open, current.dataset.n, true);
  };
  const step = (by) => {
    if (!lines.order.length) return;
    const at = current ? lines.order.indexOf(current) : by > 0 ? -1 : 0;
    if (at + by >= lines.order.length) lines.more(lines.next);
    const to = Math.max(0, Math.min(at + by, lines.order.length - 1));
    choose(lines.order[to]);
  };
  // The nearest definition above or below.
  const line = (by) => {
    let at = (current ? lines.order.indexOf(current) : -1) + by;
    while (lines.order[at] && !lines.order[at].classList.contains("d")) at += by;
    if (lines.order[at]) choose(lines.order[at]);
    else if (by > 0) lines.more(lines.next);
  };
  const keys = { ArrowRight: () => step(1), ArrowLeft: () => step(-1), ArrowDown: () => line(1), ArrowUp: () => line(-1),
    Enter: () => { const spot = current && lines.go(current.dataset.n); if (spot) choose(spot); } };
  box.addEventListener("keydown", (event) => {
    const move = keys[event.key];
    if (!move || event.ctrlKey || event.metaKey || event.altKey) return;
    event.preventDefault();
    move();
  });
  box.addEventListener("focus", () => { if (!current && box.matches(":focus-visible")) step(1); });
}
