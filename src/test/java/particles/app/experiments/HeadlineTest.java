package particles.app.experiments;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static particles.Texts.assertHas;

import com.lowagie.text.pdf.PdfName;
import com.lowagie.text.pdf.PdfReader;
import com.lowagie.text.pdf.parser.PdfTextExtractor;
import java.awt.geom.Line2D;
import java.io.IOException;
import java.math.BigDecimal;
import java.math.MathContext;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.DoubleSummaryStatistics;
import java.util.List;
import java.util.Set;
import java.util.function.Predicate;
import java.util.regex.MatchResult;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import particles.experiments.energy.DriftCharts;
import particles.output.charts.ChartFormat;
import particles.output.charts.ChartPage;
import particles.output.charts.ChartWriter;
import particles.output.charts.SolverStyle;
import particles.output.files.OutputFolder;
import particles.output.report.Picture;
import particles.output.report.ResultPage;
import particles.output.report.TableText;

/**
 * Each chart of the experiments is laid out well, as page and as slide, and its headline is recomputed from the CSV
 * file beside it. A headline is a list of claims; one that is not known here, or that the numbers do not show, fails.
 */
class HeadlineTest {
    private static final String NAME = "[a-z][a-z0-9-]*";
    private static final String NAMES = "(" + NAME + "(?:(?:, | and )" + NAME + ")*|\\d+ solvers)";
    /** Names at the end of a claim end where the headline does, or another claim begins. */
    private static final String END = "(?=$|; | [(]|, (?:not|stays|is gone|reaches|fades|at no) )";
    private static final String NUMBER = "(-?[0-9.]+(?:e-?[0-9]+)?)";
    private static final String GROWTH = "× " + NUMBER + " in " + NUMBER + " s with deltaT = " + NUMBER + " s";

    /** What a printed report has room for in two lines. */
    private static final int TWO_LINES = 215;

    @TempDir
    Path top;

    @ParameterizedTest
    @ValueSource(strings = {"lectureFigures", "phasePlots", "energyDrift --duration=2",
        "energyDrift --scene=3 --solvers=rk4,verlet,midpoint",
        "stiffGallery --decades=5 --solvers=euler,rk4,verlet,radau",
        "effectCost --columns=3 --rounds=1", "stability --scene=4",
        "workPrecision --problem=pendulum --solvers=radau,step-doubling"})
    void chartsCanBeReadAndHeadlinesSayWhatTheirNumbersShow(String task) throws IOException {
        int judged = 0;
        Path out = top.resolve("out");
        try (OutputFolder folder = OutputFolder.open(out)) {
            ResultPage measured = ChartLayoutTest.measured(task, folder);
            assertEquals("", String.join("\n", ChartLayoutTest.faults(measured)));
            assertTrue(measured.title().length() <= TWO_LINES, "in the contents of a report: " + measured.title());
            assertEquals(List.of(), otherDigits(measured));
            for (boolean slide : List.of(false, true)) {
                ChartFormat format = new ChartFormat(slide, false, false, 1);
                ResultPage page = measured.write(folder, format);
                for (Picture picture : page.pictures()) {
                    if (!picture.panels().isEmpty() && Files.exists(out.resolve(picture.name() + ".csv"))) {
                        judge(picture.title(), Drawn.read(out.resolve(picture.name() + ".csv")));
                        judged++;
                    }
                }
                if (slide) {
                    assertAreInOneFile(out.resolve(ChartWriter.PDF), page.pictures().stream()
                            .filter(picture -> picture.page(format).isPresent()).toList(), format);
                }
            }
        }
        assertTrue(judged > 1, task);
    }

    /**
     * Numbers of a headline that stand in a table with other digits: 14.3 % beside 0.14. Of more than three digits,
     * which a table needs to compare with theory, the headline has the first three or more.
     */
    private static List<String> otherDigits(ResultPage page) {
        List<String> cells = page.tables().stream().flatMap(table -> table.rows().stream().flatMap(row ->
                IntStream.range(0, row.size()).mapToObj(c -> TableText.text(table, row, c))))
                .filter(cell -> cell.matches(NUMBER)).toList();
        return Stream.concat(Stream.of(page.title()), page.pictures().stream().map(Picture::title))
                .flatMap(title -> Pattern.compile("(?<![\\w^.-])" + NUMBER + "(?![\\w^])").matcher(title).results())
                .map(MatchResult::group).distinct().filter(said -> cells.stream().anyMatch(cell ->
                        areOneNumber(said, cell)) && cells.stream().noneMatch(cell -> digits(cell).equals(digits(said))
                        || digits(said).length() > 2 && areOneNumber(said, cell)))
                .map(said -> said + " in '" + page.title() + "'").toList();
    }

    private static String digits(String number) {
        return number.replaceFirst("e.*", "").replaceAll("[-.]", "").replaceAll("^0+|0+$", "");
    }

    /** Whether the number with fewer digits is the other one, rounded, or that in percent. */
    private static boolean areOneNumber(String said, String cell) {
        int common = Math.min(digits(said).length(), digits(cell).length());
        BigDecimal one = new BigDecimal(said).abs().round(new MathContext(common));
        return common > 1 && Stream.of(0, 2).anyMatch(power -> one.compareTo(new BigDecimal(cell).abs()
                .scaleByPowerOfTen(power).round(new MathContext(common))) == 0);
    }

    /** The PDF of all slides has a page of 16:9 for each, with its title as text and nothing as pixels. */
    private static void assertAreInOneFile(Path pdf, List<Picture> slides, ChartFormat format) throws IOException {
        try (PdfReader reader = new PdfReader(Files.readAllBytes(pdf))) {
            assertEquals(slides.size(), reader.getNumberOfPages());
            for (int k = 0; k < slides.size(); k++) {
                String text = new PdfTextExtractor(reader).getTextFromPage(k + 1).replaceAll("[\\s\\u00a0]", "");
                assertHas(text, slides.get(k).title().replaceAll("[\\s\\u00a0]", ""));
                assertHas(reader.getPageSize(k + 1).toString(), "640.0x360.0");
                ChartPage slide = slides.get(k).page(format).orElseThrow();
                assertEquals(16 * slide.height(), 9 * slide.width());
                boolean pixels = reader.getPageN(k + 1).getAsDict(PdfName.RESOURCES).contains(PdfName.XOBJECT);
                assertEquals(slides.get(k).panels().isEmpty(), pixels, "only a race has pictures of a scene");
            }
        }
    }

    @Tag("slow")
    @ParameterizedTest
    @ValueSource(strings = {"stiffGallery --decades=6", "stability", "stability --scene=17 --solvers=rk4,verlet",
        "workPrecision --problem=network",
        "workPrecision --problem=stiff-chain --solvers=rk4,verlet,backward-euler,radau", "stiffCloth",
        "race --frames=150", "race --solvers=euler,rk4", "race --scene=27 --duration=0.6", "energyDrift"})
    void soDoThoseOfWholeExperiments(String task) throws IOException {
        chartsCanBeReadAndHeadlinesSayWhatTheirNumbersShow(task);
    }

    /** A headline that says more than its numbers is found: each of these is a true one with one thing changed. */
    @ParameterizedTest
    @CsvSource(delimiter = '|', textBlock = """
            A spring: rk4 is cheapest for an error of 0.01 and 1e-6                    | evaluations of the derivative
            A spring: verlet is cheapest for an error of 0.01 and 1e-6                 | evaluations of the derivative
            A spring: verlet and rk4 tie for an error of 0.01                          | evaluations of the derivative
            A spring: verlet and rk4 tie for an error of 1000                          | evaluations of the derivative
            A spring (symplectic): verlet is cheapest for an error of 0.01             | evaluations of the derivative
            A spring: verlet is cheapest for an error of 0.01, no run reaches 1e-6     | evaluations of the derivative
            A spring: every stable run has an error below 10                           | evaluations of the derivative
            A spring: verlet is the best                                               | evaluations of the derivative
            Evaluations for 1 % error of the swing grow from k = 1000 on as k^0.4 (rk4) | evaluations for 1 %
            Evaluations for 1 % error of the swing stay about the same from k = 1000 on with rk4 | evaluations for 1 %
            A net: rk4 gains 15 %                                                      | energy error / scale
            A net: rk4 stays within 1e-3 %                                             | energy error / scale
            A net: verlet and rk4 lose 96 %                                            | energy error / scale
            A net: 2 solvers lose 96 %                                                 | energy error / scale
            In the stiffest spring, the vibration fades with rk4                       | fast-mode energy
            In the stiffest spring, the vibration stays with rk4                       | fast-mode energy
            In the stiffest spring, the vibration reaches up to 1e-14 times its initial energy with rk4 | fast-mode
            """)
    void aFalseHeadlineFails(String title, String quantity) throws IOException {
        Path csv = top.resolve("made.csv");
        List<String> lines = new ArrayList<>(List.of("chart,series,x quantity,x,y quantity,y"));
        // the finest run comes first, as lines also come back
        for (int k = 8; k >= 0; k--) {                  // verlet has 0.01 at 100, rk4 at 1000; 1e-6 at 1e6 and 1e5
            lines.add("t,rk4,x," + Math.pow(10, 1.0 + k) + "," + quantity + "," + Math.pow(10, 2.0 - 2 * k));
            lines.add("t,verlet,x," + Math.pow(10, 1.0 + k) + "," + quantity + "," + Math.pow(10, -1.0 - k));
        }
        Files.write(csv, lines);
        assertThrows(AssertionError.class, () -> judge(title, Drawn.read(csv)), title);
    }

    /** A true headline, one that differs in a claim, and series: the name of each, then x and y of its points. */
    @ParameterizedTest
    @CsvSource(delimiter = '|', textBlock = """
            A spring: a step of 0.1 s is stable with rk4 and verlet | A spring: a step of 0.1 s is stable with rk4 \
            | modes of the scene: 0 1.5; rk4: 0 0; verlet: 0 0
            a step of 1 s is stable with no solver shown; drawn for 0.1 s, the longest that is stable with rk4 \
            | a step of 1 s is stable with no solver shown; drawn for 0.1 s, the longest that is stable with verlet \
            | modes of the scene: 0 2.8284; rk4: 0 0; verlet: 0 0
            Longest stable step in runs, predicted in brackets: rk4 1 s (1.1 s), verlet 2 s (2 s) \
            | Longest stable step in runs, predicted in brackets: rk4 2 s (1.1 s), verlet 1 s (2 s) \
            | rk4: 0.5 1 1.2 1.5; verlet: 1 1 2.1 1.5; limit measured on runs: 1 1 2 1
            rk4 1 s (1.1 s) | rk4 1 s (0.9 s) | rk4: 1 1 1.2 1.5; limit measured on runs: 1 1
            A chain: rk4 is 0.1 m from the reference on average | A chain: rk4 is 0.2 m from the reference on average \
            | rk4: 1 0.1 2 0.1
            A chain: rk4 stays nearest to the reference on average | A chain: verlet stays nearest to the reference on \
            average | rk4: 1 0.1 3 0.1; verlet: 1 0.5 2 0.9
            verlet leaves the race at t = 2 s | verlet leaves the race at t = 3 s | verlet: 1 0.5 2 0.9
            A spring: rk4 leaves the reference | A spring: rk4 stays on the reference to within 4 % of its half width \
            | reference: 0 0 2 2; rk4: 0 0 0.2 0
            rk4 (deltaT = 0.1 s): off the reference by up to 14 % of its half width \
            | rk4 (deltaT = 0.1 s): off the reference by up to 15 % of its half width | reference: 0 0 2 2; rk4: 0.2 0
            rk4 (deltaT = 0.1 s): on the reference to within 0.14 % of its half width \
            | rk4 (deltaT = 0.1 s): on the reference to within 0.2 % of its half width | reference: 0 0 2 2; rk4: 2e-3 0
            rk4 (deltaT = 0.1 s): off the reference by more than ten times its half width \
            | rk4 (deltaT = 0.1 s): on the reference to within 4 % of its half width | reference: 0 0 2 2; rk4: 20 0
            """)
    void oneOtherClaimMakesAHeadlineFalse(String right, String wrong, String series) throws IOException {
        Path csv = top.resolve("made.csv");
        List<String> lines = new ArrayList<>(List.of("chart,series,x quantity,x,y quantity,y"));
        for (String one : series.split("; ")) {
            String[] numbers = one.replaceFirst(".*: ", "").split(" ");
            for (int k = 0; k < numbers.length; k += 2) {
                lines.add("t," + one.replaceFirst(":.*", "") + ",x," + numbers[k] + ",y," + numbers[k + 1]);
            }
        }
        Files.write(csv, lines);
        judge(right, Drawn.read(csv));
        assertThrows(AssertionError.class, () -> judge(wrong, Drawn.read(csv)), wrong);
    }

    /** The words of a claim in a headline. */
    private record Said(MatchResult words) {
        String text(int group) {
            return words.group(group);
        }

        double number(int group) {
            return Double.parseDouble(words.group(group));
        }

        /** A part of the energy, from a number and its unit in the next group. */
        double part(int group) {
            return number(group) * (text(group + 1).equals("%") ? 0.01 : 1);
        }
    }

    /** A claim: its words, and whether the numbers show it. */
    private record Claim(Pattern words, Check check) {
        interface Check {
            boolean of(Said said, Drawn drawn);
        }

        interface SolverCheck {
            boolean of(String solver, Said said, Drawn drawn);
        }

        Claim(String words, Check check) {
            this(Pattern.compile("^" + words), check);
        }

        /** Words that claim nothing by themselves. */
        Claim(String words) {
            this(words, (said, drawn) -> true);
        }

        /** A claim of each solver that the first group names, or of as many as it says. */
        static Claim each(String words, SolverCheck check) {
            return new Claim(words, (said, drawn) -> areAll(said.text(1), drawn, solver ->
                    check.of(solver, said, drawn)));
        }
    }

    private static void judge(String title, List<Drawn> drawn) {
        String rest = title.replace('\u00a0', ' ');
        for (boolean found = true; found && !rest.isEmpty();) {
            found = false;
            for (Claim claim : CLAIMS) {
                var matcher = claim.words().matcher(rest);
                if (!found && matcher.lookingAt()) {
                    assertTrue(claim.check().of(new Said(matcher.toMatchResult()), drawn.get(0)), matcher.group());
                    rest = rest.substring(matcher.end()).replaceFirst("^(; |, | on$)", "");
                    found = true;
                }
            }
        }
        assertEquals("", rest, "no claim that can be checked, in '" + title + "'");
    }

    private static boolean near(double said, double shown, double tolerance) {
        return Math.abs(said - shown) <= tolerance;
    }

    private static final List<Claim> CLAIMS = List.of(
            new Claim(NAMES + " (?:is cheapest for|is first to|tie for|reaches) (?:an error of )?" + NUMBER
                    + "(?: and " + NUMBER + ")?", (said, drawn) -> first(said.text(1), said.number(2), drawn)
                            && largestError(drawn) > said.number(2)
                            && (said.text(3) == null || first(said.text(1), said.number(3), drawn))),
            new Claim("no run reaches (?:an error of )?" + NUMBER, (said, drawn) -> solvers(drawn).noneMatch(solver ->
                    drawn.crossing(solver, said.number(1)) < Double.POSITIVE_INFINITY)),
            new Claim("every stable run has an error below " + NUMBER, (said, drawn) ->
                    largestError(drawn) < said.number(1)),
            new Claim(NAMES + " (?:is|are) stable (?:in the least time|with the fewest evaluations)", (said, drawn) ->
                    first(said.text(1), Double.POSITIVE_INFINITY, drawn)),
            new Claim(NAMES + " falls from order (\\d) to " + NUMBER + " \\(theory: (\\d)\\)", (said, drawn) ->
                    drawn.series().containsKey(said.text(1) + ", " + said.text(3) + " (" + said.text(4) + ")")),
            new Claim("Evaluations for (?:1 % error of the swing|stability) grow from k = 1000 on as (?=k)"),
            new Claim("k\\^" + NUMBER + " \\(" + NAMES + "\\)", (said, drawn) ->
                    exponents(said.text(2), said.number(1), drawn)),
            new Claim("(?:Evaluations for (?:1 % error of the swing|stability) stay about the same from k = 1000 on"
                    + "|not) with " + NAMES + END, (said, drawn) -> exponents(said.text(1), 0, drawn)),
            new Claim("In the stiffest spring, the vibration (?=\\w)"),
            Claim.each("(?=[^,]* with " + NAMES + END + ")(is gone|stays|fades|reaches up to "
                    + NUMBER + " times its initial energy) with " + NAMES + END, (solver, said, drawn) ->
                    last(drawn.of(solver))[0] == solvers(drawn).mapToDouble(other -> last(drawn.of(other))[0]).max()
                            .orElseThrow() && vibration(said, drawn, last(drawn.of(solver))[1])),
            Claim.each(NAMES + " leaves? the reference", (solver, said, drawn) -> off(drawn, solver) > 0.05),
            Claim.each(NAMES + " (?:\\(deltaT = [0-9.]+ s\\): (off the reference by up to|on the reference to within)"
                    + "|stays? on the reference to within) " + NUMBER + " % of its half width",
                    (solver, said, drawn) -> {
                double beyond = off(drawn, solver) - 0.01 * said.number(3);
                return (said.text(2) == null ? beyond : Math.abs(beyond)) <= 0.0005 * said.number(3);     // two digits
            }),
            Claim.each(NAMES + " \\(deltaT = [0-9.]+ s\\): off the reference by more than ten times its half width",
                    (solver, said, drawn) -> off(drawn, solver) > 3.2),
            Claim.each(NAMES + " (gains?|loses?|stays? within) " + NUMBER + " (%|times the energy)",
                    (solver, said, drawn) -> energy(said.text(2), drawn.of(solver), said.part(3))),
            Claim.each(NAMES + " [+\u2212]" + NUMBER + " (%|times the energy)", (solver, said, drawn) ->
                    energy("stays within", drawn.of(solver), said.part(2))),
            Claim.each(NAMES + " (?:is|are) exact to round-off", (solver, said, drawn) ->
                    largest(drawn.of(solver)) < 1e-11),
            Claim.each(NAMES + " (?:blows? up|stops?) at t = " + NUMBER + " s", (solver, said, drawn) ->
                    near(said.number(2), last(drawn.of(solver))[0], 0.02 * said.number(2))),
            new Claim("(\\d+) more (?:stops? early|leaves? the race)", (said, drawn) -> Stream.of("stopped",
                    DriftCharts.LEFT).anyMatch(crosses -> drawn.series().getOrDefault(crosses, List.of()).size()
                    > said.number(1))),
            new Claim("the other (\\d+) (?:is|are) off by at most " + NUMBER + " (%|times the energy)", (said, drawn) ->
                    near(said.part(2), solvers(drawn).map(solver -> largest(drawn.of(solver))).sorted()
                            .skip((long) said.number(1) - 1).findFirst().orElseThrow(), 0.06 * said.part(2))),
            new Claim("(\\w.*?) makes? a step of springs more than (\\d+) times as long; all else less than (\\d+)"
                    + " times", (said, drawn) -> (said.text(1).equals("Nothing") ? 0
                            : said.text(1).replaceAll(", (exact|hand-written)", "").split(", | and ").length)
                            == bars(drawn).filter(times -> times >= said.number(2)).count()
                            && bars(drawn).allMatch(times -> times >= said.number(2) || times < said.number(3))),
            new Claim("rk4 takes less than half the time up to (\\d+) steps", (said, drawn) ->
                    halves("rk4", "linearised-euler", 0, said.number(1), drawn)),
            new Claim("linearised-euler (?:takes less than half the time )?from (\\d+)", (said, drawn) ->
                    halves("linearised-euler", "rk4", said.number(1), Double.POSITIVE_INFINITY, drawn)),
            new Claim("rk4 is not clearly faster on the softest, nor linearised-euler on the stiffest",
                    (said, drawn) -> {
                double softest = drawn.of("rk4").get(0)[0];
                double stiffest = last(drawn.of("rk4"))[0];
                return !halves("rk4", "linearised-euler", softest, softest, drawn)
                        && !halves("linearised-euler", "rk4", stiffest, stiffest, drawn);
            }),
            Claim.each(NAMES + " exceeds? 10 %", (solver, said, drawn) -> largest(drawn.of(solver)) > 0.09
                    || last(drawn.of(solver))[0] < drawn.series().values().stream().mapToDouble(points ->
                    last(points)[0]).max().orElseThrow()),
            Claim.each(NAMES + ", deltaT = " + NUMBER + " s, \\d+ steps: amplitude \u00d7 " + NUMBER
                    + ", phase [+\u2212]?" + NUMBER + " rad", (solver, said, drawn) ->
                    near(said.number(3), amplitude(drawn, solver), 1e-3)),
            new Claim("Undamped springs are stable up to deltaT omega = (?=\\d)"),
            new Claim(NUMBER + " with (" + NAME + ")", (said, drawn) -> drawn.of(said.text(2)).stream().anyMatch(p ->
                    Math.abs(p[0]) < 0.1 && near(said.number(1), Math.abs(p[1]), 0.1))),
            new Claim(" ?\\((?:equal|\\d+ to \\d+) evaluations\\)"),
            new Claim(" \\(([a-z, ]+)\\)$", (said, drawn) -> areOf(said.text(1), drawn)),
            Claim.each("(?:Undamped springs are stable )?at no step with " + NAMES + END, (solver, said, drawn) ->
                    drawn.of(solver).stream().noneMatch(p -> p[0] > 1e-3 && Math.abs(p[1]) < 0.5 && p[0] < 0.9)),
            Claim.each("All that decays is stable at any step with " + NAMES + END, (solver, said, drawn) ->
                    drawn.of(solver).stream().allMatch(p -> p[0] > -1e-9)),
            Claim.each(NAMES + " also makes? fast growth decay", (solver, said, drawn) ->
                    drawn.of(solver).stream().anyMatch(p -> p[0] > 1)),
            new Claim("a step of " + NUMBER + " s is stable with (?:no solver shown|" + NAMES + ")$", (said, drawn) ->
                    StableModes.with(drawn, 1).equals(said.text(2) == null ? Set.of()
                    : Set.of(said.text(2).split(", | and ")))),
            new Claim("a step of " + NUMBER + " s is stable with no solver shown; drawn for " + NUMBER
                    + " s, the longest that is stable with (" + NAME + ")", (said, drawn) ->
                    StableModes.with(drawn, said.number(1) / said.number(2)).isEmpty()
                    && StableModes.with(drawn, 0.999).contains(said.text(3))
                    && StableModes.with(drawn, 1.001).isEmpty()),
            new Claim("Longest stable step in runs, predicted in brackets(?: \\(([a-z, ]+)\\))?: ", (said, drawn) ->
                    said.text(1) == null || areOf(said.text(1), drawn)),
            Claim.each("(" + NAME + ") " + NUMBER + " s \\(" + NUMBER + " s\\)", (solver, said, drawn) ->
                    drawn.of(solver).stream().allMatch(p -> p[1] > 1 + 1e-9 == p[0] > said.number(3)
                            || near(said.number(3), p[0], 0.02 * said.number(3)))
                            && near(said.number(2), drawn.of("limit measured on runs").get(solvers(drawn).toList()
                            .indexOf(solver))[0], 0.005 * said.number(2))),
            Claim.each(NAMES + " is " + NUMBER + " m from the reference on average", (solver, said, drawn) ->
                    near(said.number(2), rms(drawn.of(solver)), 0.01 * said.number(2))),
            Claim.each(NAMES + " stays? nearest to the reference on average", (solver, said, drawn) ->
                    rms(drawn.of(solver)) <= 1.11 * solvers(drawn).mapToDouble(other -> rms(drawn.of(other))).min()
                            .orElseThrow()),
            Claim.each(NAMES + " leaves? the race at t = " + NUMBER + " s", (solver, said, drawn) ->
                    near(said.number(2), last(drawn.of(solver))[0], 0.05 * said.number(2))),
            Claim.each(NAMES + " spirals? (out|in)wards", (solver, said, drawn) ->
                    said.text(2).equals("out") == amplitude(drawn, solver) > 1),
            new Claim("how fast depends on the step: (" + NAME + ") " + GROWTH + ", " + GROWTH, (said, drawn) ->
                    IntStream.of(2, 5).allMatch(group -> grows(drawn.of(said.text(1)), said.number(group),
                            said.number(group + 1), said.number(group + 2)))),
            new Claim("Vectors show the vector field \\(v, \u2212x\\); each solution is a circle", (said, drawn) ->
                    drawn.of("exact").stream().allMatch(p -> near(1, Math.hypot(p[0], p[1]), 1e-12))),
            new Claim("(?:The |An? |Euler's )[^:]*?(?:, numerical energy error)?(?: \\(([a-z, ]+)\\))?: ",
                    (said, drawn) -> said.text(1) == null || areOf(said.text(1), drawn)),
            new Claim("One frame of stiff cloth: "));

    /** Whether one of the paths from (1, 0) has first steps of this deltaT, and this amplitude after this time. */
    private static boolean grows(List<double[]> paths, double amplitude, double seconds, double deltaT) {
        int steps = (int) Math.round(seconds / deltaT);
        return IntStream.range(0, paths.size() - steps).anyMatch(k -> paths.get(k)[0] == 1
                && near(deltaT, -paths.get(k + 1)[1], 0.2 * deltaT)
                && near(amplitude, Math.hypot(paths.get(k + steps)[0], paths.get(k + steps)[1]), 0.005));
    }

    /** The solvers that are named; all if they are only counted. */
    private static Stream<String> named(String names, Drawn drawn) {
        return names.endsWith(" solvers") ? solvers(drawn) : Arrays.stream(names.split(", | and "));
    }

    /** Whether all named solvers pass, or as many of all as are said. */
    private static boolean areAll(String names, Drawn drawn, Predicate<String> check) {
        long pass = named(names, drawn).filter(check).count();
        return names.equals(pass + " solvers") || !names.endsWith(" solvers") && pass == named(names, drawn).count();
    }

    private static boolean areOf(String family, Drawn drawn) {
        return solvers(drawn).allMatch(solver -> SolverStyle.of(solver).orElseThrow().family().title.equals(family));
    }

    /** The solvers of a chart: the names of its lines. */
    private static Stream<String> solvers(Drawn drawn) {
        return drawn.series().keySet().stream().map(name -> name.replaceFirst(",.*", "")).distinct()
                .filter(name -> name.matches(NAME) && !name.matches("stopped|unstable|exact|start|end|stable"));
    }

    private static double largestError(Drawn drawn) {
        return solvers(drawn).mapToDouble(solver -> largest(drawn.of(solver))).max().orElseThrow();
    }

    /** Exactly those are named that are not apart from the least work: by its bar, or by 5 % of the evaluations. */
    private static boolean first(String names, double error, Drawn drawn) {
        String best = solvers(drawn).min(Comparator.comparingDouble(solver -> drawn.crossing(solver, error)))
                .orElseThrow();
        double most = drawn.most(best, error);
        Set<String> ties = solvers(drawn).filter(solver -> drawn.crossing(solver, error) <= most)
                .collect(Collectors.toSet());
        return areAll(names, drawn, ties::contains) && (names.endsWith(" solvers")
                || named(names, drawn).count() == ties.size());
    }

    private static boolean exponents(String names, double said, Drawn drawn) {
        return areAll(names, drawn, solver -> near(said, drawn.exponent(solver, 999), 0.051));
    }

    /** The largest is said of all solvers that reach more than twice the energy. */
    private static boolean vibration(Said said, Drawn drawn, double last) {
        return switch (said.text(2)) {
            case "is gone" -> last <= 1e-9;
            case "stays" -> last >= 0.5 && last <= 2;
            case "fades" -> last > 1e-9 && last < 0.5;
            default -> last > 2 && near(said.number(3), solvers(drawn).mapToDouble(solver ->
                    last(drawn.of(solver))[1]).max().orElseThrow(), 0.005 * said.number(3));
        };
    }

    /** The chart has the size of the error; a drift is measured at its end, an oscillation by its largest. */
    private static boolean energy(String verb, List<double[]> points, double part) {
        return near(part, Math.abs(verb.startsWith("stay") ? largest(points) : last(points)[1]), 0.06 * part);
    }

    /** Whether one takes less than half the time wherever the steps are so many. */
    private static boolean halves(String cheap, String dear, double from, double to, Drawn drawn) {
        List<double[]> times = drawn.of(cheap);
        return times.stream().allMatch(p -> p[0] < from || p[0] > to
                || 2 * p[1] < drawn.of(dear).get(times.indexOf(p))[1]);
    }

    private static Stream<Double> bars(Drawn drawn) {
        return drawn.series().values().stream().flatMap(List::stream).map(p -> p[0]).filter(x -> x > 0 && x != 1);
    }

    /** How far a path is from the reference's curve, at most, in halves of the curve's extent. */
    private static double off(Drawn drawn, String solver) {
        List<double[]> curve = drawn.of("reference");
        DoubleSummaryStatistics xs = curve.stream().mapToDouble(p -> p[0]).summaryStatistics();
        DoubleSummaryStatistics vs = curve.stream().mapToDouble(p -> p[1]).summaryStatistics();
        double x = xs.getMax() - xs.getMin();
        double v = vs.getMax() - vs.getMin();
        return drawn.of(solver).stream().mapToDouble(p -> IntStream.range(1, curve.size()).mapToDouble(k ->
                2 * Line2D.ptSegDist(curve.get(k - 1)[0] / x, curve.get(k - 1)[1] / v, curve.get(k)[0] / x,
                        curve.get(k)[1] / v, p[0] / x, p[1] / v)).min().orElseThrow()).max().orElseThrow();
    }

    private static double amplitude(Drawn drawn, String solver) {
        return Math.hypot(last(drawn.of(solver))[0], last(drawn.of(solver))[1]);
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
