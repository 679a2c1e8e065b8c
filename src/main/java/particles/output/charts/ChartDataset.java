package particles.output.charts;

import org.jfree.data.DomainOrder;
import org.jfree.data.xy.AbstractXYDataset;
import particles.view.ChartData;
import particles.view.ChartData.Series;

/**
 * Adapter of chart data to JFreeChart. A point that cannot be drawn, since it is not finite or not positive on a
 * logarithmic axis, is a gap in its line.
 */
final class ChartDataset extends AbstractXYDataset {
    private static final long serialVersionUID = 1L;

    private final transient ChartData data;

    ChartDataset(ChartData data) {
        for (Series series : data.series()) {
            if (series.x().length != series.y().length) {
                throw new IllegalArgumentException("series '" + series.name() + "' has " + series.x().length
                        + " abscissae and " + series.y().length + " ordinates");
            }
        }
        this.data = data;
    }

    @Override
    public int getSeriesCount() {
        return data.series().size();
    }

    /** The legend takes names from the series; keys only have to differ. */
    @Override
    public Comparable<?> getSeriesKey(int series) {
        return series;
    }

    String name(int series) {
        return data.series().get(series).name();
    }

    @Override
    public DomainOrder getDomainOrder() {
        return DomainOrder.NONE;
    }

    @Override
    public int getItemCount(int series) {
        return data.series().get(series).x().length;
    }

    @Override
    public double getXValue(int series, int item) {
        return drawable(series, item) ? data.series().get(series).x()[item] : Double.NaN;
    }

    @Override
    public double getYValue(int series, int item) {
        return drawable(series, item) ? data.series().get(series).y()[item] : Double.NaN;
    }

    @Override
    public Number getX(int series, int item) {
        return getXValue(series, item);
    }

    @Override
    public Number getY(int series, int item) {
        return getYValue(series, item);
    }

    /** @return the last point of a series that can be drawn; -1 if there is none */
    int last(int series) {
        int item = getItemCount(series) - 1;
        while (item >= 0 && !drawable(series, item)) {
            item--;
        }
        return item;
    }

    private boolean drawable(int series, int item) {
        double x = data.series().get(series).x()[item];
        double y = data.series().get(series).y()[item];
        return Double.isFinite(x) && Double.isFinite(y) && (x > 0 || !data.xLog()) && (y > 0 || !data.yLog());
    }
}
