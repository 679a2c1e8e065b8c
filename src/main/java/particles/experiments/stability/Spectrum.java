package particles.experiments.stability;

import java.util.List;
import particles.ParticleSystem;

/**
 * The spectrum of a system: the eigenvalues of its small motions, as far as the iteration found them.
 *
 * @param modes the modes by falling |lambda|, without those whose lambda is 0
 */
public record Spectrum(List<Mode> modes) {
    /**
     * @param system the system in the state in question; not changed
     * @return its spectrum; without modes if nothing can move or no force acts
     */
    public static Spectrum of(ParticleSystem system) {
        Linearisation linear = new Linearisation(system);
        return new Spectrum(linear.coordinates() == 0 ? List.of() : Arnoldi.modes(linear));
    }

    /** @return the modes that do not grow by themselves, the fastest first */
    public List<Mode> decaying() {
        return modes.stream().filter(mode -> mode.re() <= 0).toList();
    }

    /**
     * A mode of a linearised system, s(t) = shape e<sup>lambda t</sup>: its eigenvalue lambda, and the damped spring
     * x'' = -stiffness x - damping x' that moves like it. Of a conjugate pair only the mode with positive Im lambda is
     * kept.
     *
     * @param re        Re lambda (1/s), negative for decay
     * @param im        Im lambda (1/s), 0 or more: the angular frequency
     * @param stiffness omega&sup2; of the spring (1/s&sup2;)
     * @param damping   c of the spring (1/s)
     * @param farthest  the id of the particle that moves farthest in it
     */
    public record Mode(double re, double im, double stiffness, double damping, String farthest) {
        /** @return |lambda| (1/s) */
        public double size() {
            return Math.sqrt(re * re + im * im);
        }
    }
}
