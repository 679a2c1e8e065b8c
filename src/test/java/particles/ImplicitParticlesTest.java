package particles;

import static deSolvers.problems.Bounds.assertBelow;
import static org.junit.jupiter.api.Assertions.assertEquals;

import deSolvers.DESolver;
import deSolvers.catalog.SolverCatalog;
import deSolvers.implicit.BackwardEulerSolver;
import deSolvers.implicit.ImplicitMidpointSolver;
import deSolvers.implicit.LinearisedEulerSolver;
import deSolvers.linear.SolverWork;
import deSolvers.problems.PlainSource;
import deSolvers.problems.Steps;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import particles.law.Vector3;
import particles.scene.ShortRun;

/** Implicit steps of particle systems through their 3 x 3 blocks, against the same steps without them. */
class ImplicitParticlesTest {

    private static double largestDifference(ParticleSystem a, ParticleSystem b) {
        double[] s = a.getOwnState();
        double[] t = b.getOwnState();
        double largest = 0;
        for (int i = 0; i < a.getStateSize(); i++) {
            largest = Math.max(largest, Math.abs(s[i] - t[i]));
        }
        return largest;
    }

    /**
     * Small systems are factorised, the one of 81 particles takes conjugate gradients,
     * or GMRES where damping is not symmetric.
     */
    @ParameterizedTest
    @CsvSource(textBlock = """
            5, 100, 0
            5, 100, 0.02
            9, 20,  0
            9, 20,  0.02
            """)
    void blocksLeadToTheSameStepAsAFullMatrix(int n, double stiffness, double damping) {
        for (int kind = 0; kind < 2; kind++) {
            ParticleSystem system = Cloth.hanging(n, stiffness, damping);
            ParticleSystem twin = Cloth.hanging(n, stiffness, damping);
            DESolver solver = kind == 0 ? new BackwardEulerSolver() : new ImplicitMidpointSolver();
            DESolver plain = kind == 0 ? new BackwardEulerSolver() : new ImplicitMidpointSolver();
            for (int i = 0; i < 2; i++) {
                solver.stepState(system, 1.0 / 60);
                plain.stepState(new PlainSource(twin), 1.0 / 60);
            }
            // Measured at most 1.9e-14, on velocities of up to 0.5 m/s.
            assertBelow(1e-13, largestDifference(system, twin));
            assertBelow(60, system.getEvaluations());
        }
    }

    /**
     * A stiff, crumpled cloth, whose compressed springs make the exact matrix indefinite: the solution is found by
     * descent and satisfies the step's own, nonlinear equations v1 = v0 + h a(x1, v1), x1 = x0 + h v1.
     */
    @ParameterizedTest
    @CsvSource(textBlock = """
            8,  1e4, 0
            8,  1e6, 0
            8,  1e6, 0.05
            12, 1e5, 0.05
            """)
    void compressedSpringsDoNotStopNewton(int n, double stiffness, double damping) {
        double h = 1.0 / 60;
        ParticleSystem system = Cloth.hanging(n, stiffness, damping);
        BackwardEulerSolver solver = new BackwardEulerSolver();
        double[] before = new double[system.getStateSize()];
        double[] after = new double[system.getStateSize()];
        double[] dSdt = new double[system.getStateSize()];
        for (int i = 0; i < 3; i++) {
            system.getState(before);
            solver.stepState(system, h);
            system.getState(after);
            system.getStateDerivative(dSdt);
            for (int e = 0; e < after.length; e++) {
                // Rounding of a position enters the velocity by h k/m: 1.7e6 at the stiffest, times 1e-16.
                // Measured a fifth of the bound.
                double rounding = h * stiffness / 0.01 * 2e-15 + 1e-12;
                assertEquals(before[e] + h * dSdt[e], after[e], rounding, "entry " + e + " after step " + i);
            }
        }
        // Measured 74 to 130 evaluations for the three steps.
        assertBelow(300, system.getEvaluations());
    }

    /** Each of these needs the step near a saddle, and new factors where those of an earlier matrix fail. */
    @ParameterizedTest
    @CsvSource({"12, backward-euler", "16, implicit-midpoint"})
    void aLevelClothOfStiffSpringsBuckles(int n, String solver) {
        ParticleSystem system = Cloth.level(n, 1e6);
        DESolver steps = SolverCatalog.create(solver);
        Steps.make(12, steps, system, 1.0 / 60);
        // Measured 148 and 160 evaluations.
        assertBelow(480, system.getEvaluations());
    }

    /**
     * Linear systems are solved to 1e-4 by iterations. Measured, as a part of the sum of m |v|: 1.3e-4 for the
     * linearised step of the softer cloth; 2e-12 where the matrix is factorised, 3e-11 with Newton's method.
     */
    @ParameterizedTest
    @CsvSource({"60, linearised-euler, 1e-3", "1e5, linearised-euler, 3e-10", "60, backward-euler, 3e-10"})
    void aFreeClothKeepsItsMomentum(double stiffness, String solver, double bound) {
        ParticleSystem system = Cloth.thrown(24, stiffness);
        DESolver steps = SolverCatalog.create(solver);
        double[] before = momentum(system);
        Steps.make(10, steps, system, 1.0 / 60);
        double[] after = momentum(system);
        for (int c = 0; c < 3; c++) {
            assertEquals(before[c], after[c], bound * before[3]);
        }
    }

    /** The momentum in each direction, and the sum of m |v| (N s). */
    private static double[] momentum(ParticleSystem system) {
        double[] state = system.getOwnState();
        double[] sum = new double[4];
        for (int v = 3; v < state.length; v += 6) {
            for (int c = 0; c < 3; c++) {
                sum[c] += 0.001 * state[v + c];
            }
            sum[3] += 0.001 * new Vector3(state[v], state[v + 1], state[v + 2]).length();
        }
        return sum;
    }

    /** Elimination without pivoting is so accurate that one iteration, which checks it, is enough. */
    @Test
    void aFactorisedMatrixNeedsOneIteration() {
        LinearisedEulerSolver solver = new LinearisedEulerSolver();
        ParticleSystem system = Cloth.hanging(24, 1e6, 0.05);
        solver.stepState(system, 1.0 / 60);
        SolverWork work = solver.getWork();
        assertEquals(1, work.factorisations);
        assertEquals(1, work.iterations);      // to 1e-4, at a condition of about 1e6
        assertEquals(1, system.getEvaluations());
    }

    /**
     * omega h = 20: each step of backward Euler divides the amplitude by the root of 1 + 20^2, so after 223 steps it is
     * below 1e-290, where the spring has no direction. Newton's iteration stopped there, at t = 222 s.
     */
    @Test
    void aMotionThatIsDampedToNothingEndsThere() {
        ShortRun run = ShortRun.of("backward-euler clamp 1 300", """
                particles: [{id: hook, position: [0, 0, 0], fixed: true}, {id: bob, position: [1, 0, 0]}]
                springs: [{from: hook, to: bob, stiffness: 400, restLength: 0}]
                effects: []
                """);
        assertEquals(0, run.distance(0, 1), 1e-289);
    }
}
