package particles;

import static deSolvers.problems.Bounds.assertBelow;
import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import deSolvers.implicit.RadauIIASolver;
import deSolvers.linear.SolverWork;
import deSolvers.problems.PlainSource;
import deSolvers.problems.Steps;
import java.util.Set;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import particles.law.Effect;
import particles.law.Effect.Trait;
import particles.law.Particles;

/** Radau's steps of particle systems through their 3 x 3 blocks, against the same steps with a full matrix. */
class RadauParticlesTest {
    private static final double FRAME = 1.0 / 30;

    /** A chain that swings down from the horizontal; n masses of 20 g, 8 cm apart, the first of them fixed. */
    private static ParticleSystem chain(int n, double stiffness, double damping) {
        return Cloth.chain(n, 0.02, 0.08, stiffness, damping);
    }

    /** A force without known derivatives, across the motion and dependent on position and velocity. */
    private static final class Swirl implements Effect {
        @Override
        public String getName() {
            return "swirl";
        }

        @Override
        public Set<Trait> getTraits() {
            return Set.of();
        }

        @Override
        public void addForces(double[] state, double time, double[] force) {
            for (int x = 0; x < force.length; x += Particles.STRIDE) {
                force[x + 3] += 0.3 * state[x + 2] * state[x + 1];
                force[x + 5] -= 0.2 * state[x + 3] * state[x] + 0.01 * state[x + 5];
            }
        }

        @Override
        public boolean dependsOnVelocity() {
            return true;
        }
    }

    /**
     * Nearly the same sub-steps and path with blocks and with the full matrix: a mild case with diagonal blocks; one so
     * stiff and damped that the matrix is factorised; backwards in time, where damping adds energy; and a
     * chain, mild and stiff, with a force without known derivatives, so that blocks are not the whole Jacobian.
     */
    @Tag("slow")
    @ParameterizedTest
    @CsvSource(textBlock = """
            70, 1000, 0.4, false, 2,   3e-11
            8,  1e6,  200, false, 15,  1e-8
            8,  1e6,  200, false, -15, 1e-12
            20, 100,  0.4, true,  1,   1e-13
            20, 1e5,  60,  true,  1,   4e-10
            """)
    void blocksLeadToTheSamePathAsAFullMatrix(int n, double stiffness, double damping, boolean swirl, int steps,
    double bound) {
        ParticleSystem system = chain(n, stiffness, damping);
        ParticleSystem twin = chain(n, stiffness, damping);
        if (swirl) {
            system.addEffect(new Swirl());
            twin.addEffect(new Swirl());
        }
        RadauIIASolver solver = new RadauIIASolver(1e-7, 1e-9);
        RadauIIASolver plain = new RadauIIASolver(1e-7, 1e-9);
        for (int i = 0; i < Math.abs(steps); i++) {
            solver.stepState(system, steps > 0 ? FRAME : -1e-5);
            plain.stepState(new PlainSource(twin), steps > 0 ? FRAME : -1e-5);
        }
        // Measured 3.4e-12, 1.0e-9, 2.7e-14, 3.2e-14 and 4.9e-11, on positions of up to 6 m.
        assertArrayEquals(twin.getStateArray(), system.getStateArray(), bound);
        assertEquals(swirl, solver.getWork().products > 0, "differences only where needed");
        assertTrue(stiffness < 1e5 || solver.getWork().factorisations > 0, "factorised when stiff");
        double newton = (double) solver.getWork().newtonIterations / plain.getWork().newtonIterations;
        // Measured 0.96 to 1.03
        assertBelow(1.1, newton, "solutions good enough for Newton's iteration");
    }

    /** The work of a Newton iteration is proportional to the number of links, mild or stiff. */
    @ParameterizedTest
    @CsvSource({"1000, 0.4, 300", "1e6, 200, 1000"})
    void theWorkIsProportionalToTheChain(double stiffness, double damping, double most) {
        for (int n : new int[] {50, 200, 800}) {
            RadauIIASolver solver = new RadauIIASolver(1e-4, 1e-7);
            solver.stepState(chain(n, stiffness, damping), FRAME);
            double each = (double) solver.getWork().blockOperations / solver.getWork().newtonIterations / n;
            // Measured with 50, 200 and 800: 127, 99 and 100; stiff, with factors, 558, 617 and 627.
            assertBelow(most, each, n);
        }
    }

    /** On a cloth of 32 x 32 a Newton iteration costs no more per particle than on one of 8 x 8. */
    @Test
    void aClothsWorkIsProportionalToItsParticles() {
        for (int n : new int[] {8, 32}) {
            RadauIIASolver solver = new RadauIIASolver(1e-3, 1e-6);
            ParticleSystem cloth = Cloth.hanging(n, 100, 0.05);
            Steps.make(3, solver, cloth, FRAME);
            SolverWork work = solver.getWork();
            double each = (double) work.blockOperations / work.newtonIterations / (n * n);
            // Measured 520 and 222 products of a block for a particle, and 616 and 784 evaluations; the small cloth's
            // matrix is always factorised.
            assertTrue(each < 600 && cloth.getEvaluations() < 1600, n + ": " + each + " " + cloth.getEvaluations());
            assertEquals(1, work.factorisations, "the same factors serve three frames of free fall");
        }
    }
}
