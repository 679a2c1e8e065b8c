package deSolvers;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import deSolvers.problems.Chain;
import deSolvers.problems.Decay;
import deSolvers.problems.LinearPair;
import deSolvers.problems.StepMatrix;
import deSolvers.problems.Steps;
import deSolvers.symplectic.SymplecticEulerSolver;
import deSolvers.symplectic.VelocityVerletSolver;
import java.util.function.DoubleUnaryOperator;
import java.util.function.Supplier;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** The stability limits on both axes, found by bisection on the solvers' real code. */
class StabilityLimitTest {
    private static double growthOfDecay(DESolver solver, double h) {
        Decay decay = new Decay(1);
        solver.stepState(decay, h);
        return Math.abs(decay.getState()[0]);
    }

    /** The larger eigenvalue's modulus of the 2x2 matrix of one step on x'' = -x. */
    private static double growthOfOscillator(DESolver solver, double h) {
        return StepMatrix.of(solver, LinearPair.spring(1, 0), 1, h, 1).radius();
    }

    private static double limit(DoubleUnaryOperator growth) {
        return Steps.bisect(0.5, 4, h -> growth.applyAsDouble(h) <= 1 + 1e-12);
    }

    @Test
    void limitsOnTheRealAxisMatchTheory() {
        assertEquals(2, limit(h -> growthOfDecay(new EulerSolver(), h)), 1e-9);
        assertEquals(2, limit(h -> growthOfDecay(new MidpointSolver(), h)), 1e-9);
        assertEquals(2.785293563405, limit(h -> growthOfDecay(new RK4Solver(), h)), 1e-9);
    }

    @Test
    void limitsOnTheImaginaryAxisMatchTheory() {
        assertEquals(2 * Math.sqrt(2), limit(h -> growthOfOscillator(new RK4Solver(), h)), 1e-9);
        assertEquals(2, limit(h -> growthOfOscillator(new SymplecticEulerSolver(), h)), 1e-9);
        assertEquals(2, limit(h -> growthOfOscillator(new VelocityVerletSolver(), h)), 1e-9);
    }

    @Test
    void eulerAndMidpointGrowOnTheImaginaryAxisHoweverSmallTheStep() {
        for (double h : new double[] {0.001, 0.01, 0.1}) {
            assertEquals(Math.sqrt(1 + h * h), growthOfOscillator(new EulerSolver(), h), 1e-15);
        }
        assertEquals(1, (growthOfOscillator(new MidpointSolver(), 0.1) - 1) / (1e-4 / 8), 1e-4);    // h^4/8
        assertEquals(1, (1 - growthOfOscillator(new RK4Solver(), 0.1)) / (1e-6 / 144), 0.01);       // h^6/144
    }

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
