// Poses in frame 0 from the skeleton and coordinates q, as rows 1 to 3 of 4×4 matrices (twelve numbers). Each body is
// moved after its placement: by a rotation about and a translation along an axis, or by the coordinates of a planar,
// spherical or floating joint. Shares no code with the engine.

const IDENTITY = [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0];

// Mᵢₖ = Mᵢⱼ Mⱼₖ.
function compose(a, b) {
  const m = new Array(12);
  for (let row = 0; row < 12; row += 4) {
    for (let column = 0; column < 4; column += 1) {
      m[row + column] = a[row] * b[column] + a[row + 1] * b[4 + column] + a[row + 2] * b[8 + column]
        + (column === 3 ? a[row + 3] : 0);
    }
  }
  return m;
}

// A point of the frame with pose m, in the frame that m is relative to.
const pointAt = (m, [x, y, z]) => [0, 4, 8].map((row) => m[row] * x + m[row + 1] * y + m[row + 2] * z + m[row + 3]);

// A direction, likewise.
const directionAt = (m, [x, y, z]) => [0, 4, 8].map((row) => m[row] * x + m[row + 1] * y + m[row + 2] * z);

// The origin of the frame.
const originOf = (m) => [m[3], m[7], m[11]];

// Q: a rotation about a unit axis through the origin, and a translation along it.
function alongAxis([x, y, z], angle, shift) {
  const sine = Math.sin(angle);
  const cosine = Math.cos(angle);
  const half = Math.sin(angle / 2);
  const versine = 2 * half * half;
  return [
    cosine + x * x * versine, x * y * versine - z * sine, x * z * versine + y * sine, x * shift,
    x * y * versine + z * sine, cosine + y * y * versine, y * z * versine - x * sine, y * shift,
    x * z * versine - y * sine, y * z * versine + x * sine, cosine + z * z * versine, z * shift,
  ];
}

// Q of a quaternion (x, y, z, w) and a translation; the quaternion is normalised.
function ofQuaternion(quaternion, [tx, ty, tz]) {
  const length = Math.hypot(...quaternion) || 1;
  const [x, y, z, w] = quaternion.map((entry) => entry / length);
  return [
    1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y), tx,
    2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x), ty,
    2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y), tz,
  ];
}

// The quaternion of a rotation vector \[rad\].
function quaternionOf(turn) {
  const angle = Math.hypot(...turn);
  const scale = angle > 1e-9 ? Math.sin(angle / 2) / angle : 0.5;
  return [...turn.map((entry) => entry * scale), Math.cos(angle / 2)];
}

// The rotation vector of a quaternion, at most half a revolution.
function turnOf(quaternion) {
  const sign = quaternion[3] < 0 ? -1 : 1;
  const half = Math.hypot(...quaternion.slice(0, 3));
  const angle = 2 * Math.atan2(half, Math.abs(quaternion[3]));
  return quaternion.slice(0, 3).map((entry) => (half > 1e-12 ? (sign * entry * angle) / half : 0));
}

// The displacement of a body's joint at q.
function displacement(body, q) {
  const { by: moved, axis } = body;
  if (moved === null) return IDENTITY;
  const at = moved.coordinate;
  switch (moved.manifold) {
    case "planar": {
      const turned = alongAxis([0, 0, 1], q[at + 2], 0);
      turned[3] = q[at];
      turned[7] = q[at + 1];
      return turned;
    }
    case "spherical":
      return ofQuaternion(q.slice(at, at + 4), [0, 0, 0]);
    case "floating":
      return ofQuaternion(q.slice(at + 3, at + 7), q.slice(at, at + 3));
    default: {
      const along = q[at] * moved.factor;
      return alongAxis(axis, body.rotates * along, body.translates * along);
    }
  }
}

// M₀ of all bodies, of each before its displacement, and of all links.
function poses(skeleton, q) {
  const bodies = [];
  const joints = [];
  for (const body of skeleton.bodies) {
    const outer = body.parent === null ? IDENTITY : bodies[body.parent];
    joints.push(compose(outer, body.place));
    bodies.push(compose(joints[joints.length - 1], displacement(body, q)));
  }
  const fixed = ({ body, place: at }) => compose(body === null ? IDENTITY : bodies[body], at);
  return { bodies, joints, links: skeleton.links.map(fixed), loops: skeleton.loops.map((loop) => loop.ends.map(fixed)) };
}
