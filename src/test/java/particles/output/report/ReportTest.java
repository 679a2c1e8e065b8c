package particles.output.report;

import static deSolvers.problems.Bounds.assertBelow;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static particles.Texts.assertHas;
import static particles.Texts.assertStarts;
import static particles.output.SmallPictures.differences;

import java.awt.image.BufferedImage;
import java.io.BufferedOutputStream;
import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Base64;
import java.util.Collections;
import java.util.IntSummaryStatistics;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import javax.imageio.ImageIO;
import javax.xml.parsers.ParserConfigurationException;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.xml.sax.SAXException;
import particles.Xml;
import particles.output.charts.ChartFormat;
import particles.output.files.Disk;
import particles.output.files.OutputException;
import particles.output.files.OutputFile;
import particles.output.files.OutputFolder;
import particles.output.report.Report.Section;
import particles.view.Axis;
import particles.view.Chart;
import particles.view.DataTable;
import particles.view.Look;
import particles.view.Panel;
import particles.view.Series;
import particles.view.Series.Mark;

class ReportTest {
    private static final String NASTY = "A \"chain\" <b>&amp; co</b> ]]> \u0001 \ud83d\ude80 \u03c9\u00b2";
    private static final DataTable COST = new DataTable("cost", "What it costs",
            List.of(DataTable.column("solver <name>"),
            DataTable.column("error (m)"), DataTable.column("evaluations")),
            List.of(List.of("rk4 & co", 1.23456789e-7, 400L), List.of("euler", Double.NaN, 12_345_678L)));

    @TempDir
    static Path top;

    private static String html;
    private static Xml page;

    @BeforeAll
    static void write() throws IOException, SAXException, ParserConfigurationException {
        Axis height = Axis.linear("height", "m");
        Panel chart = Panel.of("falls", List.of(new Chart(Axis.TIME, height, List.of(new Series(Look.OWN, NASTY,
                Mark.LINE, new double[] {0, 0.5}, new double[] {1, -0.25}).ending(height)))));
        DataTable many = new DataTable("costs", "All", List.of(DataTable.column("n")),
                Collections.nCopies(200, List.of((Object) 7)));
        ResultPage fall = new ResultPage("fall", NASTY, List.of("First.", NASTY),
                List.of(Picture.of("height", NASTY, chart), Picture.made("animation.gif", "It moves.")),
                List.of(COST, many));
        List<Section> sections = new ArrayList<>();
        for (String name : List.of("fall", "fallToo")) {
            Path made = top.resolve(name);
            try (OutputFolder folder = OutputFolder.open(made)) {
                fall.write(folder, ChartFormat.PAGE);
                try (OutputFile gif = folder.create("animation.gif")) {
                    gif.write(new byte[] {'G', 'I', 'F', 1, 2, 3, 4});
                    gif.commit();
                }
            }
            sections.add(new Section(name, "Falls.", made, Optional.of(fall), Optional.empty()));
        }
        sections.add(new Section("jump", "Jumps.", top, Optional.empty(), Optional.of("a < b\nand so on")));
        try (OutputFolder folder = OutputFolder.open(top.resolve("report"))) {
            new Report(NASTY, List.of(NASTY), sections, "The end.").write(folder, "report.html");
        }
        html = Files.readString(top.resolve("report/report.html"));
        page = Xml.of(html);
    }

    private static Report withPicture(String file) {
        ResultPage one = new ResultPage("one", "One", List.of(), List.of(Picture.made(file, "It moves.")), List.of());
        Section section = new Section("one", "Moves.", top, Optional.of(one), Optional.empty());
        return new Report("One", List.of(), List.of(section), "The end.");
    }

    /** The report is not held in memory as a whole: it reaches the disk in pieces of a buffer. */
    @Test
    void aLargePictureIsWrittenInPieces() throws IOException {
        Files.write(top.resolve("large.gif"), new byte[300_000]);
        AtomicInteger largest = new AtomicInteger();
        Disk counting = file -> new BufferedOutputStream(Disk.REAL.create(file), 1) {
            @Override
            public synchronized void write(byte[] bytes, int offset, int length) throws IOException {
                largest.accumulateAndGet(length, Math::max);
                super.write(bytes, offset, length);
            }
        };
        try (OutputFolder folder = OutputFolder.open(top.resolve("pieces"), counting)) {
            withPicture("large.gif").write(folder, "report.html");
        }
        assertTrue(Files.size(top.resolve("pieces/report.html")) > 400_000);
        assertTrue(largest.get() <= 1 << 16, "a piece of " + largest + " bytes");
    }

    @Test
    void aPictureThatCannotBeReadIsNamedAndNoReportIsLeft() {
        try (OutputFolder folder = OutputFolder.open(top.resolve("broken"))) {
            Report report = withPicture("gone.gif");
            OutputException failure = assertThrows(OutputException.class,
                    () -> report.write(folder, "report.html"));
            assertEquals(top.resolve("gone.gif"), failure.getFile());
        }
        assertFalse(Files.exists(top.resolve("broken/report.html")));
    }

    /** Parsing as XML in {@link #write} is the first half; the parser does see what is wrong. */
    @Test
    void pageIsWellFormed() {
        assertEquals(1, page.all("/html").size());
        assertThrows(SAXException.class, () -> Xml.of(html.replaceFirst("</section>", "")));
        assertEquals("<!DOCTYPE html>", html.lines().findFirst().orElseThrow());
        // in HTML only these may be written as <tag/>
        assertEquals(Set.of("meta", "img"), Pattern.compile("<(\\w+)[^<>]*/>").matcher(html).results()
                .map(closed -> closed.group(1)).collect(Collectors.toSet()));
        // what a browser reads as it stands has nothing that XML would read otherwise
        for (String raw : List.of(ReportStyle.CSS, ReportStyle.SCRIPT)) {
            assertFalse(raw.contains("<") || raw.contains("&") || raw.contains("]]>"));
        }
    }

    @Test
    void everythingIsInside() throws IOException {
        List<String> images = page.all("//img[normalize-space(@alt)]/@src");
        assertEquals(List.of(4, 4), List.of(page.all("//img").size(), images.size()));
        images.forEach(image -> assertStarts(image, "data:image/gif;base64,"));
        String chart = images.get(0);
        assertSamePicture(Files.readAllBytes(top.resolve("fall/height.png")),
                Base64.getDecoder().decode(chart.substring(chart.indexOf(',') + 1)));
        assertStarts(images.get(1), "data:image/gif;base64,R0lG");
        String text = html.replaceAll("base64,[^\"]*", "");
        assertFalse(text.contains("http:") || text.contains("https:") || text.contains("//") || text.contains("@import")
                || text.contains("url("), "no link leads out");
        assertEquals(List.of(), page.all("//link | //iframe | //script[@src]"));
    }

    /** A chart of at most 256 colours, as this one, stays the same; the file is smaller: measured, 0.42 of the size. */
    private static void assertSamePicture(byte[] file, byte[] embedded) throws IOException {
        BufferedImage expected = ImageIO.read(new ByteArrayInputStream(file));
        BufferedImage actual = ImageIO.read(new ByteArrayInputStream(embedded));
        assertEquals(expected.getWidth(), actual.getWidth());
        assertEquals(expected.getHeight(), actual.getHeight());
        IntSummaryStatistics off = differences(pixels(expected), pixels(actual));
        assertEquals(0, off.getMax(), off.toString());
        assertBelow(0.5 * file.length, embedded.length);
    }

    private static int[] pixels(BufferedImage image) {
        return image.getRGB(0, 0, image.getWidth(), image.getHeight(), null, 0, image.getWidth());
    }

    @Test
    void contentsLeadToTheSectionsAndIdsAreUnique() {
        List<String> ids = page.all("//@id");
        assertEquals(3 + 2 * 2 + 2 * 2, ids.size(), "sections, figures and tables have one");
        assertEquals(ids.size(), Set.copyOf(ids).size(), ids.toString());
        List<String> links = page.all("//a/@href");
        assertEquals(3, links.size());
        links.forEach(link -> assertTrue(ids.contains(link.substring(1)), link));
    }

    /** Once in a table below the chart: its quantity, the names of its lines, and their numbers. */
    @Test
    void numbersAtTheEndsOfLinesStandBelowTheChart() {
        String table = "//section[1]//table[@class='ends']";
        assertEquals(List.of("height (m)", NASTY.replace('\u0001', '\ufffd')), page.all(table + "//th"));
        assertEquals(List.of("-0.25 m"), page.all(table + "//td"));
    }

    /** One landmark for the whole page, and commands that a browser does not break at their hyphens. */
    @Test
    void thePageHasALandmarkAndWholeCommands() {
        assertEquals(3, page.all("/html/body/main/section").size());
        assertEquals("gradle fall", page.all("//span[@class='command']").get(0));
        assertHas(ReportStyle.CSS, ".command { white-space: nowrap; }");
    }

    /** A control character may not be in a page, in whatever form. */
    @Test
    void textIsEscaped() {
        String shown = NASTY.replace('\u0001', '\ufffd');
        for (String place : List.of("//title", "//h1", "//section[1]/h2", "//section[1]//figure[1]//img/@alt")) {
            assertEquals(shown, page.one(place), place);
        }
        assertEquals(List.of(), page.all("//b"));
        assertEquals("solver <name>", page.all("//th[button]").get(0));
    }

    @Test
    void tablesHaveTheNumbersOfTheRecords() {
        String table = "(//table[@id])[1]";
        assertEquals(List.of("error (m)", "evaluations"), page.all(table + "//th[@class = 'number']"));
        assertEquals(3, page.all(table + "//th[count(.//button) = 1]").size(), "to sort by");
        assertEquals(List.of("rk4 & co", "1.235e-7", "400", "euler", "\u2013", "12345678"), page.all(table + "//td"));
        List<String> values = page.all(table + "//td/@data-value");
        assertEquals(List.of(1.23456789e-7, 400.0, Double.NaN, 12345678.0),
                values.stream().map(Double::valueOf).toList());
        assertEquals("12345678", values.get(3));
        assertEquals(1, page.all(table + "//thead").size());
        assertEquals("All 200 rows, also in costs.csv", page.all("//details/summary").get(0));
        assertEquals(201, page.all("(//details)[1]//tr").size());
        String script = page.all("//script").get(0);
        assertHas(script, "th button", "dataset.value", "aria-sort");
    }

    /** Of a film there is nothing to print. */
    @Test
    void animationsAreNotPrinted() {
        assertEquals(List.of("animation", "animation"), page.all("//figure[contains(@id, '.gif')]/@class"));
        assertEquals(List.of(), page.all("//figure[not(contains(@id, '.gif'))]/@class"));
        assertHas(ReportStyle.CSS, "figure.animation { display: none; }");
    }

    @Test
    void whatFailedIsWrittenAsSuch() {
        assertEquals("could not be made", page.one("//section[3]//h2"));
        assertEquals("a < b\nand so on", page.all("//section[3]//p").get(1));
        assertHas(page.all("//li").get(2), "could not be made");
        assertEquals(2, page.all("//section[2]//figure").size(), "the others stand");
    }
}
