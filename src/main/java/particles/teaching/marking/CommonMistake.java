package particles.teaching.marking;

/**
 * A typical mistake.
 *
 * @param value the answer to which it leads
 * @param hint  what it is, said to who made it
 */
public record CommonMistake(double value, String hint) {
}
