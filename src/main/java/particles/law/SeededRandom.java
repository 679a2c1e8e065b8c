package particles.law;

/**
 * Random number generator SplitMix64: the same seed gives the same numbers on every machine and JDK, which the
 * library's generators do not all promise.
 *
 * <p>Source: G. Steele, D. Lea, C. Flood, "Fast splittable pseudorandom number generators", OOPSLA 2014.
 */
public final class SeededRandom {
    private static final long GOLDEN_RATIO = 0x9e3779b97f4a7c15L;
    private static final double UNIT = 1.0 / (1L << 53);

    private long counter;

    /** @param seed any number; equal seeds give equal sequences */
    public SeededRandom(long seed) {
        counter = seed;
    }

    /** @return 64 random bits */
    public long nextLong() {
        counter += GOLDEN_RATIO;
        long z = (counter ^ (counter >>> 30)) * 0xbf58476d1ce4e5b9L;
        z = (z ^ (z >>> 27)) * 0x94d049bb133111ebL;
        return z ^ (z >>> 31);
    }

    /** @return a uniform random number, 0 &le; r &lt; 1, a multiple of 2<sup>-53</sup> */
    public double nextDouble() {
        return (nextLong() >>> 11) * UNIT;
    }

    /**
     * Returns a random direction, uniform over a cone.
     *
     * @param axis      the middle of the cone, of length 1
     * @param halfAngle the angle from its axis to its side (rad); pi for any direction in space
     * @return a vector of length 1
     */
    public Vector3 nextDirection(Vector3 axis, double halfAngle) {
        double cos = 1 - nextDouble() * (1 - StrictMath.cos(halfAngle));
        double turn = 2 * Math.PI * nextDouble();
        double sin = Math.sqrt(Math.max(0, 1 - cos * cos));
        Vector3 other = Math.abs(axis.x()) < 0.6 ? new Vector3(1, 0, 0) : new Vector3(0, 1, 0);
        Vector3 a = axis.cross(other).normalized();
        Vector3 b = axis.cross(a);
        return axis.times(cos).plus(a.times(sin * StrictMath.cos(turn))).plus(b.times(sin * StrictMath.sin(turn)));
    }
}
