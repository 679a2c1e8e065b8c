package particles.teaching.solvers;

import java.util.List;
import particles.teaching.Finding;

/**
 * The result of checking a solver: its method, mistakes and advice.
 *
 * @param identity  the method, in a sentence
 * @param findings  mistakes and advice
 * @param multistep whether a step uses earlier ones
 */
public record SolverVerdict(String identity, List<Finding> findings, boolean multistep) {

    /** @return the mistakes */
    public List<Finding> wrong() {
        return findings.stream().filter(Finding::isWrong).toList();
    }
}
