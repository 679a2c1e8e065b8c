package particles.output.text;

import deSolvers.text.Digits;
import java.math.BigDecimal;
import java.math.MathContext;
import java.util.ArrayList;
import java.util.List;
import java.util.function.Function;
import java.util.stream.Collectors;
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
        List<List<String>> cells = cells(table);
        int[] widths = new int[table.columns().size()];
        for (List<String> row : cells) {
            for (int c = 0; c < widths.length; c++) {
                widths[c] = Math.max(widths[c], row.get(c).length());
            }
        }
        List<String> lines = new ArrayList<>();
        for (int r = 0; r < cells.size(); r++) {
            StringBuilder line = new StringBuilder();
            for (int c = 0; c < widths.length; c++) {
                String cell = cells.get(r).get(c);
                String gap = " ".repeat(widths[c] - cell.length());
                line.append(c == 0 ? "" : "  ").append(isNumbers(table, c) ? gap + cell : cell + gap);
            }
            lines.add(line.toString().stripTrailing());
        }
        return lines;
    }

    /**
     * @param table a table
     * @return its lines in Markdown
     */
    public static List<String> markdown(DataTable table) {
        List<List<String>> cells = cells(table);
        List<String> lines = new ArrayList<>();
        for (List<String> row : cells) {
            lines.add(row.stream().map(cell -> cell.replace("|", "\\|")).collect(Collectors.joining(" | ", "| ",
                    " |")));
            if (lines.size() == 1) {
                StringBuilder rule = new StringBuilder("|");
                for (int c = 0; c < row.size(); c++) {
                    rule.append(isNumbers(table, c) ? " ---: |" : " --- |");
                }
                lines.add(rule.toString());
            }
        }
        return lines;
    }

    /** @return a header and a line each row, as RFC 4180 says */
    public static List<String> csv(DataTable table) {
        List<String> lines = new ArrayList<>();
        lines.add(line(table.columns(), DataTable.Column::name));
        table.rows().forEach(row -> lines.add(line(row, cell -> cell instanceof Double d ? Numbers.shortest(d)
                : cell.toString().replaceFirst(FORMULA, "'"))));
        return lines;
    }

    private static <T> String line(List<T> cells, Function<T, String> text) {
        return cells.stream().map(text).map(TrajectoryWriter::quoted).collect(Collectors.joining(","));
    }

    /** @return the header, then the rows, as people read them */
    public static List<List<String>> cells(DataTable table) {
        List<List<String>> cells = new ArrayList<>();
        cells.add(table.columns().stream().map(DataTable.Column::name).toList());
        for (List<Object> row : table.rows()) {
            List<String> texts = new ArrayList<>();
            for (int c = 0; c < row.size(); c++) {
                texts.add(text(row.get(c), table.columns().get(c).digits()));
            }
            cells.add(texts);
        }
        return cells;
    }

    /** @return whether all cells of a column are numbers */
    public static boolean isNumbers(DataTable table, int column) {
        return table.rows().stream().anyMatch(row -> row.get(column) instanceof Number);
    }

    private static String text(Object cell, int digits) {
        if (!(cell instanceof Double value)) {
            return cell.toString();
        }
        if (value.isNaN()) {
            return "\u2013";
        }
        if (value.isInfinite()) {
            return value > 0 ? "\u221e" : "\u2212\u221e";
        }
        return Digits.exact(BigDecimal.valueOf(value).round(new MathContext(digits)));
    }
}
