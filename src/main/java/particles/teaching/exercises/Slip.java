package particles.teaching.exercises;

/**
 * A typical mistake.
 *
 * @param value the answer to which it leads
 * @param hint  what it is, said to who made it
 */
record Slip(double value, String hint) {
}
