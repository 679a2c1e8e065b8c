package particles.teaching.marking;

/**
 * A typical mistake in an exercise.
 *
 * @param value the answer to which it leads
 * @param hint  the explanation for a student who made it
 */
public record CommonMistake(double value, String hint) {
}
