// Structure of generated code: definitions and uses of names, and their values.
//
// Parses the text of a function: only the constructs that the engine prints (`let`, blocks, loops, operations, stored
// entries). The text is not changed.

const TOKEN = /\/\/[^\n]*|[\p{L}_][\p{L}\p{N}_]*|\d[\d._]*(?:e[-+]?\d+)?(?:_?f(?:32|64))?|\s+|::|->|./gu;

// The doc comment of a function, line by line, and the rest of its text.
function parted(text) {
  const lines = text.split("\n");
  const end = lines.findIndex((line) => !line.startsWith("///"));
  const said = lines.slice(0, end).map((line) => line.replace(/^\/\/\/ ?/, ""));
  return { said, code: lines.slice(end).join("\n").replace(/\n+$/, "") };
}

// The unpacked text of a function.
async function unpacked(packed) {
  const bytes = Uint8Array.from(atob(packed), (letter) => letter.charCodeAt(0));
  const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream("deflate-raw"));
  return new Response(stream).text();
}

// The tokens of a text, with their lines, and its names: for each the token that defines it, the tokens of its value,
// the names whose values read it, and true if a loop changes it in each iteration.
function analysed(code, meanings) {
  const tokens = code.match(TOKEN) || [];
  const names = new Map();
  const lines = [];
  let line = 0;
  for (const token of tokens) {
    lines.push(line);
    line += token.split("\n").length - 1;
  }
  const isName = (k) => /^[\p{L}_]/u.test(tokens[k]) && tokens[k] !== "_" && tokens[k] !== "mut";
  const opens = "([{";
  const closes = ")]}";
  // The next token at this depth that is one of those, from k on.
  const find = (k, wanted, end) => {
    let depth = 0;
    for (let at = k; at < end; at += 1) {
      const token = tokens[at];
      if (depth === 0 && wanted.includes(token)) return at;
      if (token.length === 1 && opens.includes(token)) depth += 1;
      if (token.length === 1 && closes.includes(token)) depth -= 1;
    }
    return end;
  };
  const skip = (k) => {
    let at = k;
    while (at < tokens.length && /^\s/.test(tokens[at])) at += 1;
    return at;
  };
  let loop = false;
  const define = (defined, at, from, to) => {
    if (!names.has(defined)) names.set(defined, { name: defined, at, from, to, loop, readers: new Set(), reads: new Set() });
  };
  const stores = [];
  const statements = (from, to) => {
    let k = skip(from);
    while (k < to) {
      // An attribute.
      if (tokens[k] === "#") {
        k = skip(find(find(k, "[", to) + 1, "]", to) + 1);
        continue;
      }
      if (tokens[k] === "for") {
        const [count, open] = [skip(k + 1), find(k, "{", to)];
        const close = find(open + 1, "}", to);
        const first = skip(tokens.indexOf("in", count) + 1);
        loop = true;
        define(tokens[count], count, first, first + 1);
        statements(open + 1, close);
        loop = false;
        k = skip(close + 1);
        continue;
      }
      // A block without a value, which only stores entries.
      if (tokens[k] === "{") {
        const close = find(k + 1, "}", to);
        statements(k + 1, close);
        k = skip(close + 1);
        continue;
      }
      if (tokens[k] !== "let") {
        const end = find(k, ";", to);
        if (end === to) break;
        stores.push([k, end]);
        k = skip(end + 1);
        continue;
      }
      const equal = find(k, "=", to);
      const end = find(equal + 1, ";", to);
      const value = skip(equal + 1);
      // Names returned by a block are defined in it.
      if (tokens[value] === "{") {
        statements(value + 1, find(value + 1, "}", to));
      } else {
        for (let at = k + 1; at < equal; at += 1) if (isName(at)) define(tokens[at], at, value, end);
      }
      k = skip(end + 1);
    }
    // The names that remain.
    return k;
  };
  const result = statements(find(0, "{", tokens.length) + 1, tokens.length - 1);
  for (const own of names.values()) {
    const link = (read) => {
      read.readers.add(own.name);
      own.reads.add(read.name);
    };
    // Sines and cosines are defined in pairs; each is that of its own angle.
    const said = meanings.get(own.name);
    const of = said?.kind === "angle" && names.get(said.of);
    if (of) {
      link(of);
      continue;
    }
    for (let at = own.from; at < own.to; at += 1) {
      const read = names.get(tokens[at]);
      if (read && tokens[at - 1] !== "::") link(read);
    }
  }
  // The result has no name.
  for (const [from, to] of [...stores, [result, tokens.length]]) {
    for (let at = from; at < to; at += 1) names.get(tokens[at])?.readers.add("");
  }
  return { tokens, lines, names };
}

// A value as a tree: { number }, { name }, { call, of: […] }.
function tree(tokens, from, to, helpers) {
  const own = [];
  for (let k = from; k < to; k += 1) if (!/^\s/.test(tokens[k])) own.push(tokens[k]);
  let at = 0;
  const list = () => {
    const items = [];
    at += 1;
    while (at < own.length && own[at] !== ")" && own[at] !== "]") {
      items.push(sum());
      if (own[at] === ",") at += 1;
    }
    at += 1;
    return items;
  };
  const primary = () => {
    const token = own[at];
    if (token === undefined) throw new Error("a value ends too early");
    if (token === "-") {
      at += 1;
      return { call: "neg", of: [postfixed()] };
    }
    if (token === "(") {
      at += 1;
      const inner = sum();
      at += 1;
      return inner;
    }
    if (token === "[") return { call: "list", of: list() };
    at += 1;
    // The value of a range is its first number.
    if (/^\d/.test(token)) return { number: Number(token.replace(/\.\..*$|_?f(32|64)$/, "").replace(/_/g, "")) };
    // The value of a path is its last word.
    let word = token;
    if (token === "::" || token === "<") {
      at -= 1;
      while (at < own.length && own[at] !== "(") at += 1;
      word = own[at - 1];
    } else {
      while (own[at] === "::") {
        word = own[at + 1];
        at += 2;
      }
    }
    if (own[at] !== "(") {
      const of = [{ name: word }];
      while (own[at] === "[") of.push(...list());
      return of.length > 1 ? { call: "entry", of } : of[0];
    }
    const of = list();
    const meant = helpers.get(word) || word;
    return meant === "constant" ? of[0] : { call: meant, of };
  };
  const postfixed = () => {
    let value = primary();
    while (own[at] === ".") {
      const call = own[at + 1];
      at += 2;
      value = { call, of: [value, ...list()] };
    }
    return value;
  };
  const product = () => {
    let value = postfixed();
    while (own[at] === "*" || own[at] === "/") {
      const call = own[at] === "*" ? "mul" : "div";
      at += 1;
      value = { call, of: [value, postfixed()] };
    }
    return value;
  };
  const sum = () => {
    let value = product();
    while (own[at] === "+" || own[at] === "-") {
      const call = own[at] === "+" ? "add" : "sub";
      at += 1;
      value = { call, of: [value, product()] };
    }
    return value;
  };
  const value = sum();
  return at === own.length ? value : null;
}

// The names of functions of the runtime: `k` for `constant`, `mul_add`.
function helpersOf(analysis) {
  const helpers = new Map();
  for (const own of analysis.names.values()) {
    const value = analysis.tokens.slice(own.from, own.to).join("");
    const found = /^<.*>::(constant|mul_add)$/.exec(value);
    if (found) helpers.set(own.name, found[1]);
  }
  return helpers;
}

// The values of names of an open function, for arguments given as lists of numbers by name; in a loop those of the
// first iteration. NaN if unknown.
function worth({ analysis, helpers, names }, given) {
  const known = new Map();
  const calls = {
    neg: (a) => -a,
    add: (a, b) => a + b,
    sub: (a, b) => a - b,
    mul: (a, b) => a * b,
    div: (a, b) => a / b,
    mul_add: (a, b, c) => a * b + c,
    sqrt: (a) => Math.sqrt(a),
    sign: (a) => Math.sign(a),
    list: (...of) => of,
    entry: (table, ...indices) => indices.reduce((rest, index) => rest[index], table),
  };
  const valued = (value) => {
    if (value === null) return NaN;
    if ("number" in value) return value.number;
    if ("name" in value) return of(value.name);
    const call = calls[value.call];
    return call ? call(...value.of.map(valued)) : NaN;
  };
  const of = (name) => {
    if (known.has(name)) return known.get(name);
    const value = found(name, names.get(name));
    known.set(name, value);
    return value;
  };
  const found = (name, said) => {
    switch (said?.kind) {
      case "argument": return given[said.argument][said.index - 1];
      // No external wrenches.
      case "action": return 0;
      case "angle": return said.sine ? Math.sin(of(said.of)) : Math.cos(of(said.of));
      default: {
        const own = analysis.names.get(name);
        return own ? valued(tree(analysis.tokens, own.from, own.to, helpers)) : NaN;
      }
    }
  };
  // Earlier names first, because recursion through thousands of operations would be too deep.
  return (name) => {
    const waiting = [name];
    while (waiting.length) {
      const next = waiting[waiting.length - 1];
      const reads = analysis.names.get(next)?.reads || new Set();
      const missing = [...reads].filter((read) => !known.has(read) && !helpers.has(read));
      if (missing.length && !known.has(next)) waiting.push(...missing);
      else of(waiting.pop());
    }
    return known.get(name);
  };
}
