package particles.reactions;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static particles.Systems.onMove;
import static particles.scene.ShortRun.G;

import deSolvers.problems.Steps;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import particles.SimulationException;
import particles.reactions.ContactModes.Mode;
import particles.scene.ShortRun;

/** Rods that hit the ground, come to rest, reverse or jam. */
class FallingRodsTest {
    /** @param friction the coefficient of friction */
    private static String ground(double restitution, double restSpeed, double friction, double threshold) {
        return """
                rules:
                  - ground: {restitution: %s, restSpeed: %s, friction: {law: coulomb, coefficient: %s, threshold: %s}}
                """.formatted(restitution, restSpeed, friction, threshold);
    }

    /**
     * A falling dumbbell at an angle f to the ground: the impulse is (1 + r) m v / (1 - sin&sup2; f / 2), and r = 1
     * conserves energy.
     */
    @ParameterizedTest
    @ValueSource(doubles = {0, 0.5, 1})
    void theImpulseOnARodHitWithOneEndMeetsTheClosedForm(double restitution) {
        double f = Math.toRadians(40);
        double fall = Math.sqrt(1 / G);
        ShortRun rod = ShortRun.of("rk4 exact 0.01 " + (fall + 1e-9), """
                particles: [{id: a, position: [0, 0.5, 0]}, {id: b, position: [%s, %s, 0]}]
                rods: [{from: a, to: b}]
                """.formatted(Math.cos(f), 0.5 + Math.sin(f)) + ground(restitution, 1e-6, 0, 0));
        double[] after = rod.getStates().get(0);
        double v = Math.sqrt(G);
        assertEquals(fall, rod.getTimes().get(0), 1e-12);
        double share = 1 - Math.sin(f) * Math.sin(f) / 2;
        assertEquals((1 + restitution) * v / share, after[4] + after[10] + 2 * v, 1e-11);
        assertEquals(restitution * v, after[4], 1e-11);
        assertEquals(0, after[3] + after[9], 1e-12, "no impulse along smooth ground");
        assertEquals(-(1 - restitution * restitution) * v * v / 2 / share, rod.work("impacts"), 1e-10);
    }

    /**
     * A rod falls, hits, slides with friction and comes to rest: the energy ledger balances, and the rod does no work.
     * Numerical error: that of the feedback, measured 2.4e-8 J with exact impacts and 6.7e-10 J with clamp.
     */
    @ParameterizedTest
    @CsvSource({"exact 0.005, 1e-3, 2e-7", "clamp 0.002, 1e-2, 6e-9"})
    void aFallingRodComesToRest(String steps, double slow, double error) {
        ShortRun rod = ShortRun.of("rk4 " + steps + " 4", """
                particles:
                  - {id: a, position: [0, 0.5, 0], velocity: [1, 0, 0]}
                  - {id: b, position: [0.6, 1.3, 0], velocity: [1, 0, 0]}
                rods: [{from: a, to: b}]
                """ + ground(0.3, slow, 0.4, slow));
        assertEquals(0, rod.at(1), 1e-9);
        assertEquals(0, rod.at(7), 1e-9);
        assertEquals(1, rod.distance(0, 1), 2e-8, "measured: 2.9e-9");
        assertEquals(0, Math.abs(rod.at(3)) + Math.abs(rod.at(9)), 1e-12);
        assertTrue(rod.isHeld(0) && rod.isHeld(1), "at rest");
        assertEquals(0, rod.work("rods"), "exactly");
        assertEquals(0, rod.getNumericalError(), error);
        assertTrue(rod.work("contact") < -0.1 && rod.work("impacts") < -1, "" + rod.getLedger().getWork());
    }

    private static final String THROWN = """
            particles:
              - {id: a, position: [0, 0.5, 0], velocity: [1, 0, 0.3]}
              - {id: b, position: [1, 0.7, 0], velocity: [1, 0, 0.3]}
              - {id: c, position: [0.4, 1.4, 0.3], velocity: [1, 0, 0.3]}
            rods: [{from: a, to: b}, {from: b, to: c}, {from: a, to: c}]
            """;
    private static final String TOPPLING = """
            particles: [{id: a, position: [0, 0, 0]}, {id: b, position: [1, 0, 0]}, {id: c, position: [0.5, 0.8, 0.1]}]
            rods: [{from: a, to: b}, {from: b, to: c}, {from: a, to: c}]
            """;
    private static final String CHAIN = """
            particles:
              - {id: a, position: [0, 0.3, 0]}
              - {id: b, position: [0.5, 0.4, 0]}
              - {id: c, position: [1, 0.6, 0.1]}
              - {id: d, position: [1.4, 0.9, 0]}
            rods: [{from: a, to: b}, {from: b, to: c}, {from: c, to: d}]
            """;

    /**
     * With clamp, all particles of a linkage end on the ground and stick there. The last one is moved onto the ground
     * and the rods are corrected before friction holds it; otherwise the rods of the chain could not keep their
     * lengths.
     */
    @ParameterizedTest
    @CsvSource({"thrown, 0.3, 2", "toppling, 0.5, 1", "chain, 0.3, 1.6", "chain, 0.8, 1.6"})
    void linkagesComeToRestOnRoughGround(String name, double mu, double duration) {
        String shape = name.equals("thrown") ? THROWN : name.equals("chain") ? CHAIN : TOPPLING;
        ShortRun run = new ShortRun("rk4 clamp 0.005 " + duration,
                shape + ground(name.equals("toppling") ? 0 : 0.3, 1e-2, mu, 1e-2));
        double[] worst = new double[2];
        run.getSimulation().addObserver(onMove(motion -> {
            for (int r = 0; r < run.rods().springCount(); r++) {
                double length = run.distance(run.rods().from(r), run.rods().to(r));
                worst[0] = Math.max(worst[0], Math.abs(length - run.rods().restLength(r)));
            }
            worst[1] = Math.max(worst[1], motion.getSystem().getEnergy(motion.getSystem().getOwnState(), 0)
                    - run.getLedger().getStartEnergy());
        }));
        run.run();
        for (int i = 0; i < run.getSystem().getParticles().count(); i++) {
            assertTrue(run.isHeld(i), "particle " + i + " at rest");
            assertEquals(0, run.at(6 * i + 1), 1e-12, "on the ground");
            assertEquals(0, Math.hypot(Math.hypot(run.at(6 * i + 3), run.at(6 * i + 4)), run.at(6 * i + 5)), 1e-12);
        }
        assertEquals(0, worst[0], 1e-7, "measured: 3e-8 at most");
        assertEquals(0, worst[1], 1e-3, "clamping lifts particles; measured: 2.4e-4 J for the toppling triangle");
        assertTrue(run.work("contact") < 0 && run.work("impacts") < -5, "" + run.getLedger().getWork());
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
        ShortRun trestle = ShortRun.of("rk4 exact 0.005 2", """
                particles:
                  - {id: a, position: [-%1$s, 0, 0]}
                  - {id: top, position: [0, %2$s, 0]}
                  - {id: b, position: [%1$s, 0, 0]}
                rods: [{from: a, to: top}, {from: top, to: b}]
                """.formatted(Math.sin(b), Math.cos(b)) + ground(0, 1e-6, mu, 0));
        assertEquals(-1, trestle.at(0), 1e-8, "measured: 3.4e-9, what the feedback leaves of the rods' lengths");
        assertEquals(0, trestle.at(7), 1e-8);
        assertEquals(1, trestle.at(12), 1e-8);
        double[] state = trestle.getState();
        RestingContacts contacts = trestle.contacts();
        assertEquals(mu * G, contacts.getQueries().holdMargin(0, state, trestle.effects()), 1e-9);
        contacts.getContacts().getModes().set(0, 0, Mode.SLIDING);
        contacts.getContacts().getModes().set(0, 1, Mode.FREE);
        contacts.getContacts().getModes().set(0, 2, Mode.SLIDING);
        state[10] = -4;
        assertTrue(contacts.getQueries().holdMargin(0, state, trestle.effects()) < 0, "nothing can hold it");
    }

    /**
     * The end of a double pendulum slides over rough ground until both rods are in line, sqrt(L&sup2; - 1) from below
     * the pivot, and reverses there; as the middle moves on, friction cannot hold the end. One event for each reversal,
     * lift-off and impact. Measured: 7, and 1.1e-9 m.
     */
    @Test
    void anEndReversesWhereTheRodsAreInLine() {
        ShortRun pendulum = ShortRun.of("rk4 exact 0.005 2", """
                particles:
                  - {id: pivot, position: [0, 1, 0], fixed: true}
                  - {id: middle, position: [0.7, 1.2, 0]}
                  - {id: end, position: [1.3, 1.5, 0]}
                rods: [{from: pivot, to: middle}, {from: middle, to: end}]
                """ + ground(0.3, 0.01, 0.5, 0).replace("threshold", "impacts: false, threshold"));
        double length = Math.hypot(0.7, 0.2) + Math.hypot(0.6, 0.3);
        double reach = pendulum.getStates().stream().mapToDouble(state -> state[12]).min().orElseThrow();
        assertEquals(-Math.sqrt(length * length - 1), reach, 1e-8);
        long events = pendulum.getSimulation().getEvents();
        assertTrue(events <= 10, "events: " + events);
    }

    /** Painlev&eacute;'s paradox: for a rod pushed along ground too rough for its angle, no forces keep it out. */
    @Test
    void jammingFrictionIsAClearError() {
        ShortRun rod = new ShortRun("rk4 clamp 0.001 0.1", """
                particles:
                  - {id: a, position: [0, 0, 0], velocity: [3, 0, 0]}
                  - {id: b, position: [-%s, %s, 0], velocity: [3, 0, 0]}
                rods: [{from: a, to: b}]
                """.formatted(Math.sqrt(1 / 3.0), Math.sqrt(2 / 3.0)) + ground(0, 1e-6, 4, 0));
        Steps.assertFails(SimulationException.class, "jams", rod::run);
    }
}
