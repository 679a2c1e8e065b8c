package particles.experiments.work;

import deSolvers.text.Digits;
import java.util.DoubleSummaryStatistics;
import java.util.List;
import java.util.function.ToDoubleFunction;
import java.util.stream.IntStream;
import particles.experiments.runs.FittedLine;
import particles.experiments.work.WorkPrecision.Point;

/**
 * The slope of a solver's errors, fitted only where they follow a power law: over the last three or more runs in a row,
 * from coarse to fine, whose errors are small, above rounding, and on a straight line.
 *
 * @param slope  the exponent; NaN if there are no three such runs
 * @param first  the first run of the fit, by its place in the list
 * @param last   the last one; before the first, where there is no fit
 * @param whyNot the reason if there is no slope; empty otherwise
 */
public record SlopeFit(double slope, int first, int last, String whyNot) {
    /** Errors above this are too large to follow the power law. */
    static final double SMALL = 0.1;
    /** The largest difference of slopes from run to run on a line that counts as straight. */
    private static final double STRAIGHT = 0.1;
    /** The largest number of the finest errors that may be left out, since round-off reaches them first. */
    private static final int LEFT_OUT = 2;
    /** The same for tolerances, which a solver follows only roughly. */
    private static final double ROUGHLY_STRAIGHT = 1.5;
    /** An adaptive solver for which a tighter tolerance costs less than this factor does not follow it. */
    private static final double MORE_WORK = 1.05;
    /**
     * A slope that differs from theory by more than this is not that of the method: the error falls for another reason,
     * for example because sub-steps become short enough to be stable (a difference of 3.4). Solvers that keep their
     * tolerance differ by up to 0.97 (dormand-prince in Kepler's problem).
     */
    private static final double OFF_THEORY = 1.25;

    /**
     * @param points   runs with ever shorter steps, or ever tighter tolerances
     * @param floor    errors below this may be round-off
     * @param byStep   whether the slope is that of the error as a power of deltaT; otherwise of the evaluations, with
     *                 the sign changed
     * @param shortest runs with shorter steps (s) are left out
     * @param theory   the slope that is expected; NaN where there is none
     * @return the last straight piece of the line, as long as possible, or none if its slope is not that of the method
     */
    static SlopeFit of(List<Point> points, double floor, boolean byStep, double shortest, double theory) {
        ToDoubleFunction<Point> size = byStep ? Point::deltaT : point -> 1.0 / point.evaluations();
        double straight = byStep ? STRAIGHT : ROUGHLY_STRAIGHT;
        List<Integer> usable = IntStream.range(0, points.size()).filter(k -> points.get(k).failure().isEmpty()
                && points.get(k).error() < SMALL && points.get(k).error() > floor
                && points.get(k).deltaT() >= shortest).boxed().toList();
        for (int end = usable.size() - 1; end >= Math.max(FittedLine.FEWEST, usable.size() - LEFT_OUT) - 1; end--) {
            int begin = end;
            DoubleSummaryStatistics slopes = new DoubleSummaryStatistics();
            while (begin > 0 && usable.get(begin - 1) == usable.get(begin) - 1) {
                Point coarse = points.get(usable.get(begin - 1));
                Point fine = points.get(usable.get(begin));
                double finer = size.applyAsDouble(coarse) / size.applyAsDouble(fine);
                // the finer one has to take more work
                slopes.accept(finer < MORE_WORK ? Double.NaN : Math.log(coarse.error() / fine.error())
                        / Math.log(finer));
                if (!(slopes.getMax() - slopes.getMin() <= straight)) {
                    break;
                }
                begin--;
            }
            if (end - begin >= FittedLine.FEWEST - 1) {
                int first = usable.get(begin);
                int last = usable.get(end);
                double slope = FittedLine.exponent(points.subList(first, last + 1), size, Point::error);
                return Math.abs(slope - theory) > OFF_THEORY ? none(Digits.format(
                        "a straight piece of slope %.2f, which is not the method's", slope))
                        : new SlopeFit(slope, first, last, "");
            }
        }
        return none(usable.size() < FittedLine.FEWEST
                ? usable.size() + " errors between " + floor + " and " + SMALL + ", where the method shows"
                : "not on a straight line");
    }

    private static SlopeFit none(String why) {
        return new SlopeFit(Double.NaN, 0, -1, why);
    }

    /** @return whether a run is one of those fitted */
    public boolean contains(int run) {
        return run >= first && run <= last;
    }
}
