package particles.teaching.effects;

import java.util.Optional;
import java.util.function.ToDoubleFunction;
import particles.ParticleSystem;
import particles.law.Effect;
import particles.law.Effect.Trait;

/**
 * Looks for a wrong index in a law of which a declared property does not hold: compares the entries of the state on
 * which each force depends with those on which it should depend.
 */
final class EffectIndices {
    private static final double MOVE = 1e-3;

    private final ParticleSystem system;
    private final Effect effect;
    private final double[] state;
    private final int n;

    EffectIndices(ParticleSystem system, Effect effect, double[] state) {
        this.system = system;
        this.effect = effect;
        this.state = state;
        n = state.length;
    }

    /** @return the wrong index in a sentence; empty if that is not the mistake */
    Optional<String> cause() {
        boolean[][] reads = reads();
        return wrongHalf(reads).or(() -> wrongParticle(reads));
    }

    /** By particle and entry of the state. */
    private boolean[][] reads() {
        double[] force = force(state);
        boolean[][] reads = new boolean[n / 6][n];
        for (int m = 0; m < n; m++) {
            double[] moved = state.clone();
            moved[m] += MOVE;
            double[] changed = force(moved);
            for (int k = 0; k < n; k++) {
                reads[k / 6][m] |= changed[k] != force[k];
            }
        }
        return reads;
    }

    private double[] force(double[] at) {
        double[] force = new double[n];
        effect.addForces(at, 0, force);
        return force;
    }

    private static boolean any(boolean[][] reads, int half) {
        for (boolean[] row : reads) {
            for (int m = 0; m < row.length; m++) {
                if (row[m] && m % 6 / 3 == half) {
                    return true;
                }
            }
        }
        return false;
    }

    private boolean changes(ToDoubleFunction<double[]> amount, int half) {
        double before = amount.applyAsDouble(state);
        for (int m = 3 * half; m < n; m += m % 3 == 2 ? 4 : 1) {
            double[] moved = state.clone();
            moved[m] += MOVE;
            if (amount.applyAsDouble(moved) != before) {
                return true;
            }
        }
        return false;
    }

    private Optional<String> wrongHalf(boolean[][] reads) {
        boolean positions = any(reads, 0);
        boolean velocities = any(reads, 1);
        if (effect.getTraits().contains(Trait.CONSERVATIVE) && velocities && !positions
                && changes(at -> effect.getPotentialEnergy(at, 0), 0)) {
            return Optional.of("the force depends on velocities and the potential energy on positions: the position of"
                    + " particle i begins at entry 6 i of the state, its velocity at 6 i + 3");
        }
        return effect.getTraits().contains(Trait.DISSIPATIVE) && positions && !velocities
                && changes(at -> effect.getDissipatedPower(at, 0), 1)
                ? Optional.of("the force depends on positions and not on velocities, as the dissipated power does: the"
                + " velocity of particle i begins at entry 6 i + 3 of the state") : Optional.empty();
    }

    private Optional<String> wrongParticle(boolean[][] reads) {
        for (int i = 0; i < reads.length; i++) {
            int first = -1;
            boolean own = false;
            for (int m = 0; m < n; m++) {
                own |= reads[i][m] && m / 6 == i;
                first = reads[i][m] && first < 0 ? m : first;
            }
            if (first >= 0 && !own) {
                return Optional.of("the force on particle '" + id(i) + "' changes with entry " + first
                        + " of the state, a " + (first % 6 < 3 ? "position" : "velocity") + " of '" + id(first / 6)
                        + "', and with nothing of its own: each particle has six entries, its position from 6 i on and"
                        + " its velocity from 6 i + 3 on");
            }
        }
        return Optional.empty();
    }

    private String id(int i) {
        return system.getParticles().id(i);
    }
}
