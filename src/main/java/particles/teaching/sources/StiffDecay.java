package particles.teaching.sources;

import java.util.Arrays;

/**
 * A stiff decay, y' = -1000 y in each of six entries, from y = 1: an implicit step of 1 s makes it smaller, an explicit
 * one larger.
 */
public final class StiffDecay extends StudentSource {
    /** The decay rate (1/s). */
    public static final double RATE = 1000;

    /** Creates a source with 1 in all entries. */
    public StiffDecay() {
        super(1, 1, 1, 1, 1, 1);
    }

    /** @return the largest entry */
    public double size() {
        return Arrays.stream(getState()).map(Math::abs).max().orElseThrow();
    }

    @Override
    protected void rates(double t, double[] s, double[] dSdt) {
        for (int k = 0; k < Math.min(s.length, dSdt.length); k++) {
            dSdt[k] = -RATE * s[k];
        }
    }
}
