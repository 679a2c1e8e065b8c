package particles.reactions;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static particles.scene.ShortRun.G;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import particles.reactions.ContactModes.Mode;
import particles.scene.ShortRun;

/** Rods and contacts, solved together, against closed forms: leaning, sliding, held. */
class JointContactsTest {
    /** A surface through the origin without bounces. */
    private static String plane(double nx, double ny, double mu) {
        return "  - plane: {normal: [" + nx + ", " + ny + ", 0], restitution: 0, restSpeed: 1e-6, "
                + "friction: {law: coulomb, coefficient: " + mu + ", threshold: 0}}\n";
    }

    /** Runs a rod on planes; its second end is on the y-axis, at an angle to it. */
    private static ShortRun ladder(String steps, double a, double floor, double wall) {
        return ShortRun.of("rk4 " + steps, """
                particles: [{id: a, position: [%s, 0, 0]}, {id: b, position: [0, %s, 0]}]
                rods: [{from: a, to: b}]
                rules:
                """.formatted(Math.sin(a), Math.cos(a)) + plane(0, 1, floor) + plane(1, 0, wall));
    }

    /**
     * A rod spins flat on smooth ground, one turn a second: it carries m omega&sup2; l/2 and both ends press with m g.
     */
    @ParameterizedTest
    @ValueSource(strings = {"exact", "clamp"})
    void aSpinningRodCarriesTheCentripetalForce(String impact) {
        double omega = 2 * Math.PI;
        ShortRun rod = ShortRun.of("rk4 " + impact + " 0.005 2", """
                particles:
                  - {id: a, position: [-0.5, 0, 0], velocity: [0, 0, %1$s]}
                  - {id: b, position: [0.5, 0, 0], velocity: [0, 0, -%1$s]}
                rods: [{from: a, to: b}]
                rules:
                """.formatted(omega / 2) + plane(0, 1, 0));
        assertEquals(-0.5, rod.at(0), 1e-7, "measured: 2e-8 of a turn's phase");
        assertEquals(0, rod.at(1), 1e-15);
        assertEquals(1, rod.distance(0, 1), 2e-7, "measured: 4e-8");
        double[] state = rod.getState();
        double[] force = rod.effects();
        assertEquals(G, rod.contacts().getQueries().pressure(0, 0, state, force), 1e-9);
        rod.rods().addForces(state, 0, force);
        assertEquals(omega * omega / 2, Math.hypot(force[3], force[5]), 1e-5, "measured: 2e-6");
    }

    /**
     * A rod leans on a smooth wall at an angle a0 to it and slides: a'&sup2; = 2 g/l (cos a0 - cos a); it leaves the
     * wall where cos a = 2/3 cos a0. Measured: 1.2e-9 m/s.
     */
    @Test
    void aLeaningRodLeavesTheWall() {
        double a0 = Math.toRadians(20);
        ShortRun ladder = ladder("exact 0.002 0.8", a0, 0, 0);
        double cosine = 2.0 / 3 * Math.cos(a0);
        assertEquals(cosine, ladder.getStates().get(0)[7], 1e-9);
        double rate = Math.sqrt(2 * G * (Math.cos(a0) - cosine));
        assertEquals(-Math.sqrt(1 - cosine * cosine) * rate, ladder.getStates().get(0)[10], 8e-9);
        assertEquals(Mode.FREE, ladder.contacts().getContacts().getModes().get(1, 1));
        assertTrue(ladder.at(6) > 0.05, "it moves away from the wall, at x = " + ladder.at(6));
    }

    /**
     * The same with friction mu at the floor: a'' = (g sin a - 2 mu g cos a) / (l (1 - mu sin a cos a)), if tan a &gt;
     * 2 mu. Measured: 4e-9, terms of order t&sup3;.
     */
    @Test
    void aLeaningRodSlidesAgainstFloorFriction() {
        double mu = 0.2;
        double a = Math.atan(2 * mu) + 0.1;
        double acceleration = (G * Math.sin(a) - 2 * mu * G * Math.cos(a)) / (1 - mu * Math.sin(a) * Math.cos(a));
        assertEquals(acceleration * Math.cos(a) * 1e-3, ladder("exact 1e-3 1e-3", a, mu, 0).at(3), 2e-8);
        ShortRun holds = ladder("exact 0.01 1", a - 0.11, mu, 0);
        assertEquals(Math.cos(a - 0.11), holds.at(7), 1e-14);
        assertTrue(holds.isHeld(0));
    }

    /** Friction at both ends is statically indeterminate; the rod is held if tan a &lt; 2 mu / (1 - mu&sup2;). */
    @ParameterizedTest
    @ValueSource(strings = {"exact", "clamp"})
    void frictionAtBothEndsHoldsUpToItsAngle(String impact) {
        double limit = Math.atan(0.6 / (1 - 0.09));
        ShortRun holds = ladder(impact + " 0.01 1", limit - 1e-3, 0.3, 0.3);
        assertEquals(Math.cos(limit - 1e-3), holds.at(7), 1e-14);
        assertTrue(holds.isHeld(0) && holds.isHeld(1));
        double height = ladder(impact + " 0.01 1", limit + 1e-3, 0.3, 0.3).at(7);
        assertTrue(height < Math.cos(limit) - 1e-3, "it slides: " + height);
    }

    /** Two particles joined along a slope of 30 degrees with mu = 0.3 slide like one, and the rod carries nothing. */
    @ParameterizedTest
    @ValueSource(strings = {"exact", "clamp"})
    void aRodSlidesDownASlopeWithoutLoad(String impact) {
        double a = Math.toRadians(30);
        for (double mu : new double[] {0.3, 0.6}) {
            ShortRun rod = ShortRun.of("rk4 " + impact + " 0.01 1", """
                    particles: [{id: a, position: [0, 0, 0]}, {id: b, position: [%s, -%s, 0]}]
                    rods: [{from: a, to: b}]
                    rules:
                    """.formatted(Math.cos(a), Math.sin(a)) + plane(Math.sin(a), Math.cos(a), mu));
            double way = mu == 0.6 ? 0 : G * (Math.sin(a) - mu * Math.cos(a)) / 2;
            double bound = mu == 0.6 ? 1e-14 : impact.equals("exact") ? 1e-12 : 1e-10;
            assertEquals(way * Math.cos(a), rod.at(0), bound, "0.6 holds, also lengthways");
            assertEquals(Math.cos(a) + way * Math.cos(a), rod.at(6), bound);
        }
    }

    /**
     * A rod between two walls, whose end is on a rod of fixed length to an anchor that moves too slowly to be seen: the
     * rods contradict each other until friction lets go, which is no jam. Measured: 3.6e-8 and 3.9e-6 of the energy.
     */
    @ParameterizedTest
    @CsvSource({"0.1, 1e-6", "9.81, 4e-5"})
    void aHeldRodAwaitsItsMovingAnchor(double gravity, double error) {
        ShortRun rod = ShortRun.of("rk4 clamp 0.01 2", """
                particles:
                  - {id: a, position: [1, 0, 0]}
                  - {id: c, position: [0, 1, 0]}
                  - {id: d, position: [1, 1.5, 0], fixed: true}
                rods: [{from: a, to: c}, {from: c, to: d}]
                effects:
                  - gravity: {acceleration: [0, -%s, 0]}
                rules:
                  - ground: {restitution: 0.4, friction: {law: coulomb, coefficient: 0.9}}
                  - plane: {point: [0, 0, 0], normal: [1, 0, 0]}
                  - glide: {particle: d, to: [0.9, 1.5, 0], duration: 6}
                """.formatted(gravity));
        assertEquals(0, rod.getNumericalError(), error * 0.00186, "of the energy scale");
    }

    /** A particle in a groove of 90 degrees, and another above it on a rod: each wall carries (2 m g) / sqrt 2. */
    @Test
    void aGrooveCarriesAParticleWithARod() {
        ShortRun groove = ShortRun.of("rk4 exact 0.01 0.1", """
                particles: [{id: a, position: [0, 0, 0]}, {id: b, position: [0, 1, 0]}]
                rods: [{from: a, to: b}]
                rules:
                """ + plane(1, 1, 0) + plane(-1, 1, 0));
        double[] state = groove.getState();
        for (int wall = 0; wall < 2; wall++) {
            assertEquals(2 * G * Math.sqrt(0.5), groove.contacts().getQueries().pressure(wall, 0, state,
                    groove.effects()), 1e-9);
        }
        assertEquals(1, groove.at(7), 1e-12, "it stays upright, since nothing tips it");
    }

    /** One rod topples about its foot on rough ground; another lies there, and nothing about it can move. */
    @Test
    void aRodIsHeldAtBothEndsBesideOneThatFalls() {
        ShortRun rods = ShortRun.of("rk4 clamp 0.01 0.1", """
                particles: [{id: a, position: [0, 0, 0]}, {id: b, position: [0.5, 1, 0]},
                            {id: c, position: [2, 0, 0]}, {id: d, position: [3, 0, 0]}]
                rods: [{from: a, to: b}, {from: c, to: d}]
                rules:
                """ + plane(0, 1, 1));
        assertTrue(rods.at(10) < -0.1, "it topples");
        assertTrue(rods.isHeld(0) && rods.isHeld(2) && rods.isHeld(3));
        assertEquals(0, rods.work("rods"), "exactly");
    }

    /** In a rough groove, both ends of a rod stay for a minute. */
    @Test
    void aRodInARoughGrooveStaysAtRest() {
        ShortRun groove = ShortRun.of("rk4 exact 0.01 60", """
                particles: [{id: a, position: [0, 0, 0]}, {id: b, position: [0, 0, 1]}]
                rods: [{from: a, to: b}]
                rules:
                """ + plane(1, 1, 0.3) + plane(-1, 1, 0.3));
        assertArrayEquals(new double[] {0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0},
                groove.getState(), 1e-15);
    }
}
