package particles.experiments.grid;

import particles.Motion;
import particles.Observer;
import particles.ParticleSystem;
import particles.Rule;
import particles.law.Particles;

/** Counts impacts: changes by a rule that turn the velocity of a particle by more than round-off. */
final class ImpactCount implements Observer {
    /** The least change of a velocity, relative to it. */
    private static final double LEAST = 1e-6;

    private double[] before = {};
    private double first = Double.NaN;
    private int count;

    @Override
    public void started(ParticleSystem system) {
        before = system.getOwnState().clone();
    }

    @Override
    public void moved(Motion motion) {
        before = motion.getEndState().clone();
    }

    @Override
    public void changed(ParticleSystem system, Rule rule) {
        double[] after = system.getOwnState();
        if (!rule.isCorrection() && after.length == before.length && isTurned(after)) {
            first = count++ == 0 ? system.getTime() : first;
        }
        before = after.clone();
    }

    private boolean isTurned(double[] after) {
        for (int v = 3; v < after.length; v += Particles.STRIDE) {
            double turn = 0;
            double speed = 0;
            for (int c = v; c < v + 3; c++) {
                turn += (after[c] - before[c]) * (after[c] - before[c]);
                speed += before[c] * before[c];
            }
            if (turn > LEAST * LEAST * speed) {
                return true;
            }
        }
        return false;
    }

    double getFirst() {
        return first;
    }

    int getCount() {
        return count;
    }
}
