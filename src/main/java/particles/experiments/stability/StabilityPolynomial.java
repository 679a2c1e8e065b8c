package particles.experiments.stability;

import deSolvers.catalog.SolverInfo;
import deSolvers.catalog.SolverInfo.Family;
import org.hipparchus.complex.Complex;

/**
 * The stability polynomial R(ih) of a method, for a step on the slides' oscillator x'' = -x: as z = x - i v obeys z' =
 * i z, the step multiplies z by R(ih). N steps multiply the amplitude by |R|<sup>N</sup>, and the phase runs ahead of
 * the exact one by N (arg R - h).
 *
 * @param r R(ih)
 */
public record StabilityPolynomial(Complex r) {

    /**
     * @param solver a solver of the catalogue
     * @param h      the time step
     * @return R(ih) of the slides' methods and of the implicit ones of order 1 and 2; NaN of others
     */
    public static StabilityPolynomial of(SolverInfo solver, double h) {
        if (solver.adaptive() || !solver.implicit() && solver.family() != Family.SLIDES) {
            return new StabilityPolynomial(Complex.NaN);
        }
        Complex z = new Complex(0, h);
        Complex r = Complex.ONE;
        if (solver.implicit()) {                        // 1/(1 - z) or (1 + z/2)/(1 - z/2)
            Complex above = solver.order() == 1 ? r : r.add(z.divide(2));
            return new StabilityPolynomial(above.divide(r.subtract(z.divide(solver.order()))));
        }
        for (int k = solver.order(); k > 0; k--) {      // with as many stages as its order: the series of e^z up to it
            r = z.divide(k).multiply(r).add(1);
        }
        return new StabilityPolynomial(r);
    }

    /** @return |R|<sup>steps</sup>, the factor of the amplitude after a number of steps */
    public double amplitude(int steps) {
        return StrictMath.pow(r.norm(), steps);
    }

    /** @return the angle by which the solution is ahead of the exact one after a number of steps of h (rad) */
    public double phaseError(int steps, double h) {
        return steps * (r.getArgument() - h);
    }
}
