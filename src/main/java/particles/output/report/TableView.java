package particles.output.report;

import java.util.List;
import java.util.Optional;
import java.util.stream.IntStream;
import particles.output.text.TableText;
import particles.view.DataTable;

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
