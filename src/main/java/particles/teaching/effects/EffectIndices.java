package particles.teaching.effects;

import java.util.Arrays;
import java.util.Objects;
import java.util.Optional;
import java.util.function.Function;
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
        return wrongHalf().or(() -> IntStream.range(0, trial.size() / 6).mapToObj(this::wrongParticle).flatMap(
                Optional::stream).findFirst());
    }

    /** Whether something changes with positions, 0, or velocities, 1. */
    private boolean changes(Function<double[], ?> what, int half) {
        return !Objects.deepEquals(what.apply(trial.state()), what.apply(trial.changed(k -> k % 6 / 3 == half, x ->
                (1 + MOVE) * x)));
    }

    private Optional<String> wrongHalf() {
        boolean positions = changes(trial::force, 0);
        boolean velocities = changes(trial::force, 1);
        if (trial.claims(Trait.CONSERVATIVE) && velocities && !positions && changes(trial::energy, 0)) {
            return Optional.of("the force depends on velocities and the potential energy on positions: the position of"
                    + " particle i begins at entry 6 i of the state, its velocity at 6 i + 3");
        }
        return trial.claims(Trait.DISSIPATIVE) && positions && !velocities && changes(trial::heat, 1)
                ? Optional.of("the force depends on positions and not on velocities, as the dissipated power does: the"
                + " velocity of particle i begins at entry 6 i + 3 of the state") : Optional.empty();
    }

    private Optional<String> wrongParticle(int i) {
        double[] force = forceOn(i, trial.state());
        int[] entries = IntStream.range(0, trial.size()).filter(m -> !Arrays.equals(force, forceOn(i, trial.moved(m,
                MOVE)))).toArray();
        if (entries.length == 0 || IntStream.of(entries).anyMatch(m -> m / 6 == i)) {
            return Optional.empty();
        }
        int first = entries[0];
        return Optional.of("the force on particle " + trial.id(i) + " changes with entry " + first + " of the state, a "
                + (first % 6 < 3 ? "position" : "velocity") + " of " + trial.id(first / 6) + ", and with nothing of its"
                + " own: each particle has six entries, its position from 6 i on and its velocity from 6 i + 3 on");
    }

    private double[] forceOn(int i, double[] state) {
        return Arrays.copyOfRange(trial.force(state), 6 * i, 6 * i + 6);
    }
}
