package particles.teaching.sources;

import particles.teaching.sources.StudentSource.SecondOrderSource;

/** A particle that flies without forces, and one that falls from rest, along all three axes. */
public final class Falling extends StudentSource implements SecondOrderSource {
    private final double size;

    /** @param size the velocity of the one and the acceleration of the other along each axis (m/s, m/s^2) */
    public Falling(double size) {
        super(0, 0, 0, size, size, size, 0, 0, 0, 0, 0, 0);
        this.size = size;
    }

    @Override
    protected void rates(double t, double[] s, double[] dSdt) {
        for (int k = 0; k < s.length; k++) {
            dSdt[k] = k % 6 < 3 ? s[k + 3] : k > 6 ? size : 0;
        }
    }
}
