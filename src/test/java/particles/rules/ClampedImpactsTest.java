package particles.rules;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static particles.Systems.onMove;
import static particles.scene.ShortRun.G;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import particles.EventRule;
import particles.reactions.ContactModes.Mode;
import particles.scene.ShortRun;

/**
 * Bounces, rest, sliding and sticking with clamped impacts, against closed forms. A bounce uses the speed at the
 * surface, not at the depth where the step ended: after n bounces the energy is r<sup>2n</sup> m g h for any deltaT;
 * only the times are late.
 */
class ClampedImpactsTest {
    private static ShortRun run(double deltaT, double duration, String text) {
        return ShortRun.of("rk4 clamp " + deltaT + " " + duration, text);
    }

    private static ShortRun dropped(double restitution, double restSpeed, double deltaT, double duration) {
        return run(deltaT, duration, """
                particles: [{id: p, position: [0, 1, 0]}]
                rules: [ground: {restitution: %s, restSpeed: %s}]
                """.formatted(restitution, restSpeed));
    }

    /**
     * Dropped from 1 m, it rises to r<sup>2n</sup> m after n bounces. Each bounce is late by less than a step, so the
     * n-th by less than n steps. Bounces end when a step cannot resolve them, r<sup>n</sup> v &lt;= g deltaT, in rest.
     */
    @ParameterizedTest
    @CsvSource({"0.9, 0.01", "0.9, 0.02", "0.9, 0.0333", "0.8, 0.01", "0.95, 0.005", "0.5, 1e-3",
            "0.5, 0.01", "0.5, 0.0333"})
    void bounceHeightsFollowTheFormulaUntilRest(double r, double deltaT) {
        double fall = Math.sqrt(2 / G);
        ShortRun ball = dropped(r, 0, deltaT, 30);
        int last = ball.getTimes().size() - 1;
        for (int n = 0; n < last; n++) {
            assertEquals(1, ball.getEnergies().get(n) / (G * Math.pow(r, 2 * n + 2)), 1e-12, "bounce " + n);
            double time = fall + 2 * fall * r * (1 - Math.pow(r, n)) / (1 - r);
            assertEquals(time + (n + 1) * deltaT / 2, ball.getTimes().get(n), (n + 1) * deltaT / 2, "bounce " + n);
        }
        assertEquals(Math.ceil(Math.log(deltaT / fall) / Math.log(r)), last + 1, 1, "bounces that deltaT can resolve");
        assertEquals(0, ball.at(1));
        assertEquals(0, ball.at(4));
    }

    /** Its energy is unchanged after 1000 bounces. */
    @ParameterizedTest
    @ValueSource(doubles = {0.005, 0.01, 0.02, 0.0333})
    void anElasticBallKeepsItsEnergy(double deltaT) {
        ShortRun ball = dropped(1, 1e-3, deltaT, 960);
        assertTrue(ball.getTimes().size() > 1000, "bounces: " + ball.getTimes().size());
        assertEquals(0, ball.worstEnergy(), 4e-14, "measured: 5e-15 at most");
    }

    /** Energy stays the same in a groove of two slopes, and on a ball hit off-centre so that a step ends inside it. */
    @ParameterizedTest
    @ValueSource(doubles = {0.002, 0.01, 0.02})
    void slopesAndBallsAddNoEnergy(double deltaT) {
        ShortRun groove = run(deltaT, 60, """
                particles: [{id: p, position: [-0.3, 1, 0]}]
                rules:
                  - plane: {normal: [1, 1, 0], restitution: 1, restSpeed: 0}
                  - plane: {normal: [-0.8, 1, 0], restitution: 1, restSpeed: 0}
                """);
        assertTrue(groove.getTimes().size() > 100, "bounces: " + groove.getTimes().size());
        assertEquals(0, groove.worstEnergy(), 5e-13, "measured: 6e-14 at most");
        ShortRun off = run(deltaT, 1, """
                particles: [{id: p, position: [0.2, 1.5, 0.1]}]
                rules: [sphere: {centre: [0, 0, 0], radius: 0.5, restitution: 1, restSpeed: 0}]
                """);
        assertEquals(1, off.getTimes().size(), "bounces");
        assertEquals(0, off.worstEnergy(), 5e-9, "the entry point is 1e-9 m below the surface; measured: 1.04e-9");
    }

    /** A particle that begins below the surface and rises loses speed on the way: v&sup2; = v0&sup2; - 2 g depth. */
    @Test
    void aParticleFromBelowLeavesWithItsSpeedAtTheSurface() {
        ShortRun born = new ShortRun("rk4 clamp 0.001 0.001", """
                particles: [{id: p, position: [0, 0, 0], velocity: [0, 5, 0]}]
                rules: [ground: {}]
                """);
        born.getState()[1] = -0.02;
        born.run();
        assertEquals(0, born.at(1), 1e-16);
        assertEquals(Math.sqrt(25 - 2 * G * 0.02), born.at(4), 1e-13);
    }

    /** The lecture's friction with the dissipative sign: v = v0 exp(-k_f g t). Measured with rk4 at 0.01: 3e-12. */
    @Test
    void lectureFrictionSlowsExponentially() {
        ShortRun run = run(0.01, 1, """
                particles: [{id: p, position: [0, 0, 0], velocity: [2, 0, 1]}]
                rules: [ground: {friction: {law: slide, coefficient: 0.1, threshold: 0}}]
                """);
        double factor = Math.exp(-0.1 * G);
        assertEquals(2 * factor, run.at(3), 1e-10);
        assertEquals(factor, run.at(5), 1e-10);
        assertEquals(2 * (1 - factor) / (0.1 * G), run.at(0), 1e-10);
        assertEquals(0, run.at(1));
    }

    /** With a static threshold v_eps the slide ends after (v0 - v_eps)/(k_f g), but for v_eps h of the last step. */
    @Test
    void slidingStopsAtTheThreshold() {
        ShortRun run = run(0.001, 10, """
                particles: [{id: p, position: [0, 0, 0], velocity: [2, 0, 0]}]
                rules: [ground: {friction: {law: slide, coefficient: 0.1, static: 0.3, threshold: 0.1}}]
                """);
        assertEquals(0, run.at(3));
        assertEquals((2 - 0.1) / (0.1 * G), run.at(0), 0.1 * 0.001);
    }

    /**
     * Coulomb friction stops at v0/(mu g) after v0&sup2;/(2 mu g); the last step overshoots by less than mu g h&sup2;.
     * Its power is -mu m g v all the way.
     */
    @Test
    void coulombFrictionStops() {
        double end = 2 / (0.3 * G);
        ShortRun run = new ShortRun("rk4 clamp 0.001 1", """
                particles: [{id: p, position: [0, 0, 0], velocity: [1.2, 0, 1.6]}]
                rules: [ground: {friction: {law: coulomb, coefficient: 0.3, static: 0.4, threshold: 0}}]
                """);
        run.getSimulation().addObserver(onMove(motion -> {
            double[] s = motion.getEndState();
            double[] force = new double[6];
            motion.getSystem().addUpEffects(s, motion.getEndTime(), force);
            assertEquals(motion.getEndTime() < end ? -0.3 * G * Math.hypot(s[3], s[5]) : 0,
                    run.contacts().getPower(s, motion.getEndTime(), force), 1e-12);
        }));
        run.run();
        assertEquals(0, Math.hypot(run.at(3), run.at(5)));
        assertEquals(4 / (2 * 0.3 * G), Math.hypot(run.at(0), run.at(2)), 0.3 * G * 1e-6);
        assertEquals(1000, run.getSimulation().getSteps());
    }

    /** Pushed up a slope too steep to hold it, a particle reverses and slides down. */
    @Test
    void aParticleSlidesUpASteepSlopeAndDownAgain() {
        ShortRun run = run(0.001, 1, """
                particles: [{id: p, position: [0, 0, 0], velocity: [1, 1, 0]}]
                rules: [plane: {normal: [-1, 1, 0], restitution: 0, friction: {law: coulomb, coefficient: 0.2}}]
                """);
        double turn = 2 / (G * 1.2);
        assertEquals(-G * 0.4 * (1 - turn), run.at(3), 5e-3, "apart from the step of the reversal");
    }

    @ParameterizedTest
    @ValueSource(strings = {"", ", friction: {law: coulomb, coefficient: 0.3, static: 0.4, threshold: 0}"})
    void aParticleInAGrooveStaysAtRest(String friction) {
        double a = Math.toRadians(30);
        double b = Math.toRadians(40);
        ShortRun run = run(0.01, 60, """
                particles: [{id: p, position: [0, 0, 0]}]
                rules:
                  - plane: {normal: [-%s, %s, 0], restitution: 0, restSpeed: 1e-3%s}
                  - plane: {normal: [%s, %s, 0], restitution: 0, restSpeed: 1e-3%3$s}
                """.formatted(Math.sin(a), Math.cos(a), friction, Math.sin(b), Math.cos(b)));
        for (int k = 0; k < 6; k++) {
            assertEquals(0, run.at(k), 1e-12);
        }
    }

    /** Pulled up by more than its weight, a particle leaves the ground. */
    @Test
    void contactDoesNotPull() {
        String text = """
                particles: [{id: p, position: [0, 0, 0]}]
                effects: [gravity: {acceleration: [0, 2, 0]}]
                rules: [ground: {}]
                """;
        assertEquals(Mode.SLIDING, run(0.01, 0, text).mode());
        ShortRun pulled = run(0.01, 1, text);
        assertEquals(1, pulled.at(1), 1e-12);
        assertEquals(Mode.FREE, pulled.mode());
    }

    /**
     * A step of 0.01 s at which a solver fails may be divided in contact, into 64 parts; with exact impacts, where
     * friction may stop the particle, much further.
     */
    @ParameterizedTest
    @CsvSource({"clamp, 1, 10, 0.01, false", "clamp, 0, 10, 1.6e-4, true", "clamp, 0, 10, 1.5e-4, false",
            "exact, 1, 10, 0.01, false", "exact, 0, 10, 0.01, true", "exact, 0, 10, 1.5e-4, false",
            "exact, 0, 0.001, 0.01, true", "exact, 0, 1e-9, 1e-9, true"})
    void aFailedStepMayBeDividedInContact(String impact, double height, double speed, double length, boolean may) {
        ShortRun run = ShortRun.of("rk4 " + impact + " 0.01 0", """
                particles: [{id: p, position: [0, %s, 0], velocity: [%s, 0, 0]}]
                rules: [ground: {friction: {law: coulomb, coefficient: 0.3, threshold: 0}}]
                """.formatted(height, speed));
        assertEquals(may, run.getSimulation().getRules().stream().filter(EventRule.class::isInstance)
                .anyMatch(rule -> ((EventRule) rule).mayDivide(length, 0.01)));
    }
}
