package particles.view;

import java.util.List;

/**
 * A table of results, apart from how it is shown: files get all digits, people as many as mean something.
 *
 * @param name    what its file is called, such as {@code slopes}
 * @param title   what it lists
 * @param columns what stands in each column
 * @param rows    a cell for each column: a text, a whole number ({@code Integer}, {@code Long}) or a {@code Double}
 */
public record DataTable(String name, String title, List<Column> columns, List<List<Object>> rows) {

    /**
     * One column.
     *
     * @param name   the quantity, with its unit
     * @param digits how many significant digits of a {@code Double} people are shown
     */
    public record Column(String name, int digits) {
    }

    /** @throws IllegalArgumentException if a row has not a cell for each column */
    public DataTable {
        columns = List.copyOf(columns);
        rows = rows.stream().map(List::copyOf).toList();
        for (List<Object> row : rows) {
            if (row.size() != columns.size()) {
                throw new IllegalArgumentException("a row of " + row.size() + " cells in table '" + name + "' of "
                        + columns.size() + " columns");
            }
        }
    }

    /**
     * @param name of a column; four digits of it are shown
     * @return the column
     */
    public static Column column(String name) {
        return new Column(name, 4);
    }
}
