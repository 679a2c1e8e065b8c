package particles.teaching.solvers;

import java.util.List;
import particles.teaching.Finding;

/**
 * The diagnosis of a solver: its method, and the mistakes found.
 *
 * @param identity the method in a sentence, such as "This is the midpoint method."
 * @param findings the mistakes
 */
record Diagnosis(String identity, List<Finding> findings) {
}
