package particles.rules;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static particles.Systems.afterStep;
import static particles.scene.ShortRun.G;

import java.util.Map;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import particles.reactions.ContactModes.Mode;
import particles.scene.ShortRun;

/** Ends of contact: a particle lifts off or breaks away at its time, once, without false impacts afterwards. */
class LettingGoTest {
    /** A force that grows as A sin(pi t), however fast the particle is. */
    private static final double A = 16.5;
    private static final String LIFTED = """
            particles: [{id: p, position: [0, HEIGHT, 0]}]
            effects:
              - gravity
              - drag: {coefficient: 1e-9}
              - wind: {mean: [0, 0, 0], gust: [0, 16.5e9, 0], period: 2}
            rules: [ground: {height: HEIGHT, restitution: 0.3, restSpeed: 1e-6}]
            """;

    /** Static friction gives way when the force of a gust exceeds mu_s N. */
    @Test
    void stickingEndsAtItsTime() {
        ShortRun run = ShortRun.of("rk4 exact 0.1 0.9", """
                particles: [{id: p, position: [0, 0, 0]}]
                effects: [gravity, drag: {coefficient: 1}, wind: {mean: [0, 0, 0], gust: [6, 0, 0], period: 4}]
                rules: [ground: {friction: {law: coulomb, coefficient: 0.3, static: 0.4, threshold: 0}}]
                """);
        assertEquals(Math.asin(0.4 * G / 6) * 2 / Math.PI, run.getTimes().get(0), 1e-12);
    }

    /**
     * A particle leaves the ground, slower than the rest speed, when a correction puts it a little below: it is put
     * onto the ground and goes on. If something presses it on, it rests.
     */
    @ParameterizedTest
    @CsvSource({"0, 1e-4", "1e-4, 0"})
    void aCorrectionDoesNotStopAParticleThatLeaves(double g, double speed) {
        ShortRun run = new ShortRun("rk4 exact 0.1 1", """
                particles: [{id: p, position: [0, 1e-4, 0], velocity: [0, 1e-4, 0]}]
                effects: [gravity: {acceleration: [0, -%s, 0]}]
                rules: [ground: {restitution: 0, restSpeed: 1e-3}]
                """.formatted(g));
        run.getSimulation().addRule(afterStep(corrected -> {
            boolean first = corrected.getTime() < 0.15;
            corrected.getOwnState()[1] = first ? -1e-6 : corrected.getOwnState()[1];
            return first;
        }));
        run.run();
        assertEquals(speed, run.at(4), 1e-18);
        assertEquals(0.9 * speed, run.at(1), 1e-18);
    }

    /**
     * The force lifts a weight where A sin(pi t) = g. It rises as s&sup3; at first, and the cubic between the ends of a
     * step dips below the ground; with midpoint it does not rise at all in the first step. There must be one event and
     * no impact. Measured: the time within 6e-17 s; the rise 0.029 m off by midpoint, 0.019 by verlet, 0.22 by euler
     * and 4.9e-7 by rk4.
     */
    @ParameterizedTest
    @ValueSource(doubles = {0, 0.7, -300.1})
    void aReleasedParticleDoesNotHitTheGroundAgain(double height) {
        double let = Math.asin(G / A) / Math.PI;
        double s = 1 - let;
        double rise = A / Math.PI * Math.cos(Math.PI * let) * s + A / Math.PI / Math.PI * Math.sin(Math.PI * let)
                - G * s * s / 2;
        Map<String, Double> bounds = Map.of("midpoint", 0.1, "verlet", 0.1, "euler", 0.5, "rk4", 4e-6);
        for (String solver : bounds.keySet()) {
            ShortRun run = ShortRun.of(solver + " exact 0.1 1", LIFTED.replace("HEIGHT", "" + height));
            assertEquals(1, run.getTimes().size(), "one release and no impact");
            assertEquals(let, run.getTimes().get(0), 5e-16, solver);
            assertEquals(Mode.FREE, run.mode());
            assertEquals(rise, run.at(1) - height, bounds.get(solver), solver);
        }
    }

    /**
     * The cubic's false dip does not hide a later impact of another particle in the same step, which falls under the
     * same force and hits the ground at 0.25 s. Measured: within 1.6e-5 s.
     */
    @Test
    void aFalseDipHidesNoOtherImpact() {
        double from = G / 32 - A / Math.PI * (0.25 - Math.sin(Math.PI / 4) / Math.PI);
        ShortRun run = ShortRun.of("rk4 exact 0.1 0.5", LIFTED.replace("HEIGHT", "0")
                .replace("}]\neff", "}, {id: q, position: [1, " + from + ", 0]}]\neff"));
        assertEquals(2, run.getTimes().size(), "one release, one impact: " + run.getTimes());
        assertEquals(0.25, run.getTimes().get(1), 3e-5);
    }
}
