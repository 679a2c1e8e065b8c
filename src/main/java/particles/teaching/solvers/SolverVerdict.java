package particles.teaching.solvers;

import java.util.List;
import java.util.Optional;
import particles.teaching.Finding;
import particles.teaching.declared.Method;

/**
 * The result of checking a solver: its method, mistakes and advice.
 *
 * @param method    the known method that it is; empty if it is none
 * @param identity  what it is, in a sentence
 * @param findings  at most one mistake, and advice
 * @param multistep whether a step uses earlier ones
 */
public record SolverVerdict(Optional<Method> method, String identity, List<Finding> findings, boolean multistep) {

    /** @return the mistakes */
    public List<Finding> wrong() {
        return findings.stream().filter(Finding::isWrong).toList();
    }
}
