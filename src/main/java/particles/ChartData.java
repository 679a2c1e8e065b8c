package particles;

import java.util.List;

/**
 * What a chart shows, apart from how it is drawn.
 *
 * @param title  the finding, or what is shown
 * @param xLabel the quantity along x, with its unit
 * @param yLabel the quantity along y, with its unit
 * @param xLog   whether x is logarithmic
 * @param yLog   whether y is logarithmic
 * @param series the lines and points
 */
public record ChartData(String title, String xLabel, String yLabel, boolean xLog, boolean yLog, List<Series> series) {

    /** How a series is drawn; failures are crosses that cannot be taken for results. */
    public enum Mark { LINE, POINTS, LINE_AND_POINTS, FAILURES }

    /**
     * One line of a chart.
     *
     * @param name what the legend says; if it begins with a solver's name, the series has this solver's colour and mark, the
     *             same in all charts, and series that are no solver's beside it are grey
     * @param mark how it is drawn
     * @param x    the abscissae
     * @param y    as many ordinates
     */
    public record Series(String name, Mark mark, double[] x, double[] y) {
    }
}
