package particles.teaching.solvers;

import java.util.List;
import particles.teaching.Finding;

/**
 * What a method turned out to be.
 *
 * @param identity in a sentence, such as "This is the midpoint method."
 * @param findings what is wrong with it
 */
record Diagnosis(String identity, List<Finding> findings) {
}
