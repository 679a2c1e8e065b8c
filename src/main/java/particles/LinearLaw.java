package particles;

/**
 * A force that is the same law for all particles and linear in the velocity: F = m g - c v. A system takes all of its laws
 * of this kind together, in the loop that has each particle's velocity at hand anyway.
 *
 * @param gx   the x component of g (m/s&sup2;)
 * @param gy   the y component of g (m/s&sup2;)
 * @param gz   the z component of g (m/s&sup2;)
 * @param drag c (N s/m)
 */
public record LinearLaw(double gx, double gy, double gz, double drag) {
    /** No force at all. */
    public static final LinearLaw NONE = new LinearLaw(0, 0, 0, 0);

    /**
     * @param other a second law
     * @return what both do together
     */
    public LinearLaw plus(LinearLaw other) {
        return new LinearLaw(gx + other.gx, gy + other.gy, gz + other.gz, drag + other.drag);
    }

    /** Writes the derivative's first part, v and this law's force, for the particles from ... to - 1. */
    void begin(double[] state, double[] masses, double[] dSdt, int from, int to) {
        double gx = this.gx;
        double gy = this.gy;
        double gz = this.gz;
        double c = drag;
        int i = from;
        for (int x = Particles.STRIDE * from; x < Particles.STRIDE * to; x += Particles.STRIDE) {
            double mass = masses[i++];
            double vx = state[x + 3];
            double vy = state[x + 4];
            double vz = state[x + 5];
            dSdt[x] = vx;
            dSdt[x + 1] = vy;
            dSdt[x + 2] = vz;
            dSdt[x + 3] = mass * gx - c * vx;
            dSdt[x + 4] = mass * gy - c * vy;
            dSdt[x + 5] = mass * gz - c * vz;
        }
    }
}
