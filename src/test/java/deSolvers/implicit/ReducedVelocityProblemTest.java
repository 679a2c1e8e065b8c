package deSolvers.implicit;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import deSolvers.JacobianStateSource.Blocks;
import deSolvers.StepTransaction;
import deSolvers.linear.Gmres;
import deSolvers.linear.ImplicitWork;
import java.util.Arrays;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** The equation M (v0 - v) + g F(x0 + g v, v) = 0 of particles, and each way in which its corrections are found. */
class ReducedVelocityProblemTest {
    private static final double G = 0.25;
    private static final double TOLERANCE = 1e-7;

    private final ImplicitWork.Counter work = new ImplicitWork.Counter();
    private final ReducedVelocityProblem problem = new ReducedVelocityProblem(work);
    private final Random random = new Random(8);
    private double[] start;

    private void begin(BlockParticles particles, double g) {
        start = particles.state();
        problem.begin(new StepTransaction(new BackwardEulerSolver()).begin(particles, G), particles, start, g,
                TOLERANCE);
    }

    private double[] random(int n) {
        return random.doubles(n, -1, 1).toArray();
    }

    private double[] stage(double[] v) {
        double[] stage = new double[2 * v.length];
        for (int i = 0; i < v.length; i++) {
            int at = 6 * (i / 3) + i % 3;
            stage[at] = start[at] + G * v[i];
            stage[at + 3] = v[i];
        }
        return stage;
    }

    @Test
    void theResidualIsThatOfTheVelocities() {
        BlockParticles particles = new BlockParticles(5, 3, false, Blocks.EXACT);
        begin(particles, G);
        assertEquals(15, problem.size());
        double[] v = new double[15];
        problem.startVelocities(v);
        for (int i = 0; i < 15; i++) {
            assertEquals(start[6 * (i / 3) + 3 + i % 3], v[i]);
        }
        v = random(15);
        double[] stage = new double[30];
        problem.stage(v, stage);
        assertArrayEquals(stage(v), stage);
        double[] residual = new double[15];
        problem.evaluate(v, residual);
        assertArrayEquals(stage, particles.state(), "the source is there");
        double[] dSdt = new double[30];
        particles.getStateDerivative(dSdt);
        for (int i = 0; i < 15; i++) {
            int at = 6 * (i / 3) + 3 + i % 3;
            double mass = i / 3 == 1 ? 1 : particles.mass(i / 3);
            assertEquals(mass * (start[at] - v[i] + G * dSdt[at]), residual[i], 1e-15 * mass);   // measured 0
        }
    }

    /** Velocities, with the one of the particle that is held 0 if it is to be at rest. */
    private static double[] atRest(double[] v, boolean rest) {
        if (rest && v.length > 3) {
            Arrays.fill(v, 3, 6, 0);
        }
        return v;
    }

    /**
     * What is left of (M - g C - g^2 K) correction = residual, by the source's own product; as a part of the residual.
     */
    private double left(BlockParticles particles, double[] v, double[] correction, double[] residual) {
        int n = v.length;
        double[] direction = new double[2 * n];
        double[] product = new double[2 * n];
        for (int i = 0; i < n; i++) {
            int at = 6 * (i / 3) + i % 3;
            direction[at] = G * correction[i];
            direction[at + 3] = correction[i];
        }
        particles.setState(stage(v));
        particles.getJacobianProduct(direction, product);
        double[] rest = new double[n];
        for (int i = 0; i < n; i++) {
            double mass = particles.mass(i / 3) == 0 ? 1 : particles.mass(i / 3);
            rest[i] = residual[i] - mass * (correction[i] - G * product[6 * (i / 3) + 3 + i % 3]);
        }
        return Gmres.norm(rest) / Gmres.norm(residual);
    }

    /**
     * Up to 64 particles and where it is less work the matrix is factorised; otherwise it takes conjugate gradients, or
     * GMRES where it is not symmetric. Blocks that are not all of it serve as a preconditioner for products at the
     * place of the linearisation, wherever the source has been since.
     */
    @ParameterizedTest
    @CsvSource({"1, 5, true, EXACT", "2, 5, false, EXACT", "64, 5, false, EXACT", "64, 1e4, true, EXACT",
        "65, 5, true, EXACT", "65, 5, false, EXACT", "65, 2e5, true, EXACT", "65, 2e5, false, EXACT",
                "64, 5, false, APPROXIMATE",
        "65, 5, true, APPROXIMATE", "65, 5, false, APPROXIMATE", "100, 2e5, true, APPROXIMATE", "3, 5, false, EXACT"})
    void correctionsSolveTheLinearisedEquation(int n, double stiffness, boolean symmetric, Blocks blocks) {
        BlockParticles particles = new BlockParticles(n, stiffness, symmetric, blocks);
        begin(particles, G);
        for (int round = 1; round <= 2; round++) {
            double[] v = random(3 * n);
            problem.linearise(v);
            double[] residual = new double[3 * n];
            problem.evaluate(atRest(random(3 * n), round == 1), residual);
            double[] correction = random(3 * n);
            assertTrue(problem.correct(residual, correction));
            particles.products = 0;
            double left = left(particles, v, correction, residual);
            // Measured 2.4e-8 with conjugate gradients, whose norm is another one, 8.7e-9 with GMRES and 5.6e-15 with
            // factors.
            assertTrue(left < TOLERANCE, "left " + left);
            boolean factorised = n <= 64 || stiffness > 1e4;
            assertEquals(factorised ? round : 0, work.factorisations);
            // Symmetric factors leave out what a held particle that moves does to the others: that takes an iteration
            // or two.
            boolean iterates = !factorised || blocks != Blocks.EXACT || round == 2 && symmetric && n > 1;
            assertEquals(iterates, work.krylovIterations > 0);
            assertEquals(blocks != Blocks.EXACT, work.products > 0);
            assertTrue(work.krylovIterations < 60 * round, work.krylovIterations + " iterations");
            assertEquals(round, work.jacobians);
        }
    }

    /** What no matrix can take away: a particle that is pushed out by just as much as it is inert. */
    @Test
    void aSingularMatrixIsRefused() {
        BlockParticles particles = new BlockParticles(1, 0, true, Blocks.EXACT);
        assertEquals(0, particles.mass(0), "held");
        begin(particles, G);
        problem.linearise(new double[3]);
        double[] correction = new double[3];
        assertTrue(problem.correct(new double[] {1, 2, 3}, correction));
        assertArrayEquals(new double[] {1, 2, 3}, correction, "a held particle's row is that of the unit matrix");

        BlockParticles free = new BlockParticles(70, 0, true, Blocks.EXACT);
        free.cubic = -free.mass(0) / (3 * G * G);       // 3 x^2 g^2 = mass/cubic at x = 1
        double[] state = free.state();
        state[0] = 1;
        state[1] = 1;
        state[2] = 1;
        free.setState(state);
        begin(free, G);
        problem.linearise(new double[210]);
        double[] residual = atRest(random(210), true);
        assertFalse(problem.correct(residual, new double[210]));
        assertFalse(problem.lineariseDefinite(new double[210]));
        free.cubic = -0.5 * free.mass(0) / (3 * G * G);
        problem.linearise(new double[210]);
        assertTrue(problem.correct(residual, new double[210]));
    }

    /**
     * Compressed springs make the matrix indefinite; the one for the way down is definite all the same, small or large.
     */
    @ParameterizedTest
    @CsvSource({"10, EXACT", "80, EXACT", "10, APPROXIMATE", "80, APPROXIMATE"})
    void aDefiniteMatrixGoesDownhill(int n, Blocks blocks) {
        BlockParticles particles = new BlockParticles(n, -100, true, blocks);
        begin(particles, G);
        int uphill = 0;
        for (int round = 0; round < 40; round++) {
            double[] v = random(3 * n);
            double[] residual = atRest(random(3 * n), true);
            double[] correction = new double[3 * n];
            assertTrue(problem.lineariseDefinite(v));
            assertTrue(problem.correct(residual, correction));
            assertTrue(Gmres.dot(residual, correction) > 0, "downhill");
            problem.linearise(v);
            uphill += problem.correct(residual, correction) && Gmres.dot(residual, correction) > 0 ? 0 : 1;
        }
        assertTrue(uphill > 0, "the exact one is not definite");
        assertEquals(blocks == Blocks.APPROXIMATE, particles.products > 0);
    }

    /** Conjugate gradients find out that a matrix is not definite, and leave it to GMRES. */
    @Test
    void anIndefiniteMatrixIsLeftToGmres() {
        BlockParticles particles = new BlockParticles(80, -20, true, Blocks.EXACT);
        begin(particles, G);
        int uphill = 0;
        for (int round = 0; round < 10; round++) {
            double[] v = random(240);
            double[] residual = atRest(random(240), true);
            double[] correction = new double[240];
            problem.linearise(v);
            assertTrue(problem.correct(residual, correction));
            double left = left(particles, v, correction, residual);
            assertTrue(left < TOLERANCE, "left " + left);                              // measured 5e-8
            uphill += Gmres.dot(residual, correction) < 0 ? 1 : 0;
        }
        assertTrue(uphill > 0, "the matrix is not definite");
        assertEquals(0, work.factorisations);
    }

    /**
     * The terms of the residual are sums and products, each correct to half a unit: four halves of the sum of their
     * sizes.
     */
    @ParameterizedTest
    @CsvSource({"0.25", "-0.25"})
    void roundingIsMeasuredByTheTermsOfTheResidual(double g) {
        BlockParticles particles = new BlockParticles(6, 3, true, Blocks.EXACT);
        begin(particles, g);
        double[] v = random(18);
        problem.linearise(v);
        double[] scale = particles.forceScale(particles.state());
        double[] floor = new double[18];
        problem.rounding(v, floor);
        for (int i = 0; i < 18; i++) {
            double mass = i / 3 == 1 ? 1 : particles.mass(i / 3);
            double terms = mass * (Math.abs(start[6 * (i / 3) + 3 + i % 3]) + Math.abs(v[i])) + Math.abs(g) * scale[i];
            assertEquals(2 * Math.ulp(1.0) * terms, floor[i], 1e-14 * floor[i] + 1e-300);
            assertTrue(floor[i] > 0);
        }
        // At rest in the origin nothing is rounded, and the floor is the smallest normal number.
        particles.setState(new double[36]);
        begin(particles, g);
        problem.linearise(new double[18]);
        problem.rounding(new double[18], floor);
        assertEquals(Double.MIN_NORMAL, floor[7]);
    }
}
