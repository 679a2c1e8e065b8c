package particles.teaching.sources;

import deSolvers.DESolver;
import deSolvers.text.Digits;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.function.Supplier;
import java.util.stream.IntStream;

/**
 * The measured order of a solver: the exponent with which the error after two seconds falls with deltaT.
 *
 * @param order  the middle one of the slopes between the shortest time steps; only those count between which a step
 *               costs the same and whose error is above rounding; NaN if there are none
 * @param points deltaT (s) and the error, by falling deltaT
 */
public record OrderMeasurement(double order, List<double[]> points) {
    private static final double TIME = 2;
    /** The field changes there. */
    private static final double START = 0.5;
    /** Two hundred roundings of numbers of order 1 make 5e-14; ten times that. */
    private static final double ROUNDING = 5e-13;
    private static final int FEWEST = 8;
    private static final int USUAL = 256;
    /** An adaptive method of low order divides steps of 2/256 s still, and shows its order only below. */
    private static final int MOST = 4096;
    private static final int SLOPES = 3;
    /** With half of deltaT an iteration to 1e-15 needs up to a ninth less per step; a larger change means sub-steps. */
    private static final double SAME_COST = 0.12;
    /** Below this order the error does not go to 0; Euler measures 0.97 to 1.03. */
    public static final double LOWEST = 0.7;
    /** Adaptive methods have an error that does not follow deltaT, and a small one. */
    private static final double SMALL = 1e-4;

    /** @return the measurement, on {@link WindyOscillators} */
    public static OrderMeasurement of(Supplier<DESolver> maker) {
        return of(maker, () -> new WindyOscillators(1).from(START));
    }

    /** @return the measurement on these sources, from where they are */
    public static OrderMeasurement of(Supplier<DESolver> maker, Supplier<? extends StudentSource> sources) {
        List<double[]> points = new ArrayList<>();
        List<Double> slopes = new ArrayList<>();
        double last = Double.NaN;
        double lastCost = Double.NaN;
        for (int steps = FEWEST; steps <= USUAL || steps <= MOST && slopes.isEmpty() && last > ROUNDING; steps *= 2) {
            StudentSource source = sources.get();
            double error = error(maker.get(), source, TIME, steps);
            double cost = (double) source.getEvaluations() / steps;
            points.add(new double[] {TIME / steps, error});
            if (error > ROUNDING && last > ROUNDING && Math.abs(cost - lastCost) < SAME_COST * cost + 0.5) {
                slopes.add(StrictMath.log(last / error) / StrictMath.log(2));
            }
            last = error;
            lastCost = cost;
        }
        double[] finest = slopes.stream().skip(Math.max(0, slopes.size() - SLOPES)).mapToDouble(slope -> slope).sorted()
                .toArray();
        return new OrderMeasurement(finest.length == 0 ? Double.NaN : finest[finest.length / 2], points);
    }

    /** @return the error after this time (s), wherever the solver left the clock; infinite if it gave up */
    public static double error(DESolver solver, StudentSource source, double time, int steps) {
        double start = source.getTime();
        boolean made = IntStream.range(0, steps).allMatch(step -> source.accepts(solver, time / steps));
        source.incTime(start + time - source.getTime());
        double error = source.error();
        return !made || Double.isNaN(error + Arrays.stream(source.getState()).sum()) ? Double.POSITIVE_INFINITY : error;
    }

    /** @return whether the error does not go to 0; a small one is that of a tolerance, whatever deltaT is */
    public boolean isFar() {
        return !(order >= LOWEST || smallest()[1] < SMALL);
    }

    /** @return the order with two digits */
    public String digits() {
        return Digits.format("%.2f", order);
    }

    /** @return the point with the smallest error */
    public double[] smallest() {
        return points.stream().min(Comparator.comparingDouble(point -> point[1])).orElseThrow();
    }
}
