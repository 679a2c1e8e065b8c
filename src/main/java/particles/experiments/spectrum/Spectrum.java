package particles.experiments.spectrum;

import java.util.List;
import particles.ParticleSystem;

/**
 * The spectrum of a system: the eigenvalues of its small motions, as far as the iteration found them, the fastest
 * first.
 *
 * @param modes    the modes by falling |lambda|, without those whose lambda is 0
 * @param products the number of multiplications with the Jacobian
 * @param error    a bound for the relative error of the largest |lambda|
 */
public record Spectrum(List<Mode> modes, int products, double error) {
    /** The largest memory for directions, 256 MB. */
    private static final long MOST_DOUBLES = 1L << 25;
    private static final int MOST_DIRECTIONS = 300;
    private static final int FEWEST_DIRECTIONS = 12;
    /** Values whose residual is larger than this part of the largest one are not yet eigenvalues. */
    static final double CONVERGED = 1e-3;
    /**
     * A lambda below this part of the largest is a free motion or round-off. It is the square root of the precision, as
     * 0 is a double eigenvalue.
     */
    static final double ZERO = 1e-6;

    /**
     * @param system the system in the state in question; not changed
     * @return its spectrum; without modes if nothing can move or no force acts
     */
    public static Spectrum of(ParticleSystem system) {
        Linearisation linear = new Linearisation(system);
        if (linear.coordinates() == 0) {
            return new Spectrum(List.of(), 0, 0);
        }
        return Arnoldi.spectrum(linear);
    }

    /** @return the number of directions of this size that fit into memory, at most the size */
    static int directions(int doubles) {
        long fit = Math.max(FEWEST_DIRECTIONS, MOST_DOUBLES / doubles);
        return (int) Math.min(doubles, Math.min(MOST_DIRECTIONS, fit));
    }

    /** @return the modes that do not grow by themselves, the fastest first */
    public List<Mode> decaying() {
        return modes.stream().filter(mode -> mode.re() <= 0).toList();
    }

    /**
     * @return the fastest growth of the motion itself (1/s), which is physics and not an error of the solver; 0 if
     *         nothing grows
     */
    public double growth() {
        return modes.stream().mapToDouble(Mode::re).filter(re -> re > 0).max().orElse(0);
    }
}
