package deSolvers.implicit;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import deSolvers.DEStateSource;
import deSolvers.EulerSolver;
import deSolvers.JacobianStateSource.Blocks;
import deSolvers.StepTransaction;
import deSolvers.linear.SolverWork;
import deSolvers.problems.Law;
import deSolvers.problems.PlainSource;
import deSolvers.problems.Steps;
import java.util.Arrays;
import java.util.Random;
import java.util.function.BiFunction;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.EnumSource;

/** I - g J in its two forms: they solve the same systems. */
class ShiftedJacobianTest {
    private final SolverWork work = new SolverWork();

    /** The solutions of a real and a complex system one after the other, with the Jacobian where the source starts. */
    private static double[] solve(DEStateSource source, ShiftedJacobian jacobian, double g) {
        int n = source.getStateSize();
        double[] state = new double[n];
        double[] slope = new double[n];
        source.getState(state);
        source.getStateDerivative(slope);
        double[] b = new Random(n).doubles(2 * n, -1, 1).toArray();
        double[] real = new double[n];
        double[] complex = new double[2 * n];
        double[] right = Arrays.copyOf(b, n);
        right[9] = 0;                                   // the second particle is held: its velocity stays
        right[10] = 0;
        right[11] = 0;
        Arrays.fill(b, 18, 24, 0);
        try (StepTransaction step = new StepTransaction(EulerSolver.class).begin(source, g)) {
            jacobian.setJacobian(step, state, slope, g, ShiftedJacobian.Kind.EXACT);
            assertTrue(jacobian.prepare(g) && jacobian.prepareComplex(0.6 * g, 0.8 * g));
            assertTrue(jacobian.solve(right, real, 1e-12) && jacobian.solveComplex(b, complex, 1e-12));
        }
        double[] both = Arrays.copyOf(real, 3 * n);
        System.arraycopy(complex, 0, both, n, 2 * n);
        return both;
    }

    /** Blocks against the full matrix; measured at most 3e-12 with exact blocks, of entries up to 1. */
    @ParameterizedTest
    @CsvSource({"EXACT, 10", "EXACT, 1e4", "APPROXIMATE, 10", "APPROXIMATE, 1e4"})
    void blocksSolveWhatTheFullMatrixSolves(Blocks blocks, double stiffness) {
        for (int n : new int[] {3, 20, 90}) {
            BiFunction<ShiftedJacobian, Double, double[]> solution = (jacobian, g) ->
                    solve(new BlockParticles(n, stiffness, n != 20, blocks), jacobian, g);
            double[] full = solution.apply(new DenseSystem(work, 6 * n), 0.05);
            assertArrayEquals(full, solution.apply(new ReducedVelocitySystem(work, 6 * n), 0.05), 1e-9,
                    n + " particles");
        }
    }

    /** Differences are right to half the digits. */
    @Test
    void differencesApproximateTheJacobian() {
        double[] known = solve(new BlockParticles(5, 10, false, Blocks.EXACT), new DenseSystem(work, 30), 0.05);
        double[] approximate = solve(new PlainSource(new BlockParticles(5, 10, false, Blocks.EXACT)),
                new DenseSystem(work, 30), 0.05);
        assertArrayEquals(known, approximate, 1e-6);
    }

    /** Particles with exact blocks keep them sparse, many with others too; other sources get a full matrix. */
    @ParameterizedTest
    @EnumSource(Blocks.class)
    void theFormDependsOnTheSource(Blocks blocks) {
        JacobianChoice choice = new JacobianChoice(work);
        for (int n : new int[] {2, 100, 101}) {
            boolean sparse = blocks == Blocks.EXACT || blocks == Blocks.APPROXIMATE && n == 101;
            assertEquals(sparse ? ReducedVelocitySystem.class : DenseSystem.class,
                    choice.of(new BlockParticles(n, 10, true, blocks)).getClass());
        }
    }

    @Test
    void aFullMatrixThatIsTooLargeIsRefused() {
        Law law = new Law((t, s, dSdt) -> { }, new double[5001]);
        Steps.assertFails(IllegalArgumentException.class, "5001 entries; at most 5000",
                () -> new BackwardEulerSolver().stepState(law, 1));
    }

    /**
     * A projected matrix of springs that all push outwards is that of none: x = b for velocities, b + g v for
     * positions.
     */
    @Test
    void theProjectedMatrixLeavesOutWhatPushesOutwards() {
        BlockParticles pushing = new BlockParticles(30, -1e3, true, Blocks.EXACT);
        pushing.cubic = 0;
        ReducedVelocitySystem system = new ReducedVelocitySystem(work, 180);
        double[] state = new double[180];
        double[] slope = new double[180];
        pushing.getState(state);
        pushing.getStateDerivative(slope);
        double[] b = new Random(1).doubles(180, -1, 1).toArray();
        double[] x = new double[180];
        try (StepTransaction step = new StepTransaction(EulerSolver.class).begin(pushing, 0.01)) {
            system.setJacobian(step, state, slope, 0.01, ShiftedJacobian.Kind.PROJECTED);
            assertTrue(system.prepare(0.01) && system.solve(b, x, 1e-12));
        }
        double before = 0;
        double after = 0;
        for (int i = 0; i < 180; i += 6) {
            for (int c = i; c < i + 3; c++) {
                assertEquals(b[c] + 0.01 * x[c + 3], x[c], 1e-15);
                before += pushing.mass(i / 6) * b[c + 3] * b[c + 3];
                after += pushing.mass(i / 6) * x[c + 3] * x[c + 3];
            }
        }
        // Only damping is left, and damping takes energy away.
        assertTrue(after < before && after > 0.1 * before, after + " of " + before);
    }
}
