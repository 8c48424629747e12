// Several files that are dropped together: what a description includes is put in its place, so that the page has one text,
// in which messages have their places.
//
// MJCF and xacro define an inclusion as this replacement by the contents of the file's root element. Files are found by
// the end of their paths. An inclusion of a file that was not dropped, or whose name is computed, stays as it is.

const INCLUDE = /<!--[\s\S]*?-->|<(include|xacro:include)\b[^>]*?\b(?:file|filename)\s*=\s*(["'])([^"']*)\2[^>]*?(?:\/>|>\s*<\/\1\s*>)/g;

// Depth of inclusions that is followed, and the longest text.
const [DEPTH, LONGEST] = [20, 64 * 1024 * 1024];

// The contents of the root element of a text.
function contentsOf(text) {
  const plain = text.replace(/^\uFEFF/, "").replace(/<\?[\s\S]*?\?>|<!--[\s\S]*?-->|<!DOCTYPE[^>]*>/g, (part) => (part.startsWith("<!--") ? part : ""));
  const root = /<(?!!--)([\w:.-]+)(?:\s[^>]*?)?(\/)?>/.exec(plain.replace(/<!--[\s\S]*?-->/g, (part) => " ".repeat(part.length)));
  if (!root) return null;
  if (root[2]) return "";
  const end = plain.lastIndexOf(`</${root[1]}`);
  return end < 0 ? null : plain.slice(root.index + root[0].length, end);
}

// The file that a path names: that with the longest common end.
function fileAt(files, path) {
  const parts = path.split("/").filter((part) => part && part !== "." && part !== "..");
  const alike = ({ name }) => {
    const own = name.split("/");
    let count = 0;
    while (count < Math.min(own.length, parts.length) && own[own.length - 1 - count] === parts[parts.length - 1 - count]) count += 1;
    return count;
  };
  const found = files.map((file) => ({ file, count: alike(file) })).filter(({ count }) => count > 0).sort((a, b) => b.count - a.count);
  return found[0]?.file ?? null;
}

// The names of files that a text includes.
const includedBy = (text, files) => [...text.matchAll(INCLUDE)].flatMap(([, , , path]) => (path ? [fileAt(files, path)?.name] : [])).filter(Boolean);

// The first file, which no other includes, with a text in which inclusions are replaced. `files` have names, which may be
// paths, and texts.
function joined(files) {
  const included = new Set(files.flatMap((file) => includedBy(file.text, files).filter((name) => name !== file.name)));
  const main = files.find(({ name }) => !included.has(name)) ?? files[0];
  let left = LONGEST;
  const whole = (text, open) => text.replace(INCLUDE, (tag, _, __, path) => {
    const file = path && fileAt(files, path);
    // A cycle stays as it is, and the engine reports it.
    const own = file && !open.includes(file) && open.length < DEPTH ? contentsOf(file.text) : null;
    if (own === null || (left -= own.length) < 0) return tag;
    return `<!-- begin ${file.name.replace(/--/g, "- -")} -->${whole(own, [...open, file])}<!-- end -->`;
  });
  return { name: main.name.split("/").pop(), text: whole(main.text, [main]), others: files.length - 1 };
}
