// The picture: links as rods and as bodies, joints by their motions, frames as three arrows, masses as dots. Faces are
// painted from the farthest to the nearest.

// Number of sides of round shapes.
const SIDES = 24;

// Opacity of bodies.
const BODY = 0.3;

// Constant properties of a robot: thicknesses, and the tree.
function prepared(data) {
  const { skeleton, report } = data;
  const kinds = new Map(report.details.joints.map((joint) => [joint.name, joint.kind]));
  const place = new Map(skeleton.links.map((link, k) => [link.name, k]));
  // The first body of a joint begins at the joint's frame.
  const first = new Map();
  skeleton.bodies.forEach((body, k) => first.has(body.joint) || first.set(body.joint, k));
  const links = skeleton.links.map((link, k) => {
    const moving = kinds.has(link.joint) && first.has(link.joint);
    const kept = place.has(link.parent) ? place.get(link.parent) : null;
    return {
      ...link,
      index: k,
      parent: link.name === skeleton.base ? null : kept,
      joint: moving ? first.get(link.joint) : null,
      kind: moving ? kinds.get(link.joint) : "fixed",
      box: inertiaBox(link),
      shapes: data.shapes?.get(link.name),
      // Frames of loops, by the number of the loop and of its end.
      held: (report.loops || []).flatMap(({ from, to }, number) =>
        [from, to].flatMap((name, end) => (name === link.name ? [[number, end]] : []))),
      end: !skeleton.links.some((other) => other.parent === link.name && other.name !== skeleton.base),
    };
  });
  const rest = poses(skeleton, data.neutral);
  const drawn = links.filter((link) => link.kind !== "floating");
  const lengths = drawn.flatMap((link) => {
    if (link.parent === null) return [];
    const from = originOf(rest.links[link.parent]);
    const to = originOf(link.joint === null ? rest.links[link.index] : rest.joints[link.joint]);
    return [Math.hypot(...minus(to, from))];
  });
  const { low, center, reach } = around(links, rest);
  const long = lengths.filter((length) => length > reach * 0.02).sort((a, b) => a - b);
  const typical = long.length ? long[Math.floor(long.length / 2)] : reach;
  const thick = Math.max(0.011 * reach, Math.min(typical * 0.11, 0.034 * reach));
  const heaviest = Math.max(...links.map((link) => link.mass || 0), 1e-12);
  // Mimic joints with the first bodies of the joints that they mimic.
  const mimics = new Map(report.mimicked.map(({ joint, of }) => [joint, first.get(of)]));
  return { skeleton, links, center, reach, thick, heaviest, mimics, ground: Math.min(low[2], 0) };
}

// A sphere around all links, and its lowest point.
function around(links, at) {
  const spots = links.flatMap((link, k) => {
    const own = originOf(at.links[k]);
    return link.center && link.end ? [own, pointAt(at.links[k], link.center)] : [own];
  });
  const low = [0, 1, 2].map((k) => Math.min(...spots.map((p) => p[k])));
  const high = [0, 1, 2].map((k) => Math.max(...spots.map((p) => p[k])));
  const center = times(plus(low, high), 0.5);
  return { low, center, reach: Math.max(...spots.map((p) => Math.hypot(...minus(p, center))), 1e-6) };
}

// The colours of the page.
function palette() {
  const style = getComputedStyle(document.documentElement);
  const read = (name) => style.getPropertyValue(`--${name}`).trim();
  const parts = (name) => [1, 3, 5].map((k) => parseInt(read(name).slice(k, k + 2), 16));
  const solid = ["rod", "rotation", "translation", "both", "free", "mark", "paper"];
  return {
    ...Object.fromEntries(solid.map((name) => [name, parts(name)])),
    sheet: read("paper"),
    ...Object.fromEntries(["ink", "grid", "shade", "axis-x", "axis-y", "axis-z", "mass", "accent", "wrong"].map((name) => [name, read(name)])),
    dark: read("dark") === "1",
  };
}

// A shaded colour: 0 in the shadow, 1 in direct light.
function lit([r, g, b], light, dark) {
  const shadow = dark ? 0.42 : 0.52;
  const strength = shadow + (1.06 - shadow) * light;
  const shine = light ** 12 * 34;
  const channel = (value) => Math.max(0, Math.min(255, Math.round(value * strength + shine)));
  return `rgb(${channel(r)} ${channel(g)} ${channel(b)})`;
}

// Shapes collected before painting.
class Painter {
  constructor(context, colours) {
    this.context = context;
    this.colours = colours;
    this.from = eye();
    this.light = unit(plus(plus(times(this.from.towards, 0.75), times(this.from.up, 0.6)), times(this.from.right, -0.42)));
    this.things = [];
  }

  // A flat face, unless it faces away.
  face(corners, normal, colour, opacity = 1) {
    if (dot(normal, minus(corners[0], this.from.at)) >= 0) return;
    const seen = corners.map((corner) => project(this.from, corner));
    const depth = seen.reduce((sum, corner) => sum + corner.depth, 0) / seen.length;
    const fill = lit(colour, Math.max(0, dot(normal, this.light)), this.colours.dark);
    this.things.push({ depth, paint: (context) => this.fill(context, seen, fill, opacity) });
  }

  fill(context, corners, fill, opacity) {
    context.globalAlpha = opacity;
    context.beginPath();
    corners.forEach(({ x, y }, k) => (k ? context.lineTo(x, y) : context.moveTo(x, y)));
    context.closePath();
    context.fillStyle = fill;
    context.strokeStyle = fill;
    context.lineWidth = 0.7;
    context.fill();
    // The seams of solid shapes.
    if (opacity === 1) context.stroke();
    context.globalAlpha = 1;
  }

  // A box about a point, by its axes and half its sides.
  box(center, axes, halves, colour, opacity = 1) {
    const sides = axes.map((axis, k) => times(axis, halves[k]));
    for (let k = 0; k < 3; k += 1) {
      const [a, b] = [sides[(k + 1) % 3], sides[(k + 2) % 3]];
      for (const sign of [-1, 1]) {
        const middle = plus(center, times(sides[k], sign));
        const corners = [[1, 1], [1, -1], [-1, -1], [-1, 1]].map(([i, j]) => plus(middle, plus(times(a, i), times(b, j))));
        this.face(corners, times(axes[k], sign), colour, opacity);
      }
    }
  }

  // A rod from a to b with a thickness at each end, closed on request.
  rod(a, b, thickA, thickB, colour, closed = false, opacity = 1) {
    const along = unit(minus(b, a));
    const length = Math.hypot(...minus(b, a));
    if (!(length > 0)) return;
    const aside = unit(cross(along, Math.abs(along[2]) < 0.9 ? [0, 0, 1] : [1, 0, 0]));
    const third = cross(along, aside);
    const pieces = closed ? 1 : Math.max(1, Math.min(10, Math.round(length / (5 * Math.max(thickA, thickB)))));
    const round = Array.from({ length: SIDES + 1 }, (_, k) => {
      const angle = (2 * Math.PI * k) / SIDES;
      return plus(times(aside, Math.cos(angle)), times(third, Math.sin(angle)));
    });
    const ring = (share) => {
      const center = between(a, b, share);
      const thick = thickA + (thickB - thickA) * share;
      return round.map((direction) => plus(center, times(direction, thick)));
    };
    let last = ring(0);
    if (closed) this.face(last.slice(1).reverse(), times(along, -1), colour, opacity);
    for (let piece = 1; piece <= pieces; piece += 1) {
      const next = ring(piece / pieces);
      for (let k = 0; k < SIDES; k += 1) {
        const normal = unit(plus(round[k], round[k + 1]));
        this.face([last[k], last[k + 1], next[k + 1], next[k]], normal, colour, opacity);
      }
      last = next;
    }
    if (closed && thickB > 0) this.face(last.slice(1), along, colour, opacity);
  }

  ball(center, radius, colour, opacity = 1) {
    const { x, y, depth, scale } = project(this.from, center);
    const size = radius * scale;
    const dark = this.colours.dark;
    this.things.push({
      depth: depth - radius * 0.6,
      paint(context) {
        const shade = context.createRadialGradient(x - size * 0.35, y - size * 0.45, size * 0.1, x, y, size);
        shade.addColorStop(0, lit(colour, 1, dark));
        shade.addColorStop(0.55, lit(colour, 0.75, dark));
        shade.addColorStop(1, lit(colour, 0.15, dark));
        context.fillStyle = shade;
        context.globalAlpha = opacity;
        context.beginPath();
        context.arc(x, y, size, 0, 2 * Math.PI);
        context.fill();
        context.globalAlpha = 1;
      },
    });
  }

  line(a, b, colour, width, dashes = []) {
    const [from, to] = [project(this.from, a), project(this.from, b)];
    this.context.setLineDash(dashes);
    this.context.strokeStyle = colour;
    this.context.lineWidth = width;
    this.context.beginPath();
    this.context.moveTo(from.x, from.y);
    this.context.lineTo(to.x, to.y);
    this.context.stroke();
    this.context.setLineDash([]);
  }

  finish() {
    this.things.sort((a, b) => b.depth - a.depth);
    for (const thing of this.things) thing.paint(this.context);
    this.things = [];
  }
}

// Lines on the ground, at distances of a power of ten or half of it.
function paintGround(painter, robot) {
  const decade = 10 ** Math.floor(Math.log10(robot.reach));
  const apart = robot.reach / decade > 4 ? decade : robot.reach / decade > 1.6 ? decade / 2 : decade / 5;
  const count = Math.ceil((robot.reach * 1.5) / apart);
  const middle = [0, 1].map((k) => Math.round(robot.center[k] / apart) * apart);
  const { context } = painter;
  for (let k = -count; k <= count; k += 1) {
    const half = Math.sqrt(Math.max(0, count * count - k * k)) * apart;
    const fade = k === 0 ? 0.9 : 0.5;
    context.globalAlpha = fade;
    const at = (x, y) => [middle[0] + x, middle[1] + y, robot.ground];
    painter.line(at(k * apart, -half), at(k * apart, half), painter.colours.grid, 1);
    painter.line(at(-half, k * apart), at(half, k * apart), painter.colours.grid, 1);
  }
  context.globalAlpha = 1;
}

// The colour of a degree of freedom: rotation, translation, or both.
function colourOf(body, colours) {
  if (body.by && body.by.manifold) return colours.free;
  if (body.rotates && body.translates) return colours.both;
  return body.rotates ? colours.rotation : colours.translation;
}

// The motion of a joint: a drum rotates about its axis, an arrow translates along it, a ball rotates freely, a disc
// moves in its plane. Mimic joints are pale.
function paintJoint(painter, robot, body, at, marked) {
  if (body.by === null || body.by.manifold === "floating") return;
  const size = robot.thick * 1.75;
  const own = colourOf(body, painter.colours);
  const colour = marked ? painter.colours.mark : robot.mimics.has(body.joint) ? between(own, painter.colours.paper, 0.6) : own;
  const center = originOf(at);
  if (body.by.manifold === "spherical") {
    painter.ball(center, size * 1.15, colour);
    return;
  }
  const axis = directionAt(at, body.by.manifold === "planar" ? [0, 0, 1] : body.axis);
  const ends = (length) => [plus(center, times(axis, -length)), plus(center, times(axis, length))];
  if (body.by.manifold === "planar") {
    painter.rod(...ends(size * 0.25), size * 1.9, size * 1.9, colour, true);
  } else if (body.rotates) {
    painter.rod(...ends(size * 1.25), size, size, colour, true);
  } else {
    const [back, front] = ends(size * 1.7);
    painter.rod(back, front, size * 0.55, size * 0.55, colour, true);
    painter.rod(front, plus(front, times(axis, size * 1.4)), size * 1.05, 0, colour, true);
  }
}

// The bodies of links, translucent around the rods: shapes of the description where they are known, else boxes with the
// inertia of the link. A shape has a kind, half its sides (or radius and half its length, or faces), and a pose in the link's
// frame. Meshes are solid: where they overlap themselves, seams would show through.
function paintBodies(painter, robot, at, marked) {
  for (const link of robot.links) {
    const pose = at.links[link.index];
    const colour = link.body !== null && marked.has(link.body) ? painter.colours.mark : painter.colours.rod;
    for (const shape of link.shapes || []) {
      const own = compose(pose, shape.place);
      const axes = [0, 1, 2].map((k) => [own[k], own[4 + k], own[8 + k]]);
      const center = originOf(own);
      if (shape.kind === "box") painter.box(center, axes, shape.halves, colour, BODY);
      else if (shape.kind === "mesh") {
        for (const { corners, normal } of shape.faces) painter.face(corners.map((corner) => pointAt(own, corner)), directionAt(own, normal), colour);
      } else if (shape.kind === "sphere") painter.ball(center, shape.radius, colour, BODY);
      else painter.rod(plus(center, times(axes[2], -shape.half)), plus(center, times(axes[2], shape.half)), shape.radius, shape.radius, colour, true, BODY);
    }
    if (!link.shapes?.length && link.box) {
      const axes = link.box.axes.map((axis) => directionAt(pose, axis));
      painter.box(pointAt(pose, link.center), axes, link.box.halves, colour, BODY);
    }
  }
}

// Everything at some poses. `shown` has the layers: frames (null, "described" or the number of a layout), centres of
// mass, bodies, names, the chosen frame (the number of a link) and its ellipsoid; `marked` are the bodies of the selected
// name.
function paint(canvas, robot, at, shown, marked) {
  const ratio = Math.min(window.devicePixelRatio || 1, 3);
  const [width, height] = [canvas.clientWidth, canvas.clientHeight];
  if (!width || !height) return;
  if (canvas.width !== Math.round(width * ratio) || canvas.height !== Math.round(height * ratio)) {
    canvas.width = Math.round(width * ratio);
    canvas.height = Math.round(height * ratio);
  }
  Object.assign(camera, { width, height });
  const context = canvas.getContext("2d");
  context.setTransform(ratio, 0, 0, ratio, 0, 0);
  context.clearRect(0, 0, width, height);
  context.lineCap = "round";
  context.lineJoin = "round";
  const painter = new Painter(context, palette());
  const { colours } = painter;
  const { thick } = robot;

  const rods = [];
  for (const link of robot.links) {
    const here = originOf(at.links[link.index]);
    const isMarked = link.body !== null && marked.has(link.body);
    const colour = isMarked ? colours.mark : colours.rod;
    if (link.parent !== null && link.kind !== "floating") {
      const parent = robot.links[link.parent];
      const from = originOf(at.links[link.parent]);
      const joint = link.joint === null ? here : originOf(at.joints[link.joint]);
      const carrier = parent.body !== null && marked.has(parent.body) ? colours.mark : colours.rod;
      // A rod to a joint is part of the link before it; one to a fixed link is thin.
      const size = link.kind === "fixed" ? thick * 0.4 : thick;
      rods.push([from, joint, size, size * 0.86, carrier]);
      if (Math.hypot(...minus(here, joint)) > thick * 0.05) {
        rods.push([joint, here, thick * 0.5, thick * 0.5, colour]);
      }
    }
    for (const [number, end] of link.held) rods.push([here, originOf(at.loops[number][end]), thick * 0.86, thick * 0.6, colour]);
    // A link without children reaches to its centre of mass.
    if (link.end && link.center && !link.held.length) {
      rods.push([here, pointAt(at.links[link.index], link.center), thick * 0.86, thick * 0.5, colour]);
    }
    if (link.name === robot.skeleton.base || link.kind !== "fixed") painter.ball(here, thick * 0.98, colour);
  }
  // Shadows first, straight down.
  for (const [a, b, thickness] of rods) {
    const down = ([x, y]) => [x, y, robot.ground];
    painter.line(down(a), down(b), colours.shade, 2 * thickness * project(painter.from, down(between(a, b, 0.5))).scale);
  }
  paintGround(painter, robot);
  for (const rod of rods) painter.rod(...rod);
  robot.skeleton.bodies.forEach((body, k) => paintJoint(painter, robot, body, at.bodies[k], marked.has(k)));
  if (shown.bodies) paintBodies(painter, robot, at, marked);
  painter.finish();

  paintConstraints(painter, robot, at);
  if (shown.ellipsoid && shown.frame !== null) paintEllipsoid(painter, originOf(at.links[shown.frame]), shown.ellipsoid);
  paintMasses(painter, robot, at, shown);
  paintFrames(painter, robot, at, shown, marked);
}

// Loops as rings where their ends meet, and dashed lines while they do not; dotted lines from mimic joints to those that
// they mimic.
function paintConstraints(painter, robot, at) {
  const { context, colours } = painter;
  for (const [a, b] of at.loops) {
    painter.line(originOf(a), originOf(b), colours.ink, 1.5, [4, 4]);
    const { x, y, scale } = project(painter.from, originOf(a));
    context.strokeStyle = colours.accent;
    context.lineWidth = 2;
    context.beginPath();
    context.arc(x, y, Math.max(6, robot.thick * 2.2 * scale), 0, 2 * Math.PI);
    context.stroke();
  }
  robot.skeleton.bodies.forEach((body, k) => {
    const mimicked = robot.mimics.get(body.joint);
    if (mimicked !== undefined) painter.line(originOf(at.bodies[k]), originOf(at.bodies[mimicked]), colours.accent, 1.5, [2, 4]);
  });
}

// An ellipsoid about a point as its three principal ellipses, with its axes; those of a singular direction are marked.
function paintEllipsoid(painter, center, axes) {
  const { context, colours } = painter;
  const half = axes.map(({ direction, length }) => times(direction, length));
  for (const [i, j] of [[0, 1], [1, 2], [2, 0]]) {
    const points = Array.from({ length: 49 }, (_, k) => {
      const angle = (2 * Math.PI * k) / 48;
      return project(painter.from, plus(center, plus(times(half[i], Math.cos(angle)), times(half[j], Math.sin(angle)))));
    });
    context.beginPath();
    points.forEach(({ x, y }, k) => (k ? context.lineTo(x, y) : context.moveTo(x, y)));
    context.fillStyle = colours.accent;
    context.globalAlpha = 0.12;
    context.fill();
    context.globalAlpha = 0.9;
    context.strokeStyle = colours.accent;
    context.lineWidth = 1.3;
    context.stroke();
    context.globalAlpha = 1;
  }
  for (const { direction, length, singular: marked, mark } of axes) {
    const end = times(direction, marked ? mark : length);
    painter.line(minus(center, end), plus(center, end), marked ? colours.wrong : colours.accent, marked ? 3 : 1.3, marked ? [6, 4] : []);
  }
}

// A quartered dot for each centre of mass, larger for a larger mass.
function paintMasses(painter, robot, at, shown) {
  if (!shown.masses) return;
  const { context, colours } = painter;
  for (const link of robot.links) {
    if (!link.center || !(link.mass > 0)) continue;
    const { x, y } = project(painter.from, pointAt(at.links[link.index], link.center));
    const size = 2.8 + 4.4 * Math.cbrt(link.mass / robot.heaviest);
    context.beginPath();
    context.arc(x, y, size, 0, 2 * Math.PI);
    context.fillStyle = colours.sheet;
    context.fill();
    context.fillStyle = colours.mass;
    for (const start of [0, Math.PI]) {
      context.beginPath();
      context.moveTo(x, y);
      context.arc(x, y, size, start, start + Math.PI / 2);
      context.fill();
    }
    context.strokeStyle = colours.mass;
    context.lineWidth = 1.2;
    context.beginPath();
    context.arc(x, y, size, 0, 2 * Math.PI);
    context.stroke();
  }
}

// The shown frames, by poses and names.
function frames(robot, at, shown) {
  if (shown.frames === null) return [];
  const base = { pose: IDENTITY, name: "0", body: null };
  if (shown.frames === "described") {
    return robot.links.map((link) => ({ pose: at.links[link.index], name: link.name, body: link.body }));
  }
  const places = robot.layouts[shown.frames];
  return [base, ...at.bodies.map((pose, k) => ({ pose: compose(pose, places[k]), name: String(k + 1), body: k }))];
}

// x red, y green, z blue.
function paintFrames(painter, robot, at, shown, marked) {
  const { context, colours } = painter;
  const all = frames(robot, at, shown);
  const labels = new Map();
  for (const { pose, name, body } of all) {
    const center = originOf(pose);
    const isMarked = body !== null && marked.has(body);
    const length = robot.thick * (isMarked ? 6.5 : 4.6);
    ["axis-x", "axis-y", "axis-z"].forEach((axis, k) => {
      const direction = [0, 1, 2].map((row) => pose[4 * row + k]);
      painter.line(center, plus(center, times(direction, length)), colours[axis], isMarked ? 3 : 1.8);
    });
    const { x, y } = project(painter.from, center);
    const spot = `${Math.round(x / 6)},${Math.round(y / 6)}`;
    labels.set(spot, { x, y, names: [...(labels.has(spot) ? labels.get(spot).names : []), name] });
  }
  if (shown.frames !== "described") {
    for (const { x, y, names } of labels.values()) write(context, colours, names.join(", "), x, y + 15);
  }
  if (shown.frame !== null) {
    const pose = at.links[shown.frame];
    ["axis-x", "axis-y", "axis-z"].forEach((axis, k) => {
      painter.line(originOf(pose), plus(originOf(pose), times([0, 1, 2].map((row) => pose[4 * row + k]), robot.thick * 7)), colours[axis], 3);
    });
  }
  paintNames(painter, robot, at, shown);
}

// Names of links. One that would cover another is left out until its link is pointed at: the chosen frame is the first,
// then links that move.
function paintNames(painter, robot, at, shown) {
  if (!shown.names) return;
  const { context, colours } = painter;
  const rank = (link) => (link.index === shown.frame ? 0 : link.kind !== "fixed" ? 1 : 2);
  const boxes = [];
  context.font = LABEL;
  for (const link of [...robot.links].sort((one, other) => rank(one) - rank(other))) {
    const { x, y } = project(painter.from, originOf(at.links[link.index]));
    const own = { left: x + 7, right: x + 13 + context.measureText(link.name).width, top: y - 19, bottom: y - 3 };
    if (boxes.some((box) => own.left < box.right && box.left < own.right && own.top < box.bottom && box.top < own.bottom)) continue;
    boxes.push(own);
    write(context, colours, link.name, x + 9, y - 7, "left");
  }
}

const LABEL = "600 11px ui-sans-serif, system-ui, sans-serif";

function write(context, colours, text, x, y, align = "center") {
  context.font = LABEL;
  context.textAlign = align;
  context.strokeStyle = colours.sheet;
  context.lineWidth = 3.5;
  context.strokeText(text, x, y);
  context.fillStyle = colours.ink;
  context.fillText(text, x, y);
}
