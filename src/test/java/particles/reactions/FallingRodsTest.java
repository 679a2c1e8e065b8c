package particles.reactions;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static particles.reactions.JointCase.at;
import static particles.reactions.JointCase.coulomb;
import static particles.reactions.JointCase.plane;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import particles.Simulation;
import particles.SimulationException;
import particles.energy.EnergyLedger;
import particles.law.Plane;
import particles.law.Vector3;
import particles.reactions.contact.ContactModes.Mode;
import particles.reactions.contact.ContactSurface;
import particles.reactions.contact.Friction;

/** Rods that hit the ground, come to rest, reverse or jam. */
class FallingRodsTest {
    private static final double G = 9.81;

    /**
     * A falling dumbbell at an angle f to the ground: the impulse is (1 + r) m v / (1 - sin&sup2; f / 2), and r = 1
     * conserves energy.
     */
    @ParameterizedTest
    @ValueSource(doubles = {0, 0.5, 1})
    void theImpulseOnARodHitWithOneEndMeetsTheClosedForm(double restitution) {
        double f = Math.toRadians(40);
        ContactSurface ground = new ContactSurface("ground", Plane.ground(0), restitution, Friction.NONE, 1e-6);
        JointCase rod = new JointCase(List.of(ground), at(0, 0.5, Math.cos(f), 0.5 + Math.sin(f)), at(0, 0, 0, 0),
                new int[] {0, 1});
        JointCase.Watch watch = new JointCase.Watch();
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

    /** A rod above rough ground. @param slow the speeds that count as rest, tangential and normal (m/s) */
    private static JointCase thrownRod(double slow) {
        ContactSurface ground = new ContactSurface("ground", Plane.ground(0), 0.3,
                new Friction(Friction.Law.COULOMB, 0.4, 0.5, slow), slow);
        Vector3 sideways = new Vector3(1, 0, 0);
        return new JointCase(List.of(ground), at(0, 0.5, 0.6, 1.3), new Vector3[] {sideways, sideways},
                new int[] {0, 1});
    }

    /**
     * A rod falls, hits, slides with friction and comes to rest: the energy ledger balances, and the rod does no work.
     */
    @Test
    void aFallingRodComesToRest() {
        JointCase rod = thrownRod(1e-3);
        EnergyLedger ledger = new EnergyLedger();
        Simulation simulation = rod.exact(0.005, 4);
        simulation.addObserver(ledger);
        simulation.run();
        assertEquals(0, rod.at(0, 1), 1e-9);
        assertEquals(0, rod.at(1, 1), 1e-9);
        assertEquals(1, Pendulums.distance(rod.system, 0, 1), 1e-7);
        assertTrue(rod.contacts.getModes().isSticking(0) && rod.contacts.getModes().isSticking(1), "at rest");
        assertEquals(0, ledger.getWork().get("rods"), "exactly");
        assertEquals(0, ledger.getNumericalError(), 2e-7, "the feedback; measured: 2.4e-8");
        assertTrue(ledger.getWork().get("contact") < -0.1 && ledger.getWork().get("impacts") < -1,
                ledger.getWork().toString());
    }

    /** With clamp it comes to rest at about the same place. */
    @Test
    void aFallingRodComesToRestByClamping() {
        JointCase rod = thrownRod(1e-2);
        rod.clamped(0.002, 4).run();
        assertEquals(0, rod.at(0, 1), 1e-9);
        assertEquals(0, rod.at(1, 1), 1e-9);
        assertEquals(1, Pendulums.distance(rod.system, 0, 1), 1e-7);
        assertEquals(0, Math.abs(rod.at(0, 3)) + Math.abs(rod.at(1, 3)), 1e-12);
    }

    /**
     * A trestle whose feet slide apart falls flat. When they stop at +-l its top moves down at v, and no forces could
     * hold both feet, as each rod needs v&sup2;/l towards its own foot. The result is "does not hold", not a failure.
     * Once all lie still, friction withstands mu m g.
     */
    @ParameterizedTest
    @ValueSource(doubles = {0.1, 0.05})
    void feetUnderAFallingTopAreNotHeld(double mu) {
        double b = Math.toRadians(20);
        JointCase trestle = new JointCase(List.of(plane(0, 1, coulomb(mu))),
                at(-Math.sin(b), 0, 0, Math.cos(b), Math.sin(b), 0),
                at(0, 0, 0, 0, 0, 0), new int[] {0, 1}, new int[] {1, 2});
        trestle.exact(0.005, 2).run();
        assertEquals(-1, trestle.at(0, 0), 1e-8, "measured: 3.4e-9, what the feedback leaves of the rods' lengths");
        assertEquals(0, trestle.at(1, 1), 1e-8);
        assertEquals(1, trestle.at(2, 0), 1e-8);
        double[] state = trestle.system.getOwnState();
        assertEquals(mu * G, trestle.contacts.holdMargin(0, state, trestle.effects()), 1e-9);
        trestle.contacts.getModes().set(0, 0, Mode.SLIDING);
        trestle.contacts.getModes().set(0, 1, Mode.FREE);
        trestle.contacts.getModes().set(0, 2, Mode.SLIDING);
        state[10] = -4;
        assertTrue(trestle.contacts.holdMargin(0, state, trestle.effects()) < 0, "nothing can hold it");
    }

    /**
     * The end of a double pendulum slides over rough ground until both rods are in line, sqrt(L&sup2; - 1) from below
     * the pivot, and reverses there; as the middle moves on, friction cannot hold the end. One event for each reversal,
     * lift-off and impact. Measured: 7, and 1.1e-9 m.
     */
    @Test
    void anEndReversesWhereTheRodsAreInLine() {
        ContactSurface ground = new ContactSurface("ground", Plane.ground(0), 0.3, coulomb(0.5), 0.01);
        JointCase pendulum = new JointCase(true, List.of(ground), at(0, 1, 0.7, 1.2, 1.3, 1.5), at(0, 0, 0, 0, 0, 0),
                new int[] {0, 1},
                new int[] {1, 2});
        Simulation simulation = pendulum.exact(0.005, 2);
        JointCase.Watch watch = new JointCase.Watch();
        simulation.addObserver(watch);
        simulation.run();
        double length = Math.hypot(0.7, 0.2) + Math.hypot(0.6, 0.3);
        double reach = watch.states.stream().mapToDouble(state -> state[12]).min().orElseThrow();
        assertEquals(-Math.sqrt(length * length - 1), reach, 1e-8);
        assertTrue(simulation.getEvents() <= 10, "events: " + simulation.getEvents());
    }

    /** Painlev&eacute;'s paradox: for a rod pushed along ground too rough for its angle, no forces keep it out. */
    @Test
    void jammingFrictionIsAClearError() {
        double f = Math.asin(Math.sqrt(2.0 / 3));
        JointCase rod = new JointCase(List.of(plane(0, 1, coulomb(4))), at(0, 0, -Math.cos(f), Math.sin(f)),
                at(3, 0, 3, 0), new int[] {0, 1});
        String message = assertThrows(SimulationException.class, () -> rod.clamped(0.001, 0.1).run()).getMessage();
        assertTrue(message.contains("friction jams"), message);
    }
}
