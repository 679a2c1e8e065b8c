package particles.teaching.effects;

import java.util.Optional;
import java.util.function.ToDoubleFunction;
import java.util.stream.IntStream;
import particles.law.Effect.Trait;

/**
 * Looks for a wrong index in a law of which a declared property does not hold: compares the entries of the state on
 * which each force depends with those on which it should depend.
 */
record EffectIndices(EffectTrial trial) {
    private static final double MOVE = 1e-3;

    /** @return the wrong index in a sentence; empty if that is not the mistake */
    Optional<String> cause() {
        boolean[][] reads = reads();
        return wrongHalf(reads).or(() -> IntStream.range(0, reads.length).mapToObj(i -> wrongParticle(reads[i], i))
                .flatMap(Optional::stream).findFirst());
    }

    /** By particle and entry of the state. */
    private boolean[][] reads() {
        double[] force = trial.force();
        boolean[][] reads = new boolean[force.length / 6][force.length];
        for (int m = 0; m < force.length; m++) {
            double[] changed = trial.force(trial.moved(m, MOVE));
            for (int k = 0; k < force.length; k++) {
                reads[k / 6][m] |= changed[k] != force[k];
            }
        }
        return reads;
    }

    private boolean changes(ToDoubleFunction<double[]> amount, int half) {
        double before = amount.applyAsDouble(trial.state());
        return half(half).anyMatch(m -> amount.applyAsDouble(trial.moved(m, MOVE)) != before);
    }

    private IntStream half(int half) {
        return IntStream.range(0, trial.size()).filter(m -> m % 6 / 3 == half);
    }

    private Optional<String> wrongHalf(boolean[][] reads) {
        boolean positions = half(0).anyMatch(m -> reads(reads, m));
        boolean velocities = half(1).anyMatch(m -> reads(reads, m));
        if (trial.claims(Trait.CONSERVATIVE) && velocities && !positions && changes(trial::energy, 0)) {
            return Optional.of("the force depends on velocities and the potential energy on positions: the position of"
                    + " particle i begins at entry 6 i of the state, its velocity at 6 i + 3");
        }
        return trial.claims(Trait.DISSIPATIVE) && positions && !velocities && changes(trial::heat, 1)
                ? Optional.of("the force depends on positions and not on velocities, as the dissipated power does: the"
                + " velocity of particle i begins at entry 6 i + 3 of the state") : Optional.empty();
    }

    private static boolean reads(boolean[][] reads, int m) {
        return IntStream.range(0, reads.length).anyMatch(i -> reads[i][m]);
    }

    private Optional<String> wrongParticle(boolean[] reads, int i) {
        int[] entries = IntStream.range(0, reads.length).filter(m -> reads[m]).toArray();
        if (entries.length == 0 || IntStream.of(entries).anyMatch(m -> m / 6 == i)) {
            return Optional.empty();
        }
        int first = entries[0];
        return Optional.of("the force on particle " + trial.id(i) + " changes with entry " + first + " of the state, a "
                + (first % 6 < 3 ? "position" : "velocity") + " of " + trial.id(first / 6) + ", and with nothing of its"
                + " own: each particle has six entries, its position from 6 i on and its velocity from 6 i + 3 on");
    }
}
