package deSolvers.implicit;

import static deSolvers.problems.Bounds.assertBelow;
import static deSolvers.problems.KnownSolutions.decay;
import static deSolvers.problems.KnownSolutions.protheroRobinson;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import deSolvers.DESolver;
import deSolvers.problems.ReferenceProblem;
import java.util.List;
import java.util.function.Supplier;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/** Solvers for stiff systems: no growth with steps far longer than the fastest decay. Explicit solvers fail this. */
class StiffSolversTest {
    private static final double Z = -1e6;

    /**
     * @param maker  makes a solver, which makes one step of its method for each call
     * @param factor |R(-1e6)|, the factor of one step of s' = -1e6 s with deltaT = 1
     * @param order  the order in deltaT on the stiff Prothero-Robinson problem, by theory
     * @param error  a bound on the error of that problem, L = -1e6, after 16 steps of 1/16 s
     */
    private record Method(Supplier<DESolver> maker, double factor, double order, double error) {
    }

    static List<Method> stiffSolvers() {
        return List.of(
                // errs by h/(2 L) y'' = 3.1e-8 a step, of which the next step leaves nothing
                new Method(BackwardEulerSolver::new, 1 / (1 + 1e6), 1, 4e-8),
                // each step errs by h^2/4 y'' = 9.8e-4 with the sign of the last undone, no less for larger L
                new Method(ImplicitMidpointSolver::new, (5e5 - 1) / (5e5 + 1), 2, 1.2e-3),
                // with a tolerance that everything satisfies, every call is one step, of factor about 3/|z|;
                // the order of the stages and a factor of 1/L: measured 3.05e-12
                new Method(() -> new RadauIIASolver(1e-9, 1e30),
                        (1 + Z * (2.0 / 5 + Z / 20)) / (1 + Z * (-3.0 / 5 + Z * (3.0 / 20 - Z / 60))), 3, 5e-12));
    }

    @ParameterizedTest
    @MethodSource("stiffSolvers")
    void stiffSystemsAreFollowedWithLongSteps(Method method) {
        assertNoGrowth(method.maker.get(), method.factor);
        assertStiffOrder(method.maker, method.order, method.error);
    }

    /**
     * Asserts that steps of s' = -1e6 s with deltaT = 1 never grow, and that the first multiplies by the given factor.
     */
    private static void assertNoGrowth(DESolver solver, double factor) {
        ReferenceProblem decay = decay(1e6);
        double before = 1;
        for (int i = 0; i < 20; i++) {
            solver.stepState(decay, 1);
            double after = Math.abs(decay.getState()[0]);
            assertTrue(after <= before, "step " + i + ": " + after + " after " + before);
            if (i == 0) {
                assertEquals(factor, after, 1e-9 * factor);
            }
            before = after;
        }
    }

    /**
     * Asserts that the error on the Prothero-Robinson problem, L = -1e6, is small and falls with the theoretical order.
     */
    private static void assertStiffOrder(Supplier<DESolver> solvers, double order, double bound) {
        double coarse = protheroRobinsonError(solvers.get(), 16);
        double fine = protheroRobinsonError(solvers.get(), 64);
        assertBelow(bound, coarse);
        double slope = StrictMath.log(coarse / fine) / StrictMath.log(4);
        assertEquals(order, slope, 0.1);
    }

    private static double protheroRobinsonError(DESolver solver, int steps) {
        ReferenceProblem problem = protheroRobinson(-1e6);
        double worst = 0;
        for (int i = 0; i < steps; i++) {
            solver.stepState(problem, 1.0 / steps);
            worst = Math.max(worst, problem.error());
        }
        return worst;
    }
}
