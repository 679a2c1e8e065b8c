package particles.energy;

import java.util.DoubleSummaryStatistics;
import particles.ParticleSystem;
import particles.law.Particles;
import particles.law.Vector3;

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
        Vector3 sum = Vector3.ZERO;
        for (int i = 0; i < particles.count(); i++) {
            sum = particles.isFixed(i) ? sum : sum.plus(Vector3.at(force, Particles.STRIDE * i + 3));
        }
        double weight = Math.sqrt(sum.dot(sum));
        if (!(weight > 0)) {
            return 0;
        }
        DoubleSummaryStatistics along = particles.along(state, sum);
        double most = along.getMax() / weight;
        double least = along.getMin() / weight;
        return weight * (most - least > ROUND_OFF * Math.max(most, -least) ? most - least : 1);
    }
}
