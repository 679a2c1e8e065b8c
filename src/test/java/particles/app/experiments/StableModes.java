package particles.app.experiments;

import static java.lang.Math.hypot;

import java.util.Map;
import java.util.Set;
import java.util.function.DoubleBinaryOperator;
import java.util.stream.Collectors;

/** The solvers with which all modes in a chart are stable, by the formulas of textbooks instead of the solvers. */
final class StableModes {
    private static final double ROUNDING = 1e-9;
    /** The factor by which a step multiplies a mode with z = x + iy; stable if at most 1. */
    private static final Map<String, DoubleBinaryOperator> FACTORS = Map.of(
            "euler", (x, y) -> taylor(x, y, 1), "midpoint", (x, y) -> taylor(x, y, 2), "rk4", (x, y) -> taylor(x, y, 4),
            // a spring with the eigenvalues x + iy and x - iy; verlet's last kick converges for weak damping
            "symplectic-euler", (x, y) -> x <= -1 ? 2 : hypot(x, y) * hypot(x, y) / (4 + 4 * x),
            "verlet", (x, y) -> x < -0.7 ? 2 : hypot(x, y) / 2);

    private StableModes() {
    }

    /** The solvers drawn that let no mode grow, at a multiple of the step drawn, unless it grows by itself. */
    static Set<String> with(Drawn drawn, double multiple) {
        return FACTORS.keySet().stream().filter(solver -> drawn.series().containsKey(solver)
                && drawn.of("modes of the scene").stream().allMatch(p ->
                p[0] > ROUNDING || FACTORS.get(solver).applyAsDouble(multiple * p[0], multiple * p[1]) <= 1 + ROUNDING))
                .collect(Collectors.toSet());
    }

    /** |1 + z + ... + z^n / n!|. */
    private static double taylor(double x, double y, int n) {
        double re = 1;
        double im = 0;
        for (int k = n; k > 0; k--) {
            double real = 1 + (x * re - y * im) / k;
            im = (x * im + y * re) / k;
            re = real;
        }
        return hypot(re, im);
    }
}
