package deSolvers.problems;

import deSolvers.DESolver;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.function.DoubleFunction;

/** Work-precision curve: evaluations against achieved error, to compare two methods at the same error. */
public final class WorkCurve {
    private static final int ERRORS = 21;

    private final List<double[]> points = new ArrayList<>();        // (log10 error, log10 evaluations)

    /**
     * Notes a run.
     *
     * @param evaluations calls of the derivative
     * @param error       the error at the end
     */
    public void add(double evaluations, double error) {
        points.add(new double[] {StrictMath.log10(error), StrictMath.log10(evaluations)});
    }

    /**
     * Reads a curve that was measured elsewhere.
     *
     * @param rows a text with a row for each curve: its name, a bar, and pairs of evaluations and error
     * @param name the row to read
     * @return the curve
     */
    public static WorkCurve read(String rows, String name) {
        String row = rows.lines().filter(line -> line.startsWith(name + " | ")).findFirst().orElseThrow();
        double[] pairs = Arrays.stream(row.substring(name.length() + 3).split(" +")).mapToDouble(Double::parseDouble)
                .toArray();
        WorkCurve curve = new WorkCurve();
        for (int i = 0; i < pairs.length; i += 2) {
            curve.add(pairs[i], pairs[i + 1]);
        }
        return curve;
    }

    /**
     * Runs a solver over a problem with tolerances (relative = absolute) of 10^-from, half a decade smaller, ...
     * 10^-to.
     *
     * @param problem  the problem, stepped from 0 in one step
     * @param duration its length (s)
     * @param solver   makes a solver for a tolerance
     * @param from     first exponent
     * @param to       last exponent
     * @return the curve
     */
    public static WorkCurve of(ReferenceProblem problem, double duration, DoubleFunction<DESolver> solver, int from,
                               int to) {
        WorkCurve curve = new WorkCurve();
        for (double exponent = from; exponent <= to; exponent += 0.5) {
            problem.startAt(0);
            solver.apply(StrictMath.pow(10, -exponent)).stepState(problem, duration);
            curve.add(problem.getEvaluations(), problem.error());
        }
        return curve;
    }

    /**
     * The ratio of this curve's evaluations to the other's, averaged geometrically over the errors that both reach.
     * Each curve is smoothed first, so that a single lucky run counts little.
     *
     * @param other the curve to compare with
     * @return the ratio; below 1 if this one is cheaper
     */
    public double over(WorkCurve other) {
        double sum = 0;
        for (double difference : differences(other)) {
            sum += difference;
        }
        return StrictMath.pow(10, sum / ERRORS);
    }

    /**
     * The largest such ratio at any error.
     *
     * @param other the curve to compare with
     * @return the largest ratio at any error that both reach
     */
    public double worstOver(WorkCurve other) {
        return StrictMath.pow(10, Arrays.stream(differences(other)).max().orElseThrow());
    }

    /** log10 of the ratio, at errors that are evenly spaced on a logarithmic scale. */
    private double[] differences(WorkCurve other) {
        double low = Math.max(lowest(), other.lowest());
        double high = Math.min(highest(), other.highest());
        double[] differences = new double[ERRORS];
        for (int i = 0; i < ERRORS; i++) {
            double error = low + (high - low) * i / (ERRORS - 1);
            differences[i] = at(error) - other.at(error);
        }
        return differences;
    }

    private double lowest() {
        return points.stream().mapToDouble(p -> p[0]).min().orElseThrow();
    }

    private double highest() {
        return points.stream().mapToDouble(p -> p[0]).max().orElseThrow();
    }

    /** A straight line by least squares, near points counting more than far ones, read at the error. */
    private double at(double error) {
        double n = 0;
        double sx = 0;
        double sy = 0;
        double sxx = 0;
        double sxy = 0;
        for (double[] p : points) {
            double x = p[0] - error;
            double weight = 1 / (1 + x * x);
            n += weight;
            sx += weight * x;
            sy += weight * p[1];
            sxx += weight * x * x;
            sxy += weight * x * p[1];
        }
        return (sy * sxx - sx * sxy) / (n * sxx - sx * sx);
    }
}
