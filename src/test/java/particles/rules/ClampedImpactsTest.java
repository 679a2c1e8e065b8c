package particles.rules;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static particles.Systems.GRAVITY;
import static particles.Systems.entry;
import static particles.Systems.oneParticle;
import static particles.Systems.run;

import deSolvers.RK4Solver;
import deSolvers.symplectic.SymplecticEulerSolver;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import particles.Motion;
import particles.Observer;
import particles.ParticleSystem;
import particles.Rule;
import particles.Simulation;
import particles.effects.Gravity;
import particles.law.Plane;
import particles.law.Vector3;
import particles.reactions.RestingContacts;
import particles.reactions.contact.ContactModes.Mode;
import particles.reactions.contact.ContactSurface;
import particles.reactions.contact.Friction;

/** Bounces, rest, sliding and sticking on planes against closed forms. */
class ClampedImpactsTest {
    private static final double G = 9.81;

    private static ClampedImpacts planes(ParticleSystem system, ContactSurface... planes) {
        RestingContacts contacts = new RestingContacts(system, List.of(planes));
        system.addEffect(new Gravity(system.getParticles(), GRAVITY));
        system.addReaction(contacts);
        return new ClampedImpacts(contacts);
    }

    private static ContactSurface ground(double restitution, Friction friction) {
        return new ContactSurface("ground", Plane.ground(0), restitution, friction, 1e-3);
    }

    private static ContactSurface slope(double degrees, Friction friction) {
        double a = Math.toRadians(degrees);
        return new ContactSurface("slope", new Plane(Vector3.ZERO, new Vector3(-Math.sin(a), Math.cos(a), 0)), 0,
                friction, 1e-3);
    }

    /**
     * Dropped from 1 m: the contacts come at 0.4515 s, 0.9030 s, 1.1288 s of the reference values. Each impact is up to
     * a step late, so the times are met within a few steps of 1e-4 s.
     */
    @Test
    void bouncesComeAtTheirTimes() {
        ParticleSystem system = oneParticle(new Vector3(0, 1, 0), Vector3.ZERO);
        ClampedImpacts rule = planes(system, ground(0.5, Friction.NONE));
        double[] expected = {0.451523640986, 0.903047281971, 1.128809102464, 1.241690012711};
        int[] seen = {0};
        Simulation simulation = new Simulation(system, RK4Solver::new, 1e-4, 1.26);
        simulation.addRule(rule);
        simulation.addObserver(new Observer() {
            @Override
            public void changed(ParticleSystem bounced, Rule by) {
                assertEquals(expected[seen[0]], bounced.getTime(), 1e-3);
                seen[0]++;
            }
        });
        simulation.run();
        assertEquals(4, seen[0], "bounces");
    }

    /** It comes to rest at t1 (1 + r)/(1 - r) = 1.3546 s and does not move at all after that. */
    @ParameterizedTest
    @ValueSource(doubles = {1e-3, 1e-2, 1.0 / 30})
    void bouncingEndsInRest(double deltaT) {
        ParticleSystem system = oneParticle(new Vector3(0, 1, 0), Vector3.ZERO);
        run(system, new SymplecticEulerSolver(), deltaT, 5, planes(system, ground(0.5, Friction.NONE)));
        assertEquals(0, entry(system, 4));
        assertEquals(0, entry(system, 1), 1e-12);
        ParticleSystem flying = oneParticle(new Vector3(0, 1, 0), Vector3.ZERO);
        run(flying, new SymplecticEulerSolver(), deltaT, 1, planes(flying, ground(0.5, Friction.NONE)));
        assertTrue(entry(flying, 1) > 0.01, "still in the air before");
    }

    /** The lecture's friction with the dissipative sign: v = v0 exp(-k_f g t). Measured with rk4 at 0.01: 3e-12. */
    @Test
    void lectureFrictionSlowsExponentially() {
        ParticleSystem system = oneParticle(Vector3.ZERO, new Vector3(2, 0, 1));
        run(system, new RK4Solver(), 0.01, 1, planes(system, ground(0, new Friction(Friction.Law.SLIDE, 0.1, 0, 0))));
        double factor = Math.exp(-0.1 * G);
        assertEquals(2 * factor, entry(system, 3), 1e-10);
        assertEquals(factor, entry(system, 5), 1e-10);
        assertEquals(2 * (1 - factor) / (0.1 * G), entry(system, 0), 1e-10);
        assertEquals(0, entry(system, 1));
    }

    /**
     * With a static threshold v_eps the slide ends after (v0 - v_eps)/(k_f g), but for the v_eps h of the last step.
     */
    @Test
    void slidingStopsAtTheThreshold() {
        ParticleSystem system = oneParticle(Vector3.ZERO, new Vector3(2, 0, 0));
        run(system, new RK4Solver(), 0.001, 10,
                planes(system, ground(0, new Friction(Friction.Law.SLIDE, 0.1, 0.3, 0.1))));
        assertEquals(0, entry(system, 3));
        assertEquals((2 - 0.1) / (0.1 * G), entry(system, 0), 0.1 * 0.001);
    }

    /**
     * Coulomb friction stops at v0/(mu g) after v0&sup2;/(2 mu g); the last step overshoots by less than mu g h&sup2;.
     */
    @Test
    void coulombFrictionStops() {
        ParticleSystem system = oneParticle(Vector3.ZERO, new Vector3(0, 0, 2));
        ClampedImpacts rule = planes(system, ground(0, new Friction(Friction.Law.COULOMB, 0.3, 0.4, 0)));
        double end = 2 / (0.3 * G);
        run(system, new RK4Solver(), 0.001, end - 0.01, rule);
        assertEquals(0.3 * G * 0.01, entry(system, 5), 1e-10, "not at rest before its time");
        run(system, new RK4Solver(), 0.001, 1, rule);
        assertEquals(0, entry(system, 5));
        assertEquals(4 / (2 * 0.3 * G), entry(system, 2), 0.3 * G * 1e-6);
    }

    /** tan 20 = 0.364: held by 0.4, not by 0.3; then it slides with g (sin a - mu cos a). */
    @Test
    void aSlopeHoldsAParticleIfFrictionExceedsItsTangent() {
        ParticleSystem held = oneParticle(Vector3.ZERO, Vector3.ZERO);
        run(held, new RK4Solver(), 0.01, 10, planes(held, slope(20, new Friction(Friction.Law.COULOMB, 0.3, 0.4, 0))));
        assertEquals(0, Math.abs(entry(held, 0)) + Math.abs(entry(held, 1)), 1e-15);
        ParticleSystem sliding = oneParticle(Vector3.ZERO, Vector3.ZERO);
        run(sliding, new RK4Solver(), 0.01, 1,
                planes(sliding, slope(20, new Friction(Friction.Law.COULOMB, 0.2, 0.3, 0))));
        double a = Math.toRadians(20);
        double acceleration = G * (Math.sin(a) - 0.2 * Math.cos(a));
        assertEquals(-acceleration * Math.cos(a), entry(sliding, 3), 1e-10);
        assertEquals(-acceleration / 2 * Math.sin(a), entry(sliding, 1), 1e-10);
    }

    /** Pushed up a slope too steep to hold it, a particle reverses and slides down. */
    @Test
    void aParticleSlidesUpASteepSlopeAndDownAgain() {
        ParticleSystem system = oneParticle(Vector3.ZERO, new Vector3(1, 1, 0));
        run(system, new RK4Solver(), 0.001, 1,
                planes(system, slope(45, new Friction(Friction.Law.COULOMB, 0.2, 0.2, 0))));
        double up = G * Math.sqrt(0.5) * 1.2;
        double turn = Math.sqrt(2) / up;
        double down = G * Math.sqrt(0.5) * 0.8;
        double speed = down * (1 - turn);
        assertEquals(-speed * Math.sqrt(0.5), entry(system, 3), 5e-3, "apart from the step of the reversal");
    }

    @Test
    void aParticleInAGrooveStaysAtRest() {
        for (Friction friction : List.of(Friction.NONE, new Friction(Friction.Law.COULOMB, 0.3, 0.4, 0))) {
            ParticleSystem system = oneParticle(Vector3.ZERO, Vector3.ZERO);
            ClampedImpacts rule = planes(system, slope(30, friction), slope(-40, friction));
            run(system, new RK4Solver(), 0.01, 60, rule);
            for (int k = 0; k < 6; k++) {
                assertEquals(0, entry(system, k), 1e-12);
            }
        }
    }

    /** Pulled up by more than its weight, a particle leaves the ground. */
    @Test
    void contactDoesNotPull() {
        ParticleSystem system = oneParticle(Vector3.ZERO, Vector3.ZERO);
        RestingContacts contacts = new RestingContacts(system, List.of(ground(0.5, Friction.NONE)));
        system.addEffect(new Gravity(system.getParticles(), new Vector3(0, 2, 0)));
        system.addReaction(contacts);
        ClampedImpacts rule = new ClampedImpacts(contacts);
        rule.start(system);
        assertEquals(Mode.SLIDING, contacts.getModes().get(0, 0));
        run(system, new RK4Solver(), 0.01, 1, rule);
        assertEquals(1, entry(system, 1), 1e-12);
        assertEquals(Mode.FREE, contacts.getModes().get(0, 0));
    }

    @Test
    void frictionNeverAddsEnergy() {
        ParticleSystem system = oneParticle(Vector3.ZERO, new Vector3(2, 0, 1));
        RestingContacts contacts = new RestingContacts(system,
                List.of(ground(0, new Friction(Friction.Law.COULOMB, 0.3, 0.4, 0))));
        system.addEffect(new Gravity(system.getParticles(), GRAVITY));
        system.addReaction(contacts);
        Simulation simulation = new Simulation(system, RK4Solver::new, 0.01, 0.5);
        simulation.addRule(new ClampedImpacts(contacts));
        simulation.addObserver(new Observer() {
            @Override
            public void moved(Motion motion) {
                double[] state = motion.getEndState();
                double[] force = new double[6];
                system.addUpEffects(state, motion.getEndTime(), force);
                double speed = Math.sqrt(state[3] * state[3] + state[5] * state[5]);
                assertEquals(-0.3 * G * speed, contacts.getPower(state, motion.getEndTime(), force), 1e-12);
            }
        });
        simulation.run();
        assertTrue(simulation.getSteps() == 50);
    }
}
