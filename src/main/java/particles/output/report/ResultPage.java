package particles.output.report;

import com.samskivert.mustache.Template;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.stream.Stream;
import particles.output.charts.ChartFormat;
import particles.output.charts.ChartWriter;
import particles.output.files.Numbers;
import particles.output.files.OutputException;
import particles.output.files.OutputFolder;
import particles.output.report.TableText.TableView;
import particles.view.DataTable;
import particles.view.Panel;

/**
 * The results of an experiment: pictures, and the numbers behind them.
 *
 * @param name     the name of its task and folder, such as {@code workPrecision}
 * @param title    what was measured
 * @param text     paragraphs that explain the pictures
 * @param pictures the pictures
 * @param tables   the tables, the main one first
 */
public record ResultPage(String name, String title, List<String> text, List<Picture> pictures, List<DataTable> tables) {
    /** A table with more rows is only written as CSV. */
    private static final int MOST_ROWS = 100;
    private static final String PAGE = """
            # {{{title}}}
            {{#text}}

            {{{.}}}
            {{/text}}
            {{#pictures}}

            ![{{{caption}}}]({{file}})

            {{{caption}}}{{#hasData}} Its numbers: [{{name}}.csv]({{name}}.csv).{{/hasData}}
            {{#answers}}

            {{{title}}}: {{{answer}}}
            {{/answers}}
            {{#ends}}

            | {{quantity}} |{{#curves}} {{name}} |{{/curves}}
            | --- |{{#curves}} ---: |{{/curves}}
            | |{{#curves}} {{end}} |{{/curves}}
            {{/ends}}
            {{/pictures}}
            {{#tables}}

            ## {{{table.title}}}

            {{#long}}
            All {{rows.size}} rows: [{{table.name}}.csv]({{table.name}}.csv).
            {{/long}}
            {{^long}}
            |{{#heads}} {{text}} |{{/heads}}
            |{{#heads}} ---{{#number}}:{{/number}} |{{/heads}}
            {{#rows}}
            |{{#.}} {{text}} |{{/.}}
            {{/rows}}

            With all digits: [{{table.name}}.csv]({{table.name}}.csv).
            {{/long}}
            {{/tables}}
            """;

    private static final Template MARKDOWN = Html.TEMPLATES.withEscaper(text -> text.replace("|", "\\|")).compile(PAGE);

    /**
     * @param format the format of the pictures
     * @return the page with pictures that have no more curves and charts than the format allows
     */
    public ResultPage laidOut(ChartFormat format) {
        return new ResultPage(name, title, text, pictures.stream().flatMap(picture -> picture.laidOut(format).stream())
                .toList(), tables);
    }

    /**
     * Writes PICTURE.png and PICTURE.csv for each picture, TABLE.csv for each table, and NAME.md.
     *
     * @param folder the output folder
     * @param format the format of the pictures
     * @return the page as written, in which pictures with too many curves are split
     * @throws OutputException if something cannot be written
     */
    public ResultPage write(OutputFolder folder, ChartFormat format) {
        ResultPage laidOut = laidOut(format);
        try (ChartWriter writer = new ChartWriter(folder, format)) {
            for (Picture picture : laidOut.pictures()) {
                picture.page(format).ifPresent(drawn -> writer.write(picture.file(), drawn));
                if (picture.hasData()) {
                    writeLines(folder, picture.name() + ".csv", points(picture.panels()));
                }
            }
        }
        for (DataTable table : tables) {
            writeLines(folder, table.name() + ".csv", TableText.csv(table));
        }
        folder.write(name + ".md", MARKDOWN.execute(Map.of("title", title, "text", text, "pictures", laidOut.pictures(),
                "tables", tables.stream().map(table -> new TableView(table, MOST_ROWS)).toList())));
        return laidOut;
    }

    /** The lines of a CSV file with the points of all series below each other. */
    private static List<String> points(List<Panel> panels) {
        List<String> lines = new ArrayList<>(List.of("chart,series,x quantity,x,y quantity,y"));
        panels.forEach(panel -> panel.charts().forEach(chart -> chart.series().forEach(series -> {
            for (int k = 0; k < series.x().length; k++) {
                lines.add(TableText.line(Stream.of(panel.title(), series.name(), chart.x().label(),
                        Numbers.shortest(series.x()[k]), chart.y().label(), Numbers.shortest(series.y()[k]))));
            }
        })));
        return lines;
    }

    private static void writeLines(OutputFolder folder, String name, List<String> lines) {
        folder.write(name, String.join("\n", lines) + "\n");
    }
}
