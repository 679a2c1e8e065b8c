package particles.view;

import java.util.List;

/**
 * What a chart shows, apart from how it is drawn.
 *
 * @param title  the finding, or what is shown
 * @param xLabel the quantity along x, with its unit
 * @param yLabel the quantity along y, with its unit
 * @param xLog   whether x is logarithmic
 * @param yLog   whether y is logarithmic
 * @param rows   what y = 0, 1, 2, ... mean, from above, where y is no quantity; else empty
 * @param series the lines and points
 */
public record ChartData(String title, String xLabel, String yLabel, boolean xLog, boolean yLog, List<String> rows,
                        List<Series> series) {

    /**
     * A chart of quantities.
     *
     * @param title  the finding, or what is shown
     * @param xLabel the quantity along x, with its unit
     * @param yLabel the quantity along y, with its unit
     * @param xLog   whether x is logarithmic
     * @param yLog   whether y is logarithmic
     * @param series the lines and points
     */
    public ChartData(String title, String xLabel, String yLabel, boolean xLog, boolean yLog, List<Series> series) {
        this(title, xLabel, yLabel, xLog, yLog, List.of(), series);
    }

    /** How a series is drawn. */
    public enum Mark {
        /** A line without points. */
        LINE,
        /** A wide pale line, below others that may run along it. */
        BAND,
        /** Points without a line. */
        POINTS,
        /** Hollow points without a line. */
        OPEN_POINTS,
        /** Both. */
        LINE_AND_POINTS,
        /** Both; the points are hollow, so that filled ones on top of some of them stand out. */
        LINE_AND_OPEN_POINTS,
        /** Thin straight lines, with gaps between them: the spread of a measurement. */
        BARS,
        /** Crosses that cannot be taken for results. */
        FAILURES,
        /** Rings, for failures of another kind. */
        GIVEN_UP
    }

    /**
     * One line of a chart.
     *
     * @param name what the legend says; if it begins with a solver's name, the series has this solver's colour and
     *             mark, the same in all charts, and series that are no solver's beside it are grey
     * @param mark how it is drawn
     * @param x    the abscissae
     * @param y    as many ordinates
     */
    public record Series(String name, Mark mark, double[] x, double[] y) {
    }
}
