package deSolvers.implicit;

import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import deSolvers.DESolver;
import deSolvers.DESolverException;
import deSolvers.EulerSolver;
import deSolvers.MidpointSolver;
import deSolvers.RK4Solver;
import deSolvers.StiffContract;
import java.util.List;
import java.util.function.Supplier;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/** The contrary: every promise for stiff systems is broken by the explicit solvers, with bounds as wide as 1. */
class ExplicitSolversAreNotForStiffSystemsTest {
    /** Has no name, so that it is not taken for tests to run. */
    private static StiffContract claimOf(DESolver solver) {
        return new StiffContract() {
            @Override
            protected DESolver createSolver() {
                return solver;
            }

            @Override
            protected double factorAtMinusAMillion() {
                return 1;
            }

            @Override
            protected double stiffOrder() {
                return 1;
            }

            @Override
            protected double stiffError() {
                return 1;
            }

            @Override
            protected double stiffPairError() {
                return 1;
            }
        };
    }

    static List<Supplier<DESolver>> explicitSolvers() {
        return List.of(EulerSolver::new, MidpointSolver::new, RK4Solver::new);
    }

    @ParameterizedTest
    @MethodSource("explicitSolvers")
    void everyStatementFails(Supplier<DESolver> solver) {
        assertThrows(AssertionError.class, () -> claimOf(solver.get()).aMillionTimesTooLongAStepDoesNotGrow());
        Throwable failure = assertThrows(Throwable.class, () -> claimOf(solver.get()).theStiffOrderOfProtheroAndRobinsonHolds());
        assertTrue(failure instanceof AssertionError || failure instanceof DESolverException, "grown, or overflown: " + failure);
        assertThrows(AssertionError.class,
                () -> claimOf(solver.get()).theStiffPairIsFollowedWithStepsAsLongAsTheSlowPartAllows());
    }
}
