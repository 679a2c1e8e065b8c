package particles.view;

import java.util.List;
import java.util.function.Function;
import java.util.stream.IntStream;

/**
 * A table of results, independent of how it is shown: files get all digits, people only the significant ones.
 *
 * @param name    the name of its file, such as {@code slopes}
 * @param title   the heading
 * @param columns the columns
 * @param rows    a cell for each column: a text, a whole number ({@code Integer}, {@code Long}) or a {@code Double}
 */
public record DataTable(String name, String title, List<Column> columns, List<List<Object>> rows) {

    /**
     * One column.
     *
     * @param name   the quantity, with its unit
     * @param digits the number of significant digits of a {@code Double} that people are shown
     */
    public record Column(String name, int digits) {
    }

    /**
     * A column with the cell that each row has in it.
     *
     * @param column the column
     * @param cell   makes the cell of a row's item
     */
    public record Cells<T>(Column column, Function<? super T, ?> cell) {
    }

    /** @throws IllegalArgumentException if a row does not have one cell for each column */
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

    /** @return this table without the columns in which every cell is an empty text or not a number */
    public DataTable withoutEmptyColumns() {
        List<Integer> filled = IntStream.range(0, columns.size()).filter(c -> rows.stream().anyMatch(row ->
                !row.get(c).equals("") && !row.get(c).equals(Double.NaN))).boxed().toList();
        return new DataTable(name, title, filled.stream().map(columns::get).toList(),
                rows.stream().map(row -> filled.stream().<Object>map(row::get).toList()).toList());
    }

    /**
     * @param name  the name of its file
     * @param title the heading
     * @param items what has a row each
     * @param cells the columns
     * @return the table
     */
    @SafeVarargs
    @SuppressWarnings("varargs")            // the cells are only read
    public static <T> DataTable of(String name, String title, List<T> items, Cells<T>... cells) {
        return of(name, title, items, List.of(cells));
    }

    /** As {@link #of(String, String, List, Cells...)}, with a list of columns. */
    public static <T> DataTable of(String name, String title, List<T> items, List<Cells<T>> cells) {
        return new DataTable(name, title, cells.stream().map(Cells::column).toList(),
                items.stream().map(item -> cells.stream().<Object>map(c -> c.cell.apply(item)).toList()).toList());
    }

    /**
     * @param name   the column's name
     * @param digits the number of significant digits that people are shown
     * @param cell   makes the cell of a row's item
     * @return the column
     */
    public static <T> Cells<T> column(String name, int digits, Function<? super T, ?> cell) {
        return new Cells<>(new Column(name, digits), cell);
    }

    /** As {@link #column(String, int, Function)}, with four digits. */
    public static <T> Cells<T> column(String name, Function<? super T, ?> cell) {
        return new Cells<>(column(name), cell);
    }

    /**
     * @param name the column's name; four digits are shown
     * @return the column
     */
    public static Column column(String name) {
        return new Column(name, 4);
    }
}
