package particles.experiments.phase;

import deSolvers.text.Digits;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.function.Function;
import java.util.stream.IntStream;
import particles.experiments.runs.SceneRun.Outcome;
import particles.view.ChartData;
import particles.view.ChartData.Mark;
import particles.view.ChartData.Series;

/**
 * One solver's path of one particle over that of a very accurate run.
 *
 * @param subject what is seen
 * @param path    the path, with the solver's label for a name
 * @param curve   the reference's curve
 * @param off     the largest distance of the path from the curve, in halves of the curve's width and height; NaN if the
 *                reference has no curve
 * @param outcome the outcome of the solver's run
 */
public record Portrait(Subject subject, Series path, CurveDistance curve, double off, Outcome outcome) {
    /**
     * A path that goes farther out than this many times the curve leaves the picture; otherwise all else would shrink
     * to a dot.
     */
    private static final double PICTURE = 3.2;
    /** A path this far from the curve has left it. */
    static final double LEFT = 0.05;

    /**
     * A particle along an axis.
     *
     * @param particle its id
     * @param axis     the axis
     * @param heading  begins the titles of its charts if there are several subjects
     */
    public record Subject(String particle, Axis axis, String heading) {
    }

    /** @return the solver's label */
    public String solver() {
        return path.name();
    }

    /** @return whether the run reached its end */
    public boolean whole() {
        return outcome.failure().isEmpty();
    }

    /** @return how far the last value is from the reference's; NaN if the run did not reach its end */
    double error(Function<Series, double[]> which) {
        return whole() ? Math.abs(PhasePortraits.last(which.apply(path))
                - PhasePortraits.last(which.apply(curve.getCurve()))) : Double.NaN;
    }

    /** @return the path over the reference, with both ends and the point where it leaves the picture */
    public ChartData chart() {
        Series exact = curve.getCurve();
        int shown = (int) IntStream.range(0, path.x().length).takeWhile(n ->
                !(curve.outwards(path.x()[n], path.y()[n]) > PICTURE)).count();
        int end = shown - 1;
        int last = exact.x().length - 1;
        List<Series> series = new ArrayList<>(List.of(
                new Series(exact.name(), exact.mark() == Mark.LINE ? Mark.BAND : exact.mark(), exact.x(), exact.y()),
                new Series(solver(), path.mark(), Arrays.copyOf(path.x(), shown), Arrays.copyOf(path.y(), shown)),
                Series.point("start", Mark.POINTS, exact.x()[0], exact.y()[0]),
                Series.point("reference end", Mark.OPEN_POINTS, exact.x()[last], exact.y()[last])));
        if (end >= 0) {
            boolean ends = whole() && shown == path.x().length;
            series.add(Series.point(ends ? "end" : "stopped, or out of the picture",
                    ends ? Mark.POINTS : Mark.FAILURES, path.x()[end], path.y()[end]));
        }
        return new ChartData(subject.heading() + solver() + verdict(), subject.axis().positionLabel(""),
                subject.axis().velocityLabel(""), false, false, series);
    }

    private String verdict() {
        if (!whole()) {
            return ": blows up";
        }
        if (Double.isNaN(off)) {
            return !curve.isAtRest() ? "" : ": at rest" + (subject.axis() == Axis.ANGLE ? ""
                    : " along " + subject.axis().symbol());
        }
        return off > LEFT ? ": " + percent(off) + " off the curve" : ": on the curve to " + percent(off);
    }

    /** @return a share with the digits of the table, such as 3.2 %, 0.08 % and 2e-5 % */
    static String percent(double share) {
        return share > 10 ? "over 1000 %" : Digits.few(100 * share, 2) + " %";
    }
}
