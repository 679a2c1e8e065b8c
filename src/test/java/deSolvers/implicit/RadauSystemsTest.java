package deSolvers.implicit;

import static deSolvers.implicit.RadauTableau.MU;
import static deSolvers.implicit.RadauTableau.MU_IM;
import static deSolvers.implicit.RadauTableau.MU_RE;
import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import deSolvers.DEStateSource;
import deSolvers.JacobianStateSource.Blocks;
import deSolvers.StepTransaction;
import deSolvers.linear.Gmres;
import deSolvers.linear.ImplicitWork;
import deSolvers.problems.Law;
import java.util.Arrays;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/**
 * (mu - h J) x = b, real and complex, in each of the ways to solve it: what is left of b, by the source's own product.
 */
class RadauSystemsTest {
    /** When the Jacobian is taken up. */
    private static final double OFFSET = 0.25;

    private final ImplicitWork.Counter work = new ImplicitWork.Counter();
    private final Random random = new Random(77);
    private double[] state;

    private RadauSystems systems(String kind, int n) {
        return kind.equals("dense") ? new DenseRadauSystems(work, n)
                : kind.equals("products") ? new KrylovRadauSystems(work, n) : new BlockRadauSystems(work, n);
    }

    private void setJacobian(RadauSystems systems, BlockParticles particles, double h) {
        state = random.doubles(particles.getStateSize(), -1, 1).toArray();
        particles.startAt(0);
        StepTransaction step = begin(particles);
        double[] slope = new double[state.length];
        step.setState(state);
        step.setOffset(OFFSET);
        step.getStateDerivative(slope);
        step.setOffset(0.5);
        systems.setJacobian(step, state, slope, OFFSET, h);
        // the source may be anywhere when systems are solved
        step.setState(random.doubles(state.length).toArray());
        step.setOffset(0.75);
    }

    private void moveTo(BlockParticles particles) {
        particles.setState(state);
        particles.incTime(OFFSET - particles.getTime());
    }

    /** b - (mu - h J) x as a part of b. */
    private double leftOfReal(BlockParticles particles, double h, double[] b, double[] x) {
        double[] product = new double[x.length];
        moveTo(particles);
        particles.getJacobianProduct(x, product);
        double[] rest = new double[x.length];
        Arrays.setAll(rest, i -> b[i] - MU * x[i] + h * product[i]);
        return Gmres.norm(rest) / Gmres.norm(b);
    }

    private double leftOfComplex(BlockParticles particles, double h, double[] b, double[] x) {
        int n = x.length / 2;
        double[] rest = b.clone();
        moveTo(particles);
        for (int half = 0; half < 2; half++) {
            int at = half;
            double[] part = new double[n];
            double[] product = new double[n];
            Arrays.setAll(part, i -> x[2 * i + at]);
            particles.getJacobianProduct(part, product);
            for (int i = 0; i < n; i++) {
                rest[2 * i + half] += h * product[i] - MU_RE * part[i];
                rest[2 * i + 1 - half] -= (half == 0 ? 1 : -1) * MU_IM * part[i];
            }
        }
        return Gmres.norm(rest) / Gmres.norm(b);
    }

    /**
     * Any right side whose positions are so small that they weigh no more, times their stiffness, than its velocities.
     */
    private double[] right(int numbers, BlockParticles particles) {
        double[] b = random.doubles((long) numbers * state.length, -1, 1).toArray();
        for (int i = 0; i < b.length; i++) {
            b[i] /= i / (3 * numbers) % 2 == 0 ? Math.max(1, particles.stiffness / 5) : 1;
        }
        return b;
    }

    private void assertSolved(RadauSystems systems, BlockParticles particles, double h, double most) {
        double[] b = right(1, particles);
        double[] x = new double[state.length];
        assertTrue(systems.solveReal(b, x));
        double left = leftOfReal(particles, h, b, x);
        assertTrue(left < most, "real: " + left);
        double[] complexB = right(2, particles);
        double[] complexX = new double[2 * state.length];
        assertTrue(systems.solveComplex(complexB, complexX));
        left = leftOfComplex(particles, h, complexB, complexX);
        assertTrue(left < most, "complex: " + left);
    }

    /**
     * A full matrix; GMRES with products; blocks that are all of the Jacobian, mild and so stiff that they are
     * factorised, and blocks that are not. Measured 2.3e-16 with a full matrix. GMRES leaves 1e-5 of b (measured
     * 5.0e-6); with blocks 1e-4 of the velocities' equation, in which masses weigh (measured 1.4e-4, and 2.2e-4 where
     * it is stiff).
     */
    @ParameterizedTest
    @CsvSource({"dense, 1, 5, EXACT, 2e-15", "dense, 6, 5, NONE, 2e-15", "products, 6, 5, NONE, 1e-5",
            "products, 20, 5, NONE, 1e-5",
        "blocks, 20, 5, EXACT, 2e-4", "blocks, 20, 1e5, EXACT, 1e-3", "blocks, 20, 5, APPROXIMATE, 2e-4",
        "blocks, 20, 1e5, APPROXIMATE, 1e-3"})
    void whatIsLeftIsWithinTheTolerance(String kind, int n, double stiffness, Blocks blocks, double most) {
        BlockParticles particles = new BlockParticles(n, stiffness, false, blocks);
        RadauSystems systems = systems(kind, 6 * n);
        boolean full = kind.equals("dense");
        boolean byBlocks = kind.equals("blocks");
        for (int round = 1; round <= 2; round++) {
            setJacobian(systems, particles, 0.3);
            for (double h : new double[] {0.3, -0.3, 0.2, 1}) {
                assertTrue(systems.prepare(h, MU, MU_RE, MU_IM));
                assertSolved(systems, particles, h, most);
            }
            assertEquals(round, work.jacobians);
            assertEquals(full, work.krylovIterations == 0);
            assertEquals(full || byBlocks && blocks == Blocks.EXACT, systems.keepsJacobian());
        }
        assertEquals(full || byBlocks && stiffness > 1e4, work.factorisations > 0);
        assertTrue(!full || work.factorisations == 16, "two for each length: " + work.factorisations);
        assertEquals(byBlocks && blocks == Blocks.EXACT, work.products == 0);
    }

    /**
     * Factors serve while the sub-step has not changed to twice or half of theirs; beyond it, and backwards, there are
     * new ones.
     */
    @Test
    void factorsAreKeptWhileTheyServe() {
        BlockParticles particles = new BlockParticles(30, 1e5, true, Blocks.EXACT);
        BlockRadauSystems systems = new BlockRadauSystems(work, 180);
        setJacobian(systems, particles, 0.3);
        double[][] lengthsAndFactorisations = {{0.3, 1}, {0.58, 1}, {0.16, 1}, {0.3, 1}, {0.62, 2}, {0.32, 2}, {0.3, 3},
                {-0.3, 4},
            {0.3, 5}};
        for (double[] each : lengthsAndFactorisations) {
            assertTrue(systems.prepare(each[0], MU, MU_RE, MU_IM));
            assertEquals(each[1], work.factorisations, "at " + each[0]);
        }
        setJacobian(systems, particles, 0.3);
        assertTrue(systems.prepare(0.3, MU, MU_RE, MU_IM));
        assertEquals(5, work.factorisations, "another state's may serve");
        // While they cost no more than when they were new they are kept; when they have cost as much as new ones would,
        // not.
        double[] b = right(2, particles);
        double[] x = new double[b.length];
        for (double[] each : new double[][] {{0.3, 5}, {0.58, 6}}) {
            for (int n = 0; n < 200; n++) {
                assertTrue(systems.prepare(each[0], MU, MU_RE, MU_IM) && systems.solveComplex(b, x));
            }
            assertEquals(each[1], work.factorisations, "at " + each[0]);
        }
    }

    private StepTransaction begin(DEStateSource source) {
        return new StepTransaction(new RadauIIASolver()).begin(source, 1);
    }

    /** mu = 1, h = 1 and s' = s: there is nothing to solve then. */
    @ParameterizedTest
    @CsvSource({"dense", "products"})
    void aSingularSystemIsRefused(String kind) {
        Law growth = new Law((t, s, dSdt) -> System.arraycopy(s, 0, dSdt, 0, 2), 0, 0);
        RadauSystems systems = systems(kind, 2);
        systems.setJacobian(begin(growth), new double[2], new double[2], 0, 1);     // differences are exact at 0
        double[] x = new double[2];
        assertFalse(systems.prepare(1, 1, 2, 0) && systems.solveReal(new double[] {1, 1}, x), "real");
        assertFalse(systems.prepare(1, 2, 1, 0) && systems.solveComplex(new double[] {1, 1, 1, 1}, new double[4]),
                "complex");
        assertTrue(systems.prepare(1, 2, 2, 0) && systems.solveReal(new double[] {3, 4}, x));
        assertArrayEquals(new double[] {3, 4}, x, 1e-14);
    }

    /** Nor is there where a particle is pushed out by just as much as it is inert. */
    @Test
    void aSingularBlockIsRefused() {
        BlockParticles particles = new BlockParticles(3, 0, true, Blocks.EXACT);
        particles.cubic = -particles.mass(0) / 3;       // dF/dx = -3 cubic x^2 = 3, the mass, at x = 1
        state = new double[18];
        Arrays.fill(state, 0, 3, 1);
        BlockRadauSystems systems = new BlockRadauSystems(work, 18);
        systems.setJacobian(begin(particles), state, new double[18], 0, 1);
        assertFalse(systems.prepare(1, 1, 1, 0));
        assertTrue(systems.prepare(0.5, 1, 1, 0));
    }
}
