package deSolvers.hard;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import deSolvers.DESolver;
import deSolvers.DESolverException;
import deSolvers.catalog.SolverCatalog;
import deSolvers.problems.ReferenceProblem;
import java.util.Optional;
import java.util.stream.IntStream;

/**
 * A run of one solver on one problem, to its end or to an exception.
 *
 * @param error    the largest deviation from the exact solution where the run ended
 * @param largest  the largest entry of the state seen after any step
 * @param failure  why the run stopped before its end, if it did
 */
record HardRun(double error, double largest, Optional<DESolverException> failure) {
    /**
     * @param solver  a catalogue name
     * @param problem at its start
     * @param deltaT  the step (s)
     * @param steps   how many
     */
    static HardRun of(String solver, ReferenceProblem problem, double deltaT, int steps) {
        DESolver made = SolverCatalog.create(solver);
        double largest = 0;
        for (int i = 0; i < steps; i++) {
            double[] before = problem.getState();
            double time = problem.getTime();
            try {
                made.stepState(problem, deltaT);
            } catch (DESolverException e) {
                assertEquals(time, problem.getTime(), "the clock after a failure");
                IntStream.range(0, before.length).forEach(k -> assertEquals(before[k], problem.getState()[k],
                        "entry " + k));
                return new HardRun(problem.error(), largest, Optional.of(e));
            }
            for (double entry : problem.getState()) {
                assertFalse(Double.isNaN(entry), "a NaN that nobody reported");
                largest = Math.max(largest, Math.abs(entry));
            }
        }
        return new HardRun(problem.error(), largest, Optional.empty());
    }

    /** Requires that the run came to its end, with an error below a bound. */
    HardRun assertFollows(double bound) {
        assertTrue(failure.isEmpty() && error < bound, this::message);
        return this;
    }

    /** Requires that the run failed, with a message that has a part. */
    HardRun assertFails(String part) {
        assertTrue(failure.isPresent() && message().contains(part), this::message);
        return this;
    }

    /** @return the failure's message, or a description of the result */
    String message() {
        return failure.map(Throwable::getMessage).orElse("ended without failure, error " + error + ", largest "
                + largest);
    }
}
