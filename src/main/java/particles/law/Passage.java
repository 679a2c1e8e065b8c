package particles.law;

/**
 * Finds where the path of a sub-step passes through the reach of a force that neither of its ends feels, as a particle
 * that grazes a ball does. The path is the cubic through the positions and velocities at both ends. A law says how deep
 * something is in its reach.
 *
 * <p>The depth may grow at the beginning of the path and fall at its end; it is then largest somewhere between, where
 * its rate changes sign. Both that time and the time of entry are found by bisection.
 */
public abstract class Passage {
    /** An end feels a passage if it is at least so deep inside, as a part of the largest depth. */
    private static final double FELT = 0.1;
    /** Each halves the interval in which a time is. */
    private static final int BISECTIONS = 40;

    private final double[] begin;
    private final double[] end;
    private final double[] at;
    private double h;

    /** Begins without a path. */
    protected Passage() {
        begin = new double[Particles.STRIDE];
        end = begin.clone();
        at = begin.clone();
    }

    /**
     * @param s a position (m) and a velocity (m/s), of a particle or of one relative to another
     * @return how deep it is in the reach of the force (m); negative outside
     */
    protected abstract double depth(double[] s);

    /**
     * @param s a position and a velocity
     * @return the rate of the depth (m/s), or a positive multiple of it
     */
    protected abstract double sinking(double[] s);

    /**
     * Looks at the paths of all free particles.
     *
     * @param particles the particles
     * @param from      the state at the beginning
     * @param to        the state at the end
     * @param duration  the duration (s); negative if it goes backwards in time
     * @return the duration of a shorter sub-step, which ends at the first entry, or at the largest depth if it begins
     *         near the entry (s, positive); infinite if there is no such passage
     */
    public final double find(Particles particles, double[] from, double[] to, double duration) {
        double first = Double.POSITIVE_INFINITY;
        for (int i = 0; i < particles.count(); i++) {
            if (!particles.isFixed(i)) {
                System.arraycopy(from, Particles.STRIDE * i, begin, 0, begin.length);
                System.arraycopy(to, Particles.STRIDE * i, end, 0, end.length);
                first = Math.min(first, find(duration));
            }
        }
        return first;
    }

    /**
     * Looks at the path of a particle as seen from another one.
     *
     * @param from     the state at the beginning
     * @param to       the state at the end
     * @param i        a particle
     * @param j        another one
     * @param duration the duration (s); negative if it goes backwards in time
     * @return as {@link #find(Particles, double[], double[], double)}
     */
    public final double find(double[] from, double[] to, int i, int j, double duration) {
        for (int c = 0; c < begin.length; c++) {
            begin[c] = from[Particles.STRIDE * i + c] - from[Particles.STRIDE * j + c];
            end[c] = to[Particles.STRIDE * i + c] - to[Particles.STRIDE * j + c];
        }
        return find(duration);
    }

    private double find(double duration) {
        h = duration;
        if (!(h * sinking(begin) > 0 && h * sinking(end) < 0)) {
            return Double.POSITIVE_INFINITY;
        }
        double middle = bisect(1, true);
        move(middle);
        double deepest = depth(at);
        if (!(deepest > 0 && FELT * deepest > Math.max(depth(begin), depth(end)))) {
            return Double.POSITIVE_INFINITY;
        }
        double entry = bisect(middle, false);
        return Math.abs(h) * (entry > middle - entry ? entry : middle);
    }

    /** The last fraction of the duration, below this one, at which it is still sinking; or else still outside. */
    private double bisect(double high, boolean sinking) {
        double low = 0;
        for (int k = 0; k < BISECTIONS; k++) {
            double u = (low + high) / 2;
            move(u);
            if (sinking ? h * sinking(at) > 0 : depth(at) <= 0) {
                low = u;
            } else {
                high = u;
            }
        }
        return low;
    }

    /** Moves to a fraction of the duration. */
    private void move(double u) {
        for (int c = 0; c < 3; c++) {
            double way = end[c] - begin[c];
            at[c] = begin[c] + u * u * (3 - 2 * u) * way
                    + u * (1 - u) * h * ((1 - u) * begin[c + 3] - u * end[c + 3]);
            at[c + 3] = 6 * u * (1 - u) * way / h + (1 - u) * (1 - 3 * u) * begin[c + 3]
                    + u * (3 * u - 2) * end[c + 3];
        }
    }
}
