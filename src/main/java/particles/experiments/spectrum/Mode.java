package particles.experiments.spectrum;

/**
 * A mode of a linearised system, s(t) = shape e<sup>lambda t</sup>: its eigenvalue lambda, and the damped spring x'' =
 * -stiffness x - damping x' that moves like it. Of a conjugate pair only the mode with positive Im lambda is kept.
 *
 * @param re        Re lambda (1/s), negative for decay
 * @param im        Im lambda (1/s), 0 or more: the angular frequency
 * @param stiffness omega&sup2; of the spring (1/s&sup2;)
 * @param damping   c of the spring (1/s)
 * @param shape     the displacement and the velocity at time 0 in the layout of the state, up to a factor
 */
public record Mode(double re, double im, double stiffness, double damping, double[] shape) {

    /** @return |lambda| (1/s) */
    public double size() {
        return Math.sqrt(re * re + im * im);
    }
}
