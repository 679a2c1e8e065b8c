package particles.app.run;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.lowagie.text.pdf.PdfReader;
import com.lowagie.text.pdf.parser.PdfTextExtractor;
import deSolvers.text.Digits;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.DoubleSummaryStatistics;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import particles.app.cli.ExitCode;
import particles.app.cli.OptionStyle;
import particles.app.cli.Screen;
import particles.view.ChartData.Mark;
import particles.view.ChartData.Series;

/** The titles of a run's charts, recomputed from run.json and trajectory.csv, which are written by other classes. */
class RunFindingsTest {
    @TempDir
    Path out;

    @ParameterizedTest
    @CsvSource(delimiter = '|', textBlock = """
            3  | 5   | falls from (\\S+) J to (\\S+) J | (\\S+) times as large as the first
            11 | 20  | rises from (\\S+) J to (\\S+) J | (\\S+) times as wide and (\\S+) times as high
            2  | 6.2 | stays at (\\S+) J to            | as large as the first
            """)
    void titlesSayWhatTheRunShows(String scene, double duration, String energy, String path) throws IOException {
        Screen.of(ExitCode.DONE, List.of(new RunCommand(Path.of("scenes"), new StopRequest())), OptionStyle.GRADLE,
                "run", "--scene=" + scene, "--duration=" + duration, "--frames=false", "--slide", "--out=" + out);
        List<String> slides = slides();
        Matcher energies = find(energy, slides.get(0));
        String json = Files.readString(out.resolve("run.json"));
        assertEquals(Digits.few(number(json, "start")), energies.group(1));
        if (energies.groupCount() > 1) {
            assertEquals(Digits.few(number(json, "end")), energies.group(2));
        }
        assertEquals(Digits.few(number(json, "largestRelativeNumericalError")),
                find("error is at most (\\S+) of the energy scale", slides.get(slides.size() - 2)).group(1));
        Matcher sizes = find("the second half of the path is " + path, slides.get(slides.size() - 1));
        double wider = sizes.groupCount() > 0 ? Double.parseDouble(sizes.group(1)) : 1;
        double higher = sizes.groupCount() > 1 ? Double.parseDouble(sizes.group(2)) : wider;
        assertEquals(growth(2), wider, 0.051 * wider);
        assertEquals(growth(5), higher, 0.051 * higher);
    }

    private List<String> slides() throws IOException {
        List<String> slides = new ArrayList<>();
        try (PdfReader reader = new PdfReader(Files.readAllBytes(out.resolve("slides.pdf")))) {
            for (int page = 1; page <= reader.getNumberOfPages(); page++) {
                slides.add(new PdfTextExtractor(reader).getTextFromPage(page).replaceAll("[\\s\\u00a0]+", " "));
            }
        }
        return slides;
    }

    private static Matcher find(String regex, String text) {
        Matcher matcher = Pattern.compile(regex).matcher(text);
        assertTrue(matcher.find(), regex + " in " + text);
        return matcher;
    }

    private static double number(String json, String key) {
        return Double.parseDouble(find("\"" + key + "\" : ([^,\\s]+)", json).group(1));
    }

    /** How much larger a column's extent is in the second half of the run, of the particle that moves. */
    private double growth(int column) throws IOException {
        double[] values = Files.readAllLines(out.resolve("trajectory.csv")).stream().skip(1)
                .map(line -> line.split(",")).filter(cells -> cells[1].matches("block|particle")).mapToDouble(cells ->
                Double.parseDouble(cells[column])).toArray();
        return extent(Arrays.copyOfRange(values, values.length / 2, values.length))
                / extent(Arrays.copyOfRange(values, 0, values.length / 2 + 1));
    }

    private static double extent(double[] values) {
        DoubleSummaryStatistics all = Arrays.stream(values).summaryStatistics();
        return all.getMax() - all.getMin();
    }

    @Test
    void anEnergyIsConstantVariesOrGoesOneWay() {
        assertEquals("the total energy stays at 4 J", RunFindings.energy(List.of(line(4, 4, 4))));
        assertEquals("the total energy stays at 4 J to 0.25 % of the largest energy",
                RunFindings.energy(List.of(line(4, 4.01, 4), line(4, 0, 1))));
        assertEquals("the total energy varies from 1 J to 4 J", RunFindings.energy(List.of(line(4, 1, 3))));
        assertEquals("the total energy falls from 4 J to 1 J", RunFindings.energy(List.of(line(4, 5, 1))));
        assertEquals("the total energy rises from 0 J to 1 J",
                RunFindings.energy(List.of(line(1e-20, 1.5, 1), line(2))));
        assertEquals("no step was made", RunFindings.energy(List.of(line(4))));
        assertEquals("the numerical error is as large as the energy", RunFindings.error(List.of(line(0, 1))));
        assertEquals("the numerical error is at most 1e-6 of the energy scale",
                RunFindings.error(List.of(line(0, -1e-6))));
    }

    @Test
    void pathsThatHardlyGrowOrGrowFarHaveNumbersOfASensibleSize() {
        assertEquals("the second half of the path is less than 0.01 times as wide and more than 100 times as high",
                path(new double[] {0, 1, 1, 1, 1, 1, 1, 1, 1, 1.001}, 0, 1, 1, 1, 1, 1, 1, 1, 1, 200));
    }

    private static String path(double[] x, double... y) {
        return RunFindings.path(new Series("rk4", Mark.LINE, x, y));
    }

    @Test
    void worksAreNamedTheLargestFirst() {
        List<Series> works = List.of(line(0, 1), new Series("work: wind", Mark.LINE, new double[2],
                new double[] {0, -3}));
        assertEquals("work by the end: wind \u22123 J, drag +1 J", RunFindings.work(works, true));
        assertEquals("work by the end: wind 3 J, drag 1 J", RunFindings.work(works, false));
    }

    @Test
    void aCutIsNoStateOfAPath() {
        assertEquals("a path of 3 states", path(new double[] {0, 1, Double.NaN, 2}, 0, 1, Double.NaN, 2));
    }

    @Test
    void aPathMayEndAtRest() {
        assertEquals("the particle is at rest in the second half of the path",
                path(new double[] {3, 2, 1, 1, 1, 1, 1, 1, 1, 1}, 4, 2, 0, 0, 0, 0, 0, 0, 0, 0));
    }

    /** With constant velocity, both halves are of one size. */
    @ParameterizedTest
    @CsvSource(textBlock = """
            1,  a path of 1 state
            2,  a path of 2 states
            9,  a path of 9 states
            10, the second half of the path is as large as the first
            11, the second half of the path is as large as the first
            """)
    void aPathOfFewStatesHasNoHalves(int states, String title) {
        double[] even = IntStream.range(0, states).asDoubleStream().toArray();
        assertEquals(title, path(even, even));
    }

    private static Series line(double... values) {
        return new Series("work: drag", Mark.LINE, new double[values.length], values);
    }
}
