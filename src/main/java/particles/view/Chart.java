package particles.view;

import java.util.Arrays;
import java.util.List;
import java.util.function.Predicate;

/**
 * The data of a chart, independent of how it is drawn.
 *
 * @param name   the name that its picture has where it is drawn by itself; empty for the main chart of a panel
 * @param x      the axis along x
 * @param y      the axis along y
 * @param rows   names for y = 0, 1, 2, ..., from the top, if y is not a quantity; otherwise empty
 * @param series the lines and points
 * @param scale  the series whose ranges the axes show: its own, or those of the charts with which it is compared
 */
public record Chart(String name, Axis x, Axis y, List<String> rows, List<Series> series, List<Series> scale) {
    /** Creates the main chart of a panel, with axes for its own series. */
    public Chart(Axis x, Axis y, List<Series> series) {
        this("", x, y, List.of(), series, series);
    }

    /** @return the chart with a name for its picture */
    public Chart named(String name) {
        return new Chart(name, x, y, rows, series, scale);
    }

    /** @return the chart with names for y = 0, 1, 2, ..., as y is no quantity */
    public Chart inRows(List<String> names) {
        return new Chart(name, x, y, names, series, scale);
    }

    /** @return the chart with some of its series, on the same axes, and with the rows in which they have points */
    public Chart only(Predicate<Series> which) {
        List<Series> some = series.stream().filter(which).toList();
        if (rows.isEmpty()) {
            return new Chart(name, x, y, rows, some, scale);
        }
        int[] used = some.stream().flatMapToDouble(one -> Arrays.stream(one.y())).mapToInt(row -> (int) row).distinct()
                .sorted().toArray();
        List<Series> moved = some.stream().map(one -> new Series(one.look(), one.name(), one.mark(), one.x(),
                Arrays.stream(one.y()).map(row -> Arrays.binarySearch(used, (int) row)).toArray())).toList();
        return new Chart(name, x, y, Arrays.stream(used).mapToObj(rows::get).toList(), moved, scale);
    }

    /** @return the chart on the axes that these series would have */
    public Chart scaledTo(List<Series> others) {
        return new Chart(name, x, y, rows, series, others);
    }

    /**
     * Adds a row for each item below this chart, over the same x axis.
     *
     * @param label what the rows have in common
     * @param rows  their names
     * @param marks points (x, row), of which those without any are left out
     * @return this chart, and the rows if there are points in them
     */
    public List<Chart> above(String label, List<String> rows, List<Series> marks) {
        List<Series> drawn = marks.stream().filter(one -> one.x().length > 0).toList();
        return drawn.isEmpty() ? List.of(this)
                : List.of(this, new Chart(x, Axis.linear(label, ""), drawn).inRows(rows));
    }
}
