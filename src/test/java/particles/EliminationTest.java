package particles;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import deSolvers.implicit.LinearisedEulerSolver;
import deSolvers.implicit.ImplicitWork;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import particles.effects.Gravity;
import particles.effects.springs.SpringForce;
import particles.law.Vector3;

/** Of a step's linear system implicit solvers eliminate the unknowns where that takes less work than iterations. */
class EliminationTest {
    private static final double FRAME = 1.0 / 60;

    private static ImplicitWork work(ParticleSystem system) {
        LinearisedEulerSolver solver = new LinearisedEulerSolver();
        solver.stepState(system, FRAME);
        return solver.getWork();
    }

    /**
     * Where elimination begins neither way takes more work: whichever is taken, none that is much cheaper is missed.
     */
    @ParameterizedTest
    @ValueSource(ints = {16, 20, 24})
    void aClothIsEliminatedFromWhereIterationsWouldTakeMoreWork(int edge) {
        ImplicitWork softer = work(Cloth.hanging(edge, 100, 0));
        assertEquals(0, softer.factorisations());
        int changes = 0;
        for (double stiffness = 110; stiffness < 5000; stiffness *= 1.1) {
            ImplicitWork stiffer = work(Cloth.hanging(edge, stiffness, 0));
            if (stiffer.factorisations() != softer.factorisations()) {
                changes++;
                double ratio = (double) stiffer.blockOperations() / softer.blockOperations();
                // Measured 0.99 and 1.00 with 20 and 24 particles along an edge.
                assertTrue(ratio > 0.9 && ratio < 1.1, ratio + " of the work at " + stiffness + " N/m");
            }
            softer = stiffer;
        }
        assertEquals(1, changes);
        assertEquals(1, softer.factorisations());
    }

    /** A chain of 200 particles that hangs from the first, slightly crumpled. */
    private static ParticleSystem chain(double stiffness) {
        ParticleSystem system = new ParticleSystem();
        SpringForce springs = new SpringForce(system.getParticles());
        for (int i = 0; i < 200; i++) {
            system.addParticle("link" + i, 0.01, new Vector3(0.05 * i, 0, 0.01 * (7 * i % 5)), Vector3.ZERO, i == 0);
            if (i > 0) {
                springs.addSpring(i - 1, i, stiffness, 0.05, 0);
            }
        }
        system.addEffect(new Gravity(system.getParticles(), Systems.GRAVITY));
        system.addEffect(springs);
        return system;
    }

    /** In a chain nothing fills in: elimination is cheaper by far, as soon as there is anything to save. */
    @Test
    void aChainIsEliminatedAsSoonAsIterationsAreMany() {
        ImplicitWork soft = work(chain(200));
        ImplicitWork stiff = work(chain(2000));
        assertEquals(0, soft.factorisations());
        assertTrue(soft.krylovIterations() < 16, soft.krylovIterations() + " iterations");              // measured 13
        assertEquals(1, stiff.krylovIterations());
        assertEquals(1, stiff.factorisations());
        assertTrue(stiff.blockOperations() < soft.blockOperations(), stiff + " after " + soft);
    }
}
