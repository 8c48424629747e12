// Singular values of small matrices, and principal axes of inertia tensors.

// Singular values of a matrix, the largest first, each with its direction in the space of the rows: rows are rotated in
// pairs until all are orthogonal (one-sided method of Jacobi). Small values keep their digits, unlike roots of
// eigenvalues of A Aᵗ.
function singular(matrix) {
  const rows = matrix.map((row) => [...row]);
  const count = rows.length;
  const directions = rows.map((_, k) => rows.map((__, l) => Number(k === l)));
  const product = (a, b) => a.reduce((sum, entry, k) => sum + entry * b[k], 0);
  const rotate = (list, i, j, cosine, sine) => {
    const [a, b] = [list[i], list[j]];
    list[i] = a.map((entry, k) => cosine * entry - sine * b[k]);
    list[j] = a.map((entry, k) => sine * entry + cosine * b[k]);
  };
  for (let sweep = 0; sweep < 40; sweep += 1) {
    let rotated = false;
    for (let i = 0; i < count; i += 1) {
      for (let j = i + 1; j < count; j += 1) {
        const [a, b, mixed] = [product(rows[i], rows[i]), product(rows[j], rows[j]), product(rows[i], rows[j])];
        if (Math.abs(mixed) <= 1e-15 * Math.sqrt(a * b) || mixed === 0) continue;
        rotated = true;
        const half = (b - a) / (2 * mixed);
        const tangent = (half < 0 ? -1 : 1) / (Math.abs(half) + Math.hypot(1, half));
        const cosine = 1 / Math.hypot(1, tangent);
        rotate(rows, i, j, cosine, cosine * tangent);
        rotate(directions, i, j, cosine, cosine * tangent);
      }
    }
    if (!rotated) break;
  }
  const found = rows.map((row, k) => ({ value: Math.hypot(...row), direction: directions[k] }));
  return found.sort((one, other) => other.value - one.value);
}

// The box of uniform density with the mass and the inertia of a link: its axes, and half its sides \[m\]; null if the
// link has no mass.
function inertiaBox({ mass, inertia }) {
  if (!(mass > 0) || !inertia) return null;
  const [xx, xy, xz, yy, yz, zz] = inertia;
  const found = singular([[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]]);
  const total = found.reduce((sum, { value }) => sum + value, 0);
  return {
    axes: found.map(({ direction }) => direction),
    halves: found.map(({ value }) => Math.sqrt(Math.max(0, (1.5 * (total - 2 * value)) / mass))),
  };
}
