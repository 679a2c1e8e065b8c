package particles.experiments.runs;

import particles.Motion;
import particles.Observer;
import particles.ParticleSystem;
import particles.Rule;
import particles.law.Particles;
import particles.law.Vector3;

/**
 * The box in which a run takes place: from the lowest to the highest coordinates that any particle had after any step.
 */
public final class Extent implements Observer {
    private final double[] low = {Double.POSITIVE_INFINITY, Double.POSITIVE_INFINITY, Double.POSITIVE_INFINITY};
    private final double[] high = {Double.NEGATIVE_INFINITY, Double.NEGATIVE_INFINITY, Double.NEGATIVE_INFINITY};

    @Override
    public void started(ParticleSystem system) {
        include(system, system.getOwnState());
    }

    @Override
    public void moved(Motion motion) {
        include(motion.getSystem(), motion.getEndState());
    }

    @Override
    public void changed(ParticleSystem system, Rule rule) {
        include(system, system.getOwnState());
    }

    private void include(ParticleSystem system, double[] state) {
        for (int i = 0, x = 0; i < system.getParticles().count(); i++, x += Particles.STRIDE) {
            for (int c = 0; c < 3; c++) {
                low[c] = Math.min(low[c], state[x + c]);
                high[c] = Math.max(high[c], state[x + c]);
            }
        }
    }

    /** @return its longest edge (m) */
    public double longest() {
        return Math.max(high[0] - low[0], Math.max(high[1] - low[1], high[2] - low[2]));
    }

    /** @return whether the particle with its state from x on is farther outside than a length (m) */
    public boolean isBeyond(double length, double[] state, int x) {
        for (int c = 0; c < 3; c++) {
            if (state[x + c] < low[c] - length || state[x + c] > high[c] + length) {
                return true;
            }
        }
        return false;
    }

    /** @return the corner with the lowest coordinates (m); infinite before a run */
    public Vector3 low() {
        return Vector3.at(low, 0);
    }

    /** @return the corner with the highest coordinates (m) */
    public Vector3 high() {
        return Vector3.at(high, 0);
    }
}
