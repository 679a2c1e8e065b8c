package particles.output.report;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.ByteBuffer;
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
    /** The position of the width in a PNG file; the height follows. */
    private static final int PNG_WIDTH = 16;

    /** The width of a picture of one chart (pixels). */
    private static final int WIDE = 1920;

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
        put("<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\"/>\n"
                + "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\"/>\n<title>"
                + Html.escaped(report.title()) + "</title>\n<style>\n" + ReportStyle.CSS
                + "</style>\n</head>\n<body>\n<h1>"
                + Html.escaped(report.title()) + "</h1>\n");
        paragraphs(report.text());
        Map<Section, String> ids = new LinkedHashMap<>();
        report.sections().forEach(section -> ids.put(section, html.id(section.name())));
        put("<nav>\n<h2>Contents</h2>\n<ol>\n");
        for (Section section : report.sections()) {
            put("<li><a href=\"#" + ids.get(section) + "\">" + Html.escaped(section.name()) + "</a>: "
                    + Html.escaped(finding(section)) + "</li>\n");
        }
        put("</ol>\n</nav>\n");
        for (Section section : report.sections()) {
            section(section, ids.get(section));
        }
        put("<footer><p>" + Html.escaped(report.end()) + "</p></footer>\n<script>\n" + ReportStyle.SCRIPT
                + "</script>\n</body>\n</html>\n");
    }

    private static String finding(Section section) {
        return section.page().map(ResultPage::title).orElse("could not be made");
    }

    private void section(Section section, String id) throws IOException {
        put("<section id=\"" + id + "\">\n<p class=\"task\">gradle " + Html.escaped(section.name()) + ": "
                + Html.escaped(section.purpose()) + "</p>\n<h2>" + Html.escaped(finding(section)) + "</h2>\n");
        if (section.failure().isPresent()) {
            put("<p class=\"failure\">" + Html.escaped(section.failure().get()) + "</p>\n");
        }
        if (section.page().isPresent()) {
            ResultPage page = section.page().get();
            paragraphs(page.text());
            for (Picture picture : page.pictures()) {
                if (!picture.isAgain()) {
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
        String caption = Html.escaped(picture.caption());
        String kind = moves ? "\" class=\"animation\">\n" : hasManyParts(bytes) ? "\" class=\"whole\">\n" : "\">\n";
        put("<figure id=\"" + html.id(section.name() + "-" + picture.name()) + kind
                + "<div class=\"scroll\"><button type=\"button\" title=\"larger or smaller\"><img alt=\"" + caption
                + "\" src=\"data:image/" + (moves ? "gif" : "png") + ";base64,");
        file.write(Base64.getEncoder().encode(picture.data().isEmpty() ? bytes : SmallImage.of(bytes)));
        put("\"/></button></div>\n<figcaption>" + caption + "</figcaption>\n</figure>\n");
    }

    /** Whether a picture's text would be too small on half a sheet: wider pictures than a chart, and tall ones. */
    private static boolean hasManyParts(byte[] png) {
        ByteBuffer header = ByteBuffer.wrap(png);
        int width = header.getInt(PNG_WIDTH);
        int height = header.getInt(PNG_WIDTH + Integer.BYTES);
        return width > WIDE || height > width;
    }

    private void table(Section section, DataTable table) {
        boolean isLong = table.rows().size() > MOST_ROWS;
        if (isLong) {
            put("<p class=\"printed\">Not printed: " + Html.escaped(table.title()) + "; " + table.rows().size()
                    + " rows, in " + Html.escaped(table.name()) + ".csv.</p>\n<div class=\"folded\">\n");
        }
        put("<h3>" + Html.escaped(table.title()) + "</h3>\n");
        if (isLong) {
            put("<details>\n<summary>All " + table.rows().size() + " rows</summary>\n");
        }
        put("<div class=\"table\"><table id=\"" + html.id(section.name() + "-" + table.name()) + "\">\n<thead><tr>");
        for (int c = 0; c < table.columns().size(); c++) {
            put("<th scope=\"col\"" + (TableText.isNumbers(table, c) ? " class=\"number\"" : "")
                    + "><button type=\"button\">" + Html.escaped(table.columns().get(c).name()) + "</button></th>");
        }
        put("</tr></thead>\n<tbody>\n");
        List<List<String>> cells = TableText.cells(table);
        for (int r = 0; r < table.rows().size(); r++) {
            StringBuilder row = new StringBuilder("<tr>");
            for (int c = 0; c < table.columns().size(); c++) {
                row.append(cell(table.rows().get(r).get(c), cells.get(r + 1).get(c)));
            }
            put(row.append("</tr>\n").toString());
        }
        put("</tbody>\n</table></div>\n" + (isLong ? "</details>\n</div>\n" : ""));
    }

    /** A cell with all digits for sorting and a few for reading. */
    private static String cell(Object value, String text) {
        if (!(value instanceof Number number)) {
            return "<td class=\"text\">" + Html.escaped(text) + "</td>";
        }
        String all = number instanceof Double d ? Numbers.shortest(d) : number.toString();
        return "<td class=\"number\" data-value=\"" + all + "\">" + Html.escaped(text) + "</td>";
    }

    private void paragraphs(List<String> text) {
        text.forEach(paragraph -> put("<p>" + Html.escaped(paragraph) + "</p>\n"));
    }

    private void put(String text) {
        byte[] bytes = text.getBytes(StandardCharsets.UTF_8);
        file.write(bytes, 0, bytes.length);
    }
}
