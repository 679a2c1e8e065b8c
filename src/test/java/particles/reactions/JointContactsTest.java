package particles.reactions;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static particles.Systems.GRAVITY;

import deSolvers.RK4Solver;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import particles.EnergyLedger;
import particles.Observer;
import particles.ParticleSystem;
import particles.Plane;
import particles.Rule;
import particles.Simulation;
import particles.SimulationException;
import particles.Vector3;
import particles.effects.Gravity;
import particles.reactions.ContactModes.Mode;
import particles.rules.ClampedImpacts;
import particles.rules.ExactImpacts;

/** Rods and contacts, solved together, against closed forms. */
class JointContactsTest {
    private static final double G = 9.81;
    private static final double ROOT = Math.sqrt(0.5);

    /** Rods of masses 1 kg on planes, with gravity. */
    private static final class Case {
        final ParticleSystem system = new ParticleSystem();
        final RigidConstraints rods = new RigidConstraints(system, 5);
        final RestingContacts contacts;

        Case(List<ContactSurface> planes, Vector3[] places, Vector3[] velocities, int[]... pairs) {
            for (int i = 0; i < places.length; i++) {
                system.addParticle("p" + i, 1, places[i], velocities[i], false);
            }
            system.addEffect(new Gravity(system.getParticles(), GRAVITY));
            contacts = new RestingContacts(system.getParticles(), planes);
            for (int[] pair : pairs) {
                rods.addRod(pair[0], pair[1], Pendulums.distance(system, pair[0], pair[1]));
            }
            rods.solveWith(contacts);
            system.addReaction(contacts);
            system.addReaction(rods);
        }

        Simulation exact(double deltaT, double duration) {
            Simulation simulation = new Simulation(system, new RK4Solver(), deltaT, duration, Double.POSITIVE_INFINITY);
            simulation.addEventRule(new ExactImpacts(contacts), new RK4Solver());
            return simulation;
        }

        Simulation clamped(double deltaT, double duration) {
            Simulation simulation = new Simulation(system, new RK4Solver(), deltaT, duration, Double.POSITIVE_INFINITY);
            simulation.addRule(new ClampedImpacts(contacts));
            return simulation;
        }

        double at(int i, int k) {
            return system.getOwnState()[6 * i + k];
        }

        double[] effects() {
            double[] force = new double[system.getStateSize()];
            system.addUpEffects(system.getOwnState(), system.getTime(), force);
            return force;
        }
    }

    private static ContactSurface plane(double nx, double ny, Friction friction) {
        return new ContactSurface("plane", new Plane(Vector3.ZERO, new Vector3(nx, ny, 0)), 0, friction, 1e-6);
    }

    private static Friction coulomb(double mu) {
        return new Friction(Friction.Law.COULOMB, mu, mu, 0);
    }

    private static Vector3[] at(double... xy) {
        Vector3[] places = new Vector3[xy.length / 2];
        for (int i = 0; i < places.length; i++) {
            places[i] = new Vector3(xy[2 * i], xy[2 * i + 1], 0);
        }
        return places;
    }

    /** Notes when rules acted. */
    private static final class Watch implements Observer {
        private final List<Double> times = new ArrayList<>();
        private final List<double[]> states = new ArrayList<>();

        @Override
        public void changed(ParticleSystem system, Rule rule) {
            times.add(system.getTime());
            states.add(system.getOwnState().clone());
        }
    }

    /**
     * A rod that spins flat on smooth ground, once around each second: it carries m omega&sup2; l/2 and both ends weigh m g.
     */
    @ParameterizedTest
    @ValueSource(booleans = {true, false})
    void aRodSpinsOnTheGround(boolean exact) {
        double omega = 2 * Math.PI;
        Case rod = new Case(List.of(plane(0, 1, Friction.NONE)), at(-0.5, 0, 0.5, 0),
                new Vector3[] {new Vector3(0, 0, omega / 2), new Vector3(0, 0, -omega / 2)}, new int[] {0, 1});
        Simulation simulation = exact ? rod.exact(0.005, 2) : rod.clamped(0.005, 2);
        simulation.run();
        assertEquals(-0.5, rod.at(0, 0), 1e-7, "measured: 2e-8 of a turn's phase");
        assertEquals(0, rod.at(0, 1), 1e-15);
        assertEquals(1, Pendulums.distance(rod.system, 0, 1), 2e-7, "measured: 4e-8");
        assertEquals(G, rod.contacts.pressure(0, 0, rod.system.getOwnState(), rod.effects()), 1e-9);
        double[] force = rod.effects();
        rod.rods.addForces(rod.system.getOwnState(), 0, force);
        assertEquals(omega * omega / 2, Math.hypot(force[3], force[5]), 1e-5, "measured: 2e-6");
    }

    /**
     * A rod leans on a smooth wall at an angle a0 to it and slides: a'&sup2; = 2 g/l (cos a0 - cos a); it leaves the wall
     * where cos a = 2/3 cos a0. Measured: 1.2e-9 m/s.
     */
    @Test
    void aLeaningRodLeavesTheWall() {
        double a0 = Math.toRadians(20);
        Case ladder = new Case(List.of(plane(0, 1, Friction.NONE), plane(1, 0, Friction.NONE)),
                at(Math.sin(a0), 0, 0, Math.cos(a0)), at(0, 0, 0, 0), new int[] {0, 1});
        Watch watch = new Watch();
        Simulation simulation = ladder.exact(0.002, 0.8);
        simulation.addObserver(watch);
        simulation.run();
        double cosine = 2.0 / 3 * Math.cos(a0);
        assertEquals(cosine, watch.states.get(0)[7], 1e-9);
        double rate = Math.sqrt(2 * G * (Math.cos(a0) - cosine));
        assertEquals(-Math.sqrt(1 - cosine * cosine) * rate, watch.states.get(0)[10], 8e-9);
        assertEquals(Mode.FREE, ladder.contacts.getModes().get(1, 1));
        assertTrue(ladder.at(1, 0) > 0.05, "it moves away from the wall, at x = " + ladder.at(1, 0));
    }

    /**
     * The same with friction mu at the floor: a'' = (g sin a - 2 mu g cos a) / (l (1 - mu sin a cos a)), if tan a &gt; 2 mu.
     */
    @Test
    void frictionAtTheFloor() {
        double mu = 0.2;
        double a = Math.atan(2 * mu) + 0.1;
        Case slides = ladder(a, coulomb(mu), Friction.NONE);
        slides.exact(1e-3, 1e-3).run();
        double acceleration = (G * Math.sin(a) - 2 * mu * G * Math.cos(a)) / (1 - mu * Math.sin(a) * Math.cos(a));
        assertEquals(acceleration * Math.cos(a) * 1e-3, slides.at(0, 3), 2e-8, "up to terms of order t^3; measured: 4e-9");
        Case holds = ladder(Math.atan(2 * mu) - 0.01, coulomb(mu), Friction.NONE);
        holds.exact(0.01, 1).run();
        assertEquals(Math.cos(Math.atan(2 * mu) - 0.01), holds.at(1, 1), 1e-14);
        assertTrue(holds.contacts.getModes().isSticking(0));
    }

    private static Case ladder(double a, Friction floor, Friction wall) {
        return new Case(List.of(plane(0, 1, floor), plane(1, 0, wall)), at(Math.sin(a), 0, 0, Math.cos(a)), at(0, 0, 0, 0),
                new int[] {0, 1});
    }

    /** Friction at both ends: statically indeterminate, and held whenever it can be, tan a &lt; 2 mu / (1 - mu&sup2;). */
    @ParameterizedTest
    @ValueSource(booleans = {true, false})
    void frictionAtBothEnds(boolean exact) {
        double limit = Math.atan(0.6 / (1 - 0.09));
        Case holds = ladder(limit - 1e-3, coulomb(0.3), coulomb(0.3));
        (exact ? holds.exact(0.01, 1) : holds.clamped(0.01, 1)).run();
        assertEquals(Math.cos(limit - 1e-3), holds.at(1, 1), 1e-14);
        assertTrue(holds.contacts.getModes().isSticking(0) && holds.contacts.getModes().isSticking(1));
        Case slides = ladder(limit + 1e-3, coulomb(0.3), coulomb(0.3));
        (exact ? slides.exact(0.01, 1) : slides.clamped(0.01, 1)).run();
        assertTrue(slides.at(1, 1) < Math.cos(limit) - 1e-3, "it slides: " + slides.at(1, 1));
    }

    /** Two particles joined along a slope of 30 degrees with mu = 0.3 slide like one, and the rod carries nothing. */
    @ParameterizedTest
    @ValueSource(booleans = {true, false})
    void aRodOnASlope(boolean exact) {
        double a = Math.toRadians(30);
        Case rod = new Case(List.of(plane(Math.sin(a), Math.cos(a), coulomb(0.3))), at(0, 0, Math.cos(a), -Math.sin(a)),
                at(0, 0, 0, 0), new int[] {0, 1});
        (exact ? rod.exact(0.01, 1) : rod.clamped(0.01, 1)).run();
        double way = G * (Math.sin(a) - 0.3 * Math.cos(a)) / 2;
        assertEquals(way * Math.cos(a), rod.at(0, 0), exact ? 1e-12 : 1e-10);
        assertEquals(Math.cos(a) + way * Math.cos(a), rod.at(1, 0), exact ? 1e-12 : 1e-10);
        Case steep = new Case(List.of(plane(Math.sin(a), Math.cos(a), coulomb(0.6))), at(0, 0, Math.cos(a), -Math.sin(a)),
                at(0, 0, 0, 0), new int[] {0, 1});
        (exact ? steep.exact(0.01, 1) : steep.clamped(0.01, 1)).run();
        assertEquals(0, steep.at(0, 0), 1e-14, "0.6 holds, also what lies lengthways");
    }

    /** A particle in a groove of 90 degrees, and another below it on a rod: each wall carries (2 m g) / sqrt 2. */
    @Test
    void aGrooveCarriesWhatHangsOnARod() {
        Case groove = new Case(List.of(plane(1, 1, Friction.NONE), plane(-1, 1, Friction.NONE)), at(0, 0, 0, 1), at(0, 0, 0, 0),
                new int[] {0, 1});
        groove.exact(0.01, 0.1).run();
        double[] state = groove.system.getOwnState();
        assertEquals(2 * G * ROOT, groove.contacts.pressure(0, 0, state, groove.effects()), 1e-9);
        assertEquals(2 * G * ROOT, groove.contacts.pressure(1, 0, state, groove.effects()), 1e-9);
        assertEquals(1, groove.at(1, 1), 1e-12, "it stands on its end for a while, since nothing tips it");
    }

    /** In a groove with friction, both ends of a rod stay for a minute to the last bit. */
    @Test
    void aRodAtRestInAGroove() {
        Friction rough = coulomb(0.3);
        ParticleSystem system = new ParticleSystem();
        Case groove = new Case(List.of(plane(1, 1, rough), plane(-1, 1, rough)),
                new Vector3[] {Vector3.ZERO, new Vector3(0, 0, 1)}, new Vector3[] {Vector3.ZERO, Vector3.ZERO}, new int[] {0, 1});
        double[] before = groove.system.getOwnState().clone();
        groove.exact(0.01, 60).run();
        for (int k = 0; k < 12; k++) {
            assertEquals(before[k], groove.system.getOwnState()[k], 1e-15);
        }
        assertEquals(0, system.getStateSize());
    }

    /**
     * A dumbbell at an angle f to the ground falls: the blow is (1 + r) m v / (1 - sin&sup2; f / 2),
     * and r = 1 keeps the energy.
     */
    @ParameterizedTest
    @ValueSource(doubles = {0, 0.5, 1})
    void aRodHitsTheGroundWithOneEnd(double restitution) {
        double f = Math.toRadians(40);
        ContactSurface ground = new ContactSurface("ground", Plane.ground(0), restitution, Friction.NONE, 1e-6);
        Case rod = new Case(List.of(ground), at(0, 0.5, Math.cos(f), 0.5 + Math.sin(f)), at(0, 0, 0, 0), new int[] {0, 1});
        Watch watch = new Watch();
        EnergyLedger ledger = new EnergyLedger();
        double fall = Math.sqrt(1 / G);
        Simulation simulation = rod.exact(0.01, fall + 1e-9);
        simulation.addObserver(watch);
        simulation.addObserver(ledger);
        simulation.run();
        double[] after = watch.states.get(0);
        double v = Math.sqrt(G);
        assertEquals(fall, watch.times.get(0), 1e-12);
        assertEquals((1 + restitution) * v / (1 - Math.sin(f) * Math.sin(f) / 2), after[4] + after[10] + 2 * v, 1e-11);
        assertEquals(restitution * v, after[4], 1e-11);
        assertEquals(0, after[3] + after[9], 1e-12, "no impulse along smooth ground");
        double lost = (1 - restitution * restitution) * v * v / 2 / (1 - Math.sin(f) * Math.sin(f) / 2);
        assertEquals(-lost, ledger.getWork().get("impacts"), 1e-10);
    }

    /** Falling, striking, sliding with friction, coming to rest: the books close, and the rod does no work. */
    @Test
    void aFallingRodComesToRest() {
        ContactSurface ground = new ContactSurface("ground", Plane.ground(0), 0.3,
                new Friction(Friction.Law.COULOMB, 0.4, 0.5, 1e-3),
                1e-3);
        Case rod = new Case(List.of(ground), at(0, 0.5, 0.6, 1.3), new Vector3[] {new Vector3(1, 0, 0), new Vector3(1, 0, 0)},
                new int[] {0, 1});
        EnergyLedger ledger = new EnergyLedger();
        Simulation simulation = rod.exact(0.005, 4);
        simulation.addObserver(ledger);
        simulation.run();
        assertEquals(0, rod.at(0, 1), 1e-9);
        assertEquals(0, rod.at(1, 1), 1e-9);
        assertEquals(1, Pendulums.distance(rod.system, 0, 1), 1e-7);
        assertTrue(rod.contacts.getModes().isSticking(0) && rod.contacts.getModes().isSticking(1), "at rest");
        assertEquals(0, ledger.getWork().get("rods"), 2e-7, "the feedback; measured: 2e-8");
        assertEquals(0, ledger.getNumericalError(), 1e-8, "measured: 1e-9");
        assertTrue(ledger.getWork().get("contact") < -0.1 && ledger.getWork().get("impacts") < -1, ledger.getWork().toString());
    }

    /** By steps that are clamped it ends in the same rest, about. */
    @Test
    void aFallingRodComesToRestByClamping() {
        ContactSurface ground = new ContactSurface("ground", Plane.ground(0), 0.3,
                new Friction(Friction.Law.COULOMB, 0.4, 0.5, 1e-2),
                1e-2);
        Case rod = new Case(List.of(ground), at(0, 0.5, 0.6, 1.3), new Vector3[] {new Vector3(1, 0, 0), new Vector3(1, 0, 0)},
                new int[] {0, 1});
        rod.clamped(0.002, 4).run();
        assertEquals(0, rod.at(0, 1), 1e-9);
        assertEquals(0, rod.at(1, 1), 1e-9);
        assertEquals(1, Pendulums.distance(rod.system, 0, 1), 1e-7);
        assertEquals(0, Math.abs(rod.at(0, 3)) + Math.abs(rod.at(1, 3)), 1e-12);
    }

    /** Painlev&eacute;'s paradox: pushed along ground too rough for its angle, a rod has no forces that keep it out. */
    @Test
    void frictionThatJamsIsAClearError() {
        double f = Math.asin(Math.sqrt(2.0 / 3));
        Case rod = new Case(List.of(plane(0, 1, coulomb(4))), at(0, 0, -Math.cos(f), Math.sin(f)),
                at(3, 0, 3, 0), new int[] {0, 1});
        String message = assertThrows(SimulationException.class, () -> rod.clamped(0.001, 0.1).run()).getMessage();
        assertTrue(message.contains("friction jams"), message);
    }
}
