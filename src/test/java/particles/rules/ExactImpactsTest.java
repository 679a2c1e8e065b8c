package particles.rules;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static particles.scene.ShortRun.G;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import particles.law.Plane;
import particles.law.Vector3;
import particles.reactions.ContactModes.Mode;
import particles.scene.ShortRun;

/** Impacts, rest and the ends of contact, sliding and sticking at their exact times. */
class ExactImpactsTest {
    /** Contact times of the reference values, h0 = 1, r = 0.5. */
    private static final double[] CONTACTS = {0.451523640986, 0.903047281971, 1.128809102464, 1.241690012711,
        1.298130467834, 1.326350695396};

    private static ShortRun run(double deltaT, double duration, String text) {
        return ShortRun.of("rk4 exact " + deltaT + " " + duration, text);
    }

    /** A particle on an incline of 45 degrees with friction of 0.2, which does not hold it. */
    private static ShortRun slide(double up, double along, double threshold, double deltaT, double duration) {
        return run(deltaT, duration, """
                particles: [{id: p, position: [0, 0, 0], velocity: [%1$s, %1$s, %2$s]}]
                rules:
                  - plane: {normal: [-1, 1, 0], restSpeed: 1e-6,
                            friction: {law: coulomb, coefficient: 0.2, threshold: %3$s}}
                """.formatted(up * Math.sqrt(0.5), along, threshold));
    }

    /**
     * Bounds: contact times within 1e-9 s, rest at 1.354570922957 s within 1e-6. Measured: 6e-13 (digits of the table),
     * 4e-7. A fixed particle inside the ball stays where it is.
     */
    @ParameterizedTest
    @ValueSource(strings = {"ground: {restSpeed: 1e-6}", "sphere: {centre: [0, -1, 0], radius: 1, restSpeed: 1e-6}"})
    void bouncesComeAtTheirTimesAndEndInRest(String surface) {
        ShortRun run = run(0.01, 3, """
                particles: [{id: p, position: [0, 1, 0]}, {id: pivot, position: [0, -0.5, 0], fixed: true}]
                rules: [%s]
                """.formatted(surface));
        for (int k = 0; k < CONTACTS.length; k++) {
            assertEquals(CONTACTS[k], run.getTimes().get(k), 2e-12);
        }
        assertEquals(1.354570922957, run.getTimes().get(22), 1e-6);
        assertEquals(23, run.getTimes().size(), "impacts until 4.43 m/s times 0.5^n is below 1e-6 m/s");
        assertTrue(run.getLowest() >= -1e-12, "lowest place " + run.getLowest());
        assertEquals(0, run.at(4));
        assertEquals(0, run.at(1), 1e-15);
        assertEquals(-0.5, run.at(7));
        assertEquals(300, run.getSimulation().getSteps());
    }

    /** Restitutions 0.8 and 0.9 come to rest at their times, with steps far longer than the last bounces. */
    @ParameterizedTest
    @CsvSource({"0.8, 4.063712768872", "0.9, 8.578949178729"})
    void longBounceSequencesEndAtTheirTimes(double restitution, double rest) {
        ShortRun run = ShortRun.of("midpoint exact 0.0333333333333 9", """
                particles: [{id: p, position: [0, 1, 0]}]
                rules: [ground: {restSpeed: 1e-6, restitution: %s}]
                """.formatted(restitution));
        assertEquals(rest, run.getTimes().get(run.getTimes().size() - 1), 3e-6,
                "2 v/g (1 + r + ...) with v = 1e-6 m/s is left out");
        assertTrue(run.getLowest() >= -1e-12, "lowest place " + run.getLowest());
    }

    /** One step over three bounces; two particles that hit at the same time. */
    @Test
    void oneStepHandlesManyImpacts() {
        ShortRun run = run(1.2, 1.2, """
                particles: [{id: p, position: [0, 1, 0]}, {id: q, position: [5, 1, 0], mass: 3}]
                rules: [ground: {restSpeed: 1e-6}]
                """);
        assertEquals(1, run.getSimulation().getSteps());
        assertEquals(3, run.getTimes().size(), "three bounces, each of both at one moment");
        double sinceThird = 1.2 - CONTACTS[2];
        double speed = Math.sqrt(2 * G) / 8;
        assertEquals(speed * sinceThird - G / 2 * sinceThird * sinceThird, run.at(1), 1e-11);
        assertEquals(run.at(1), run.at(7), 1e-14);
    }

    /**
     * With drag, through three bounces off the ground or off the top of a ball: rk4 keeps order 4 (measured 3.97 to
     * 4.03) and euler order 1; with clamp, rk4 falls to about order 1.
     */
    @ParameterizedTest
    @ValueSource(strings = {"ground: {restSpeed: 1e-6}", "sphere: {centre: [0, -1, 0], radius: 1, restSpeed: 1e-6}"})
    void theSolverKeepsItsOrderThroughBounces(String surface) {
        double exact = heightAfterBounces("rk4 exact", 4000, surface);
        double order = order("rk4 exact", exact, surface);
        assertTrue(order >= 3.8 && order <= 4.3, "rk4, exact: " + order);
        double clamped = order("rk4 clamp", exact, surface);
        assertTrue(clamped <= 1.8, "rk4, clamp: " + clamped);
        assertEquals(1, order("euler exact", exact, surface), 0.15);
    }

    private static double order(String solver, double exact, String surface) {
        return Math.log(Math.abs((heightAfterBounces(solver, 23, surface) - exact)
                / (heightAfterBounces(solver, 23 * 16, surface) - exact))) / Math.log(16);
    }

    private static double heightAfterBounces(String solver, int steps, String surface) {
        return ShortRun.of(solver + " " + 1.15 / steps + " 1.15", """
                particles: [{id: p, position: [0, 1, 0]}]
                effects: [gravity, drag: {coefficient: 0.5}]
                rules: [%s]
                """.formatted(surface)).at(1);
    }

    @Test
    void aFastParticleDoesNotTunnelThroughTwoWalls() {
        ShortRun run = run(0.01, 0.1, """
                particles: [{id: p, position: [0.3, 5, 0], velocity: [1e4, 0, 0]}]
                rules:
                  - plane: {normal: [1, 0, 0], restitution: 1}
                  - plane: {point: [1, 0, 0], normal: [-1, 0, 0], restitution: 1}
                """);
        double x = run.at(0);
        assertTrue(x >= 0 && x <= 1, "x = " + x);
        assertEquals(1e4, Math.abs(run.at(3)), 1e-9);
        double unfolded = (0.3 + 1e4 * 0.1) % 2;
        assertEquals(unfolded <= 1 ? unfolded : 2 - unfolded, x, 1e-9);
    }

    /** Coulomb friction stops at v0/(mu g) after v0&sup2;/(2 mu g), at steps of 0.1 s. Measured: 2e-16. */
    @Test
    void coulombFrictionStopsAtItsTime() {
        ShortRun run = run(0.1, 2, """
                particles: [{id: p, position: [0, 0, 0], velocity: [1.2, 0, 1.6]}]
                rules: [ground: {friction: {law: coulomb, coefficient: 0.3, static: 0.4, threshold: 0}}]
                """);
        assertEquals(2 / (0.3 * G), run.getTimes().get(0), 1e-15);
        assertEquals(4 / (2 * 0.3 * G), Math.hypot(run.at(0), run.at(2)), 2e-15);
        assertEquals(0, Math.abs(run.at(3)) + Math.abs(run.at(5)));
        assertTrue(run.isHeld(0));
    }

    /** The lecture's friction slows to the static threshold at ln(v0/v_eps)/(k_f g), after (v0 - v_eps)/(k_f g). */
    @Test
    void lectureFrictionStopsAtTheThreshold() {
        ShortRun run = run(0.01, 5, """
                particles: [{id: p, position: [0, 0, 0], velocity: [2, 0, 0]}]
                rules: [ground: {friction: {law: slide, coefficient: 0.1, static: 0.3, threshold: 0.1}}]
                """);
        assertEquals(Math.log(20) / (0.1 * G), run.getTimes().get(0), 1e-9);
        assertEquals(1.9 / (0.1 * G), run.at(0), 1e-10);
    }

    /**
     * Straight up, it stops after v/(g (sin + mu cos)) and slides down with g (sin - mu cos), for any threshold below
     * which friction would hold it on a gentler slope: one event for the threshold, one for the reversal.
     */
    @ParameterizedTest
    @CsvSource({"0, 1", "0.01, 2", "0.3, 2"})
    void aSlideStraightUpReversesOnce(double threshold, int events) {
        ShortRun run = slide(1, 0, threshold, 0.01, 0.4);
        double root = Math.sqrt(0.5);
        double g = G * root;
        double turn = 1 / (g * 1.2);
        double place = turn / 2 - g * 0.8 * (0.4 - turn) * (0.4 - turn) / 2;
        assertEquals(place * root, run.at(0), 1e-12);
        assertEquals(-g * 0.8 * (0.4 - turn) * root, run.at(3), 1e-12);
        assertEquals(events, run.getSimulation().getEvents());
    }

    /**
     * An oblique slide never stops, however large the steps. Within a step of 0.01 s it turns by more than a right
     * angle at a hundredth of its speed, and keeps its velocity across the slope: no jump is booked, and it ends where
     * steps a fiftieth as long take it (measured: 3.5e-5 m apart, and 2 % of the speed across).
     */
    @Test
    void anObliqueSlideTurnsWithoutStopping() {
        ShortRun small = slide(1, 0.05, 0, 0.0002, 0.4);
        assertTrue(small.at(5) > 0.005, "friction leaves " + small.at(5));
        ShortRun large = slide(1, 0.05, 0, 0.01, 0.4);
        assertEquals(small.at(5), large.at(5), 0.1 * small.at(5));
        assertEquals(small.at(0), large.at(0), 2e-4);
        assertEquals(0, large.work("impacts"), 1e-15);
    }

    /**
     * A particle that begins inside a solid is moved onto its surface. There it flies off if it moves outwards, y = v t
     * - g t&sup2;/2, bounces if it moves inwards, and otherwise rests. Measured: 2e-15 m.
     */
    @ParameterizedTest
    @CsvSource({"5, 5, FREE", "-5, 2.5, FREE", "0, 0, SLIDING"})
    void aParticleBornInsideLeavesWithItsSpeed(double speed, double leaving, Mode mode) {
        double t = 0.3;
        ShortRun run = new ShortRun("rk4 exact 0.01 0.3", """
                particles: [{id: p, position: [0, 0, 0], velocity: [1, %s, 0]}]
                rules: [ground: {}]
                """.formatted(speed));
        run.getState()[1] = -0.05;
        run.run();
        assertEquals(leaving == 0 ? 0 : leaving * t - G / 2 * t * t, run.at(1), 1e-14);
        assertEquals(t, run.at(0), 1e-15);
        assertEquals(mode, run.mode());
        assertEquals(1, run.getSimulation().getEvents());
    }

    /**
     * A particle slides down one side of a sharp groove into the other: both together bring it to rest, outside both.
     */
    @Test
    void aParticleComesToRestInASharpGroove() {
        ShortRun run = run(0.01, 6, """
                particles: [{id: p, position: [0.3, 2, 0]}]
                rules:
                  - plane: {normal: [-2, 1, 0], restitution: 0.4, restSpeed: 1e-6}
                  - plane: {normal: [2, 1, 0.3], restitution: 0.4, restSpeed: 1e-6}
                """);
        for (Vector3 normal : new Vector3[] {new Vector3(-2, 1, 0), new Vector3(2, 1, 0.3)}) {
            assertEquals(0, new Plane(Vector3.ZERO, normal).distance(new Vector3(run.at(0), run.at(1), run.at(2))),
                    1e-9);
        }
    }
}
