package particles.experiments.work;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Locale;
import particles.experiments.runs.PowerLaw;
import particles.experiments.work.WorkPrecision.Point;
import particles.experiments.work.WorkProblem.Stiff;

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
    static final double STRAIGHT = 0.1;
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
     * @param points  runs with ever shorter steps
     * @param problem the problem
     * @param inStiff whether the fit is of the stiff range alone
     * @param theory  the slope that is expected; NaN where there is no one
     * @return the fit of the error as a power of deltaT
     */
    static SlopeFit byStep(List<Point> points, WorkProblem problem, boolean inStiff, double theory) {
        double shortest = inStiff ? problem.stiff().map(Stiff::deltaT).orElse(0.0) : 0;
        List<Integer> usable = usable(points, problem.floor());
        usable.removeIf(k -> points.get(k).deltaT() < shortest);
        return last(points, usable, problem, STRAIGHT, false).near(theory);
    }

    /**
     * @param points  runs with ever tighter tolerance
     * @param problem the problem
     * @param theory  the slope that is expected; NaN where there is no one
     * @return the fit of the error as a power of the evaluations, with the sign changed
     */
    static SlopeFit byWork(List<Point> points, WorkProblem problem, double theory) {
        return last(points, usable(points, problem.floor()), problem, ROUGHLY_STRAIGHT, true).near(theory);
    }

    /** This fit, or none if its slope is not that of the method. */
    private SlopeFit near(double theory) {
        return Math.abs(slope - theory) > OFF_THEORY ? none(String.format(Locale.ROOT,
                "a straight piece of slope %.2f, which is not the method's", slope)) : this;
    }

    /** The last straight piece of the line, as long as possible. */
    private static SlopeFit last(List<Point> points, List<Integer> usable, WorkProblem problem, double straight,
            boolean byWork) {
        for (int end = usable.size() - 1; end >= Math.max(PowerLaw.FEWEST, usable.size() - LEFT_OUT) - 1; end--) {
            int begin = end;
            double low = Double.POSITIVE_INFINITY;
            double high = Double.NEGATIVE_INFINITY;
            while (begin > 0 && usable.get(begin - 1) == usable.get(begin) - 1) {
                double slope = slope(points.get(usable.get(begin - 1)), points.get(usable.get(begin)), byWork);
                low = Math.min(low, slope);
                high = Math.max(high, slope);
                if (!(high - low <= straight)) {
                    break;
                }
                begin--;
            }
            if (end - begin >= PowerLaw.FEWEST - 1) {
                return fitted(points, usable.get(begin), usable.get(end), byWork);
            }
        }
        return none(usable.size() < PowerLaw.FEWEST
                ? usable.size() + " errors between " + problem.floor() + " and " + SMALL + ", where the method shows"
                : "not on a straight line");
    }

    /** The slope between two runs; NaN if the finer one did not take more work. */
    private static double slope(Point coarse, Point fine, boolean byWork) {
        double finer = byWork ? (double) fine.evaluations() / coarse.evaluations() : coarse.deltaT() / fine.deltaT();
        return byWork && finer < MORE_WORK ? Double.NaN : Math.log(coarse.error() / fine.error()) / Math.log(finer);
    }

    private static List<Integer> usable(List<Point> points, double floor) {
        List<Integer> usable = new ArrayList<>();
        for (int k = points.size() - 1; k >= 0; k--) {
            double error = points.get(k).error();
            if (points.get(k).failure().isEmpty() && error < SMALL && error > floor) {
                usable.add(k);
            }
        }
        Collections.reverse(usable);
        return usable;
    }

    private static SlopeFit fitted(List<Point> points, int first, int last, boolean byWork) {
        List<Point> fit = points.subList(first, last + 1);
        double[] x = fit.stream().mapToDouble(p -> byWork ? 1.0 / p.evaluations() : p.deltaT()).toArray();
        return new SlopeFit(PowerLaw.exponent(x, fit.stream().mapToDouble(Point::error).toArray()), first, last, "");
    }

    private static SlopeFit none(String why) {
        return new SlopeFit(Double.NaN, 0, -1, why);
    }

    /** @return whether a run is one of those fitted */
    public boolean contains(int run) {
        return run >= first && run <= last;
    }
}
