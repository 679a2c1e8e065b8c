package particles.app.experiments;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.geom.Line2D;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.function.Function;
import java.util.regex.MatchResult;
import java.util.regex.Pattern;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import particles.output.charts.ChartFormat;
import particles.output.files.OutputFolder;
import particles.output.report.Picture;
import particles.output.report.ResultPage;
import particles.output.report.ResultPageWriter;

/**
 * Each chart of the experiments is laid out well, as page and as slide, and its headline is recomputed from the CSV
 * file beside it. A headline is a list of claims; one that is not known here, or that the numbers do not show, fails.
 */
class HeadlineTest {
    private static final String NAME = "[a-z][a-z0-9-]*";
    private static final String NAMES = "(" + NAME + "(?:(?:, | and )" + NAME + ")*|\\d+ solvers)";
    /** Names at the end of a claim end where the headline does, or another claim begins. */
    private static final String END = "(?=$|; |, (?:not|stays|is gone|up to|fades|at no) )";
    private static final String NUMBER = "(-?[0-9.]+(?:e-?[0-9]+)?)";

    @TempDir
    Path top;

    @ParameterizedTest
    @ValueSource(strings = {"lectureFigures", "phasePlots", "energyDrift --duration=2",
        "energyDrift --scene=3 --solvers=rk4,verlet,midpoint",
        "stiffGallery --decades=5 --solvers=euler,rk4,verlet,radau",
        "effectCost --columns=3 --rounds=1", "stability --scene=4",
        "workPrecision --problem=kepler --solvers=rk4,euler,dormand-prince"})
    void chartsCanBeReadAndHeadlinesSayWhatTheirNumbersShow(String task) throws IOException {
        int judged = 0;
        Path out = top.resolve("out");
        try (OutputFolder folder = OutputFolder.open(out)) {
            ResultPage measured = ChartLayoutTest.measured(task, folder);
            assertEquals("", String.join("\n", ChartLayoutTest.faults(measured)));
            for (boolean slide : List.of(false, true)) {
                ResultPage page = ResultPageWriter.write(folder, measured, new ChartFormat(slide, false));
                for (Picture picture : page.pictures()) {
                    if (Files.exists(out.resolve(picture.name() + ".csv"))) {
                        judge(picture.title(), Drawn.read(out.resolve(picture.name() + ".csv")));
                        judged++;
                    }
                }
            }
        }
        assertTrue(judged > 1, task);
    }

    @Tag("slow")
    @ParameterizedTest
    @ValueSource(strings = {"stiffGallery", "stability", "workPrecision", "stiffCloth", "race", "energyDrift"})
    void soDoThoseOfWholeExperiments(String task) throws IOException {
        chartsCanBeReadAndHeadlinesSayWhatTheirNumbersShow(task);
    }

    /** A headline that says more than its numbers is found: each of these is a true one with one thing changed. */
    @ParameterizedTest
    @CsvSource(delimiter = '|', value = {
        "A spring: rk4 is cheapest for 0.01 and 1e-6 | evaluations of the derivative",
        "A spring: verlet is cheapest for 0.01 and 1e-6 | evaluations of the derivative",
        "A spring: verlet and rk4 tie for 0.01 | evaluations of the derivative",
        "A spring: verlet is cheapest for 0.01, none has 1e-6 | evaluations of the derivative",
        "A spring: verlet is the best | evaluations of the derivative",
        "Evaluations for 1 % grow as k^0.4 (rk4) | evaluations for 1 %",
        "Evaluations for 1 % stay the same at any stiffness with rk4 | evaluations for 1 %",
        "A net: rk4 gains 15 % | energy error / scale",
        "A net: rk4 stays within 1e-3 % | energy error / scale",
        "A net: verlet and rk4 lose 96 % | energy error / scale"})
    void aFalseHeadlineFails(String title, String quantity) throws IOException {
        Path csv = top.resolve("made.csv");
        List<String> lines = new ArrayList<>(List.of("chart,series,x quantity,x,y quantity,y"));
        for (int k = 0; k <= 8; k++) {                  // verlet has 0.01 at 100, rk4 at 1000; 1e-6 at 1e6 and 1e5
            lines.add("t,rk4,x," + Math.pow(10, 1.0 + k) + "," + quantity + "," + Math.pow(10, 2.0 - 2 * k));
            lines.add("t,verlet,x," + Math.pow(10, 1.0 + k) + "," + quantity + "," + Math.pow(10, -1.0 - k));
        }
        Files.write(csv, lines);
        assertThrows(AssertionError.class, () -> judge(title, Drawn.read(csv)), title);
    }

    /** A claim: its words, and a check that fails if the numbers do not show it. */
    private record Claim(Pattern words, Check check) {
        interface Check {
            void of(MatchResult said, List<Drawn> drawn);
        }

        Claim(String words, Check check) {
            this(Pattern.compile("^" + words), check);
        }
    }

    private static void judge(String title, List<Drawn> drawn) {
        String rest = title.replace('\u00a0', ' ');
        for (boolean found = true; found && !rest.isEmpty();) {
            found = false;
            for (Claim claim : CLAIMS) {
                var matcher = claim.words().matcher(rest);
                if (!found && matcher.lookingAt()) {
                    claim.check().of(matcher.toMatchResult(), drawn);
                    rest = rest.substring(matcher.end()).replaceFirst("^(; |, | on$)", "");
                    found = true;
                }
            }
        }
        assertEquals("", rest, "no claim that can be checked, in '" + title + "'");
    }

    private static final List<Claim> CLAIMS = List.of(
            new Claim(NAMES + " (?:is cheapest for|is first to|tie for) " + NUMBER + "(?: and " + NUMBER + ")?",
                    (said, drawn) -> {
                        for (int group = 2; group <= 3 && said.group(group) != null; group++) {
                            first(said.group(1), Double.parseDouble(said.group(group)), drawn.get(0));
                        }
                    }),
            new Claim("none has (?:an error of )?" + NUMBER, (said, drawn) -> assertEquals(List.of(),
                    solvers(drawn.get(0)).filter(solver -> drawn.get(0).crossing(solver,
                            Double.parseDouble(said.group(1))) < Double.POSITIVE_INFINITY).toList(), said.group())),
            new Claim(NAMES + " has " + NUMBER + "(?: and " + NUMBER + "|, not " + NUMBER + ")", (said, drawn) -> {
                assertTrue(reaches(drawn.get(0), said.group(1), said.group(2)), said.group());
                assertTrue(said.group(3) == null || reaches(drawn.get(0), said.group(1), said.group(3)), said.group());
                assertTrue(said.group(4) == null || !reaches(drawn.get(0), said.group(1), said.group(4)), said.group());
            }),
            new Claim(NAMES + " falls from order (\\d) to " + NUMBER + " \\(theory: (\\d)\\)", (said, drawn) ->
                    assertTrue(drawn.get(0).series().containsKey(said.group(1) + ", " + said.group(3) + " ("
                            + said.group(4) + ")"), said.group())),
            new Claim("Evaluations for (?:1 %|stability) grow as (?=k)", (said, drawn) -> { }),
            new Claim("k\\^" + NUMBER + " \\(" + NAMES + "\\)", (said, drawn) -> exponents(said.group(2),
                    Double.parseDouble(said.group(1)), drawn.get(0))),
            new Claim("(?:Evaluations for (?:1 %|stability) stay the same at any stiffness|not) with " + NAMES + END,
                    (said, drawn) -> exponents(said.group(1), 0, drawn.get(0))),
            new Claim("The stiff vibration (?=\\w)", (said, drawn) -> { }),
            new Claim("(is gone|stays|fades|up to " + NUMBER + " times is borrowed) with " + NAMES + END,
                    (said, drawn) -> vibration(said.group(1), said.group(2), said.group(3), drawn.get(0))),
            new Claim(NAMES + " (gains?|loses?|stays? within) " + NUMBER + " (%|times the energy)", (said, drawn) ->
                    energy(said.group(2), said.group(1), part(said.group(3), said.group(4)), drawn.get(0))),
            new Claim(NAMES + " [+\u2212]" + NUMBER + " (%|times the energy)", (said, drawn) ->
                    energy("stays within", said.group(1), part(said.group(2), said.group(3)), drawn.get(0))),
            new Claim(NAMES + " (?:is|are) exact to round-off", (said, drawn) -> named(said.group(1)).forEach(solver ->
                    assertTrue(largest(drawn.get(0).of(solver)) < 1e-11, said.group()))),
            new Claim(NAMES + " (?:blows? up|stops?) at t = " + NUMBER + " s", (said, drawn) -> named(said.group(1))
                    .forEach(solver -> assertEquals(Double.parseDouble(said.group(2)),
                            last(drawn.get(0).of(solver))[0], 0.02 * Double.parseDouble(said.group(2)), said.group()))),
            new Claim("the other (\\d+) are off by at most " + NUMBER + " (%|times the energy)", (said, drawn) ->
                    assertEquals(part(said.group(2), said.group(3)), solvers(drawn.get(0))
                            .map(solver -> largest(drawn.get(0).of(solver))).sorted().skip(Integer.parseInt(
                            said.group(1)) - 1).findFirst().orElseThrow(), 0.06 * part(said.group(2), said.group(3)))),
            new Claim("(\\w.*?) makes? a step of springs more than 10 times as long", (said, drawn) ->
                    assertEquals(said.group(1).equals("Nothing") ? 0
                            : said.group(1).replaceAll(", (exact|hand-written)", "").split(", | and ").length,
                            bars(drawn.get(0)).filter(times -> times >= 10).count(), said.group())),
            new Claim("all else less than (\\d+) times", (said, drawn) -> assertTrue(bars(drawn.get(0))
                    .filter(times -> times < 10).allMatch(times -> times < Integer.parseInt(said.group(1))),
                    said.group())),
            new Claim("rk4 takes less than half the time up to (\\d+) steps", (said, drawn) ->
                    halves("rk4", "linearised-euler", said.group(1), drawn.get(0))),
            new Claim("linearised-euler (?:takes less than half the time )?from (\\d+)", (said, drawn) ->
                    halves("linearised-euler", "rk4", said.group(1), drawn.get(0))),
            new Claim("both take about as long", (said, drawn) -> drawn.get(0).of("rk4").forEach(p -> Stream.of(
                    List.of("rk4", "linearised-euler"), List.of("linearised-euler", "rk4")).forEach(two ->
                    assertThrows(AssertionError.class, () -> halves(two.get(0), two.get(1), "" + p[0],
                            drawn.get(0)))))),
            new Claim(NAMES + " exceeds? 10 %", (said, drawn) -> named(said.group(1)).forEach(solver -> assertTrue(
                    last(drawn.get(0).of(solver))[0] < drawn.get(0).series().values().stream().mapToDouble(points ->
                    last(points)[0]).max().orElseThrow() || largest(drawn.get(0).of(solver)) > 0.09, said.group()))),
            new Claim(NAMES + " leaves? the curve", (said, drawn) -> named(said.group(1)).forEach(solver ->
                    assertTrue(off(drawn.get(0), solver) > 0.05, said.group()))),
            new Claim(NAMES + " stays? on (?:it|the curve) to " + NUMBER + " %", (said, drawn) -> named(said.group(1))
                    .forEach(solver -> assertTrue(off(drawn.get(0), solver) <= 0.011 * Double.parseDouble(
                            said.group(2)) + 2e-3, said.group()))),
            new Claim(NAMES + ": " + NUMBER + " % off the curve", (said, drawn) -> assertTrue(off(drawn.get(0),
                    said.group(1)) > 0.05, said.group())),
            new Claim(NAMES + ": on the curve to " + NUMBER + " %", (said, drawn) -> assertTrue(off(drawn.get(0),
                    said.group(1)) <= 0.01 * Double.parseDouble(said.group(2)) * 1.1 + 2e-3, said.group())),
            new Claim(NAMES + ", deltaT = " + NUMBER + " s, \\d+ steps: amplitude \u00d7 " + NUMBER
                    + ", phase [+\u2212]?" + NUMBER + " rad", (said, drawn) -> assertEquals(
                            Double.parseDouble(said.group(3)), Math.hypot(last(drawn.get(0).of(said.group(1)))[0],
                            last(drawn.get(0).of(said.group(1)))[1]), 1e-3, said.group())),
            new Claim("Undamped springs are stable up to deltaT omega = (?=\\d)", (said, drawn) -> { }),
            new Claim(NUMBER + " with (" + NAME + ")", (said, drawn) -> assertTrue(drawn.get(0).of(said.group(2))
                    .stream().anyMatch(p -> Math.abs(p[0]) < 0.1
                    && Math.abs(Math.abs(p[1]) - Double.parseDouble(said.group(1))) < 0.1), said.group())),
            new Claim(" ?\\(equal evaluations\\)", (said, drawn) -> { }),
            new Claim("(?:Undamped springs are stable )?at no step with " + NAMES + END, (said, drawn) ->
                    named(said.group(1)).forEach(solver -> assertTrue(drawn.get(0).of(solver).stream()
                            .noneMatch(p -> p[0] > 1e-3 && Math.abs(p[1]) < 0.5 && p[0] < 0.9), said.group()))),
            new Claim("All that decays is stable at any step with " + NAMES + END, (said, drawn) ->
                    named(said.group(1)).forEach(solver -> assertTrue(drawn.get(0).of(solver).stream()
                            .allMatch(p -> p[0] > -1e-9), said.group()))),
            new Claim(NAMES + " also makes? fast growth decay", (said, drawn) -> named(said.group(1)).forEach(solver ->
                    assertTrue(drawn.get(0).of(solver).stream().anyMatch(p -> p[0] > 1), said.group()))),
            new Claim("the fastest mode lies at deltaT \\|lambda\\| = " + NUMBER, (said, drawn) ->
                    assertTrue(drawn.get(0).of("deltaT times an eigenvalue of the scene").stream()
                    .anyMatch(p -> Math.abs(Math.hypot(p[0], p[1]) / Double.parseDouble(said.group(1)) - 1) < 0.005),
                    said.group())),
            new Claim("Runs move apart from deltaT = (?=\\d)", (said, drawn) -> { }),
            new Claim(NUMBER + " s \\((" + NAME + ")\\)", (said, drawn) -> assertTrue(drawn.get(0).series()
                    .containsKey(said.group(2) + ", runs: " + said.group(1) + " s"), said.group())),
            new Claim(NAMES + " stays? nearest to the reference", (said, drawn) -> {
                Drawn distance = drawn.get(0);
                double nearest = solvers(distance).mapToDouble(solver -> rms(distance.of(solver))).min().orElseThrow();
                named(said.group(1)).forEach(solver -> assertTrue(rms(distance.of(solver)) <= 1.11 * nearest,
                        said.group()));
            }),
            new Claim("(" + NAME + ") leaves at t = " + NUMBER + " s", (said, drawn) -> assertEquals(
                    Double.parseDouble(said.group(2)), last(drawn.get(0).of(said.group(1)))[0],
                    0.05 * Double.parseDouble(said.group(2)), said.group())),
            new Claim("Euler and midpoint spiral outwards, RK4 inwards: how fast depends on the step",
                    (said, drawn) -> {
                        assertTrue(amplitude(drawn, "euler") > 1 && amplitude(drawn, "midpoint") > 1, said.group());
                        assertTrue(amplitude(drawn, "rk4") < 1, said.group());
                    }),
            new Claim("Vectors show the vector field \\(v, \u2212x\\); each solution is a circle", (said, drawn) ->
                    assertTrue(drawn.get(0).of("exact").stream().allMatch(p ->
                            Math.abs(Math.hypot(p[0], p[1]) - 1) < 1e-12), said.group())),
            new Claim("(?:The |An? |Euler's )[^:]*?(?:, numerical energy error)?: ", (said, drawn) -> { }),
            new Claim("One frame of stiff cloth: ", (said, drawn) -> { }));

    private static List<String> named(String names) {
        return names.endsWith(" solvers") ? List.of() : Arrays.asList(names.split(", | and "));
    }

    /** The solvers of a chart: the names of its lines. */
    private static Stream<String> solvers(Drawn drawn) {
        return drawn.series().keySet().stream().map(name -> name.replaceFirst(",.*", "")).distinct()
                .filter(name -> name.matches(NAME) && !name.matches("stopped|unstable|exact|start|end|stable"));
    }

    private static boolean reaches(Drawn drawn, String solver, String error) {
        return drawn.crossing(solver, Double.parseDouble(error)) < Double.POSITIVE_INFINITY;
    }

    /** Exactly those are named that are not apart from the least work: by quartiles, or by 5 % of the evaluations. */
    private static void first(String names, double error, Drawn drawn) {
        String best = solvers(drawn).min(Comparator.comparingDouble(solver -> drawn.crossing(solver, error)))
                .orElseThrow();
        List<String> ties = solvers(drawn).filter(solver -> bound(drawn, solver, error, 0)
                <= bound(drawn, best, error, 1)).sorted().toList();
        if (named(names).isEmpty()) {
            assertEquals(names, ties.size() + " solvers");
        } else {
            assertEquals(ties, named(names).stream().sorted().toList(), "for " + error);
        }
    }

    private static double bound(Drawn drawn, String solver, double error, int end) {
        double bar = drawn.crossing(solver, error, end);
        return Double.isNaN(bar) ? drawn.crossing(solver, error) * (end == 0 ? 0.975 : 1.025) : bar;
    }

    private static void exponents(String names, double said, Drawn drawn) {
        named(names).forEach(solver -> assertEquals(said, drawn.exponent(solver, 999), 0.051, solver));
        if (named(names).isEmpty()) {
            assertEquals(Integer.parseInt(names.replace(" solvers", "")), solvers(drawn).filter(solver ->
                    drawn.of(solver).stream().filter(p -> p[0] >= 999).count() >= 3
                    && Math.abs(drawn.exponent(solver, 999) - said) <= 0.051).count(), names);
        }
    }

    private static void vibration(String fate, String most, String names, Drawn drawn) {
        for (String solver : named(names)) {
            double last = last(drawn.of(solver))[1];
            double largest = largest(drawn.of(solver));
            assertTrue(fate.equals("is gone") ? last <= 1e-9 : fate.equals("stays") ? last >= 0.5 && largest <= 2
                    : fate.equals("fades") ? largest <= 2 && last < 0.5
                    : largest > 2 && largest <= 1.5 * Double.parseDouble(most), solver + " " + fate);
        }
    }

    private static double part(String number, String unit) {
        return Double.parseDouble(number) * (unit.equals("%") ? 0.01 : 1);
    }

    /** The chart has the size of the error; a drift is measured at its end, an oscillation by its largest. */
    private static void energy(String verb, String names, double part, Drawn drawn) {
        for (String solver : named(names)) {
            double shown = verb.startsWith("stay") ? largest(drawn.of(solver)) : last(drawn.of(solver))[1];
            assertEquals(part, Math.abs(shown), 0.06 * part, solver + " " + verb);
        }
    }

    private static void halves(String cheap, String dear, String steps, Drawn drawn) {
        double at = Double.parseDouble(steps);
        Function<String, Double> time = solver -> drawn.of(solver).stream().filter(p -> p[0] == at).findFirst()
                .orElseThrow()[1];
        assertTrue(2 * time.apply(cheap) < time.apply(dear), cheap + " at " + steps);
    }

    private static Stream<Double> bars(Drawn drawn) {
        return drawn.series().values().stream().flatMap(List::stream).map(p -> p[0]).filter(x -> x > 0 && x != 1);
    }

    /** How far a path is from the reference's curve, at most, in halves of the curve's extent. */
    private static double off(Drawn drawn, String solver) {
        List<double[]> curve = drawn.of("reference");
        double x = curve.stream().mapToDouble(p -> p[0]).max().orElseThrow()
                - curve.stream().mapToDouble(p -> p[0]).min().orElseThrow();
        double v = curve.stream().mapToDouble(p -> p[1]).max().orElseThrow()
                - curve.stream().mapToDouble(p -> p[1]).min().orElseThrow();
        return drawn.of(solver).stream().mapToDouble(p -> IntStream.range(1, curve.size()).mapToDouble(k ->
                2 * Line2D.ptSegDist(curve.get(k - 1)[0] / x, curve.get(k - 1)[1] / v, curve.get(k)[0] / x,
                        curve.get(k)[1] / v, p[0] / x, p[1] / v)).min().orElseThrow()).max().orElseThrow();
    }

    private static double amplitude(List<Drawn> drawn, String solver) {
        return drawn.stream().mapToDouble(one -> Math.hypot(last(one.of(solver))[0], last(one.of(solver))[1])).max()
                .orElseThrow();
    }

    private static double[] last(List<double[]> points) {
        return points.get(points.size() - 1);
    }

    private static double largest(List<double[]> points) {
        return points.stream().mapToDouble(p -> Math.abs(p[1])).max().orElse(0);
    }

    private static double rms(List<double[]> points) {
        return Math.sqrt(points.stream().mapToDouble(p -> p[1] * p[1]).average().orElse(Double.NaN));
    }
}
