package particles.experiments.phase;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import particles.view.ChartData;
import particles.view.ChartData.Mark;
import particles.view.ChartData.Series;

/**
 * The chart of one solver's path over the reference, with both ends and the point where the path leaves the picture.
 */
final class PortraitChart {
    /**
     * A path that goes farther out than this many times the curve leaves the picture; otherwise all else would shrink
     * to a dot.
     */
    private static final double PICTURE = 3.2;
    /** A path this far from the curve has left it. */
    static final double LEFT = 0.05;

    private final String solver;
    private final Series path;
    private final Series exact;
    private final boolean whole;
    private final boolean rests;
    private final int shown;
    private final double off;

    PortraitChart(String solver, Series path, Series exact, CurveDistance curve, boolean whole) {
        this.solver = solver;
        this.path = path;
        this.exact = exact;
        this.whole = whole;
        rests = curve.isAtRest();
        int n = 0;
        while (n < path.x().length && !(curve.outwards(path.x()[n], path.y()[n]) > PICTURE)) {
            n++;
        }
        shown = n;
        off = curve.largest(path.x(), path.y());
    }

    double getDistanceOff() {
        return off;
    }

    /**
     * @param whose the particle's name, if there are several charts of this solver
     * @param axis  the axis of the portrait
     */
    ChartData data(String whose, Axis axis) {
        List<Series> series = new ArrayList<>();
        series.add(new Series(exact.name(), exact.mark() == Mark.LINE ? Mark.BAND : exact.mark(), exact.x(),
                exact.y()));
        series.add(new Series(solver, path.mark(), Arrays.copyOf(path.x(), shown), Arrays.copyOf(path.y(), shown)));
        int last = exact.x().length - 1;
        series.add(Series.point("start", Mark.POINTS, exact.x()[0], exact.y()[0]));
        series.add(Series.point("end of the reference", Mark.OPEN_POINTS, exact.x()[last], exact.y()[last]));
        int end = shown - 1;
        if (end >= 0 && whole && shown == path.x().length) {
            series.add(Series.point("end", Mark.POINTS, path.x()[end], path.y()[end]));
        } else if (end >= 0) {
            series.add(Series.point("stopped, or out of the picture", Mark.FAILURES, path.x()[end], path.y()[end]));
        }
        return new ChartData(whose + title(axis), axis.positionLabel(""), axis.velocityLabel(""), false, false, series);
    }

    private String title(Axis axis) {
        if (!whole) {
            return solver + ": blows up";
        }
        if (Double.isNaN(off)) {
            return rests ? solver + ": at rest" + (axis == Axis.ANGLE ? "" : " along " + axis.symbol()) : solver;
        }
        return solver + (off > LEFT ? ": " + percent(off) + " off the curve"
                : ": on the curve to " + percent(off));
    }

    /** @return a share with one or two digits, such as 3.2 %, 0.08 % and 2e-5 % */
    static String percent(double share) {
        double percent = 100 * share;
        return percent > 1000 ? "over 1000 %" : percent >= 10 ? String.format(Locale.ROOT, "%.0f %%", percent)
                : percent >= 0.1 ? String.format(Locale.ROOT, "%.1f %%", percent)
                : percent >= 0.0095 ? String.format(Locale.ROOT, "%.2f %%", percent)
                : percent >= 0.00095 ? String.format(Locale.ROOT, "%.3f %%", percent)
                : percent == 0 ? "0 %" : String.format(Locale.ROOT, "%.0e %%", percent).replace("e-0", "e-");
    }
}
