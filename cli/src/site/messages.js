// Errors and warnings with the lines of the text that caused them, as an editor shows them.

// The word at a column, counted in characters from 1, with the text before and after it; a value between quotation marks
// is one word.
function wordAt(line, column) {
  const letters = [...line];
  const rest = letters.slice(column - 1).join("");
  const quote = letters[column - 2];
  const value = /["']/.test(quote || "") && rest.includes(quote) ? rest.slice(0, rest.indexOf(quote)) : "";
  const word = value || /^(?:"[^"]*"|[\p{L}\p{N}_.:+-]+|<[\w:]+|.)/u.exec(rest)?.[0] || "";
  return [letters.slice(0, column - 1).join(""), word, rest.slice(word.length)];
}

// A message; `go` is called with its line and column when it is chosen.
function messageOf({ line, column, message, hint }, kind, lines, go) {
  const said = [el("p", { class: "said" }, el("b", {}, kind === "error" ? "Error" : "Warning"), ` ${message}`),
    hint ? el("p", { class: "hint" }, hint) : null];
  const text = line === null ? undefined : lines[line - 1];
  if (text === undefined) return el("div", { class: `message ${kind}` }, said);
  const near = [];
  if (line > 1 && lines[line - 2].trim()) near.push(el("div", { class: "line" }, el("span", { class: "at" }, String(line - 1)), clipped(lines[line - 2])));
  const [before, word, after] = wordAt(text, column);
  near.push(el("div", { class: "line" }, el("span", { class: "at" }, String(line)),
    clipped(before, true), el("button", { type: "button", class: "word", title: `Line ${line}, column ${column}`, onclick: () => go(line, column) }, word || " "), clipped(after)));
  return el("div", { class: `message ${kind}` }, el("div", { class: "lines" }, near), said);
}

// A long line is cut, at its beginning or its end.
const clipped = (text, begins = false) => (text.length <= 120 ? text : begins ? `…${text.slice(-120)}` : `${text.slice(0, 120)}…`);

// The messages of an answer, errors first.
function messagesOf({ errors = [], warnings = [] }, text, go) {
  const lines = text.split(/\r\n|\r|\n/);
  const shown = (list, kind, most) => [
    ...list.slice(0, most).map((one) => messageOf(one, kind, lines, go)),
    list.length > most ? el("p", { class: "small" }, `and ${list.length - most} more`) : null,
  ];
  return [...shown(errors, "error", 20), ...(errors.length ? shown(warnings, "warning", 5) : [])].filter(Boolean);
}
