// The state of the page in its address: the sample or the name of the file, options, and the configuration.

// The parts of an address.
function ofAddress() {
  const parts = new URLSearchParams(location.hash.slice(1));
  const q = (parts.get("q") || "").split(",").map(Number);
  const options = [...parts].filter(([name]) => name.startsWith("-")).map(([name, value]) => [name.slice(1), value]);
  return { robot: parts.get("robot"), options, q: parts.has("q") && q.every(Number.isFinite) ? q : null };
}

// Writes an address, without an entry in the history.
function toAddress({ robot, options, q }) {
  const parts = new URLSearchParams();
  if (robot) parts.set("robot", robot);
  for (const [name, value] of options) parts.append(`-${name}`, value);
  if (q) parts.set("q", q.map((entry) => String(Math.round(entry * 1e6) / 1e6)).join(","));
  history.replaceState(null, "", `#${String(parts).replace(/%2C/g, ",")}`);
}
