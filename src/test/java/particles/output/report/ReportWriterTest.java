package particles.output.report;

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
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Base64;
import java.util.Collections;
import java.util.HashSet;
import java.util.IntSummaryStatistics;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.atomic.AtomicInteger;
import javax.imageio.ImageIO;
import javax.xml.parsers.DocumentBuilder;
import javax.xml.parsers.DocumentBuilderFactory;
import javax.xml.parsers.ParserConfigurationException;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.w3c.dom.Document;
import org.w3c.dom.Element;
import org.w3c.dom.NodeList;
import org.xml.sax.SAXException;
import particles.output.charts.ChartFormat;
import particles.output.charts.Panel;
import particles.output.files.OutputException;
import particles.output.files.OutputFile;
import particles.output.files.OutputFolder;
import particles.output.report.Report.Section;
import particles.view.ChartData;
import particles.view.ChartData.Mark;
import particles.view.ChartData.Series;
import particles.view.DataTable;

class ReportWriterTest {
    private static final String NASTY = "A \"chain\" <b>&amp; co</b> ]]> \u0001 \ud83d\ude80 \u03c9\u00b2";
    private static final DataTable COST = new DataTable("cost", "What it costs",
            List.of(DataTable.column("solver <name>"),
            DataTable.column("error (m)"), DataTable.column("evaluations")),
            List.of(List.of("rk4 & co", 1.23456789e-7, 400L), List.of("euler", Double.NaN, 12_345_678L)));

    @TempDir
    static Path top;

    private static String html;
    private static Document page;

    @BeforeAll
    static void write() throws IOException, SAXException, ParserConfigurationException {
        ChartData chart = new ChartData("falls", "time (s)", "height (m)", false, false,
                List.of(new Series("ball", Mark.LINE, new double[] {0, 0.5}, new double[] {1, -0.25})));
        DataTable many = new DataTable("costs", "All", List.of(DataTable.column("n")),
                Collections.nCopies(200, List.of((Object) 7)));
        ResultPage fall = new ResultPage("fall", NASTY, List.of("First.", NASTY),
                List.of(Picture.of("height", NASTY, Panel.chart(chart)), Picture.made("animation.gif", "It moves.")),
                List.of(COST, many));
        List<Section> sections = new ArrayList<>();
        for (String name : List.of("fall", "fallToo")) {
            Path made = top.resolve(name);
            try (OutputFolder folder = OutputFolder.open(made)) {
                ResultPageWriter.write(folder, fall, ChartFormat.PAGE);
                try (OutputFile gif = folder.create("animation.gif")) {
                    gif.write(new byte[] {'G', 'I', 'F', 1, 2, 3, 4});
                    gif.commit();
                }
            }
            sections.add(new Section(name, "Falls.", made, 1.5, Optional.of(fall), Optional.empty()));
        }
        sections.add(new Section("jump", "Jumps.", top, 0, Optional.empty(), Optional.of("a < b\nand so on")));
        try (OutputFolder folder = OutputFolder.open(top.resolve("report"))) {
            ReportWriter.write(folder, "report.html", new Report(NASTY, List.of(NASTY), sections, "The end."));
        }
        html = Files.readString(top.resolve("report/report.html"));
        page = parse(html);
    }

    private static Report withPicture(String file) {
        ResultPage one = new ResultPage("one", "One", List.of(), List.of(Picture.made(file, "It moves.")), List.of());
        Section section = new Section("one", "Moves.", top, 1, Optional.of(one), Optional.empty());
        return new Report("One", List.of(), List.of(section), "The end.");
    }

    /** The report is not held in memory as a whole: it reaches the disk in pieces of a buffer. */
    @Test
    void aLargePictureIsWrittenInPieces() throws IOException {
        Files.write(top.resolve("large.gif"), new byte[300_000]);
        AtomicInteger largest = new AtomicInteger();
        OutputFile.Opener counting = file -> new BufferedOutputStream(OutputFile.ON_DISK.open(file), 1) {
            @Override
            public void write(byte[] bytes, int offset, int length) throws IOException {
                largest.accumulateAndGet(length, Math::max);
                super.write(bytes, offset, length);
            }
        };
        try (OutputFolder folder = OutputFolder.open(top.resolve("pieces"), counting)) {
            ReportWriter.write(folder, "report.html", withPicture("large.gif"));
        }
        assertTrue(Files.size(top.resolve("pieces/report.html")) > 400_000);
        assertTrue(largest.get() <= 1 << 16, "a piece of " + largest + " bytes");
    }

    @Test
    void aPictureThatCannotBeReadIsNamedAndNoReportIsLeft() {
        try (OutputFolder folder = OutputFolder.open(top.resolve("broken"))) {
            Report report = withPicture("gone.gif");
            OutputException failure = assertThrows(OutputException.class,
                    () -> ReportWriter.write(folder, "report.html", report));
            assertEquals(top.resolve("gone.gif"), failure.getFile());
        }
        assertFalse(Files.exists(top.resolve("broken/report.html")));
    }

    private static Document parse(String text) throws IOException, SAXException, ParserConfigurationException {
        DocumentBuilder builder = DocumentBuilderFactory.newInstance().newDocumentBuilder();
        builder.setErrorHandler(null);
        return builder.parse(new ByteArrayInputStream(text.getBytes(StandardCharsets.UTF_8)));
    }

    private static List<Element> all(String tag) {
        return all(page.getDocumentElement(), tag);
    }

    private static List<Element> all(Element in, String tag) {
        List<Element> found = new ArrayList<>();
        NodeList nodes = in.getElementsByTagName(tag);
        for (int k = 0; k < nodes.getLength(); k++) {
            found.add((Element) nodes.item(k));
        }
        return found;
    }

    /** Parsing as XML in {@link #write} is the first half; the parser does see what is wrong. */
    @Test
    void pageIsWellFormed() {
        assertEquals("html", page.getDocumentElement().getTagName());
        assertThrows(SAXException.class, () -> parse(html.replaceFirst("</section>", "")));
        assertEquals("<!DOCTYPE html>", html.lines().findFirst().orElseThrow());
        // in HTML only these may be written as <tag/>
        Set<String> closed = new HashSet<>();
        java.util.regex.Matcher matcher = java.util.regex.Pattern.compile("<(\\w+)[^<>]*/>").matcher(html);
        while (matcher.find()) {
            closed.add(matcher.group(1));
        }
        assertEquals(Set.of("meta", "img"), closed);
        // what a browser reads as it stands has nothing that XML would read otherwise
        for (String raw : List.of(ReportStyle.CSS, ReportStyle.SCRIPT)) {
            assertFalse(raw.contains("<") || raw.contains("&") || raw.contains("]]>"));
        }
    }

    @Test
    void everythingIsInside() throws IOException {
        List<Element> images = all("img");
        assertEquals(4, images.size());
        for (Element image : images) {
            assertStarts(image.getAttribute("src"), "data:image/");
            assertFalse(image.getAttribute("alt").isBlank());
        }
        String png = images.get(0).getAttribute("src");
        assertStarts(png, "data:image/png;base64,");
        assertSamePicture(Files.readAllBytes(top.resolve("fall/height.png")),
                Base64.getDecoder().decode(png.substring(png.indexOf(',') + 1)));
        assertStarts(images.get(1).getAttribute("src"), "data:image/gif;base64,R0lG");
        String text = html.replaceAll("base64,[^\"]*", "");
        assertFalse(text.contains("http:") || text.contains("https:") || text.contains("//") || text.contains("@import")
                || text.contains("url("), "no link leads out");
        assertTrue(all("link").isEmpty() && all("iframe").isEmpty());
        for (Element script : all("script")) {
            assertFalse(script.hasAttribute("src"));
        }
    }

    /** 16 shades from 0 to 255 are 17 apart: none is off by more than 8. And the file is smaller: measured, 0.24. */
    private static void assertSamePicture(byte[] file, byte[] embedded) throws IOException {
        BufferedImage expected = ImageIO.read(new ByteArrayInputStream(file));
        BufferedImage actual = ImageIO.read(new ByteArrayInputStream(embedded));
        assertEquals(expected.getWidth(), actual.getWidth());
        assertEquals(expected.getHeight(), actual.getHeight());
        IntSummaryStatistics off = differences(pixels(expected), pixels(actual));
        assertTrue(off.getMax() <= 8, off.toString());
        assertTrue(embedded.length < 0.5 * file.length, embedded.length + " of " + file.length);
    }

    private static int[] pixels(BufferedImage image) {
        return image.getRGB(0, 0, image.getWidth(), image.getHeight(), null, 0, image.getWidth());
    }

    @Test
    void contentsLeadToTheSectionsAndIdsAreUnique() {
        Set<String> ids = new HashSet<>();
        for (Element element : all("*")) {
            if (element.hasAttribute("id")) {
                assertTrue(ids.add(element.getAttribute("id")), "twice: " + element.getAttribute("id"));
            }
        }
        assertEquals(3 + 2 * 2 + 2 * 2, ids.size(), "sections, figures and tables have one");
        List<Element> links = all("a");
        assertEquals(3, links.size());
        links.forEach(link -> assertTrue(ids.contains(link.getAttribute("href").substring(1)),
                link.getAttribute("href")));
    }

    /** A control character may not be in a page, in whatever form. */
    @Test
    void textIsEscaped() {
        String shown = NASTY.replace('\u0001', '\ufffd');
        assertEquals(shown, all("title").get(0).getTextContent());
        assertEquals(shown, all("h1").get(0).getTextContent());
        assertEquals(shown, all(all("section").get(0), "h2").get(0).getTextContent());
        assertEquals(shown, all("img").get(0).getAttribute("alt"));
        assertTrue(all("b").isEmpty());
        assertEquals("solver <name>", all("th").get(0).getTextContent());
    }

    @Test
    void tablesHaveTheNumbersOfTheRecords() {
        Element table = all("table").get(0);
        List<Element> heads = all(table, "th");
        assertEquals(List.of("", "number", "number"), heads.stream().map(head -> head.getAttribute("class")).toList());
        heads.forEach(head -> assertEquals(1, all(head, "button").size(), "to sort by"));
        List<Element> cells = all(table, "td");
        assertEquals(List.of("rk4 & co", "1.235e-7", "400", "euler", "\u2013", "12345678"),
                cells.stream().map(Element::getTextContent).toList());
        assertEquals(1.23456789e-7, Double.parseDouble(cells.get(1).getAttribute("data-value")));
        assertEquals("12345678", cells.get(5).getAttribute("data-value"));
        assertTrue(Double.isNaN(Double.parseDouble(cells.get(4).getAttribute("data-value"))));
        assertEquals(1, all(table, "thead").size());
        Element details = all("details").get(0);
        assertEquals("All 200 rows", all(details, "summary").get(0).getTextContent());
        assertEquals(201, all(details, "tr").size());
        String script = all("script").get(0).getTextContent();
        assertHas(script, "th button", "data-value", "aria-sort");
    }

    /**
     * A long table has no lone heading on paper: what hides it hides the heading too, and a sentence stands for both.
     */
    @Test
    void longTablesAreNotPrintedButNamed() {
        Element section = all("section").get(0);
        Element folded = all(section, "div").stream().filter(div -> div.getAttribute("class").equals("folded"))
                .findFirst()
                .orElseThrow();
        assertEquals(List.of("All"), all(folded, "h3").stream().map(Element::getTextContent).toList());
        assertEquals(2, all(section, "h3").size(), "the short table's stands alone");
        Element note = all(section, "p").stream().filter(p -> p.getAttribute("class").equals("printed")).findFirst()
                .orElseThrow();
        assertEquals("Not printed: All; 200 rows, in costs.csv.", note.getTextContent());
        String print = ReportStyle.CSS.substring(ReportStyle.CSS.indexOf("@media print"));
        assertHas(print, ".folded { display: none; }", ".printed { display: block; }");
    }

    /** A chart is as wide as charts are; of a film there is nothing to print. */
    @Test
    void onlyPicturesOfManyPartsHaveASheet() throws IOException {
        assertEquals(List.of("", "animation", "", "animation"),
                all("figure").stream().map(figure -> figure.getAttribute("class")).toList());
        try (OutputFolder folder = OutputFolder.open(top.resolve("wide"))) {
            ChartData chart = new ChartData("falls", "time (s)", "height (m)", false, false, List.of());
            ResultPage panels = new ResultPage("wide", "Wide", List.of(),
                    List.of(Picture.panels("many", "Many.", "Many",
                    Collections.nCopies(2, Panel.chart(chart)))), List.of());
            ResultPageWriter.write(folder, panels, ChartFormat.PAGE);
            ReportWriter.write(folder, "report.html",
                    new Report("Wide", List.of(), List.of(new Section("wide", "Is wide.",
                    top.resolve("wide"), 1, Optional.of(panels), Optional.empty())), "The end."));
        }
        assertHas(Files.readString(top.resolve("wide/report.html")), "class=\"whole\"");
    }

    @Test
    void whatFailedIsWrittenAsSuch() {
        Element jump = all("section").get(2);
        assertEquals("could not be made", all(jump, "h2").get(0).getTextContent());
        assertEquals("a < b\nand so on", all(jump, "p").get(1).getTextContent());
        assertHas(all("li").get(2).getTextContent(), "could not be made");
        assertTrue(all(all("section").get(1), "figure").size() == 2, "the others stand");
    }
}
