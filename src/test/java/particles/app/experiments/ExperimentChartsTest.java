package particles.app.experiments;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static particles.Texts.assertHas;

import com.lowagie.text.pdf.PdfName;
import com.lowagie.text.pdf.PdfReader;
import com.lowagie.text.pdf.parser.PdfTextExtractor;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Set;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import particles.output.charts.ChartFormat;
import particles.output.charts.ChartPage;
import particles.output.charts.ChartWriter;
import particles.output.files.OutputFolder;
import particles.output.report.Picture;
import particles.output.report.ResultPage;
import particles.view.Panel;
import particles.view.Series;

/**
 * Each chart of the experiments is laid out well, as page and as slide, with at most five curves on a slide; its CSV
 * file has its points and nothing else, and the page has the answers of all charts.
 */
class ExperimentChartsTest {
    private static final String HEAD = "chart,series,x quantity,x,y quantity,y";

    @TempDir
    Path top;

    @ParameterizedTest
    @ValueSource(strings = {"lectureFigures", "phasePlots", "energyDrift --set=duration=2",
        "energyDrift --scene=3 --solvers=rk4,verlet,midpoint",
        "stiffGallery --solvers=rk4,verlet", "stability --scene=4",
        "workPrecision --problem=pendulum --solvers=radau,step-doubling"})
    void chartsCanBeReadAndTheirNumbersAreInFiles(String task) throws IOException {
        int drawn = 0;
        Path out = top.resolve("out");
        try (OutputFolder folder = OutputFolder.open(out)) {
            ResultPage measured = ChartLayoutTest.measured(task, folder);
            assertEquals("", String.join("\n", ChartLayoutTest.faults(measured)));
            for (boolean slide : List.of(false, true)) {
                ChartFormat format = new ChartFormat(slide, false, false, 1);
                ResultPage page = measured.write(folder, format);
                for (Picture picture : page.pictures()) {
                    if (!picture.panels().isEmpty()) {
                        List<String> lines = Files.readAllLines(out.resolve(picture.name() + ".csv"));
                        assertEquals(lines(picture), lines.size());
                        assertEquals(HEAD, lines.get(0));
                        assertTrue(!slide || curves(picture) <= 5, picture.name() + " has " + curves(picture));
                        drawn++;
                    }
                }
                if (slide) {
                    assertAreInOneFile(out.resolve(ChartWriter.PDF), page.pictures().stream()
                            .filter(picture -> picture.page(format).isPresent()).toList(), format);
                }
            }
            assertEndsAreInThePage(measured, Files.readString(out.resolve(measured.name() + ".md")));
        }
        assertTrue(drawn > 1, task);
    }

    private static Stream<Series> series(Picture picture) {
        return picture.panels().stream().flatMap(panel -> panel.charts().stream()).flatMap(chart ->
                chart.series().stream());
    }

    private static long lines(Picture picture) {
        return 1 + series(picture).mapToLong(series -> series.x().length).sum();
    }

    private static long curves(Picture picture) {
        return series(picture).filter(series -> series.mark().isCurve()).flatMap(series ->
                series.look().solver().stream()).distinct().count();
    }

    /** The page of a task has each number once more in a table, beside its name. */
    private static void assertEndsAreInThePage(ResultPage page, String text) {
        Set<Panel> panels = page.pictures().stream().flatMap(picture -> picture.panels().stream())
                .collect(Collectors.toSet());
        for (Panel panel : panels) {
            assertTrue(text.contains(panel.answer()), panel.answer());
        }
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
    @ValueSource(strings = {"stiffGallery", "effectCost", "stability", "stability --scene=17 --solvers=rk4,verlet",
        "workPrecision --problem=network",
        "workPrecision --problem=stiff-chain --solvers=rk4,verlet,backward-euler,radau", "stiffCloth",
        "race", "race --solvers=euler,rk4", "race --scene=27 --set=duration=0.6", "energyDrift"})
    void soCanThoseOfWholeExperiments(String task) throws IOException {
        chartsCanBeReadAndTheirNumbersAreInFiles(task);
    }
}
