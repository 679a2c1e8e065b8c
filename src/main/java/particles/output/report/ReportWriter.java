package particles.output.report;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.util.Base64;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import particles.output.files.Numbers;
import particles.output.files.OutputException;
import particles.output.files.OutputFile;
import particles.output.files.OutputFolder;
import particles.output.report.Report.Section;
import particles.output.text.TableText;
import particles.view.DataTable;

/**
 * Writes a report as one self-contained HTML page, with pictures, style and script inside. The page is well-formed XML
 * too.
 */
public final class ReportWriter {
    /** A table with more rows is collapsed, and not printed. */
    private static final int MOST_ROWS = 60;
    private final OutputFile file;
    private final Html html = new Html();

    private ReportWriter(OutputFile file) {
        this.file = file;
    }

    /**
     * @param folder the output folder
     * @param name   the name of its file, such as {@code report.html}
     * @param report the report; the pictures are read from the sections' folders
     * @throws OutputException if it cannot be written
     */
    public static void write(OutputFolder folder, String name, Report report) {
        try (OutputFile file = folder.create(name)) {
            new ReportWriter(file).page(report);
            file.commit();
        } catch (IOException e) {
            throw new UncheckedIOException(e);      // of the pictures; the file's own are OutputExceptions
        }
    }

    private void page(Report report) throws IOException {
        put("""
                <!DOCTYPE html>
                <html lang="en">
                <head>
                <meta charset="utf-8"/>
                <meta name="viewport" content="width=device-width, initial-scale=1"/>
                <title>%s</title>
                <style>
                """, report.title());
        write(ReportStyle.CSS);
        put("</style>\n</head>\n<body>\n<h1>%s</h1>\n", report.title());
        paragraphs(report.text());
        Map<Section, String> ids = new LinkedHashMap<>();
        report.sections().forEach(section -> ids.put(section, html.id(section.name())));
        put("<nav>\n<h2>Contents</h2>\n<ol>\n");
        for (Section section : report.sections()) {
            put("<li><a href=\"#%s\">%s</a>: %s</li>\n", ids.get(section), section.name(), finding(section));
        }
        put("</ol>\n</nav>\n");
        for (Section section : report.sections()) {
            section(section, ids.get(section));
        }
        put("<footer><p>%s</p></footer>\n<script>\n", report.end());
        write(ReportStyle.SCRIPT);
        put("</script>\n</body>\n</html>\n");
    }

    private static String finding(Section section) {
        return section.page().map(ResultPage::title).orElse("could not be made");
    }

    private void section(Section section, String id) throws IOException {
        put("""
                <section id="%s">
                <p class="task">gradle %s: %s</p>
                <h2>%s</h2>
                """, id, section.name(), section.purpose(), finding(section));
        section.failure().ifPresent(failure -> put("<p class=\"failure\">%s</p>\n", failure));
        if (section.page().isPresent()) {
            ResultPage page = section.page().get();
            paragraphs(page.text());
            for (Picture picture : page.pictures()) {
                if (!picture.repeated()) {
                    figure(section, picture);
                }
            }
            for (DataTable table : page.tables()) {
                table(section, table);
            }
        }
        put("</section>\n");
    }

    private void figure(Section section, Picture picture) throws IOException {
        byte[] bytes = Files.readAllBytes(section.folder().resolve(picture.file()));
        boolean moves = picture.file().endsWith(".gif");
        String kind = moves ? " class=\"animation\"" : picture.panels().size() > 1 ? " class=\"whole\"" : "";
        put("<figure id=\"%s\"" + kind + """
                >
                <div class="scroll"><button type="button" title="larger or smaller"><img alt="%s" \
                src="data:image/%s;base64,""", html.id(section.name() + "-" + picture.name()), picture.caption(),
                moves ? "gif" : "png");
        file.write(Base64.getEncoder().encode(picture.data().isEmpty() ? bytes : SmallImage.of(bytes)));
        put("\"/></button></div>\n<figcaption>%s</figcaption>\n</figure>\n", picture.caption());
    }

    private void table(Section section, DataTable table) {
        int count = table.rows().size();
        boolean isLong = count > MOST_ROWS;
        if (isLong) {
            put("""
                    <p class="printed">Not printed: %s; %s rows, in %s.csv.</p>
                    <div class="folded">
                    """, table.title(), count, table.name());
        }
        put("<h3>%s</h3>\n", table.title());
        if (isLong) {
            put("<details>\n<summary>All %s rows</summary>\n", count);
        }
        put("<div class=\"table\"><table id=\"%s\">\n<thead><tr>", html.id(section.name() + "-" + table.name()));
        for (int c = 0; c < table.columns().size(); c++) {
            put("<th scope=\"col\"" + (TableText.isNumbers(table, c) ? " class=\"number\"" : "")
                    + "><button type=\"button\">%s</button></th>", table.columns().get(c).name());
        }
        put("</tr></thead>\n<tbody>\n");
        List<List<String>> cells = TableText.cells(table);
        for (int r = 0; r < count; r++) {
            put("<tr>");
            for (int c = 0; c < table.columns().size(); c++) {
                cell(table.rows().get(r).get(c), cells.get(r + 1).get(c));
            }
            put("</tr>\n");
        }
        put("</tbody>\n</table></div>\n" + (isLong ? "</details>\n</div>\n" : ""));
    }

    /** A cell with all digits for sorting and a few for reading. */
    private void cell(Object value, String text) {
        if (value instanceof Number number) {
            put("<td class=\"number\" data-value=\"%s\">%s</td>",
                    number instanceof Double d ? Numbers.shortest(d) : number, text);
        } else {
            put("<td class=\"text\">%s</td>", text);
        }
    }

    private void paragraphs(List<String> text) {
        text.forEach(paragraph -> put("<p>%s</p>\n", paragraph));
    }

    private void put(String template, Object... texts) {
        write(Html.fill(template, texts));
    }

    private void write(String html) {
        byte[] bytes = html.getBytes(StandardCharsets.UTF_8);
        file.write(bytes, 0, bytes.length);
    }
}
