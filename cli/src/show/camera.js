// The camera: viewpoint of the picture, moved by pointers and keys.

const camera = {
  azimuth: -0.9,
  elevation: 0.35,
  distance: 3,
  target: [0, 0, 0],
  width: 1,
  height: 1,
};

// Distance of the picture from the camera, in units of its smaller side.
const FOCUS = 1.9;

const minus = (a, b) => a.map((entry, k) => entry - b[k]);
const plus = (a, b) => a.map((entry, k) => entry + b[k]);
const times = (a, factor) => a.map((entry) => entry * factor);
const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
const unit = (a) => times(a, 1 / (Math.hypot(...a) || 1));
const between = (a, b, share) => a.map((entry, k) => entry + (b[k] - entry) * share);

// Axes of the camera in frame 0: to the right, upwards, towards the viewer; and its position.
function eye() {
  const { azimuth, elevation, distance, target } = camera;
  const [ca, sa, ce, se] = [Math.cos(azimuth), Math.sin(azimuth), Math.cos(elevation), Math.sin(elevation)];
  const towards = [ca * ce, sa * ce, se];
  const right = [-sa, ca, 0];
  return { right, up: cross(towards, right), towards, at: plus(target, times(towards, distance)) };
}

// Position of a point in the picture \[px\], its distance from the camera \[m\], and pixels per metre there.
function project(from, p) {
  const seen = minus(p, from.at);
  const depth = Math.max(-dot(seen, from.towards), camera.distance * 0.02);
  const scale = FOCUS * Math.min(camera.height, camera.width) / depth;
  return {
    x: camera.width / 2 + dot(seen, from.right) * scale,
    y: camera.height / 2 - dot(seen, from.up) * scale,
    depth,
    scale,
  };
}

// Fits a sphere into the picture.
function frame(center, radius) {
  camera.target = center;
  camera.distance = radius * FOCUS * 2.4;
}

function turn(dx, dy) {
  camera.azimuth -= dx;
  camera.elevation = Math.max(-1.5, Math.min(1.5, camera.elevation + dy));
}

function zoom(factor) {
  camera.distance *= factor;
}

function shift(dx, dy) {
  const from = eye();
  const metres = camera.distance / (FOCUS * Math.min(camera.height, camera.width));
  camera.target = plus(camera.target, plus(times(from.right, -dx * metres), times(from.up, dy * metres)));
}

// Connects pointers, the wheel and keys to the camera; `changed` is called after each step, `whole` shows all.
function moveByHand(canvas, changed, whole) {
  const pointers = new Map();
  const spread = () => {
    const [a, b] = [...pointers.values()];
    return { size: Math.hypot(a.x - b.x, a.y - b.y), x: (a.x + b.x) / 2, y: (a.y + b.y) / 2 };
  };
  canvas.addEventListener("pointerdown", (event) => {
    pointers.set(event.pointerId, { x: event.clientX, y: event.clientY });
    canvas.setPointerCapture(event.pointerId);
  });
  canvas.addEventListener("pointermove", (event) => {
    const last = pointers.get(event.pointerId);
    if (!last) return;
    const before = pointers.size === 2 ? spread() : null;
    const [dx, dy] = [event.clientX - last.x, event.clientY - last.y];
    pointers.set(event.pointerId, { x: event.clientX, y: event.clientY });
    if (before) {
      const after = spread();
      zoom(before.size / Math.max(after.size, 1));
      shift(after.x - before.x, after.y - before.y);
    } else if (event.shiftKey || event.button === 2 || event.buttons === 4) {
      shift(dx, dy);
    } else {
      turn(dx * 0.008, dy * 0.008);
    }
    changed();
  });
  const released = (event) => pointers.delete(event.pointerId);
  canvas.addEventListener("pointerup", released);
  canvas.addEventListener("pointercancel", released);
  canvas.addEventListener("wheel", (event) => {
    // The wheel scrolls the page unless the picture is focused or pinched.
    if (!event.ctrlKey && document.activeElement !== canvas) return;
    event.preventDefault();
    zoom(Math.exp(event.deltaY * 0.0015));
    changed();
  }, { passive: false });
  const keys = {
    ArrowLeft: () => turn(0.12, 0),
    ArrowRight: () => turn(-0.12, 0),
    ArrowUp: () => turn(0, 0.12),
    ArrowDown: () => turn(0, -0.12),
    "+": () => zoom(0.85),
    "=": () => zoom(0.85),
    "-": () => zoom(1 / 0.85),
    0: whole,
    Home: whole,
  };
  canvas.addEventListener("keydown", (event) => {
    const step = keys[event.key];
    if (!step || event.ctrlKey || event.metaKey || event.altKey) return;
    event.preventDefault();
    step();
    changed();
  });
}
