// Closes loops while joints are moved: Newton's method with steps of minimum length. Some coordinates are held. Shares
// no code with the functions of loops.

// Tolerance of residuals [m, or the cosine of an angle].
const CLOSED = 1e-11;

// The residuals of all loops: entries of M of frame B in frame A that are zero if the loop is closed.
function residuals(skeleton, q) {
  const at = poses(skeleton, q).loops;
  return skeleton.loops.flatMap(({ rows, size }, number) => {
    const [a, b] = at[number];
    const axis = (m, k) => [m[k], m[4 + k], m[8 + k]];
    const apart = minus(originOf(b), originOf(a));
    return rows.map(([row, i, j]) => {
      switch (row) {
        case "along": return dot(axis(a, i), apart);
        case "product": return dot(axis(a, i), axis(b, j));
        case "inclined": return dot(axis(a, 2), axis(b, 2)) - size;
        default: return (dot(apart, apart) - size * size) / (2 * size);
      }
    });
  });
}

// x of A x = b, by elimination with the largest pivots.
function solved(matrix, right) {
  const rows = matrix.map((row, k) => [...row, right[k]]);
  const count = rows.length;
  for (let k = 0; k < count; k += 1) {
    const pivot = rows.slice(k).reduce((best, row, at) => (Math.abs(row[k]) > Math.abs(rows[best][k]) ? at + k : best), k);
    [rows[k], rows[pivot]] = [rows[pivot], rows[k]];
    for (let row = k + 1; row < count; row += 1) {
      const factor = rows[row][k] / rows[k][k];
      for (let column = k; column <= count; column += 1) rows[row][column] -= factor * rows[k][column];
    }
  }
  const x = new Array(count).fill(0);
  for (let k = count - 1; k >= 0; k -= 1) {
    const known = rows[k].slice(k + 1, count).reduce((sum, entry, at) => sum + entry * x[k + 1 + at], 0);
    x[k] = (rows[k][count] - known) / rows[k][k];
  }
  return x;
}

// Coordinates near the present ones that close all loops, with those in `held` unchanged; null if there are none.
function closed(skeleton, start, held) {
  const q = [...start];
  const free = q.map((_, k) => k).filter((k) => !held.includes(k));
  const worst = (values) => Math.max(0, ...values.map(Math.abs));
  for (let round = 0; round < 60; round += 1) {
    const now = residuals(skeleton, q);
    if (worst(now) < CLOSED) return q;
    // Central differences: their error is far below one step.
    const step = 1e-5;
    const columns = free.map((k) => {
      const [before, after] = [-step, step].map((by) => residuals(skeleton, q.map((entry, at) => (at === k ? entry + by : entry))));
      return after.map((entry, row) => (entry - before[row]) / (2 * step));
    });
    // The shortest step: A Aᵗ y = residuals, then Aᵗ y. The added diagonal allows redundant constraints.
    const square = now.map((_, i) => now.map((__, j) => columns.reduce((sum, column) => sum + column[i] * column[j], i === j ? 1e-10 : 0)));
    const y = solved(square, now);
    // Limits a step to half a radian or half a metre.
    const steps = columns.map((column) => column.reduce((sum, entry, row) => sum + entry * y[row], 0));
    const scale = Math.min(1, 0.5 / (worst(steps) || 1));
    free.forEach((k, at) => { q[k] -= scale * steps[at]; });
    straighten(skeleton, q);
  }
  return worst(residuals(skeleton, q)) < 1e-8 ? q : null;
}

// Normalises quaternions.
function straighten(skeleton, q) {
  for (let k = 0; k < q.length; k += 1) {
    if (skeleton.coordinates[k].kind !== "quaternion") continue;
    const length = Math.hypot(...q.slice(k, k + 4)) || 1;
    for (let entry = k; entry < k + 4; entry += 1) q[entry] /= length;
    k += 3;
  }
}
