package particles.effects;

import static deSolvers.problems.Bounds.assertBetween;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static particles.scene.ShortRun.G;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import particles.scene.ShortRun;

/** Particle systems against closed forms: drag, wind, springs, orbits, penalties and cohesion. */
class ClosedFormsTest {

    private static ShortRun run(String steps, String position, String velocity, String effects) {
        return ShortRun.of(steps, "particles: [{id: p, position: [%s], velocity: [%s]}]\neffects: [%s]"
                .formatted(position, velocity, effects));
    }

    /** A particle at rest at the origin. */
    private static ShortRun atRest(String steps, String effects) {
        return run(steps, "0, 0, 0", "0, 0, 0", effects);
    }

    /**
     * m = 1, k = 100, c = 2, x0 = 1: x(1) = -0.336851680590413. Measured with rk4 at 0.001: 2.5e-10 (h^4 (h omega)...);
     * Euler at the same step is visibly off.
     */
    @ParameterizedTest
    @CsvSource({"rk4, 0, 1e-9", "euler, 0.022, 0.02"})
    void aDampedSpringMeetsItsClosedForm(String solver, double off, double tolerance) {
        double x = ShortRun.of(solver + " clamp 0.001 1", """
                particles: [{id: bob, position: [6, 0, 0]}, {id: anchor, position: [0, 0, 0], fixed: true}]
                springs: [{from: anchor, to: bob, stiffness: 100, restLength: 5, damping: 2}]
                effects: []
                """).at(0);
        assertEquals(off, Math.abs(x - 5 + 0.336851680590413), tolerance);
    }

    /** m = 1, c = 0.5, g = 9.81 from rest: v(1) and the fall in 1 s as tabulated. Measured: 6e-11, and 6e-10 J. */
    @Test
    void fallWithLinearDragMeetsTheReferenceValues() {
        ShortRun run = atRest("rk4 clamp 0.01 1", "gravity, drag: {coefficient: 0.5}");
        assertEquals(-7.719868456438, run.at(4), 3e-10);
        assertEquals(-4.180263087124, run.at(1), 3e-10);
        assertEquals(-(G * 4.180263087124 - 7.719868456438 * 7.719868456438 / 2), run.work("drag (dissipated)"), 1e-9);
        assertEquals(0, run.getNumericalError(), 3e-10);
        assertEquals(-19.62, atRest("rk4 clamp 0.01 61", "gravity, drag: {coefficient: 0.5}").at(4), 1e-10,
                "terminal speed m g / c");
    }

    /**
     * v = v_t tanh(g t/v_t), fall = v_t&sup2;/g ln cosh(g t/v_t), v_t = sqrt(m g/c). Measured with rk4 at 0.01: 7e-9.
     */
    @Test
    void fallWithQuadraticDragMeetsTheClosedForm() {
        double terminal = Math.sqrt(G / 0.3);
        ShortRun run = atRest("rk4 clamp 0.01 1", "gravity, quadraticDrag: {coefficient: 0.3}");
        assertEquals(-terminal * Math.tanh(G / terminal), run.at(4), 2e-8);
        assertEquals(-terminal * terminal / G * Math.log(Math.cosh(G / terminal)), run.at(1), 2e-8);
        run = atRest("rk4 clamp 0.01 21", "gravity, quadraticDrag: {coefficient: 0.3}");
        assertEquals(-terminal, run.at(4), 1e-12, "terminal speed");
    }

    /**
     * v' = -c (v - a sin(w t)) from rest has v = c a / (c&sup2; + w&sup2;) (c sin w t - w cos w t + w e^-ct): rk4 is
     * this close only if the wind is evaluated at each stage's time. Measured: 7e-12.
     */
    @Test
    void windIsEvaluatedAtTheTimeOfEachStage() {
        double c = 0.8;
        double w = 2 * Math.PI / 1.5;
        ShortRun run = atRest("rk4 clamp 0.002 2",
                "drag: {coefficient: 0.8}, wind: {mean: [0, 0, 0], gust: [3, 0, 0], period: 1.5}");
        double exact = c * 3 / (c * c + w * w) * (c * Math.sin(2 * w) - w * Math.cos(2 * w) + w * Math.exp(-2 * c));
        assertEquals(exact, run.at(3), 5e-11);
    }

    /** A particle ends up moving with a steady wind: v - u = 1/(c t + 1/w0). Measured: 6e-10. */
    @Test
    void windCarriesParticlesByQuadraticDrag() {
        ShortRun run = atRest("rk4 clamp 0.01 2", "quadraticDrag: {coefficient: 0.5}, wind: {mean: [3, 4, 0]}");
        double left = 1 / (0.5 * 2 + 1.0 / 5);
        assertEquals(3 - 0.6 * left, run.at(3), 1e-9);
        assertEquals(4 - 0.8 * left, run.at(4), 1e-9);
    }

    /**
     * Kepler: from perihelion a (1 - e), after half a period pi sqrt(a&sup3;/mu) at aphelion -a (1 + e), after a whole
     * one back. Measured with yoshida4 at T/2000: 5e-8 m, 1.4e-9 J.
     */
    @Test
    void orbitsAreKeplerEllipses() {
        double mu = 2;
        double a = 1.5;
        double e = 0.5;
        double period = 2 * Math.PI * Math.sqrt(a * a * a / mu);
        for (int halves = 1; halves <= 2; halves++) {
            ShortRun run = run("yoshida4 clamp " + period / 2000 + " " + halves * period / 2, a * (1 - e) + ", 0, 0",
                    "0, " + Math.sqrt(mu / a * (1 + e) / (1 - e)) + ", 0", "attraction: {strength: 2}");
            assertEquals(halves == 1 ? -a * (1 + e) : a * (1 - e), run.at(0), 2e-7);
            assertEquals(0, run.at(1), 2e-7);
            assertEquals(-mu / (2 * a), run.getLedger().getStartEnergy(), 1e-15);
            assertEquals(-mu / (2 * a), run.getLedger().getEnergy(), 1e-8);
        }
    }

    /** With softening, a small oscillation through the centre has omega&sup2; = mu/s&sup3;. Measured: 7e-16. */
    @Test
    void softeningLetsParticlesPassThroughTheCentre() {
        double period = 2 * Math.PI / Math.sqrt(2 / (0.5 * 0.5 * 0.5));
        ShortRun run = run("rk4 clamp " + period / 500 + " " + period / 2, "1e-4, 0, 0", "0, 0, 0",
                "attraction: {strength: 2, softening: 0.5}");
        assertEquals(-1e-4, run.at(0), 5e-15);
    }

    /**
     * Without loss a particle is inside for pi sqrt(m/k) and leaves as fast as it came: on a plane, a ball and in a
     * hollow. Measured: 6e-12.
     */
    @ParameterizedTest
    @CsvSource({"'penaltyPlane: {normal: [1, 0, 0], STIFF}', 0, -2",
        "'penaltySphere: {centre: [-1, 1, 1], radius: 1, hollow: false, STIFF}', 0, -2",
        "'penaltySphere: {centre: [4, 1, 1], radius: 1, hollow: true, STIFF}', 5, 2"})
    void aPenaltyWithoutLossReturnsAllEnergy(String law, double x, double speed) {
        boolean plane = law.startsWith("penaltyPlane");
        double inside = Math.PI / Math.sqrt(1e4);
        ShortRun run = run("rk4 clamp " + inside / 300 + " " + inside, x + ", 1, 1",
                speed + (plane ? ", 3, 0" : ", 0, 0"), law.replace("STIFF", "stiffness: 1e4"));
        assertEquals(x, run.at(0), 5e-11);
        assertEquals(-speed, run.at(3), 5e-11);
        assertEquals(plane ? 3 : 0, run.at(4));
    }

    /**
     * With loss b, from m v dv/(1 - b v) = k d dd: it comes in with v0 and leaves with w where
     * b (v0 + w) = ln((1 + b v0)/(1 - b w)). Measured: 1e-7 of v0 (the end of contact lies within a step).
     */
    @Test
    void bounceLossGivesTheRestitutionOfItsClosedForm() {
        double b = 0.4;
        double v0 = 2;
        double w = run("rk4 clamp 2e-5 0.1", "0, 0, 0", "0, -2, 0", "penaltyPlane: {stiffness: 1e4, loss: 0.4}").at(4);
        assertBetween(0.8, 1.9, w);
        assertEquals(Math.log((1 + b * v0) / (1 - b * w)), b * (v0 + w), 1e-6);
    }

    /**
     * Two particles oscillate about the distance of balance with omega&sup2; = 2 e (dX/dr)&sup2;/(m/2). Measured: 4e-6
     * of the amplitude.
     */
    @Test
    void aCohesivePairOscillatesAboutItsDistanceOfBalance() {
        double d = 0.6;
        double slope = 8 * d / (1 - d * d);
        double omega = Math.sqrt(2 * 0.5 * slope * slope / 0.5);
        ShortRun run = ShortRun.of("rk4 clamp " + 0.001 / omega + " " + Math.PI / omega, """
                particles: [{id: a, position: [0, 0, 0]}, {id: b, position: [0.600001, 0, 0]}]
                effects: [cohesion: {range: 1, balance: 0.6, depth: 0.5}]
                """);
        assertEquals(-0.5, run.getLedger().getStartEnergy(), 1e-10);
        assertEquals(d - 1e-6, run.at(6) - run.at(0), 2e-11);
    }
}
