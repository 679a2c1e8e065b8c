package particles.reactions;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static particles.reactions.JointCase.at;
import static particles.reactions.JointCase.coulomb;
import static particles.reactions.JointCase.plane;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import particles.ParticleSystem;
import particles.Simulation;
import particles.energy.EnergyLedger;
import particles.law.Vector3;
import particles.reactions.contact.ContactModes.Mode;
import particles.reactions.contact.Friction;

/** Rods and contacts, solved together, against closed forms: leaning, sliding, held. */
class JointContactsTest {
    private static final double G = 9.81;
    private static final double ROOT = Math.sqrt(0.5);

    /**
     * A rod spins flat on smooth ground, one turn a second: it carries m omega&sup2; l/2 and both ends press with m g.
     */
    @ParameterizedTest
    @ValueSource(booleans = {true, false})
    void aSpinningRodCarriesTheCentripetalForce(boolean exact) {
        double omega = 2 * Math.PI;
        JointCase rod = new JointCase(List.of(plane(0, 1, Friction.NONE)), at(-0.5, 0, 0.5, 0),
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
     * A rod leans on a smooth wall at an angle a0 to it and slides: a'&sup2; = 2 g/l (cos a0 - cos a); it leaves the
     * wall where cos a = 2/3 cos a0. Measured: 1.2e-9 m/s.
     */
    @Test
    void aLeaningRodLeavesTheWall() {
        double a0 = Math.toRadians(20);
        JointCase ladder = new JointCase(List.of(plane(0, 1, Friction.NONE), plane(1, 0, Friction.NONE)),
                at(Math.sin(a0), 0, 0, Math.cos(a0)), at(0, 0, 0, 0), new int[] {0, 1});
        JointCase.Watch watch = new JointCase.Watch();
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
     * The same with friction mu at the floor: a'' = (g sin a - 2 mu g cos a) / (l (1 - mu sin a cos a)), if tan a &gt;
     * 2 mu.
     */
    @Test
    void aLeaningRodSlidesAgainstFloorFriction() {
        double mu = 0.2;
        double a = Math.atan(2 * mu) + 0.1;
        JointCase slides = ladder(a, coulomb(mu), Friction.NONE);
        slides.exact(1e-3, 1e-3).run();
        double acceleration = (G * Math.sin(a) - 2 * mu * G * Math.cos(a)) / (1 - mu * Math.sin(a) * Math.cos(a));
        assertEquals(acceleration * Math.cos(a) * 1e-3, slides.at(0, 3), 2e-8,
                "up to terms of order t^3; measured: 4e-9");
        JointCase holds = ladder(Math.atan(2 * mu) - 0.01, coulomb(mu), Friction.NONE);
        holds.exact(0.01, 1).run();
        assertEquals(Math.cos(Math.atan(2 * mu) - 0.01), holds.at(1, 1), 1e-14);
        assertTrue(holds.contacts.getModes().isSticking(0));
    }

    private static JointCase ladder(double a, Friction floor, Friction wall) {
        return new JointCase(List.of(plane(0, 1, floor), plane(1, 0, wall)), at(Math.sin(a), 0, 0, Math.cos(a)),
                at(0, 0, 0, 0),
                new int[] {0, 1});
    }

    /** Friction at both ends is statically indeterminate; the rod is held if tan a &lt; 2 mu / (1 - mu&sup2;). */
    @ParameterizedTest
    @ValueSource(booleans = {true, false})
    void frictionAtBothEndsHoldsUpToItsAngle(boolean exact) {
        double limit = Math.atan(0.6 / (1 - 0.09));
        JointCase holds = ladder(limit - 1e-3, coulomb(0.3), coulomb(0.3));
        (exact ? holds.exact(0.01, 1) : holds.clamped(0.01, 1)).run();
        assertEquals(Math.cos(limit - 1e-3), holds.at(1, 1), 1e-14);
        assertTrue(holds.contacts.getModes().isSticking(0) && holds.contacts.getModes().isSticking(1));
        JointCase slides = ladder(limit + 1e-3, coulomb(0.3), coulomb(0.3));
        (exact ? slides.exact(0.01, 1) : slides.clamped(0.01, 1)).run();
        assertTrue(slides.at(1, 1) < Math.cos(limit) - 1e-3, "it slides: " + slides.at(1, 1));
    }

    /** Two particles joined along a slope of 30 degrees with mu = 0.3 slide like one, and the rod carries nothing. */
    @ParameterizedTest
    @ValueSource(booleans = {true, false})
    void aRodSlidesDownASlopeWithoutLoad(boolean exact) {
        double a = Math.toRadians(30);
        JointCase rod = new JointCase(List.of(plane(Math.sin(a), Math.cos(a), coulomb(0.3))),
                at(0, 0, Math.cos(a), -Math.sin(a)),
                at(0, 0, 0, 0), new int[] {0, 1});
        (exact ? rod.exact(0.01, 1) : rod.clamped(0.01, 1)).run();
        double way = G * (Math.sin(a) - 0.3 * Math.cos(a)) / 2;
        assertEquals(way * Math.cos(a), rod.at(0, 0), exact ? 1e-12 : 1e-10);
        assertEquals(Math.cos(a) + way * Math.cos(a), rod.at(1, 0), exact ? 1e-12 : 1e-10);
        JointCase steep = new JointCase(List.of(plane(Math.sin(a), Math.cos(a), coulomb(0.6))),
                at(0, 0, Math.cos(a), -Math.sin(a)),
                at(0, 0, 0, 0), new int[] {0, 1});
        (exact ? steep.exact(0.01, 1) : steep.clamped(0.01, 1)).run();
        assertEquals(0, steep.at(0, 0), 1e-14, "0.6 holds, also lengthways");
    }

    /** A particle in a groove of 90 degrees, and another below it on a rod: each wall carries (2 m g) / sqrt 2. */
    @Test
    void aGrooveCarriesAParticleHangingOnARod() {
        JointCase groove = new JointCase(List.of(plane(1, 1, Friction.NONE), plane(-1, 1, Friction.NONE)),
                at(0, 0, 0, 1), at(0, 0, 0, 0),
                new int[] {0, 1});
        groove.exact(0.01, 0.1).run();
        double[] state = groove.system.getOwnState();
        assertEquals(2 * G * ROOT, groove.contacts.pressure(0, 0, state, groove.effects()), 1e-9);
        assertEquals(2 * G * ROOT, groove.contacts.pressure(1, 0, state, groove.effects()), 1e-9);
        assertEquals(1, groove.at(1, 1), 1e-12, "it stays upright, since nothing tips it");
    }

    /** One rod topples about its foot on rough ground; another lies there, and nothing about it can move. */
    @Test
    void aRodIsHeldAtBothEndsBesideOneThatFalls() {
        JointCase rods = new JointCase(List.of(plane(0, 1, coulomb(1))), at(0, 0, 0.5, 1, 2, 0, 3, 0),
                at(0, 0, 0, 0, 0, 0, 0, 0), new int[] {0, 1}, new int[] {2, 3});
        EnergyLedger ledger = new EnergyLedger();
        Simulation simulation = rods.clamped(0.01, 0.1);
        simulation.addObserver(ledger);
        simulation.run();
        assertTrue(rods.at(1, 4) < -0.1, "it topples");
        for (int i : new int[] {0, 2, 3}) {
            assertTrue(rods.contacts.getModes().isSticking(i), "end " + i);
        }
        assertEquals(0, ledger.getWork().get("rods"), "exactly");
    }

    /** In a rough groove, both ends of a rod stay bit for bit for a minute. */
    @Test
    void aRodInARoughGrooveStaysAtRest() {
        Friction rough = coulomb(0.3);
        ParticleSystem system = new ParticleSystem();
        JointCase groove = new JointCase(List.of(plane(1, 1, rough), plane(-1, 1, rough)),
                new Vector3[] {Vector3.ZERO, new Vector3(0, 0, 1)}, new Vector3[] {Vector3.ZERO, Vector3.ZERO},
                new int[] {0, 1});
        double[] before = groove.system.getOwnState().clone();
        groove.exact(0.01, 60).run();
        for (int k = 0; k < 12; k++) {
            assertEquals(before[k], groove.system.getOwnState()[k], 1e-15);
        }
        assertEquals(0, system.getStateSize());
    }
}
