package particles.experiments.grid;

import static particles.view.DataTable.column;

import deSolvers.catalog.SolverCatalog;
import java.util.ArrayList;
import java.util.List;
import java.util.function.ToDoubleFunction;
import java.util.stream.IntStream;
import particles.experiments.grid.Grid.Row;
import particles.experiments.grid.Measure.Kind;
import particles.experiments.runs.RunCharts;
import particles.experiments.runs.RunCharts.Curve;
import particles.view.Axis;
import particles.view.Chart;
import particles.view.DataTable;
import particles.view.DataTable.Cells;
import particles.view.Look;
import particles.view.Panel;
import particles.view.Series;
import particles.view.Series.Mark;

/**
 * The results of a grid as charts and as a table: each measure over the first axis, with a curve for each value of the
 * second one and a panel for each value of the third, or for some of many.
 *
 * @param grid     the axes
 * @param measures what was measured
 * @param rows     the results, in any order
 */
public record GridCharts(Grid grid, List<Measure> measures, List<Row> rows) {
    /** Of more values of the second axis, or of the third, these many are drawn, at equal distances in the list. */
    private static final int MOST_DRAWN = 8;

    /** @return the measures that have a picture */
    public List<Measure> drawn() {
        return measures.stream().filter(measure -> measure.kind() != Kind.REFERENCE_ERROR).toList();
    }

    /**
     * @param measure one of them
     * @param title   the scene
     * @return a panel for each value of the third axis; the only one without it
     */
    public List<Panel> panels(Measure measure, String title) {
        String over = title + ": " + measure.name();
        if (grid.axes().size() < 3) {
            return List.of(Panel.of(over, charts(measure, rows)));
        }
        GridAxis third = grid.axes().get(2);
        return some(third).stream().map(value -> Panel.of(over + ", " + third.key() + " = " + value,
                charts(measure, rows.stream().filter(row -> row.at().get(2).equals(value)).toList())).named(value))
                .toList();
    }

    /** The chart, and below it the runs without a result, in a row for each curve. */
    private List<Chart> charts(Measure measure, List<Row> some) {
        GridAxis first = grid.axes().get(0);
        boolean numeric = first.isNumeric();
        ToDoubleFunction<Row> x = row -> numeric ? Double.parseDouble(row.at().get(0))
                : first.values().indexOf(row.at().get(0));
        int m = measures.indexOf(measure);
        List<String> curves = grid.axes().size() < 2 ? List.of(measure.name()) : some(grid.axes().get(1));
        Axis y = measure.axis(first.log());
        List<Curve<Row>> drawn = IntStream.range(0, curves.size()).mapToObj(c -> new Curve<>(named(curves.get(c)),
                SolverCatalog.find(curves.get(c)).map(Look::of).orElseGet(() -> Look.number(c)),
                some.stream().filter(row -> grid.axes().size() < 2 || row.at().get(1).equals(curves.get(c))).toList()))
                .toList();
        List<Chart> charts = new RunCharts<>(drawn, first.axis(), x).charts(y, row -> row.measured().get(m),
                runs -> "");
        if (!numeric) {                // its values are rows, and the measure is along x
            return List.of(new Chart(y, Axis.linear(first.key(), ""), charts.get(0).series().stream().map(one ->
                    new Series(one.look(), one.name(), Mark.POINTS, one.y(), one.x())).toList())
                    .inRows(first.values()));
        }
        return charts;
    }

    private static List<String> some(GridAxis axis) {
        int last = axis.values().size() - 1;
        return last < MOST_DRAWN ? axis.values() : IntStream.range(0, MOST_DRAWN).mapToObj(k ->
                axis.values().get(k * last / (MOST_DRAWN - 1))).toList();
    }

    /** A solver is known by its name, a number by its key. */
    private String named(String curve) {
        String key = grid.axes().size() < 2 ? "solver" : grid.axes().get(1).key();
        return key.equals("solver") ? curve : key.substring(key.lastIndexOf('.') + 1) + " = " + curve;
    }

    /** @return a row for each result that is there, in the order of the points */
    public DataTable table() {
        List<Cells<Row>> cells = new ArrayList<>();
        IntStream.range(0, grid.axes().size()).forEach(a -> cells.add(column(grid.axes().get(a).axis().label(),
                row -> row.at().get(a))));
        IntStream.range(0, measures.size()).forEach(m -> cells.add(column(new Axis(measures.get(m).name(),
                measures.get(m).unit(), false).label(), row -> cell(measures.get(m), row.measured().get(m)))));
        cells.add(column("end", Row::end));
        return DataTable.of("sweep", "Every run", rows, cells);
    }

    private static Object cell(Measure measure, double value) {
        return measure.kind().isCount() && !Double.isNaN(value) ? (Object) (long) value : (Object) value;
    }

    /** @return the axes in words, such as "springs[0].damping, solver" */
    public String axes() {
        return String.join(", ", grid.axes().stream().map(GridAxis::key).toList());
    }
}
