package particles.output.charts;

import java.util.List;
import org.jfree.data.xy.DefaultXYDataset;
import particles.view.Axis;
import particles.view.Chart;
import particles.view.Series;

/**
 * Adapter of series to JFreeChart. A point that cannot be drawn, since it is not finite or not positive on a
 * logarithmic axis, is a gap in its line.
 */
final class ChartDataset extends DefaultXYDataset {
    private static final long serialVersionUID = 1L;

    private final transient List<Series> series;

    /** Keys only have to differ: the legend takes names from the series. */
    ChartDataset(Chart chart, List<Series> series) {
        this.series = series;
        for (int k = 0; k < series.size(); k++) {
            double[][] points = {series.get(k).x().clone(), series.get(k).y().clone()};
            for (int p = 0; p < points[0].length; p++) {
                if (!isDrawn(chart.x(), points[0][p]) || !isDrawn(chart.y(), points[1][p])) {
                    points[0][p] = Double.NaN;
                    points[1][p] = Double.NaN;
                }
            }
            addSeries(k, points);
        }
    }

    static boolean isDrawn(Axis axis, double value) {
        return Double.isFinite(value) && (value > 0 || !axis.log());
    }

    Series series(int k) {
        return series.get(k);
    }

    /** @return the last point of a series that can be drawn; -1 if there is none */
    int last(int k) {
        int item = getItemCount(k) - 1;
        while (item >= 0 && Double.isNaN(getXValue(k, item))) {
            item--;
        }
        return item;
    }
}
