package particles.output.charts;

import org.jfree.data.xy.DefaultXYDataset;
import particles.view.ChartData;
import particles.view.ChartData.Series;

/**
 * Adapter of chart data to JFreeChart. A point that cannot be drawn, since it is not finite or not positive on a
 * logarithmic axis, is a gap in its line.
 */
final class ChartDataset extends DefaultXYDataset {
    private static final long serialVersionUID = 1L;

    private final transient ChartData data;

    /** The legend takes names from the series; keys only have to differ. */
    ChartDataset(ChartData data) {
        this.data = data;
        for (int k = 0; k < data.series().size(); k++) {
            Series series = data.series().get(k);
            double[][] points = {series.x().clone(), series.y().clone()};
            for (int p = 0; p < Math.min(points[0].length, points[1].length); p++) {
                double x = series.x()[p];
                double y = series.y()[p];
                if (!Double.isFinite(x) || !Double.isFinite(y) || x <= 0 && data.xLog() || y <= 0 && data.yLog()) {
                    points[0][p] = Double.NaN;
                    points[1][p] = Double.NaN;
                }
            }
            addSeries(k, points);
        }
    }

    String name(int series) {
        return data.series().get(series).name();
    }

    /** @return the last point of a series that can be drawn; -1 if there is none */
    int last(int series) {
        int item = getItemCount(series) - 1;
        while (item >= 0 && Double.isNaN(getXValue(series, item))) {
            item--;
        }
        return item;
    }
}
