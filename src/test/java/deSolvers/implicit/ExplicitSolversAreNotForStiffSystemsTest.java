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
    static List<Supplier<DESolver>> explicitSolvers() {
        return List.of(EulerSolver::new, MidpointSolver::new, RK4Solver::new);
    }

    @ParameterizedTest
    @MethodSource("explicitSolvers")
    void everyStatementFails(Supplier<DESolver> solver) {
        assertThrows(AssertionError.class, () -> StiffContract.assertNoGrowth(solver.get(), 1));
        Throwable failure = assertThrows(Throwable.class, () -> StiffContract.assertStiffOrder(solver, 1, 1));
        assertTrue(failure instanceof AssertionError || failure instanceof DESolverException,
                "grown, or overflown: " + failure);
        assertThrows(AssertionError.class, () -> StiffContract.assertStiffPair(solver.get(), 1));
    }
}
