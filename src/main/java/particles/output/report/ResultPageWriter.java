package particles.output.report;

import java.util.ArrayList;
import java.util.List;
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
        writeLines(folder, page.name() + ".md", markdown(laidOut));
        return laidOut;
    }

    private static List<String> markdown(ResultPage page) {
        List<String> lines = new ArrayList<>(List.of("# " + page.title()));
        for (String paragraph : page.text()) {
            lines.addAll(List.of("", paragraph));
        }
        for (Picture picture : page.pictures()) {
            lines.addAll(List.of("", "![" + picture.caption() + "](" + picture.file() + ")", "", picture.caption()
                    + (picture.data().isEmpty() ? "" : " Its numbers: [%1$s.csv](%1$s.csv)."
                            .formatted(picture.name()))));
        }
        for (DataTable table : page.tables()) {
            lines.addAll(List.of("", "## " + table.title(), ""));
            String link = "[" + table.name() + ".csv](" + table.name() + ".csv).";
            if (table.rows().size() > MOST_ROWS) {
                lines.add("All " + table.rows().size() + " rows: " + link);
            } else {
                lines.addAll(TableText.markdown(table));
                lines.addAll(List.of("", "With all digits: " + link));
            }
        }
        return lines;
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
