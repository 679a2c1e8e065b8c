package particles.rules;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static particles.Systems.GRAVITY;
import static particles.Systems.entry;
import static particles.Systems.oneParticle;

import deSolvers.DESolver;
import deSolvers.RK4Solver;
import java.util.ArrayList;
import java.util.List;
import java.util.function.Supplier;
import org.junit.jupiter.api.Test;
import particles.Observer;
import particles.ParticleSystem;
import particles.Rule;
import particles.Simulation;
import particles.effects.Gravity;
import particles.effects.LinearDrag;
import particles.effects.Wind;
import particles.energy.EnergyLedger;
import particles.law.Plane;
import particles.law.Sphere;
import particles.law.Vector3;
import particles.reactions.RestingContacts;
import particles.reactions.contact.ContactModes.Mode;
import particles.reactions.contact.ContactSurface;
import particles.reactions.contact.Friction;

/** Balls and hollows as obstacles: impacts, rest, sliding along and off, and no tunnelling. */
class SphereImpactsTest {
    private static final double G = 9.81;
    private static final Sphere BALL = new Sphere(Vector3.ZERO, 1, false);
    private static final Sphere HOLLOW = new Sphere(Vector3.ZERO, 1, true);

    private static ContactSurface solid(Sphere sphere, double restitution, Friction friction) {
        return new ContactSurface("sphere", sphere, restitution, friction, 1e-6);
    }

    private static RestingContacts contacts(ParticleSystem system, ContactSurface... solids) {
        RestingContacts contacts = new RestingContacts(system, List.of(solids));
        system.addReaction(contacts);
        return contacts;
    }

    private static Simulation exact(ParticleSystem system, RestingContacts contacts, double deltaT, double duration) {
        Supplier<DESolver> solver = RK4Solver::new;
        Simulation simulation = new Simulation(system, solver, deltaT, duration);
        simulation.addRule(new ExactImpacts(contacts));
        return simulation;
    }

    private static List<Double> timesOf(Simulation simulation) {
        List<Double> times = new ArrayList<>();
        simulation.addObserver(new Observer() {
            @Override
            public void changed(ParticleSystem system, Rule rule) {
                times.add(system.getTime());
            }
        });
        return times;
    }

    /** Dropped on the top of a ball from 1 m above it: the contact times of the reference values, as on a plane. */
    @Test
    void bouncesOnTheTopOfABallComeAtTheirTimes() {
        ParticleSystem system = oneParticle(new Vector3(0, 2, 0), Vector3.ZERO);
        system.addEffect(new Gravity(system.getParticles(), GRAVITY));
        Simulation simulation = exact(system, contacts(system, solid(BALL, 0.5, Friction.NONE)), 0.01, 3);
        List<Double> times = timesOf(simulation);
        simulation.run();
        double[] table = {0.451523640986, 0.903047281971, 1.128809102464, 1.241690012711, 1.298130467834,
                1.326350695396};
        for (int k = 0; k < table.length; k++) {
            assertEquals(table[k], times.get(k), 2e-12);
        }
        assertEquals(1.354570922957, times.get(times.size() - 1), 1e-6);
        assertEquals(1, entry(system, 1), 1e-12);
    }

    /** A horizontal shot of v at height 0.6 meets the ball at x = -0.8; with r = 1 it leaves with v - 2 (v . N) N. */
    @Test
    void aShotIsReflectedAboutTheNormal() {
        ParticleSystem system = oneParticle(new Vector3(-3, 0.6, 0), new Vector3(2, 0, 0));
        Simulation simulation = exact(system, contacts(system, solid(BALL, 1, Friction.NONE)), 0.07, 2);
        List<Double> times = timesOf(simulation);
        simulation.run();
        assertEquals(1.1, times.get(0), 1e-14);
        assertEquals(2 - 2 * 1.6 * 0.8, entry(system, 3), 1e-13);
        assertEquals(2 * 1.6 * 0.6, entry(system, 4), 1e-13);
    }

    /** One step would carry it through the ball, or a thousand times across the hollow. */
    @Test
    void fastParticlesDoNotTunnel() {
        ParticleSystem outside = oneParticle(new Vector3(-3, 0, 0), new Vector3(1e5, 0, 0));
        exact(outside, contacts(outside, solid(BALL, 0.5, Friction.NONE)), 0.01, 0.01).run();
        assertEquals(-5e4, entry(outside, 3), 1e-9);
        ParticleSystem inside = oneParticle(new Vector3(0.3, 0.2, -0.1), new Vector3(1e5, 3e4, 2e4));
        exact(inside, contacts(inside, solid(HOLLOW, 1, Friction.NONE)), 0.01, 0.02).run();
        double[] s = inside.getOwnState();
        assertTrue(Math.sqrt(s[0] * s[0] + s[1] * s[1] + s[2] * s[2]) <= 1 + 1e-9);
        assertEquals(1e10 + 9e8 + 4e8, s[3] * s[3] + s[4] * s[4] + s[5] * s[5], 0.05);
        for (boolean hollow : new boolean[] {false, true}) {
            ParticleSystem clamped = oneParticle(hollow ? Vector3.ZERO : new Vector3(-3, 0, 0), new Vector3(1e5, 0, 0));
            RestingContacts contacts = contacts(clamped, solid(hollow ? HOLLOW : BALL, 0.5, Friction.NONE));
            Simulation simulation = new Simulation(clamped, RK4Solver::new, 0.01, 0.01);
            simulation.addRule(new ClampedImpacts(contacts));
            simulation.run();
            assertEquals(hollow ? 1 : -1, entry(clamped, 0), 1e-12);
            assertEquals(-5e4, entry(clamped, 3), 1e-9);
        }
    }

    /**
     * Pushed off the top, a particle slides down a ball and leaves it where cos = (2 + v0&sup2;/(g R))/3: its energy is
     * conserved, and contact ends where the ball would have to pull. Measured: 3e-10.
     */
    @Test
    void slidingOffABallLeavesAtItsAngle() {
        double v0 = 0.5;
        ParticleSystem system = oneParticle(new Vector3(0, 1, 0), new Vector3(v0, 0, 0));
        system.addEffect(new Gravity(system.getParticles(), GRAVITY));
        RestingContacts contacts = contacts(system, solid(BALL, 0, Friction.NONE));
        Simulation simulation = exact(system, contacts, 0.005, 0.9);
        List<Double> heights = new ArrayList<>();
        simulation.addObserver(new Observer() {
            @Override
            public void changed(ParticleSystem s, Rule rule) {
                heights.add(entry(s, 1));
            }
        });
        EnergyLedger ledger = new EnergyLedger();
        simulation.addObserver(ledger);
        simulation.run();
        assertEquals((2 + v0 * v0 / G) / 3, heights.get(0), 3e-9);
        assertEquals(1, heights.size());
        assertEquals(Mode.FREE, contacts.getModes().get(0, 0));
        assertEquals(0, ledger.getNumericalError(), 1e-7, "the fourth order of the ledger's own rule: measured 1.1e-8");
        assertEquals(0, ledger.getWork().get("contact"), 1e-7, "a smooth ball does no work");
    }

    /**
     * In a smooth bowl a particle swings like a pendulum: from 90 degrees the quarter period is 1.1803405990 times
     * sqrt(R/g) pi/2.
     */
    @Test
    void slidingInABowlIsAPendulum() {
        ParticleSystem system = oneParticle(new Vector3(Math.sin(Math.PI / 4), -Math.cos(Math.PI / 4), 0),
                Vector3.ZERO);
        system.addEffect(new Gravity(system.getParticles(), GRAVITY));
        double period = 2 * Math.PI / Math.sqrt(G) * 1.039973343196804;
        RestingContacts contacts = contacts(system, solid(HOLLOW, 0, Friction.NONE));
        exact(system, contacts, period / 400, period / 4).run();
        assertEquals(0, entry(system, 0), 1e-8);
        assertEquals(-1, entry(system, 1), 1e-12);
        assertEquals(-Math.sqrt(2 * G * (1 - Math.cos(Math.PI / 4))), entry(system, 3), 1e-8);
    }

    /** On a rough ball a particle stays if the tangent of the slope is less than mu, and slides if it is more. */
    @Test
    void frictionHoldsOnTheTopOfABall() {
        for (double angle : new double[] {0.25, 0.35}) {
            ParticleSystem system = oneParticle(new Vector3(Math.sin(angle), Math.cos(angle), 0), Vector3.ZERO);
            system.addEffect(new Gravity(system.getParticles(), GRAVITY));
            RestingContacts contacts = contacts(system,
                    solid(BALL, 0, new Friction(Friction.Law.COULOMB, 0.3, 0.3, 0)));
            exact(system, contacts, 0.01, 0.1).run();
            if (Math.tan(angle) < 0.3) {
                assertEquals(Math.sin(angle), entry(system, 0), 1e-15);
            } else {
                assertTrue(entry(system, 0) > Math.sin(angle) + 1e-4, "slides from " + Math.sin(angle) + " to "
                        + entry(system, 0));
            }
        }
    }

    /** A particle rests in the wedge between a ball and the ground, outside both. */
    @Test
    void aParticleRestsInAWedgeOfBallAndWall() {
        ParticleSystem system = oneParticle(new Vector3(0.9, 0.9, 0), Vector3.ZERO);
        system.addEffect(new Gravity(system.getParticles(), GRAVITY));
        RestingContacts contacts = contacts(system, solid(BALL, 0.3, Friction.NONE),
                new ContactSurface("wall", new Plane(new Vector3(0.95, 0, 0), new Vector3(-1, 0, 0)), 0.3,
                Friction.NONE, 1e-6));
        exact(system, contacts, 0.01, 5).run();
        assertEquals(0.95, entry(system, 0), 1e-9);
        assertEquals(Math.sqrt(1 - 0.95 * 0.95), entry(system, 1), 1e-9);
        assertEquals(0, Math.abs(entry(system, 3)) + Math.abs(entry(system, 4)), 1e-9);
    }

    /** With drag, off a ball three times: exact impacts keep rk4 at order 4; clamp falls to about 1. */
    @Test
    void theSolverKeepsItsOrderOffABall() {
        double reference = height(1.1 / 6400, true);
        double exact = Math.log(Math.abs(height(1.1 / 40, true) - reference) / Math.abs(height(1.1 / 320,
                true) - reference))
                / Math.log(8);
        double clamp = Math.log(Math.abs(height(1.1 / 40, false) - reference) / Math.abs(height(1.1 / 320,
                false) - reference))
                / Math.log(8);
        assertTrue(exact > 3.8 && exact < 4.3, "exact: " + exact);
        assertTrue(clamp < 1.8, "clamp: " + clamp);
    }

    private static double height(double deltaT, boolean atImpact) {
        ParticleSystem system = oneParticle(new Vector3(0, 2, 0), Vector3.ZERO);
        system.addEffect(new Gravity(system.getParticles(), GRAVITY));
        system.addEffect(new LinearDrag(system.getParticles(), 0.5, Wind.STILL));
        RestingContacts contacts = contacts(system, solid(BALL, 0.5, Friction.NONE));
        if (atImpact) {
            exact(system, contacts, deltaT, 1.1).run();
        } else {
            Simulation simulation = new Simulation(system, RK4Solver::new, deltaT, 1.1);
            simulation.addRule(new ClampedImpacts(contacts));
            simulation.run();
        }
        return entry(system, 1);
    }

    /** With clamp, particles also slide in a bowl and down a ball; the solver's drift is removed after each step. */
    @Test
    void clampedParticlesSlideAlongSpheres() {
        ParticleSystem system = oneParticle(new Vector3(Math.sin(Math.PI / 4), -Math.cos(Math.PI / 4), 0),
                Vector3.ZERO);
        system.addEffect(new Gravity(system.getParticles(), GRAVITY));
        double period = 2 * Math.PI / Math.sqrt(G) * 1.039973343196804;
        Simulation simulation = new Simulation(system, RK4Solver::new, period / 400, period / 4);
        simulation.addRule(new ClampedImpacts(contacts(system, solid(HOLLOW, 0, Friction.NONE))));
        simulation.run();
        assertEquals(0, entry(system, 0), 1e-8);
        assertEquals(-1, entry(system, 1), 1e-12);
    }

    /** A pivot inside a ball was put onto it, and so was a moving anchor: its rod then pulled at another place. */
    @Test
    void aBallMovesNoFixedParticle() {
        ParticleSystem system = oneParticle(new Vector3(0, 2, 0), Vector3.ZERO);
        int pivot = system.addParticle("pivot", 1, new Vector3(0, 0.5, 0), Vector3.ZERO, true);
        exact(system, contacts(system, solid(BALL, 0.5, Friction.NONE)), 0.1, 0.3).run();
        assertEquals(0.5, entry(system, 6 * pivot + 1));
    }
}
