package particles.law;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import deSolvers.RK4Solver;
import deSolvers.problems.Steps;
import org.junit.jupiter.api.Test;
import particles.Cloth;
import particles.ParticleSystem;

/** Tests {@link ParticleForce}: a force on one particle is applied to all, and its energies are summed. */
class ParticleForceTest {
    private static final double G = 9.75;
    /** Bytes for position, velocity and force, if the compiler does not remove the objects. */
    private static final long THREE_VECTORS = 3 * 40;

    /** A weight that counts its calls. */
    private static final class Weight extends ParticleForce {
        private long calls;

        Weight(Particles particles) {
            super(particles);
        }

        @Override
        protected Vector3 getForce(Vector3 position, Vector3 velocity, double mass, double time) {
            calls++;
            return new Vector3(0, -mass * G, 0);
        }

        @Override
        protected double getPotentialEnergy(Vector3 position, double mass, double time) {
            return mass * G * position.y();
        }
    }

    @Test
    void forcesAreAddedToTheVelocityEntries() {
        ParticleSystem system = new ParticleSystem();
        system.addParticle("a", 2, new Vector3(1, 2, 3), new Vector3(4, 5, 6), false);
        system.addParticle("b", 3, Vector3.ZERO, Vector3.ZERO, true);
        ParticleForce sum = new ParticleForce(system.getParticles()) {
            @Override
            protected Vector3 getForce(Vector3 position, Vector3 velocity, double mass, double time) {
                return position.plus(velocity.times(10)).plus(new Vector3(mass, 0, time));
            }
        };
        double[] force = new double[12];
        force[4] = 1000;
        sum.addForces(system.getOwnState(), 0.5, force);
        assertArrayEquals(new double[] {0, 0, 0, 43, 1052, 63.5, 0, 0, 0, 3, 0, 0.5}, force);
        assertEquals(0, sum.getPotentialEnergy(system.getOwnState(), 0));
    }

    @Test
    void energyCountsFreeParticlesOnly() {
        ParticleSystem system = new ParticleSystem();
        system.addParticle("a", 2, new Vector3(1, 2, 3), Vector3.ZERO, false);
        system.addParticle("b", 3, new Vector3(1, 4, 3), Vector3.ZERO, false);
        system.addParticle("c", 7, new Vector3(1, 8, 3), Vector3.ZERO, true);
        Weight weight = new Weight(system.getParticles());
        assertEquals((2 * 2 + 3 * 4) * G, weight.getPotentialEnergy(system.getOwnState(), 0));
        assertEquals("Weight", weight.getName());
    }

    /** One call and at most three small objects for each particle and evaluation; the compiler removes most of them. */
    @Test
    void aStepCallsTheForceOncePerParticleAndEvaluation() {
        ParticleSystem cloth = Cloth.hanging(64, 20, 0.02);
        Weight weight = new Weight(cloth.getParticles());
        cloth.addEffect(weight);
        RK4Solver solver = new RK4Solver();
        Steps.make(100, solver, cloth, 1.0 / 1024);
        weight.calls = 0;
        long bytes = Steps.allocatedIn(100, solver, cloth, 1.0 / 1024);
        assertEquals(100L * 4 * 64 * 64, weight.calls);
        assertTrue(bytes <= THREE_VECTORS * weight.calls + 4000, bytes + " bytes in " + weight.calls + " calls");
    }
}
