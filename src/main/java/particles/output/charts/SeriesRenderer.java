package particles.output.charts;

import java.awt.BasicStroke;
import java.awt.Color;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.jfree.chart.renderer.xy.XYLineAndShapeRenderer;
import particles.view.ChartData;
import particles.view.ChartData.Mark;
import particles.view.ChartData.Series;

/**
 * Makes the renderer of a chart's series: each is drawn by its mark, in the style of its solver, and no two lines are
 * alike.
 */
final class SeriesRenderer {
    /**
     * Lines that go up and down by their range more often than this fill an area; they are drawn translucent.
     */
    private static final int DENSE = 120;

    private SeriesRenderer() {
    }

    /**
     * @param data      the data
     * @param firstLook the number of the style of the first series without a solver
     */
    static XYLineAndShapeRenderer of(ChartData data, int firstLook) {
        XYLineAndShapeRenderer renderer = new XYLineAndShapeRenderer();
        renderer.setDrawSeriesLineAsPath(true);         // dashes run on from point to point
        renderer.setUseOutlinePaint(true);
        renderer.setDataBoundsIncludesVisibleSeriesOnly(false);     // or y is not that of a point at the end of x
        renderer.setUseFillPaint(true);
        renderer.setLegendItemLabelGenerator((dataset, k) -> ((ChartDataset) dataset).name(k));
        renderer.setLegendLine(ChartStyle.LEGEND_LINE);
        List<SolverStyle> looks = looks(data, firstLook);
        for (int k = 0; k < data.series().size(); k++) {
            Mark mark = data.series().get(k).mark();
            boolean dense = mark == Mark.LINE && k > 0 && isDense(data.series().get(k).y());
            SolverStyle look = looks.get(k);
            boolean failed = mark == Mark.FAILURES || mark == Mark.GIVEN_UP;
            boolean open = mark == Mark.LINE_AND_OPEN_POINTS || mark == Mark.OPEN_POINTS;
            Color colour = failed ? Color.RED.darker() : look.colour();
            renderer.setSeriesLinesVisible(k, !failed && mark != Mark.POINTS && mark != Mark.OPEN_POINTS);
            renderer.setSeriesShapesVisible(k, mark != Mark.LINE && mark != Mark.BARS && mark != Mark.BAND);
            renderer.setSeriesPaint(k, dense || mark == Mark.BAND ? ChartStyle.pale(colour) : colour);
            renderer.setSeriesStroke(k, dense ? ChartStyle.THIN : mark == Mark.BARS ? ChartStyle.BAR
                    : mark == Mark.BAND ? ChartStyle.BAND : look.stroke());
            renderer.setSeriesShape(k, mark == Mark.FAILURES ? ChartStyle.FAILURE
                    : mark == Mark.GIVEN_UP ? ChartStyle.GIVEN_UP : look.shape());
            renderer.setSeriesFillPaint(k, open ? Color.WHITE : colour);
            renderer.setSeriesOutlinePaint(k, open ? colour : Color.WHITE);
            renderer.setSeriesOutlineStroke(k, open ? ChartStyle.BAR : new BasicStroke(0.6f));
        }
        return renderer;
    }

    /**
     * The styles of all series. If a line of another name has a solver's style already, the line gets dashes that are
     * free.
     */
    private static List<SolverStyle> looks(ChartData data, int firstLook) {
        boolean ofSolvers = data.series().stream().anyMatch(series -> SolverStyle.of(series.name()).isPresent());
        int own = 0;
        Map<List<Object>, String> lines = new HashMap<>();
        List<SolverStyle> looks = new ArrayList<>();
        for (int k = 0; k < data.series().size(); k++) {
            Series series = data.series().get(k);
            int number = ofSolvers ? own : firstLook + k;       // the same beside any number of solvers
            SolverStyle look = SolverStyle.of(series.name())
                    .or(() -> energy(series.name()).map(colour -> SolverStyle.own(colour, 0)))
                    .orElse(SolverStyle.own(ofSolvers ? ChartStyle.AXIS : ChartStyle.colour(number), number));
            own += SolverStyle.of(series.name()).isPresent() ? 0 : 1;
            boolean line = series.mark() == Mark.LINE || series.mark() == Mark.LINE_AND_POINTS
                    || series.mark() == Mark.LINE_AND_OPEN_POINTS;
            for (int n = 0; line && n < ChartStyle.STROKES && !series.name().equals(
                    lines.getOrDefault(List.of(look.colour(), look.stroke()), series.name())); n++) {
                look = new SolverStyle(look.family(), look.colour(), ChartStyle.stroke(n), ChartStyle.shape(n));
            }
            if (line) {
                lines.put(List.of(look.colour(), look.stroke()), series.name());
            }
            looks.add(look);
        }
        return looks;
    }

    /** The colours of energy charts: total, work that drives the system, all other work, and numerical error. */
    private static Optional<Color> energy(String series) {
        boolean drives = series.endsWith("(driven)") || series.equals("work: moving anchors");
        return Optional.ofNullable(series.startsWith("work: ") ? new Color(drives ? 0x6a3d9a : 0x2f7f8f)
                : series.startsWith("total") ? Color.BLACK
                : series.equals("numerical error") ? new Color(0xb3261e) : null);
    }

    /** Whether a line goes up and down so often that it would cover the lines below, unless it is translucent. */
    static boolean isDense(double[] y) {
        double low = Double.POSITIVE_INFINITY;
        double high = Double.NEGATIVE_INFINITY;
        double way = 0;
        double before = Double.NaN;
        for (double value : y) {
            if (!Double.isNaN(value)) {                 // where a line is cut
                low = Math.min(low, value);
                high = Math.max(high, value);
                way += Double.isNaN(before) ? 0 : Math.abs(value - before);
            }
            before = value;
        }
        return way > DENSE * (high - low);
    }
}
