package particles;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static particles.Systems.GRAVITY;

import deSolvers.DESolver;
import deSolvers.EulerSolver;
import deSolvers.RK4Solver;
import java.util.List;
import org.junit.jupiter.api.Test;
import particles.effects.Gravity;
import particles.law.Plane;
import particles.law.Vector3;
import particles.law.Violation;
import particles.reactions.RestingContacts;
import particles.reactions.RigidConstraints;
import particles.reactions.contact.ContactSurface;
import particles.reactions.contact.Friction;

/** The end of a run checks its rods, wires and contacts. */
class ConstraintViolationTest {

    /** A pendulum of 1 m from 90 degrees, without feedback. */
    private static Simulation pendulum(DESolver solver, double deltaT) {
        ParticleSystem system = new ParticleSystem();
        system.addParticle("nail", 1, Vector3.ZERO, Vector3.ZERO, true);
        system.addParticle("bob", 1, new Vector3(1, 0, 0), Vector3.ZERO, false);
        system.addEffect(new Gravity(system.getParticles(), GRAVITY));
        RigidConstraints rods = new RigidConstraints(system, 0);
        rods.addRod(0, 1, 1);
        system.addReaction(rods);
        return new Simulation(system, () -> solver, deltaT, 2);
    }

    /** Euler's step along the tangent lengthens the rod by a fifth; rk4's by 3e-10 of it. */
    @Test
    void aRodThatIsAFifthTooLongEndsTheRun() {
        String message = assertThrows(SimulationException.class,
                () -> pendulum(new EulerSolver(), 0.02).run()).getMessage();
        assertEquals("the rod from 'nail' to 'bob' is LENGTH m long, not 1 m: the motion is wrong",
                message.replaceFirst("is [0-9.]+ m", "is LENGTH m"));
        Simulation good = pendulum(new RK4Solver(), 0.002);
        good.run();
        assertEquals(0, good.getViolation().part(), 1e-8);
    }

    @Test
    void theLargerViolationCounts() {
        Violation small = new Violation(0.1, "small");
        Violation large = new Violation(0.2, "large");
        assertEquals(large, small.or(large));
        assertEquals(large, large.or(small));
    }

    /** A rod that drags a ball through the ground was no violation as long as the ball did not count as touching. */
    @Test
    void aFreeParticleBelowASurfaceIsAViolation() {
        ParticleSystem system = Systems.oneParticle(new Vector3(0, -0.2, 0), Vector3.ZERO);
        RestingContacts contacts = new RestingContacts(system, List.of(new ContactSurface("ground",
                new Plane(Vector3.ZERO, new Vector3(0, 1, 0)), 0.5, Friction.NONE, 0.01)));
        assertEquals(0.2, contacts.getViolation(system.getOwnState()).part(), 1e-15);
        system.getOwnState()[1] = 0.2;
        assertEquals(0, contacts.getViolation(system.getOwnState()).part());
    }
}
