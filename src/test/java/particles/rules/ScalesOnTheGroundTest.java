package particles.rules;

import static deSolvers.problems.Bounds.assertBelow;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static particles.scene.ShortRun.G;

import deSolvers.catalog.SolverCatalog;
import java.util.List;
import java.util.Locale;
import java.util.Random;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.MethodSource;
import particles.reactions.ContactModes.Mode;
import particles.reactions.RestingContacts;
import particles.scene.ShortRun;
import particles.spec.messages.InvalidInputException;

/** Friction with scales: closed forms with every solver, and laws on random motions. */
class ScalesOnTheGroundTest {
    private static final double MU = 0.6;
    private static final double FORWARD = 0.5;
    private static final double BACKWARD = 1.5;
    private static final double ACROSS = 3;

    /** Two particles, not connected, which move alike, so that the axis keeps its direction. */
    private static final String PAIR = """
            shapes:
              - rope: {id: r, start: [0, 0, 0], end: %s, particles: 2, mass: 2, velocity: %s,
                       scales: {forward: 0.5, backward: 1.5, across: 3}}
            rules:
              - plane: {normal: %s, restitution: 0, friction: {law: coulomb, coefficient: 0.6, threshold: 1e-4}}
            """;
    private static final String SLOPE = "[0.6, 0.8, 0]";
    private static final String LEVEL = "[0, 1, 0]";
    private static final String DOWNHILL = "[0.08, -0.06, 0]";
    private static final String UPHILL = "[-0.08, 0.06, 0]";

    static Stream<String> ways() {
        return SolverCatalog.names().stream().flatMap(name -> Stream.of(name + " clamp", name + " exact"));
    }

    private static ShortRun run(String way, double deltaT, double duration, String head, String velocity,
            String normal) {
        return ShortRun.of(way + " " + deltaT + " " + duration, PAIR.formatted(head, velocity, normal));
    }

    /** The way downhill (m) or its speed (m/s). */
    private static double downhill(ShortRun run, int from) {
        return 0.8 * run.at(from) - 0.6 * run.at(from + 1);
    }

    private static boolean isOfOrderOne(String way) {
        return SolverCatalog.info(way.split(" ")[0]).order() == 1;
    }

    /** The slope is 0.75: more than 0.5 mu, less than 1.5 mu. */
    @ParameterizedTest
    @MethodSource("ways")
    void aSlopeHoldsScalesBackwardAndLetsThemSlideForward(String way) {
        ShortRun held = run(way, 0.01, 1, UPHILL, "[0, 0, 0]", SLOPE);
        assertEquals(0, downhill(held, 0));
        ShortRun slid = run(way, 0.01, 1, DOWNHILL, "[0, 0, 0]", SLOPE);
        double a = G * (0.6 - FORWARD * MU * 0.8);
        assertEquals(a, downhill(slid, 3), 1e-9 * a);
        assertEquals(a / 2, downhill(slid, 0), 0.01 * a);
    }

    /** Thrown uphill, head first, with 2 m/s: it stops after v/a = 0.243 s and 0.243 m, and does not slide back. */
    @ParameterizedTest
    @MethodSource("ways")
    void whatSlidesUphillForwardStopsAndStays(String way) {
        double a = G * (0.6 + FORWARD * MU * 0.8);
        double deltaT = 0.002;
        ShortRun run = run(way, deltaT, 0.4, UPHILL, "[-1.6, 1.2, 0]", SLOPE);
        assertEquals(0, downhill(run, 3), 0, "it stops exactly");
        assertTrue(run.isHeld(0));
        assertEquals(-4 / (2 * a), downhill(run, 0), isOfOrderOne(way) ? 1.1 * deltaT : 1e-4);   // v h/2 by Euler
        double stop = run.getTimes().get(run.getTimes().size() - 1);
        assertTrue(way.endsWith("clamp") || Math.abs(stop - 2 / a) < 2e-5, "stopped at " + stop);
        assertEquals(0, run.getNumericalError(), isOfOrderOne(way) ? 0.1 : 1e-3, "J, of 8 J");
    }

    /** Sideways the whole factor acts: v&sup2; / (2 mu g) with 3 mu; what pulls less than that moves nothing. */
    @ParameterizedTest
    @MethodSource("ways")
    void acrossTheBodyFrictionIsThatOfTheThirdFactor(String way) {
        ShortRun run = run(way, 0.002, 0.3, "[0.1, 0, 0]", "[0, 0, 2]", LEVEL);
        assertEquals(4 / (2 * ACROSS * MU * G), run.at(2), isOfOrderOne(way) ? 0.0022 : 1e-4);
        assertEquals(0, run.at(5));
        assertEquals(0, run.at(0), 1e-15);
        assertEquals(0, run(way, 0.01, 0.2, "[0, 0, 0.1]", "[0, 0, 0]", SLOPE).at(0), 0, "0.75 is less than 3 mu");
    }

    /** The end of an oblique slide: v' = -mu g S&sup2; v / |S v|, with 200,000 Euler steps of our own. */
    private static double[] reference(double vx, double vz) {
        double[] s = {0, 0, vx, vz};
        double h = 5e-6;
        while (Math.hypot(s[2], s[3]) > 1e-4) {
            double along = s[2] < 0 ? BACKWARD : FORWARD;
            double scale = MU * G * h / Math.hypot(along * s[2], ACROSS * s[3]);
            s[2] -= scale * along * along * s[2];
            s[3] -= scale * ACROSS * ACROSS * s[3];
            s[0] += h * s[2];
            s[1] += h * s[3];
        }
        return s;
    }

    /**
     * All but one: a sub-step of yoshida4 goes back in time, where the sharp turn before the stop grows. With some
     * thresholds its run with exact impacts is refused, as contacts that make no headway.
     */
    static Stream<String> obliqueWays() {
        return ways().filter(way -> !way.equals("yoshida4 exact"));
    }

    @ParameterizedTest
    @MethodSource("obliqueWays")
    void anObliqueSlideEndsWhereTheEquationSays(String way) {
        for (int back = -1; back <= 1; back += 2) {
            double[] exact = reference(back * 1.5, 1);
            double deltaT = 0.002;
            ShortRun run = run(way, deltaT, 0.8, "[0.1, 0, 0]", "[" + 1.5 * back + ", 0, 1]", LEVEL);
            double error = Math.hypot(run.at(0) - exact[0], run.at(2) - exact[1]);
            assertBelow(isOfOrderOne(way) ? 1.5 * deltaT : 2e-4, error, way + " " + back);     // 1.16 deltaT by Euler
            assertEquals(0, Math.hypot(run.at(3), run.at(5)), 0, "it has stopped");
            // each stops at an event of its own, below 1e-4 m/s: which leaves v^2/(2 a) = 1.7e-9 m
            assertEquals(run.at(0) + 0.1, run.at(6), 5e-9, "both move alike");      // measured 3.4e-9
        }
    }

    /** Springs, a lattice and a bumpy landing: with equal factors all is as with another mu, up to round-off. */
    @Test
    void equalFactorsAreAnotherCoefficient() {
        String text = """
                shapes:
                  - cloth: {id: c, corner: [0, 0.1, 0], across: [1, 0.2, 0], down: [0, 0, 0.5], columns: 5, rows: 3,
                            mass: 0.1, velocity: [1, 0, 0.4], structural: {stiffness: 50, damping: 0.2}%s}
                rules:
                  - ground: {restitution: 0, friction: {law: coulomb, coefficient: %s}}
                """;
        ShortRun plain = ShortRun.of("rk4 clamp 0.002 0.6", text.formatted("", 0.3));
        ShortRun scaled = ShortRun.of("rk4 clamp 0.002 0.6", text.formatted(
                ", scales: {forward: 0.5, backward: 0.5, across: 0.5}", 0.6));
        for (int k = 0; k < plain.getState().length; k++) {
            assertEquals(plain.at(k), scaled.at(k), 1e-10);
        }
    }

    /** At an impact without bounce at 2 m/s, friction takes 2 m/s times mu and the factor from the velocity along. */
    @ParameterizedTest
    @CsvSource({"1.4, 0.5", "-4, 1.5"})
    void anImpactRubsWithTheFactorOfItsDirection(double speed, double factor) {
        ShortRun run = ShortRun.of("rk4 exact 0.001 0.1", """
                shapes: [rope: {start: [0, 0.1, 0], end: [0.1, 0.1, 0], particles: 2, mass: 2, velocity: [%s, -2, 0],
                         scales: {forward: 0.5, backward: 1.5, across: 3}}]
                rules: [ground: {restitution: 0, friction: {law: coulomb, coefficient: 0.6}}]
                effects: []
                """.formatted(speed));
        assertEquals(speed - Math.signum(speed) * factor * 0.6 * 2, run.at(3), 1e-12);
    }

    /** A chain of rods, pulled along or across by 0.99 and 1.01 of what its five particles hold together. */
    @ParameterizedTest
    @CsvSource({"1, 0, 0.5", "-1, 0, 1.5", "0, 1, 3"})
    void aChainOfRodsHoldsTheSumOfItsFriction(double x, double z, double factor) {
        for (double part : new double[] {0.99, 1.01}) {
            double pull = part * factor * MU * 5 * G;
            String pushes = Stream.of(x, 0.0, z).map(c -> Double.toString(c * pull / 5))
                    .collect(Collectors.joining(", ", "[", "]"));
            ShortRun run = ShortRun.of("rk4 clamp 0.001 0.01", """
                    shapes: [rope: {id: r, start: [0, 0, 0], end: [0.4, 0, 0], particles: 5, mass: 1,
                             scales: {forward: 0.5, backward: 1.5, across: 3}}]
                    rods: [%s]
                    rules: [ground: {restitution: 0, friction: {law: coulomb, coefficient: 0.6}}]
                    effects: [gravity, push: {force: %s}]
                    """.formatted(IntStream.range(0, 4).mapToObj(i -> "{from: \"r[%d]\", to: \"r[%d]\"}"
                            .formatted(i, i + 1)).collect(Collectors.joining(", ")), pushes));
            assertEquals(part < 1, run.isHeld(2), x + " " + z + " " + part);
        }
    }

    /** Random bodies on a slope and a wall, free and on rods, from rest, sliding or stopping: P is at most 0. */
    @ParameterizedTest
    @CsvSource({"coulomb, false", "coulomb, true", "slide, false", "slide, true"})
    void frictionNeverGivesEnergy(String law, boolean rods) {
        Random random = new Random(7);
        double least = 0;
        for (int k = 0; k < 300; k++) {
            ShortRun run = new ShortRun("rk4 clamp 0.01 0", String.format(Locale.ROOT, """
                    shapes: [rope: {id: r, start: [0, 0, 0], end: [1, 0, 0.3], particles: 6, mass: 1,
                             structural: {stiffness: 10}, scales: {forward: %s, backward: %s, across: %s}}]
                    rods: [%s]
                    rules:
                      - ground: {friction: {law: %5$s, coefficient: 0.3}}
                      - plane: {normal: [0, 1, 1], friction: {law: %5$s, coefficient: 0.2}}
                    """, factor(random, rods), factor(random, rods), factor(random, rods),
                    rods ? "{from: \"r[2]\", to: \"r[3]\"}" : "", law));
            double[] state = run.getState();
            for (int i = 0; i < 6; i++) {
                for (int c = 0; c < 3; c++) {
                    state[6 * i + c] += 0.3 * random.nextGaussian();
                    state[6 * i + 3 + c] = k % 3 == 0 ? 0 : random.nextGaussian();
                }
            }
            RestingContacts contacts = run.contacts();
            for (int i = 0; i < 6; i++) {
                contacts.getContacts().getModes().set(0, i, i == 5 ? Mode.FREE : Mode.SLIDING);
                contacts.getContacts().getModes().set(1, i, i % 2 == 0 ? Mode.FREE : Mode.SLIDING);
                contacts.settle(i, false, state);
            }
            contacts.getContacts().beginStep();
            for (int i = 0; i < 6 && k % 2 == 0; i++) {
                contacts.getContacts().stopAfter(i, 0.01);
            }
            double power = contacts.getPower(state, 0, run.effects());
            assertTrue(power <= 1e-9, "case " + k + ": " + power + " W");
            least = Math.min(least, power);
        }
        assertTrue(least < -1, "it takes energy");
    }

    /** Up to about 100, but smaller where friction could jam rods. */
    private static double factor(Random random, boolean rods) {
        return StrictMath.exp((rods ? 0.4 : 2) * random.nextGaussian());
    }

    @Test
    void scalesNeedFriction() {
        String text = PAIR.formatted("[0.1, 0, 0]", "[0, 0, 0]", LEVEL);
        String without = text.replaceAll(", friction: .*", "}");
        assertFalse(without.contains("coulomb"));
        String message = assertThrows(InvalidInputException.class, () -> ShortRun.of("rk4 clamp 0.01 0.1", without))
                .getMessage();
        assertTrue(message.contains("'scales' change friction, and no rule has any"), message);
        for (String wrong : List.of("forward: 0", "forwards: 1")) {
            String message2 = assertThrows(InvalidInputException.class, () -> ShortRun.of("rk4 clamp 0.01 0.1",
                    text.replace("forward: 0.5", wrong))).getMessage();
            assertTrue(message2.contains("forward"), message2);
        }
    }
}
