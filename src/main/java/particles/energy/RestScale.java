package particles.energy;

import particles.ParticleSystem;
import particles.law.Particles;

/** The energy scale of a scene in which nothing moves: weight times height. */
final class RestScale {
    /** Relative to coordinates: particles at one level may differ by this in height. */
    private static final double ROUND_OFF = 1e-12;

    private RestScale() {
    }

    /**
     * @param system the system at its start
     * @return the length of the sum of all effects' forces on the particles that can move, times the extent of all
     *         particles along it, or times 1 m where they have none beyond round-off (J); 0 without force
     */
    static double of(ParticleSystem system) {
        Particles particles = system.getParticles();
        double[] state = system.getOwnState();
        double[] force = new double[system.getStateSize()];
        system.addUpEffects(state, system.getTime(), force);
        double[] sum = new double[3];
        for (int i = 0; i < particles.count(); i++) {
            for (int c = 0; c < 3 && !particles.isFixed(i); c++) {
                sum[c] += force[Particles.STRIDE * i + 3 + c];
            }
        }
        double weight = Math.sqrt(sum[0] * sum[0] + sum[1] * sum[1] + sum[2] * sum[2]);
        if (!(weight > 0)) {
            return 0;
        }
        double lowest = Double.POSITIVE_INFINITY;
        double highest = Double.NEGATIVE_INFINITY;
        double size = 0;
        for (int x = 0; x < force.length; x += Particles.STRIDE) {
            double along = (state[x] * sum[0] + state[x + 1] * sum[1] + state[x + 2] * sum[2]) / weight;
            lowest = Math.min(lowest, along);
            highest = Math.max(highest, along);
            size = Math.max(size, Math.abs(along));
        }
        return weight * (highest - lowest > ROUND_OFF * size ? highest - lowest : 1);
    }
}
