package particles.output.report;

import deSolvers.text.Digits;
import java.math.BigDecimal;
import java.math.MathContext;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Optional;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import particles.output.files.Numbers;
import particles.output.files.TrajectoryWriter;
import particles.view.DataTable;

/** Tables as text: for the screen, for Markdown, and with all digits as CSV. */
public final class TableText {
    /** The beginning of a text that a spreadsheet takes for a formula, which may do harm. */
    private static final String FORMULA = "^(?=[=@\\t]|[+-](?![\\d.eE+-]*$))";

    private TableText() {
    }

    /**
     * @param table a table
     * @return its lines: columns below each other, numbers to the right
     */
    public static List<String> plain(DataTable table) {
        List<String> lines = new ArrayList<>(Collections.nCopies(table.rows().size() + 1, ""));
        for (int c = 0; c < table.columns().size(); c++) {
            int column = c;
            List<String> cells = Stream.concat(Stream.of(table.columns().get(c).name()),
                    table.rows().stream().map(row -> text(table, row, column))).toList();
            int width = cells.stream().mapToInt(String::length).max().orElse(0);
            String format = (c == 0 ? "%s" : "%s  ") + (isNumbers(table, c) ? "%" : "%-") + width + "s";
            for (int r = 0; r < cells.size(); r++) {
                lines.set(r, format.formatted(lines.get(r), cells.get(r)));
            }
        }
        lines.replaceAll(String::stripTrailing);
        return lines;
    }

    /** @return a header and a line each row, as RFC 4180 says */
    public static List<String> csv(DataTable table) {
        List<String> lines = new ArrayList<>();
        lines.add(line(table.columns().stream().map(DataTable.Column::name)));
        table.rows().forEach(row -> lines.add(line(row.stream().map(cell -> cell instanceof Double d
                ? Numbers.shortest(d) : cell.toString().replaceFirst(FORMULA, "'")))));
        return lines;
    }

    /** @return a line of a CSV file */
    static String line(Stream<String> cells) {
        return cells.map(TrajectoryWriter::quoted).collect(Collectors.joining(","));
    }

    private static boolean isNumbers(DataTable table, int column) {
        return table.rows().stream().anyMatch(row -> row.get(column) instanceof Number);
    }

    /** @return a row's cell in a column, as people read it */
    public static String text(DataTable table, List<Object> row, int column) {
        if (!(row.get(column) instanceof Double value)) {
            return row.get(column).toString();
        }
        if (value.isNaN()) {
            return "\u2013";
        }
        if (value.isInfinite()) {
            return value > 0 ? "\u221e" : "\u2212\u221e";
        }
        return Digits.exact(BigDecimal.valueOf(value).round(new MathContext(table.columns().get(column).digits())));
    }

    /**
     * A table as the templates of pages see it.
     *
     * @param table    the table
     * @param mostRows a table with more rows is long
     */
    record TableView(DataTable table, int mostRows) {
        /** A column's name, and whether it has numbers. */
        record Head(String text, boolean number) {
        }

        /** A cell for people, and the value of a number with all digits. */
        record Cell(String text, Optional<Object> value) {
        }

        boolean isLong() {
            return table.rows().size() > mostRows;
        }

        List<Head> heads() {
            return IntStream.range(0, table.columns().size()).mapToObj(c ->
                    new Head(table.columns().get(c).name(), TableText.isNumbers(table, c))).toList();
        }

        List<List<Cell>> rows() {
            return table.rows().stream().map(row -> IntStream.range(0, row.size()).mapToObj(c -> new Cell(
                    TableText.text(table, row, c), Optional.of(row.get(c)).filter(Number.class::isInstance)))
                    .toList()).toList();
        }
    }
}
