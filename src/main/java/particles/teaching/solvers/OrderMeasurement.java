package particles.teaching.solvers;

import deSolvers.DESolver;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.Locale;
import java.util.function.Supplier;
import particles.teaching.StudentFailure;
import particles.teaching.sources.StudentSource;
import particles.teaching.sources.WindyOscillators;

/**
 * The measured order of a solver: the exponent with which the error after two seconds falls with deltaT.
 *
 * @param order  the middle one of the slopes between the shortest time steps; only those count between which a step
 *               costs the
 *               same and whose error is above rounding; NaN if there are none
 * @param points deltaT (s) and the error, by falling deltaT
 */
public record OrderMeasurement(double order, List<double[]> points) {
    private static final double TIME = 2;
    private static final double START = 0.5;
    /** Two hundred roundings of numbers of order 1 make 5e-14; ten times that. */
    private static final double ROUNDING = 5e-13;
    private static final int FEWEST = 8;
    private static final int USUAL = 256;
    /** An adaptive method of low order divides steps of 2/256 s still, and shows its order only below. */
    private static final int MOST = 4096;
    private static final int SLOPES = 3;

    /** @return the measurement, on {@link WindyOscillators} */
    public static OrderMeasurement of(Supplier<DESolver> maker) {
        return measure(maker, () -> new WindyOscillators(1));
    }

    /**
     * @return the measurement on this law, not from 0, where the field does not change, so that the first step's clock
     *         hardly shows
     */
    static OrderMeasurement of(Supplier<DESolver> maker, Supplier<WindyOscillators> laws) {
        return measure(maker, () -> {
            WindyOscillators source = laws.get();
            source.startAt(START);
            return source;
        });
    }

    private static OrderMeasurement measure(Supplier<DESolver> maker, Supplier<WindyOscillators> sources) {
        List<double[]> points = new ArrayList<>();
        List<Double> slopes = new ArrayList<>();
        double last = Double.NaN;
        double lastCost = Double.NaN;
        for (int steps = FEWEST; steps <= USUAL || steps <= MOST && slopes.isEmpty() && last > ROUNDING; steps *= 2) {
            StudentSource source = sources.get();
            double error = error(maker.get(), source, steps);
            double cost = (double) source.getEvaluations() / steps;
            points.add(new double[] {TIME / steps, error});
            if (error > ROUNDING && last > ROUNDING && Math.abs(cost - lastCost) < 0.05 * cost + 0.5) {
                slopes.add(StrictMath.log(last / error) / StrictMath.log(2));
            }
            last = error;
            lastCost = cost;
        }
        double[] finest = slopes.stream().skip(Math.max(0, slopes.size() - SLOPES)).mapToDouble(slope -> slope).sorted()
                .toArray();
        return new OrderMeasurement(finest.length == 0 ? Double.NaN : finest[finest.length / 2], points);
    }

    /** The error against the state after two seconds, wherever the solver left the clock; infinite if it gave up. */
    private static double error(DESolver solver, StudentSource source, int steps) {
        double start = source.getTime();
        try {
            StudentSource.after(source, solver, steps, TIME / steps);
        } catch (RuntimeException e) {
            if (StudentFailure.isRefusal(e)) {
                return Double.POSITIVE_INFINITY;        // these steps are too long for it
            }
            throw e;
        }
        source.incTime(start + TIME - source.getTime());
        double error = source.error();
        return Double.isNaN(error) || Arrays.stream(source.getState()).anyMatch(Double::isNaN)
                ? Double.POSITIVE_INFINITY
                : error;
    }

    /** @return the order with two digits */
    String digits() {
        return String.format(Locale.ROOT, "%.2f", order);
    }

    /** @return the point with the smallest error */
    double[] smallest() {
        return points.stream().min(Comparator.comparingDouble(point -> point[1])).orElseThrow();
    }
}
