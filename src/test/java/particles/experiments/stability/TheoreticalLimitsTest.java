package particles.experiments.stability;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import deSolvers.catalog.SolverCatalog;
import deSolvers.catalog.SolverInfo;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.function.DoublePredicate;
import java.util.function.DoubleUnaryOperator;
import java.util.function.ToDoubleFunction;
import org.hipparchus.complex.Complex;
import org.hipparchus.linear.MatrixUtils;
import org.hipparchus.linear.RealMatrix;
import org.junit.jupiter.api.Test;

/** The limits that the catalogue states, computed from each method's polynomial and not from its code. */
class TheoreticalLimitsTest {
    /** The largest modulus by which a step multiplies, as a function of z = h lambda. */
    private static final Map<String, ToDoubleFunction<Complex>> GROWTH = new LinkedHashMap<>();

    static {
        GROWTH.put("euler", z -> taylor(z, 1, 1).norm());
        GROWTH.put("midpoint", z -> taylor(z, 1, 1, 1 / 2.0).norm());
        GROWTH.put("rk4", z -> rk4(z).norm());
        // two steps of half the length, as a sub-step without extrapolation
        GROWTH.put("step-doubling", z -> rk4(z.multiply(0.5)).pow(2).norm());
        GROWTH.put("dormand-prince",
                z -> taylor(z, 1, 1, 1 / 2.0, 1 / 6.0, 1 / 24.0, 1 / 120.0, 1 / 600.0).norm());
        GROWTH.put("adams", TheoreticalLimitsTest::adams);
        GROWTH.put("backward-euler", z -> Complex.ONE.divide(taylor(z, 1, -1)).norm());
        GROWTH.put("linearised-euler", GROWTH.get("backward-euler"));
        GROWTH.put("implicit-midpoint", z -> taylor(z, 1, 1 / 2.0).divide(taylor(z, 1, -1 / 2.0)).norm());
        GROWTH.put("radau", z -> taylor(z, 1, 2 / 5.0, 1 / 20.0)
                .divide(taylor(z, 1, -3 / 5.0, 3 / 20.0, -1 / 60.0)).norm());
    }

    private static Complex taylor(Complex z, double... coefficients) {
        Complex sum = Complex.ZERO;
        for (int k = coefficients.length - 1; k >= 0; k--) {
            sum = sum.multiply(z).add(coefficients[k]);
        }
        return sum;
    }

    private static Complex rk4(Complex z) {
        return taylor(z, 1, 1, 1 / 2.0, 1 / 6.0, 1 / 24.0);
    }

    /**
     * The predicted state goes into the corrector, z/24 (9 z/24 (55 f0 - 59 f1 + 37 f2 - 9 f3) + ...): the largest root
     * of the characteristic polynomial.
     */
    private static double adams(Complex z) {
        Complex square = z.multiply(z).multiply(9 / 576.0);
        Complex a3 = Complex.ONE.add(z.multiply(28 / 24.0)).add(square.multiply(55));
        Complex a2 = z.multiply(-5 / 24.0).add(square.multiply(-59));
        Complex a1 = z.multiply(1 / 24.0).add(square.multiply(37));
        Complex a0 = square.multiply(-9);
        return largestRoot(a3, a2, a1, a0);
    }

    /** Of x^4 = a3 x^3 + a2 x^2 + a1 x + a0, all roots at once (Durand and Kerner). */
    private static double largestRoot(Complex a3, Complex a2, Complex a1, Complex a0) {
        Complex[] roots = new Complex[4];
        for (int k = 0; k < 4; k++) {
            roots[k] = new Complex(0.4, 0.9).pow(k);
        }
        for (int turn = 0; turn < 200; turn++) {
            for (int k = 0; k < 4; k++) {
                Complex x = roots[k];
                Complex value = x.subtract(a3).multiply(x).subtract(a2).multiply(x).subtract(a1).multiply(x)
                        .subtract(a0);
                for (int j = 0; j < 4; j++) {
                    value = j == k ? value : value.divide(x.subtract(roots[j]));
                }
                roots[k] = x.subtract(value);
            }
        }
        return Arrays.stream(roots).mapToDouble(Complex::norm).max().orElseThrow();
    }

    /** Outwards from 0 until a step grows; 1e-12 is the rounding of the polynomials. */
    private static double limit(DoubleUnaryOperator growth) {
        DoublePredicate stable = h -> growth.applyAsDouble(h) <= 1 + 1e-12;
        double step = 1e-3;
        for (double h = step; h <= 100; h += step) {
            if (!stable.test(h)) {
                return StabilityLimit.bisected(h - step, h, 1e-14, stable);
            }
        }
        return Double.POSITIVE_INFINITY;
    }

    /** Below 0.01, growth with h^6 or faster is no larger than rounding: such a limit counts as 0. */
    private static double zeroIfTiny(double limit) {
        return limit < 0.02 ? 0 : limit;
    }

    @Test
    void everyStatedLimitIsThatOfThePolynomial() {
        GROWTH.forEach((name, growth) -> {
            SolverInfo info = SolverCatalog.info(name);
            assertEquals(info.realLimit(), limit(h -> growth.applyAsDouble(new Complex(-h, 0))), 5.1e-5,
                    name + ", real");
            assertEquals(info.imaginaryLimit(), zeroIfTiny(limit(h -> growth.applyAsDouble(new Complex(0, h)))),
                    5.1e-5, name + ", imaginary");
        });
    }

    /** Every solver with a stated real limit has its polynomial here. */
    @Test
    void noStatedLimitIsLeftOut() {
        for (SolverInfo info : SolverCatalog.all()) {
            assertEquals(!Double.isNaN(info.realLimit()), GROWTH.containsKey(info.name()), info.name());
        }
    }

    /** The digits of the root locus, and what the table and the caption call theory. */
    @Test
    void adamsHasTheRootLocus() {
        assertEquals(1.284816, limit(h -> adams(new Complex(-h, 0))), 5e-7);
        assertEquals(1.6e-7, adams(new Complex(0, 0.1)) - 1, 5e-9);
        assertEquals(1.5e-3, adams(new Complex(0, 0.5)) - 1, 5e-5);
        assertEquals(0.007, adams(new Complex(0, 0.8)) - 1, 5e-4);
        assertTrue(adams(new Complex(-0.02, 0.8)) < 1, "the outline runs close beside the axis");
    }

    /** Position and velocity steps on an undamped spring: a matrix of determinant 1 is stable up to |trace| = 2. */
    @Test
    void symplecticLimitsAreThoseOfTheTrace() {
        for (String name : new String[] {"symplectic-euler", "verlet"}) {
            assertEquals(2, SolverCatalog.info(name).imaginaryLimit(), name);      // |2 - h^2| <= 2
        }
        assertEquals(SolverCatalog.info("yoshida4").imaginaryLimit(),
                limit(h -> Math.abs(yoshidaTrace(h)) <= 2 + 1e-12 ? 1 : 2), 5.1e-5);
        // critically damped, symplectic Euler: 4 - h^2 - 4 h = 0
        assertEquals(2 * (Math.sqrt(2) - 1), SolverCatalog.info("symplectic-euler").dampedLimit(), 5.1e-5);
    }

    /** Three leapfrogs of the lengths w1, w0, w1. */
    private static double yoshidaTrace(double h) {
        double w1 = 1 / (2 - Math.cbrt(2));
        RealMatrix all = MatrixUtils.createRealIdentityMatrix(2);
        for (double w : new double[] {w1, 1 - 2 * w1, w1}) {
            double g = w * h;
            all = MatrixUtils.createRealMatrix(new double[][] {{1 - g * g / 2, g},
                {-g * (1 - g * g / 4), 1 - g * g / 2}}).multiply(all);
        }
        return all.getTrace();
    }
}
