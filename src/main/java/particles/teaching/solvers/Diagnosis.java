package particles.teaching.solvers;

import java.util.Optional;
import particles.teaching.Finding;

/**
 * The diagnosis of a solver: its method, and the mistake found.
 *
 * @param identity the method in a sentence, such as "This is the midpoint method", whose full stop follows; or a whole
 *                 sentence
 * @param finding  the mistake, or a note
 * @param order    the order that its coefficients have; 0 if they were not read
 * @param method   the name of a known method that it is; empty if it is none, or if that is not sure
 */
record Diagnosis(String identity, Optional<Finding> finding, int order, String method) {

    Diagnosis(String identity, Optional<Finding> finding) {
        this(identity, finding, 0, "");
    }
}
