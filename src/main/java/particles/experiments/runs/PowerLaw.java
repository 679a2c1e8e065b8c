package particles.experiments.runs;

import java.util.List;
import java.util.function.ToDoubleFunction;

/** Powers fitted to measurements: a straight line in logarithms, by least squares. */
public final class PowerLaw {
    /** The fewest points for a fit; two points always lie on a line. */
    public static final int FEWEST = 3;

    private PowerLaw() {
    }

    /** @return the exponent of y as a power of x; NaN for fewer than three points */
    public static <T> double exponent(List<T> points, ToDoubleFunction<? super T> x, ToDoubleFunction<? super T> y) {
        if (points.size() < FEWEST) {
            return Double.NaN;
        }
        return FittedLine.of(points.stream().mapToDouble(x).map(StrictMath::log).toArray(),
                points.stream().mapToDouble(y).map(StrictMath::log).toArray()).slope();
    }
}
