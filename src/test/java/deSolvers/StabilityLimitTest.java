package deSolvers;

import static org.junit.jupiter.api.Assertions.assertTrue;

import deSolvers.problems.Chain;
import deSolvers.problems.Steps;
import deSolvers.symplectic.SymplecticEulerSolver;
import deSolvers.symplectic.VelocityVerletSolver;
import java.util.function.Supplier;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** The stability limits on chains of springs. */
class StabilityLimitTest {
    /** Fixed-fixed chains, m = k = 1, omega_max = 2 sin(n pi / (2 (n + 1))), started in the fastest mode. */
    @ParameterizedTest
    @CsvSource({"1, 1.414213562, 2.000000000", "2, 1.154700538, 1.632993162", "10, 1.010283227, 1.428756241",
        "100, 1.000120951, 1.414384613"})
    void theFastestModeSetsTheLargestStepOfAChain(int n, double leapfrog, double rk4) {
        assertLimit(n, leapfrog, SymplecticEulerSolver::new);
        assertLimit(n, leapfrog, VelocityVerletSolver::new);
        assertLimit(n, rk4, RK4Solver::new);
    }

    private static void assertLimit(int n, double limit, Supplier<DESolver> solver) {
        // Below its limit RK4 loses amplitude, verlet keeps it and symplectic Euler's x stays on an ellipse of at most
        // 1/sqrt(1 - 0.999^2) = 22.4 times the start's; above it RK4 grows by 0.7 % per step, the other two by 9 %.
        assertTrue(amplitudeAfter2000(n, limit * 0.999, solver.get()) < 22.4);
        assertTrue(amplitudeAfter2000(n, limit * 1.001, solver.get()) > 1e5);
    }

    private static double amplitudeAfter2000(int n, double deltaT, DESolver solver) {
        Chain chain = new Chain(n, n);
        double largest = 0;
        for (int i = 0; i < 2000; i++) {
            solver.stepState(chain, deltaT);
            double[] s = chain.getState();
            for (int x = 0; x < s.length; x += 2) {
                largest = Math.max(largest, Math.abs(s[x]));
            }
        }
        return largest;
    }
}
