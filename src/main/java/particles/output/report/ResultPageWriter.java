package particles.output.report;

import com.samskivert.mustache.Template;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import particles.output.charts.ChartFormat;
import particles.output.charts.ChartWriter;
import particles.output.files.Numbers;
import particles.output.files.OutputException;
import particles.output.files.OutputFolder;
import particles.output.files.TrajectoryWriter;
import particles.output.text.TableText;
import particles.view.ChartData;
import particles.view.DataTable;

/**
 * Writes the results of an experiment: each picture with its numbers, each table, and a page that explains them.
 */
public final class ResultPageWriter {
    /** A table with more rows is only written as CSV. */
    private static final int MOST_ROWS = 100;
    private static final String PAGE = """
            # {{{title}}}
            {{#text}}

            {{{.}}}
            {{/text}}
            {{#pictures}}

            ![{{{caption}}}]({{file}})

            {{{caption}}}{{^data.isEmpty}} Its numbers: [{{name}}.csv]({{name}}.csv).{{/data.isEmpty}}
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

    private ResultPageWriter() {
    }

    /**
     * Writes PICTURE.png and PICTURE.csv for each picture, TABLE.csv for each table, and NAME.md.
     *
     * @param folder the output folder
     * @param page   the results
     * @param format the format of the pictures
     * @return the page as written, in which pictures with too many curves are split
     * @throws OutputException if something cannot be written
     */
    public static ResultPage write(OutputFolder folder, ResultPage page, ChartFormat format) {
        ResultPage laidOut = page.laidOut(format);
        try (ChartWriter writer = new ChartWriter(folder, format)) {
            for (Picture picture : laidOut.pictures()) {
                picture.page(format).ifPresent(drawn -> writer.write(picture.file(), drawn));
                if (!picture.data().isEmpty()) {
                    writeLines(folder, picture.name() + ".csv", points(picture.data()));
                }
            }
        }
        for (DataTable table : page.tables()) {
            writeLines(folder, table.name() + ".csv", TableText.csv(table));
        }
        folder.write(page.name() + ".md", MARKDOWN.execute(Map.of("title", page.title(), "text", page.text(),
                "pictures", laidOut.pictures(), "tables", page.tables().stream()
                .map(table -> new TableView(table, MOST_ROWS)).toList())));
        return laidOut;
    }

    /** The lines of a CSV file with the points of all series below each other. */
    private static List<String> points(List<ChartData> charts) {
        List<String> lines = new ArrayList<>(List.of("chart,series,x quantity,x,y quantity,y"));
        for (ChartData chart : charts) {
            for (ChartData.Series series : chart.series()) {
                for (int k = 0; k < series.x().length; k++) {
                    lines.add(Stream.of(chart.title(), series.name(), chart.xLabel(), Numbers.shortest(series.x()[k]),
                            chart.yLabel(), Numbers.shortest(series.y()[k])).map(TrajectoryWriter::quoted)
                            .collect(Collectors.joining(",")));
                }
            }
        }
        return lines;
    }

    static void writeLines(OutputFolder folder, String name, List<String> lines) {
        folder.write(name, String.join("\n", lines) + "\n");
    }
}
