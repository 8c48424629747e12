// Errors of single precision, measured: results in f32 beside those in f64, for the same arguments.

// Number of configurations.
const SAMPLES_OF_ERRORS = 64;

// A number from 0 to 1, from a generator of its own (mulberry32), so that a page shows the same errors each time.
function randomNumbers(seed) {
  let state = seed;
  return () => {
    state = (state + 0x6d2b79f5) | 0;
    let mixed = Math.imul(state ^ (state >>> 15), 1 | state);
    mixed = (mixed + Math.imul(mixed ^ (mixed >>> 7), 61 | mixed)) ^ mixed;
    return ((mixed ^ (mixed >>> 14)) >>> 0) / 4294967296;
  };
}

// States within the limits, with rates up to 1, of numbers that f32 has.
function randomStates({ coordinates, velocities }) {
  const random = randomNumbers(1);
  const within = (low, high) => Math.fround(low + (high - low) * random());
  const rates = () => velocities.map(() => within(-1, 1));
  return Array.from({ length: SAMPLES_OF_ERRORS }, () => {
    const q = coordinates.map(({ kind, range }) => within(...(kind === "quaternion" ? [-1, 1] : range || (kind === "rotation" ? [-Math.PI, Math.PI] : [-1, 1]))));
    const [qd, qdd, tau, weights] = [rates(), rates(), rates(), rates()];
    const wrench = Array.from({ length: 6 }, () => within(-1, 1));
    return { q, qd, qdd, tau, weights, q_change: rates(), qd_change: rates(), qdd_change: rates(), tau_change: rates(), wrench };
  });
}

// The median error of each number of a result; `compute` resolves to results in a scalar type. Null for results that are
// no list of numbers, and for quaternions, whose errors would be those of their lengths.
async function medianErrors(skeleton, compute) {
  if (skeleton.coordinates.some(({ kind }) => kind === "quaternion")) return null;
  const states = randomStates(skeleton);
  const [single, double] = [await compute(states, "f32"), await compute(states, "f64")];
  const numbers = (result) => (typeof result === "number" ? [result] : Array.isArray(result) && result.every((entry) => typeof entry === "number") ? result : null);
  if (!single || !double || numbers(double[0]) === null) return null;
  return numbers(double[0]).map((_, entry) => {
    const errors = double.map((result, k) => Math.abs(numbers(result)[entry] - numbers(single[k])[entry])).sort((a, b) => a - b);
    return errors[Math.floor(errors.length / 2)];
  });
}
