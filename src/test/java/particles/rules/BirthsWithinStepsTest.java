package particles.rules;

import static org.junit.jupiter.api.Assertions.assertEquals;

import deSolvers.catalog.SolverCatalog;
import deSolvers.catalog.SolverInfo;
import java.util.Arrays;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import particles.scene.ShortRun;

/** Particles that are born within a step: the rest of the step moves them like all others. */
class BirthsWithinStepsTest {
    private static final double G = ShortRun.G;

    private static ShortRun jet(String steps, String effects, String... rules) {
        return ShortRun.of(steps, """
                particles: [{id: source, position: [0, 0, 0], fixed: true}]
                effects: [%s]
                rules:
                """.formatted(effects) + String.join("\n", rules));
    }

    private static String emitter(double rate) {
        return "  - emitter: {id: e, position: [0, 0, 0], speed: 10, rate: " + rate + "}";
    }

    /** v = v0 exp(-t), x = v0 (1 - exp(-t)) with drag of 1 N s/m. RK4 errs by 3e-8 in a step of 0.1 s. */
    @Test
    void dragActsFromTheBirthOn() {
        ShortRun run = jet("rk4 clamp 0.1 2", "drag: {coefficient: 1}", emitter(0.93));
        double age = 2 - 1 / 0.93;
        assertEquals(10 * (1 - Math.exp(-age)), run.at(7), 1e-5);
        assertEquals(10 * Math.exp(-age), run.at(10), 1e-5);
    }

    /** Born at rest inside a soft ball on it: both swing about the place of balance, x = d cos(w t)/2. */
    @Test
    void aPairForceActsOnBothFromTheBirthOn() {
        ShortRun run = ShortRun.of("rk4 clamp 0.05 1", """
                particles: [{id: a, position: [0.1, 0, 0]}]
                effects: [repulsion: {radius: 0.1, stiffness: 8}]
                rules:
                  - emitter: {id: e, position: [0, 0, 0], speed: 0, rate: 1.3}
                """);
        double t = 1 - 1 / 1.3;
        double distance = 0.2 - 0.1 * Math.cos(4 * t);          // omega^2 = 2 k/m = 16; they do not part before 0.39 s
        assertEquals(distance, run.at(0) - run.at(6), 2e-6);      // measured 7.5e-7
        assertEquals(0.1, run.at(0) + run.at(6), 1e-14, "the momentum is 0");
    }

    /** A drop born 0.1 m above the ground at 10 m/s downwards strikes within the step of its birth and comes back. */
    @Test
    void anImpactInTheStepOfTheBirthIsExact() {
        ShortRun run = jet("rk4 exact 0.1 1.05", "", """
                  - emitter: {id: e, position: [0, 0.1, 0], direction: [0, -1, 0], speed: 10, rate: 0.99}
                  - ground: {height: 0, restitution: 0.5}
                """);
        double struck = 1 / 0.99 + 0.01;
        assertEquals(5 * (1.05 - struck), run.at(7), 1e-12);
    }

    /** Two nozzles with births at the same times, and a third with births between them. */
    @Test
    void severalNozzlesShareASteps() {
        ShortRun run = jet("rk4 clamp 0.1 1", "gravity", emitter(30), emitter(30).replace("id: e", "id: f"),
                emitter(70).replace("id: e", "id: g"));
        assertEquals(131, run.getSystem().getParticles().count());
        for (int i = 1; i <= 130; i++) {
            double age = 1 - run.getSystem().getParticles().birthTime(i);
            assertEquals(10 * age - G * age * age / 2, run.at(6 * i + 1), 1e-12);
        }
    }

    /** A linear spring pendulum beside the nozzle is divided by the births too, and keeps its order. */
    @Test
    void birthsDoNotDisturbOthers() {
        ShortRun run = ShortRun.of("dormand-prince clamp 0.1 3", """
                particles:
                  - {id: hook, position: [0, 0, 0], fixed: true}
                  - {id: bob, position: [1.5, 0, 0]}
                springs: [{from: hook, to: bob, stiffness: 9, restLength: 1}]
                effects: []
                rules:
                """ + emitter(17));
        assertEquals(1 + Math.cos(9) / 2, run.at(6), 1e-5);
    }

    /**
     * From any place, in any direction, at any speed and rate. Some births are at a step's end, others early or late in
     * it; a step of 1.5 s has 49 of them. Solvers of order 1 are off by up to g deltaT times the age.
     */
    @ParameterizedTest
    @CsvSource(textBlock = """
            0.1,   0.99,  10,  0,  1,  0
            0.01,  33,    10,  0,  1,  0
            0.01,  100,   10,  0,  1,  0
            0.3,   7,     10,  0,  1,  0
            1.5,   33,    10,  0,  1,  0
            0.7,   0.99,  10,  0,  1,  0
            0.05,  7.3,   0,   0,  1,  0
            0.2,   11,    100, 1,  0,  0
            0.003, 250,   3,   0,  0,  1
            0.7,   1.9,   5,   1,  1,  1
            1.5,   3.1,   20,  -1, 2,  0
            2,     40,    1,   0,  -1, 0
            0.04,  25,    7,   1,  0,  -1
            0.125, 8,     2,   3,  4,  0
            0.09,  13.7,  0.1, 0,  1,  1
            """)
    void everySolverMovesDropsFromTheirBirthOn(double deltaT, double rate, double speed, double x, double y, double z) {
        double[] place = {3, -2, 1};
        double[] way = {x, y, z};
        double length = Math.sqrt(x * x + y * y + z * z);
        for (SolverInfo solver : SolverCatalog.all()) {
            ShortRun run = jet(solver.name() + " exact " + deltaT + " 1.5", "gravity", emitter(rate)
                    .replace("[0, 0, 0]", Arrays.toString(place))
                    .replace("speed: 10", "speed: " + speed + ", direction: " + Arrays.toString(way)));
            assertEquals(1 + (int) (1.5 * rate + 1e-6), run.getSystem().getParticles().count());
            for (int i = 1; i < run.getSystem().getParticles().count(); i++) {
                double age = 1.5 - i / rate;
                double late = solver.order() == 1 ? G * Math.min(deltaT, age) * age : 0;
                for (int c = 0; c < 3; c++) {
                    double v = speed * way[c] / length;
                    double g = c == 1 ? G : 0;
                    assertEquals(v - g * age, run.at(6 * i + 3 + c), 1e-9, solver.name());
                    assertEquals(place[c] + v * age - g * age * age / 2, run.at(6 * i + c),
                            1e-9 + (c == 1 ? late : 0), solver.name());
                }
            }
        }
    }
}
