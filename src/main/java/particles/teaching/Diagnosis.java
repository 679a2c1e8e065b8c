package particles.teaching;

import java.util.List;

/**
 * What a method turned out to be.
 *
 * @param identity   in a sentence, such as "This is the midpoint method."
 * @param findings   what is wrong with it
 * @param polynomial the coefficients of its stability polynomial, from z^0 on; empty if it has none
 */
record Diagnosis(String identity, List<Finding> findings, double[] polynomial) {
}
