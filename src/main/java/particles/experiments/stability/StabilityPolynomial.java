package particles.experiments.stability;

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
     * @param solver a solver's name
     * @param h      the time step
     * @return R(ih); NaN if its polynomial is not known here
     */
    public static StabilityPolynomial of(String solver, double h) {
        return switch (solver) {
            case "euler" -> new StabilityPolynomial(1, h);
            case "midpoint" -> new StabilityPolynomial(1 - h * h / 2, h);
            case "rk4" -> new StabilityPolynomial(1 - h * h / 2 + h * h * h * h / 24, h - h * h * h / 6);
            case "backward-euler", "linearised-euler" -> new StabilityPolynomial(1 / (1 + h * h), h / (1 + h * h));
            case "implicit-midpoint" -> {
                double norm = 1 + h * h / 4;
                yield new StabilityPolynomial((1 - h * h / 4) / norm, h / norm);
            }
            default -> new StabilityPolynomial(Double.NaN, Double.NaN);
        };
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
