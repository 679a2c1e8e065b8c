// The particles, springs and rods of a run, as the engine describes them.

/** Adds columns: of three numbers for each particle, and then of four for each spring. */
export function columnsOf({ids, numbers}) {
  const particles = numbers.subarray(0, 3 * ids.length), springs = numbers.subarray(particles.length);
  const column = (rows, width, k) => rows.filter((number, i) => i % width === k);
  return {ids, fixed: column(particles, 3, 0), births: column(particles, 3, 1), lives: column(particles, 3, 2),
    springs: springs.filter((number, i) => i % 4 < 2), restLengths: column(springs, 4, 2),
    stiffness: column(springs, 4, 3)};
}
