// Shapes of the links of a URDF file, for the picture: boxes, cylinders, spheres, and meshes whose files are there; of the
// visual elements where there are some, else of those for collisions. Other formats have none here.

// Numbers of an attribute, or null.
function numbersOf(element, name, count) {
  const numbers = (element?.getAttribute(name) || "").trim().split(/\s+/).map(Number);
  return numbers.length === count && numbers.every(Number.isFinite) ? numbers : null;
}

// The pose of an element's origin.
function originPose(element) {
  const origin = [...element.children].find(({ localName }) => localName === "origin");
  const [x, y, z] = numbersOf(origin, "xyz", 3) || [0, 0, 0];
  const [roll, pitch, yaw] = numbersOf(origin, "rpy", 3) || [0, 0, 0];
  const turned = [[[0, 0, 1], yaw], [[0, 1, 0], pitch], [[1, 0, 0], roll]].map(([axis, angle]) => alongAxis(axis, angle, 0));
  return turned.reduce(compose, [1, 0, 0, x, 0, 1, 0, y, 0, 0, 1, z]);
}

// The shape of a visual or collision element, or null. `meshes` are files, with names and bytes.
function shapeOf(element, meshes) {
  const geometry = [...element.children].find(({ localName }) => localName === "geometry")?.firstElementChild;
  const place = originPose(element);
  const number = (name) => numbersOf(geometry, name, 1)?.[0] ?? null;
  switch (geometry?.localName) {
    case "box": {
      const size = numbersOf(geometry, "size", 3);
      return size && { kind: "box", halves: size.map((side) => side / 2), place };
    }
    case "cylinder":
    case "capsule": {
      const [radius, length] = [number("radius"), number("length")];
      return radius === null || length === null ? null : { kind: "cylinder", radius, half: length / 2, place };
    }
    case "sphere": {
      const radius = number("radius");
      return radius === null ? null : { kind: "sphere", radius, place };
    }
    case "mesh": {
      const found = fileAt(meshes, (geometry.getAttribute("filename") || "").replaceAll("\\", "/"));
      const faces = found && meshOf(found, numbersOf(geometry, "scale", 3) || [1, 1, 1]);
      return faces && { kind: "mesh", faces, place };
    }
    default: return null;
  }
}

// The shapes of links by name. A text that is no plain URDF has none.
function shapesOf(text, meshes) {
  const shapes = new Map();
  if (!/<robot[\s>]/.test(text) || text.includes("<xacro:") || text.includes("<!ENTITY")) return shapes;
  const root = new DOMParser().parseFromString(text, "application/xml").documentElement;
  if (root.localName !== "robot") return shapes;
  for (const link of [...root.children].filter(({ localName }) => localName === "link")) {
    const of = (kind) => [...link.children].filter(({ localName }) => localName === kind).map((element) => shapeOf(element, meshes)).filter(Boolean);
    const visual = of("visual");
    const own = visual.length ? visual : of("collision");
    if (own.length) shapes.set(link.getAttribute("name"), own);
  }
  return shapes;
}
