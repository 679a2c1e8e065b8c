package particles.effects;

import static org.junit.jupiter.api.Assertions.assertEquals;

import deSolvers.catalog.SolverCatalog;
import deSolvers.catalog.SolverInfo;
import java.util.List;
import java.util.Locale;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import particles.scene.ShortRun;

/** What comes and goes within a step of an adaptive solver, ten inputs of each kind, against closed forms. */
class FastPassagesTest {
    private static final List<String> ADAPTIVE = SolverCatalog.all().stream().filter(SolverInfo::adaptive)
            .map(SolverInfo::name).toList();

    private static ShortRun run(String solver, double deltaT, double duration, String text, Object... values) {
        return ShortRun.of(String.format(Locale.ROOT, "%s exact %s %s", solver, deltaT, duration),
                String.format(Locale.ROOT, text, values));
    }

    /**
     * Straight at the centre: inside, the depth is v/w sin(w t) with w = sqrt(k), so the ball is back after pi/w. One
     * that is faster than w r passes in 2 asin(w r/v)/w. Measured: 1.2e-4 of the way after it, with dormand-prince.
     */
    @ParameterizedTest
    @CsvSource(textBlock = """
            -1,    10,   0.08,  20000
            -1.37, 10,   0.01,  2e6
            -2,    30,   0.1,   1e5
            -0.5,  3,    0.02,  3e4
            -0.7,  100,  0.05,  1e7
            -3,    7,    0.001, 1e8
            -1,    10,   0.08,  10000
            -1.01, 20,   0.03,  1e5
            -5,    300,  0.2,   1e6
            -0.2,  0.5,  0.005, 11000
            -1,    50,   0.01,  1e6
            """)
    void aPostOnTheWay(double start, double speed, double radius, double stiffness) {
        double w = Math.sqrt(stiffness);
        boolean returns = speed < w * radius;
        double inside = returns ? Math.PI / w : 2 * Math.asin(w * radius / speed) / w;
        double after = 0.5;
        double duration = (-start - radius) / speed + inside + after;
        double end = (returns ? -1 : 1) * (radius + speed * after);
        for (String solver : ADAPTIVE) {
            ShortRun run = run(solver, 0.04, duration, """
                    particles: [{id: b, position: [%s, 1e-12, 0], velocity: [%s, 0, 0]}]
                    effects: [penaltySphere: {centre: [0, 0, 0], radius: %s, stiffness: %s}]
                    """, start, speed, radius, stiffness);
            assertEquals(0, (run.at(0) - end) / (speed * after), 3e-4, solver);
        }
    }

    /** The relative motion is that of the reduced mass: after half a period it is reversed. Measured: 1e-4. */
    @ParameterizedTest
    @CsvSource(textBlock = """
            1,    1,   20,  -20, 0.05,  linear
            1,    1,   20,  0,   0.05,  linear
            3,    1,   10,  -30, 0.01,  linear
            1,    100, 50,  0,   0.02,  linear
            1e-3, 1,   100, -1,  0.005, linear
            1e3,  1,   30,  -30, 0.05,  linear
            1,    1,   5,   -5,  0.002, hertz
            2,    1,   20,  -20, 0.05,  hertz
            1,    1,   200, 100, 0.01,  linear
            1,    9,   0,   -40, 0.03,  hertz
            1e-6, 1e6, 0,   -40, 0.03,  linear
            """)
    void twoSoftBallsThatMeet(double m, double n, double v, double u, double radius, String law) {
        double reduced = m * n / (m + n);
        double speed = v - u;
        double stiffness = law.equals("linear") ? 4 * reduced * speed * speed / radius / radius
                : 4 * reduced * speed * speed / Math.pow(radius, 2.5);
        double exchanged = ((m - n) * v + 2 * n * u) / (m + n);
        for (String solver : ADAPTIVE) {
            for (int start = 0; start < 3; start++) {
                double gap = 1 + 0.13 * start;
                ShortRun run = run(solver, 0.04, (gap + 1) / speed, """
                        particles:
                          - {id: a, mass: %s, position: [0, 0, 0], velocity: [%s, 0, 0]}
                          - {id: b, mass: %s, position: [%s, 0, 0], velocity: [%s, 0, 0]}
                        effects: [repulsion: {radius: %s, stiffness: %s, law: %s}]
                        """, m, v, n, gap, u, radius, stiffness, law);
                assertEquals(0, (run.at(3) - exchanged) / speed, 2e-4, solver + " from " + gap);
            }
        }
    }

    /** The vector v x L - mu r/|r| of Laplace, Runge and Lenz points to the pericentre for ever. Measured: 6e-6. */
    @ParameterizedTest
    @CsvSource(textBlock = """
            1e-5, 1e-6, 10
            1e-3, 1e-5, 10
            1,    1e-2, 10
            1,    1e-3, 30
            10,   0.1,  5
            1e-4, 1e-4, 3
            5,    0.05, 20
            0.1,  1e-4, 10
            1e-2, 1e-5, 20
            100,  0.5,  10
            """)
    void aNearPassageOfAnAttractingPoint(double mu, double b, double v) {
        for (String solver : ADAPTIVE) {
            ShortRun run = run(solver, 0.04, 3 / v, """
                    particles: [{id: a, position: [-1, %s, 0], velocity: [%s, 0, 0]}]
                    effects: [attraction: {strength: %s}]
                    """, b, v, mu);
            double[] before = lenz(new double[] {-1, b, 0, v, 0}, mu);
            double[] after = lenz(run.getState(), mu);
            assertEquals(0, Math.hypot(after[0] - before[0], after[1] - before[1])
                    / Math.hypot(before[0], before[1]), 2e-5, solver);
        }
    }

    private static double[] lenz(double[] s, double mu) {
        double spin = s[0] * s[4] - s[1] * s[3];
        double r = Math.hypot(s[0], s[1]);
        return new double[] {s[4] * spin - mu * s[0] / r, -s[3] * spin - mu * s[1] / r};
    }

    /** x'' = k (A sin(w t) - x) from rest: x = A k (sin(w t) - w/q sin(q t)) / (q^2 - w^2), q^2 = k; 3.3e-5 off. */
    @ParameterizedTest
    @CsvSource(textBlock = """
            0.05, 0.01,   40,  0.04, 0.28
            0.05, 0.02,   40,  0.04, 0.36
            0.1,  0.04,   100, 0.04, 0.4
            0.01, 0.003,  10,  0.03, 0.3
            0.5,  0.0777, 1,   0.3,  3
            0.05, 0.05,   400, 0.1,  1
            0.02, 0.013,  90,  0.13, 1.3
            0.05, 0.008,  4,   0.04, 0.4
            0.2,  0.1,    25,  0.2,  2
            0.05, 0.1,    9,   0.5,  2
            """)
    void anAnchorThatIsShakenFast(double amplitude, double period, double k, double deltaT, double duration) {
        double w = 2 * Math.PI / period;
        double q = Math.sqrt(k);
        double x = amplitude * k * (Math.sin(w * duration) - w / q * Math.sin(q * duration)) / (k - w * w);
        for (String solver : ADAPTIVE) {
            ShortRun run = run(solver, deltaT, duration, """
                    particles: [{id: hook, position: [0, 0, 0], fixed: true}, {id: b, position: [0, -1, 0]}]
                    springs: [{from: hook, to: b, stiffness: %s}]
                    effects: []
                    rules: [shake: {particle: hook, amplitude: [0, %s, 0], period: %s}]
                    """, k, amplitude, period);
            assertEquals(x, run.at(7) + 1, 4e-5 * amplitude * k / (w * q), solver);
        }
    }

    /** v' = c (g sin(w t) - v) from rest: v = c g (c sin(w t) - w cos(w t) + w exp(-c t)) / (c^2 + w^2); 1.5e-4 off. */
    @ParameterizedTest
    @CsvSource(textBlock = """
            100, 0.01,   1,    1
            100, 0.02,   1,    1
            10,  0.04,   0.1,  2
            3,   0.003,  5,    0.5
            50,  0.0777, 0.3,  1.5
            1,   0.1,    2,    3
            7,   0.05,   0.01, 1
            200, 0.013,  10,   0.4
            5,   0.2,    1,    2
            20,  0.007,  0.5,  1
            """)
    void fastGusts(double gust, double period, double c, double duration) {
        double w = 2 * Math.PI / period;
        double v = c * gust * (c * Math.sin(w * duration) - w * Math.cos(w * duration) + w * Math.exp(-c * duration))
                / (c * c + w * w);
        for (String solver : ADAPTIVE) {
            ShortRun run = run(solver, 0.04, duration, """
                    particles: [{id: b, position: [0, 0, 0]}]
                    effects: [wind: {mean: [0, 0, 0], gust: [%s, 0, 0], period: %s}, drag: {coefficient: %s}]
                    """, gust, period, c);
            assertEquals(v, run.at(3), 1.6e-4 * c * gust / w, solver);
        }
    }
}
