package particles.experiments.spectrum;

import java.util.List;
import particles.ParticleSystem;

/**
 * The eigenvalues of a system's small motions, as far as the iteration found them; always the fastest first.
 *
 * @param modes    by falling |lambda|, without those whose lambda is 0
 * @param method   how they were found
 * @param products multiplications with the Jacobian
 * @param error    of the largest |lambda|, relative, at most
 */
public record Spectrum(List<Mode> modes, String method, int products, double error) {
    /** What an iteration may keep: 256 MB of directions. */
    private static final long MOST_DOUBLES = 1L << 25;
    private static final int MOST_DIRECTIONS = 300;
    private static final int FEWEST_DIRECTIONS = 12;
    /** Values whose residual is larger than this part of the largest one are not yet eigenvalues. */
    static final double CONVERGED = 1e-3;
    /**
     * A lambda below this part of the largest is a free motion or a rest of rounding: the root of the precision,
     * as 0 is double.
     */
    static final double ZERO = 1e-6;

    /**
     * @param system at the state that is asked about; not changed
     * @return its spectrum; no modes where nothing can move or nothing acts on what can
     */
    public static Spectrum of(ParticleSystem system) {
        Linearisation linear = new Linearisation(system);
        if (linear.coordinates() == 0) {
            return new Spectrum(List.of(), "nothing can move", 0, 0);
        }
        return linear.isConservative() ? Lanczos.spectrum(linear) : Arnoldi.spectrum(linear);
    }

    /** @return how many directions of so many doubles may be kept; no more than there are */
    static int directions(int doubles) {
        long fit = Math.max(FEWEST_DIRECTIONS, MOST_DOUBLES / doubles);
        return (int) Math.min(doubles, Math.min(MOST_DIRECTIONS, fit));
    }

    /**
     * @return the fastest growth of the motion itself (1/s), which is physics and no solver's fault; 0 if nothing grows
     */
    public double growth() {
        return modes.stream().mapToDouble(Mode::re).filter(re -> re > 0).max().orElse(0);
    }
}
