package particles.rules;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static particles.scene.ShortRun.G;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import particles.reactions.ContactModes.Mode;
import particles.scene.ShortRun;

/** Balls and hollows as obstacles: impacts, rest, sliding along and off, and no tunnelling. */
class SphereImpactsTest {

    /** Runs a particle with a unit sphere at the origin. */
    private static ShortRun run(String steps, String particle, String sphere, String... more) {
        return ShortRun.of(steps, """
                particles: [{id: p, %s}]
                rules:
                  - sphere: {centre: [0, 0, 0], radius: 1, restSpeed: 1e-6, %s}
                """.formatted(particle, sphere) + String.join("\n", more));
    }

    /** A horizontal shot of v at height 0.6 meets the ball at x = -0.8; with r = 1 it leaves with v - 2 (v . N) N. */
    @Test
    void aShotIsReflectedAboutTheNormal() {
        ShortRun run = run("rk4 exact 0.07 2", "position: [-3, 0.6, 0], velocity: [2, 0, 0]", "restitution: 1",
                "effects: []");
        assertEquals(1.1, run.getTimes().get(0), 1e-14);
        assertEquals(2 - 2 * 1.6 * 0.8, run.at(3), 1e-13);
        assertEquals(2 * 1.6 * 0.6, run.at(4), 1e-13);
    }

    /** One step would carry it through the ball, or across the hollow. */
    @ParameterizedTest
    @CsvSource({"exact, -3, false, -1", "clamp, -3, false, -1", "clamp, 0, true, 1"})
    void fastParticlesDoNotTunnel(String impact, double from, boolean hollow, double at) {
        String particle = "position: [" + from + ", 0, 0], velocity: [1e5, 0, 0]";
        ShortRun run = run("rk4 " + impact + " 0.01 0.01", particle, "hollow: " + hollow, "effects: []");
        assertEquals(-5e4, run.at(3), 1e-9);
        assertEquals(impact.equals("clamp") ? at : at - 5e4 * (0.01 - 2e-5), run.at(0), 1e-7);
    }

    /** A thousand times across the hollow in a step, without loss. */
    @Test
    void aFastParticleStaysInTheHollow() {
        ShortRun run = run("rk4 exact 0.01 0.02", "position: [0.3, 0.2, -0.1], velocity: [1e5, 3e4, 2e4]",
                "restitution: 1, hollow: true", "effects: []");
        assertTrue(Math.hypot(Math.hypot(run.at(0), run.at(1)), run.at(2)) <= 1 + 1e-9);
        assertEquals(1e10 + 9e8 + 4e8, run.at(3) * run.at(3) + run.at(4) * run.at(4) + run.at(5) * run.at(5), 0.05);
    }

    /**
     * Pushed off the top, a particle slides down a ball and leaves it where cos = (2 + v0&sup2;/(g R))/3: its energy is
     * conserved, and contact ends where the ball would have to pull. Measured: 3e-10.
     */
    @Test
    void slidingOffABallLeavesAtItsAngle() {
        ShortRun run = run("rk4 exact 0.005 0.9", "position: [0, 1, 0], velocity: [0.5, 0, 0]", "restitution: 0");
        assertEquals((2 + 0.25 / G) / 3, run.getStates().get(0)[1], 3e-9);
        assertEquals(1, run.getStates().size());
        assertEquals(Mode.FREE, run.mode());
        assertEquals(0, run.getNumericalError(), 1e-7, "order 4 of the ledger's rule: measured 1.1e-8");
        assertEquals(0, run.work("contact"), 1e-7, "a smooth ball does no work");
    }

    /**
     * In a smooth bowl a particle swings like a pendulum: from 45 degrees the period is 1.03997 times 2 pi sqrt(R/g).
     * With clamp, the solver's drift is removed after each step.
     */
    @ParameterizedTest
    @ValueSource(strings = {"exact", "clamp"})
    void slidingInABowlIsAPendulum(String impact) {
        double quarter = Math.PI / 2 / Math.sqrt(G) * 1.039973343196804;
        ShortRun run = run("rk4 " + impact + " " + quarter / 100 + " " + quarter,
                "position: [0.70710678118654752, -0.70710678118654752, 0]", "restitution: 0, hollow: true");
        assertEquals(0, run.at(0), 1e-8);
        assertEquals(-1, run.at(1), 1e-12);
        assertEquals(Math.sqrt(2 * G * (1 - Math.sqrt(0.5))), -run.at(3), 1e-8);
    }

    /**
     * On a rough ball a particle stays if the tangent of the slope is less than mu, and slides with g (sin a - mu cos
     * a) if it is more. Measured: 1 % more, since the slope grows.
     */
    @ParameterizedTest
    @CsvSource({"0.25, 0, 1e-15", "0.35, 1, 1e-4"})
    void frictionHoldsOnTheTopOfABall(double angle, double slides, double tolerance) {
        ShortRun run = run("rk4 exact 0.01 0.1", "position: [" + Math.sin(angle) + ", " + Math.cos(angle) + ", 0]",
                "restitution: 0, friction: {law: coulomb, coefficient: 0.3, threshold: 0}");
        double acceleration = slides * G * (Math.sin(angle) - 0.3 * Math.cos(angle));
        assertEquals(acceleration * 0.1 * 0.1 / 2 * Math.cos(angle), run.at(0) - Math.sin(angle), tolerance);
    }

    /** A particle rests in the wedge between a ball and a wall, outside both. */
    @Test
    void aParticleRestsInAWedgeOfBallAndWall() {
        ShortRun run = run("rk4 exact 0.01 5", "position: [0.9, 0.9, 0]", "restitution: 0.3",
                "  - plane: {point: [0.95, 0, 0], normal: [-1, 0, 0], restitution: 0.3, restSpeed: 1e-6}");
        assertEquals(0.95, run.at(0), 1e-9);
        assertEquals(Math.sqrt(1 - 0.95 * 0.95), run.at(1), 1e-9);
        assertEquals(0, Math.abs(run.at(3)) + Math.abs(run.at(4)), 1e-9);
    }
}
