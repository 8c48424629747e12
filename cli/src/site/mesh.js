// Meshes of links, for the picture: files in STL, OBJ and Collada that are dropped with a description.
//
// In: the bytes of a file. Out: faces, each with its corners in metres and its normal, of a coarser mesh where there are
// more than a picture needs. What cannot be read is `null`, and the link is drawn without it.

// Endings of files with meshes.
const MESH = /\.(stl|obj|dae)$/i;

// Number of faces that are drawn of a mesh.
const FACES = 700;

// Cells of the finest grid along the longest side, fewer than 64, and the ratio to the next coarser one at most.
const [CELLS, COARSER] = [40, 0.9];

// The faces of a file as numbers, three for each of three corners, or null.
function facesOf(name, buffer) {
  const text = () => new TextDecoder().decode(buffer);
  try {
    if (/\.stl$/i.test(name)) return ofStl(buffer) ?? ofStlText(text());
    if (/\.obj$/i.test(name)) return ofObj(text());
    return ofCollada(text());
  } catch {
    // A file that is cut short.
    return null;
  }
}

// A binary STL file says how many faces follow its head of 80 bytes.
function ofStl(buffer) {
  const view = new DataView(buffer);
  const count = buffer.byteLength >= 84 ? view.getUint32(80, true) : 0;
  if (!count || buffer.byteLength < 84 + 50 * count) return null;
  const entries = new Float64Array(9 * count);
  for (let face = 0; face < count; face += 1) {
    for (let k = 0; k < 9; k += 1) entries[9 * face + k] = view.getFloat32(84 + 50 * face + 12 + 4 * k, true);
  }
  return entries;
}

function ofStlText(text) {
  return [...text.matchAll(/vertex\s+(\S+)\s+(\S+)\s+(\S+)/g)].flatMap(([, ...point]) => point.map(Number));
}

// Vertices and polygons, whose indices begin at 1, or at -1 for the last vertex.
function ofObj(text) {
  const points = [];
  const entries = [];
  for (const line of text.split("\n")) {
    const [word, ...rest] = line.trim().split(/\s+/);
    if (word === "v") points.push(rest.slice(0, 3).map(Number));
    if (word === "f") addPolygon(entries, rest.map((entry) => {
      const index = parseInt(entry, 10);
      return points[index < 0 ? points.length + index : index - 1];
    }));
  }
  return entries;
}

// The nodes of the scene of a Collada file with their geometries, in metres, with z upwards.
function ofCollada(text) {
  if (text.includes("<!ENTITY")) return null;
  const root = new DOMParser().parseFromString(text, "application/xml").documentElement;
  const all = (element, name) => [...element.getElementsByTagName(name)];
  const named = new Map(all(root, "*").filter((element) => element.id).map((element) => [`#${element.id}`, element]));
  const numbers = (element) => (element?.textContent ?? "").trim().split(/\s+/).map(Number);
  const scale = Number(all(root, "unit")[0]?.getAttribute("meter") ?? 1);
  const upright = { Y_UP: [1, 0, 0, 0, 0, 0, -1, 0, 0, 1, 0, 0], X_UP: [0, -1, 0, 0, 1, 0, 0, 0, 0, 0, 1, 0] }[all(root, "up_axis")[0]?.textContent.trim()] ?? IDENTITY;

  // Adds the faces of a geometry at a place.
  const sourceOf = (input) => named.get(input?.getAttribute("source"));
  const entries = [];
  const add = (element, place) => {
    for (const list of [...all(element, "triangles"), ...all(element, "polylist"), ...all(element, "polygons")]) {
      const inputs = [...list.children].filter(({ localName }) => localName === "input");
      const own = inputs.find((input) => input.getAttribute("semantic") === "VERTEX");
      const positions = [...sourceOf(own).children].find((input) => input.getAttribute("semantic") === "POSITION");
      const points = numbers(all(sourceOf(positions), "float_array")[0]);
      const offset = (input) => Number(input.getAttribute("offset") ?? 0);
      const apart = Math.max(...inputs.map(offset)) + 1;
      const corners = (indices) => indices.filter((_, k) => k % apart === offset(own)).map((index) => pointAt(place, points.slice(3 * index, 3 * index + 3)));
      const groups = all(list, "p").map((own_indices) => corners(numbers(own_indices)));
      const [counts] = all(list, "vcount");
      if (list.localName === "polygons") groups.forEach((polygon) => addPolygon(entries, polygon));
      else if (counts) {
        let first = 0;
        for (const count of numbers(counts)) addPolygon(entries, groups[0].slice(first, first += count));
      } else for (const corner of groups[0] ?? []) entries.push(...corner);
    }
  };

  // The displacement of a node, step by step as it is written; a matrix may scale.
  const steps = {
    matrix: (entries) => entries.slice(0, 12),
    translate: ([x, y, z]) => [1, 0, 0, x, 0, 1, 0, y, 0, 0, 1, z],
    rotate: ([x, y, z, angle]) => alongAxis(unit([x, y, z]), (angle * Math.PI) / 180, 0),
    scale: ([x, y, z]) => [x, 0, 0, 0, 0, y, 0, 0, 0, 0, z, 0],
  };
  const visit = (node, before, depth) => {
    let place = before;
    for (const child of depth < 32 ? node.children : []) {
      const { localName } = child;
      if (localName in steps) place = compose(place, steps[localName](numbers(child)));
      if (localName === "instance_geometry") add(named.get(child.getAttribute("url")), place);
      if (localName === "node") visit(child, place, depth + 1);
      if (localName === "instance_node") visit(named.get(child.getAttribute("url")), place, depth + 1);
    }
  };
  for (const scene of all(root, "visual_scene")) visit(scene, upright, 0);
  return entries.map((entry) => entry * scale);
}

// Adds a polygon as faces about its first corner.
function addPolygon(entries, corners) {
  for (let k = 2; k < corners.length; k += 1) entries.push(...corners[0], ...corners[k - 1], ...corners[k]);
}

// Fewer faces: the corners in a cell of a grid become their mean, and faces with two such corners go.
function coarser(entries, most) {
  const low = [Infinity, Infinity, Infinity];
  const high = [-Infinity, -Infinity, -Infinity];
  for (let k = 0; k < entries.length; k += 1) {
    low[k % 3] = Math.min(low[k % 3], entries[k]);
    high[k % 3] = Math.max(high[k % 3], entries[k]);
  }
  const side = Math.max(...minus(high, low));
  let fewer = entries;
  for (let cells = CELLS; fewer.length > 9 * most && cells > 2; cells *= Math.min(COARSER, Math.sqrt((9 * most) / fewer.length))) {
    fewer = inCells(entries, low, cells / side);
  }
  return fewer;
}

// The faces between the cells of a grid, of which `each` are in a unit of length.
function inCells(entries, low, each) {
  const corners = entries.length / 3;
  const places = new Map();
  const cellOf = new Int32Array(corners);
  const sums = [];
  for (let corner = 0; corner < corners; corner += 1) {
    let place = 0;
    for (let axis = 0; axis < 3; axis += 1) place = place * 64 + Math.floor((entries[3 * corner + axis] - low[axis]) * each);
    let cell = places.get(place);
    if (cell === undefined) places.set(place, cell = sums.push([0, 0, 0, 0]) - 1);
    cellOf[corner] = cell;
    for (let axis = 0; axis < 3; axis += 1) sums[cell][axis] += entries[3 * corner + axis];
    sums[cell][3] += 1;
  }
  const means = sums.map(([x, y, z, count]) => [x / count, y / count, z / count]);
  const seen = new Set();
  const kept = [];
  for (let corner = 0; corner < corners; corner += 3) {
    const [a, b, c] = cellOf.subarray(corner, corner + 3);
    const face = (a * sums.length + b) * sums.length + c;
    if (a === b || b === c || c === a || seen.has(face)) continue;
    seen.add(face);
    kept.push(...means[a], ...means[b], ...means[c]);
  }
  return kept;
}

// The faces to draw of a file, with a scale of each axis; a mirrored mesh is turned inside out again. The file keeps what was
// read of it.
function meshOf(file, scale) {
  if (!file.entries) {
    const entries = facesOf(file.name, file.buffer) ?? [];
    const whole = entries.length % 9 === 0 && entries.every(Number.isFinite);
    file.entries = whole ? coarser(entries, FACES) : [];
  }
  if (!file.entries.length) return null;
  const mirrored = scale[0] * scale[1] * scale[2] < 0;
  return Array.from({ length: file.entries.length / 9 }, (_, face) => {
    const corner = (k) => scale.map((factor, axis) => factor * file.entries[9 * face + 3 * k + axis]);
    const corners = (mirrored ? [2, 1, 0] : [0, 1, 2]).map(corner);
    return { corners, normal: unit(cross(minus(corners[1], corners[0]), minus(corners[2], corners[0]))) };
  });
}
