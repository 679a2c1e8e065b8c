package particles.teaching.measured;

import deSolvers.DESolver;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.function.Supplier;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import particles.teaching.Finding;
import particles.teaching.sources.StudentSource;
import particles.teaching.sources.StudentSource.SecondOrderSource;

/**
 * What a solver makes of particles without forces and with a constant acceleration, which every method of order 1 moves
 * exactly, but for the position that falls.
 *
 * @param trial the steps
 * @param axis  the axis of the motion
 * @param moved the distance of a particle without forces, in units of v deltaT
 * @param kept  its velocity in units of v
 * @param fell  the distance of one that falls from rest, in units of a deltaT^2
 * @param speed its velocity, in units of a deltaT
 */
public record FreeFall(Trial trial, char axis, double moved, double kept, double fell, double speed) {
    /** What an iteration may leave. */
    private static final double SAME = 1e-6;
    /** No powers of 2, so that float numbers show. */
    private static final List<Trial> TRIALS = List.of(new Trial(0.1, 1.3140625123), new Trial(0.3, 1.3140625123),
            new Trial(0.001, 1.3140625123), new Trial(2, 1.3140625123), new Trial(0.1, 1.7e-4), new Trial(0.1, 2.9e3));

    /**
     * Steps from the start.
     *
     * @param deltaT the length of each (s)
     * @param size   the velocity and the acceleration (m/s, m/s^2): what is cut off or rounded shows in some
     * @param steps  their number
     */
    public record Trial(double deltaT, double size, int steps) {
        Trial(double deltaT, double size) {
            this(deltaT, size, 1);
        }
    }

    /** A particle that flies, and one that falls from rest, each in all three coordinates. */
    private static final class Falling extends StudentSource implements SecondOrderSource {
        private final double speed;

        Falling(double speed) {
            super(0, 0, 0, speed, speed, speed, 0, 0, 0, 0, 0, 0);
            this.speed = speed;
        }

        @Override
        protected void rates(double t, double[] s, double[] dSdt) {
            for (int k = 0; k < s.length; k++) {
                dSdt[k] = k % 6 < 3 ? s[k + 3] : k > 6 ? speed : 0;
            }
        }
    }

    /** @return what it makes of them along each axis; none if it refuses */
    private static Stream<FreeFall> of(Supplier<DESolver> maker, Trial trial) {
        Falling source = new Falling(trial.size);
        DESolver solver = maker.get();
        double h = trial.deltaT;
        boolean made = Stream.generate(() -> source.accepts(solver, h)).limit(trial.steps).allMatch(one -> one);
        double[] s = Arrays.stream(source.getState()).map(x -> x / trial.size).toArray();
        return IntStream.range(0, 3).filter(c -> made && Arrays.stream(s).allMatch(Double::isFinite)).mapToObj(c ->
                new FreeFall(trial, "xyz".charAt(c), s[c] / h, s[c + 3], s[c + 6] / h / h, s[c + 9] / h));
    }

    /** @return a step's numbers, if they are the same multiples of deltaT with another deltaT */
    public static Optional<FreeFall> inUnits(Supplier<DESolver> maker) {
        return of(maker, TRIALS.get(0)).findFirst().filter(one -> of(maker, TRIALS.get(1)).noneMatch(one::isUnlike));
    }

    /** @return whether what falls does so in another way */
    public boolean isUnlike(FreeFall other) {
        return off(fell, other.fell) || off(speed, other.speed);
    }

    private boolean off(double value, double right) {
        return Math.abs(value - right) > SAME * trial.steps;
    }

    private Optional<Finding> mistake() {
        int n = trial.steps;
        return Phrase.FLIGHT.when(off(moved, n) || off(kept, 1), n, trial.deltaT, trial.size, axis, moved, n,
                kept).or(() ->
                Phrase.FALL.when(off(speed, n), n, trial.deltaT, trial.size, axis, speed, n, fell, n * n
                / 2.0));
    }

    /**
     * @param steps the number of steps of each length; more for a solver that uses earlier ones
     * @return the first motion that is not exact
     */
    public static Optional<Finding> mistake(Supplier<DESolver> maker, int steps) {
        return TRIALS.stream().flatMap(trial -> IntStream.rangeClosed(1, steps).mapToObj(n -> new Trial(trial.deltaT,
                trial.size, n))).flatMap(trial -> of(maker, trial)).flatMap(fall -> fall.mistake().stream())
                .findFirst();
    }
}
