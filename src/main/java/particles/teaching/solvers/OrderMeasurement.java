package particles.teaching.solvers;

import deSolvers.DESolver;
import java.util.ArrayList;
import java.util.List;
import java.util.function.Supplier;
import particles.teaching.sources.WindyOscillators;

/**
 * The order of a solver, measured: how fast the error over two seconds falls with deltaT.
 *
 * @param order  the slope between the two smallest time steps whose error is above rounding; NaN if there are none
 * @param points deltaT (s) and the error, by falling deltaT
 */
public record OrderMeasurement(double order, List<double[]> points) {
    private static final double TIME = 2;
    private static final double ROUNDING = 1e-12;

    /** @return the measurement, on {@link WindyOscillators} */
    public static OrderMeasurement of(Supplier<DESolver> maker) {
        return of(maker, 1);
    }

    /** @return the measurement, on so many particles */
    public static OrderMeasurement of(Supplier<DESolver> maker, int particles) {
        List<double[]> points = new ArrayList<>();
        for (int steps = 8; steps <= 256; steps *= 2) {
            WindyOscillators source = new WindyOscillators(particles);
            DESolver solver = maker.get();
            for (int i = 0; i < steps; i++) {
                solver.stepState(source, TIME / steps);
            }
            points.add(new double[] {TIME / steps, errorAt(source)});
        }
        double order = Double.NaN;
        for (int k = 1; k < points.size() && !(points.get(k)[1] < ROUNDING); k++) {
            order = StrictMath.log(points.get(k - 1)[1] / points.get(k)[1]) / StrictMath.log(2);
        }
        return new OrderMeasurement(order, points);
    }

    /** The error against the state at two seconds, wherever the solver left the clock. */
    private static double errorAt(WindyOscillators source) {
        source.incTime(TIME - source.getTime());
        return source.error();
    }

    public double smallestError() {
        return points.stream().mapToDouble(point -> point[1]).min().orElse(Double.NaN);
    }
}
