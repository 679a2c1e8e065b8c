package particles.experiments.stability;

import deSolvers.catalog.SolverInfo;

/**
 * The stability polynomial R(ih) of a method, for a step on the slides' oscillator x'' = -x: as z = x - i v obeys z' =
 * i z, the step multiplies z by R(ih). N steps multiply the amplitude by |R|<sup>N</sup>, and the phase runs ahead of
 * the exact one by N (arg R - h).
 *
 * @param re the real part of R(ih)
 * @param im the imaginary part
 */
public record StabilityPolynomial(double re, double im) {

    /**
     * @param solver a solver of the catalogue
     * @param h      the time step
     * @return R(ih) of the slides' methods and of the implicit ones of order 1 and 2; NaN of others
     */
    public static StabilityPolynomial of(SolverInfo solver, double h) {
        if (solver.adaptive() || !solver.implicit() && !solver.family().equals("slides")) {
            return new StabilityPolynomial(Double.NaN, Double.NaN);
        }
        if (solver.implicit()) {                        // 1/(1 - z) or (1 + z/2)/(1 - z/2)
            double a = h / solver.order();
            double norm = 1 + a * a;
            return new StabilityPolynomial((solver.order() == 1 ? 1 : 1 - a * a) / norm, h / norm);
        }
        double re = 1;
        double im = 0;
        for (int k = solver.order(); k > 0; k--) {      // with as many stages as its order: the series of e^z up to it
            double before = re;
            re = 1 - h / k * im;
            im = h / k * before;
        }
        return new StabilityPolynomial(re, im);
    }

    /** @return |R|<sup>steps</sup>, the factor of the amplitude after a number of steps */
    public double amplitude(int steps) {
        return StrictMath.pow(Math.sqrt(re * re + im * im), steps);
    }

    /** @return the angle by which the solution is ahead of the exact one after a number of steps of h (rad) */
    public double phaseError(int steps, double h) {
        return steps * (StrictMath.atan2(im, re) - h);
    }
}
