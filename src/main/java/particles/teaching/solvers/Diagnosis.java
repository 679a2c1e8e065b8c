package particles.teaching.solvers;

import java.util.List;
import particles.teaching.Finding;

/**
 * The diagnosis of a solver: its method, and the mistakes found.
 *
 * @param identity the method in a sentence, such as "This is the midpoint method."
 * @param findings the mistakes
 * @param order    the order that its coefficients have; 0 if they were not read
 */
record Diagnosis(String identity, List<Finding> findings, int order) {

    Diagnosis(String identity, List<Finding> findings) {
        this(identity, findings, 0);
    }
}
