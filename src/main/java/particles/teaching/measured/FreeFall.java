package particles.teaching.measured;

import deSolvers.DESolver;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.function.Supplier;
import particles.teaching.Finding;
import particles.teaching.sources.Falling;

/**
 * What a solver makes of particles without forces and with a constant acceleration, which every method of order 1 moves
 * exactly, but for the position that falls.
 *
 * @param deltaT the length of each step (s)
 * @param size   the velocity and the acceleration (m/s, m/s^2)
 * @param steps  the number of steps
 * @param axis   the axis of the motion
 * @param moved  the distance of a particle without forces, in units of v deltaT
 * @param kept   its velocity in units of v
 * @param fell   the distance of one that falls from rest, in units of a deltaT^2
 * @param speed  its velocity, in units of a deltaT
 */
public record FreeFall(double deltaT, double size, int steps, char axis, double moved, double kept, double fell,
        double speed) {
    /** What an iteration may leave. */
    private static final double SAME = 1e-6;
    private static final double USUAL = 1.3140625123;
    /**
     * Lengths of steps, and velocities and accelerations: what is cut off or rounded shows in some. No powers of 2, so
     * that float numbers show.
     */
    private static final double[][] TRIALS = {{0.1, USUAL}, {0.3, USUAL}, {0.001, USUAL}, {2, USUAL}, {0.1, 1.7e-4},
        {0.1, 2.9e3}};

    /** @return the motions along each axis after the first steps; none after one that is refused */
    private static List<FreeFall> of(Supplier<DESolver> maker, int steps, double[] trial) {
        double h = trial[0];
        double size = trial[1];
        Falling source = new Falling(size);
        DESolver solver = maker.get();
        List<FreeFall> falls = new ArrayList<>();
        for (int n = 1; n <= steps && source.accepts(solver, h); n++) {
            double[] s = Arrays.stream(source.getState()).map(x -> x / size).toArray();
            for (int c = 0; c < 3; c++) {
                falls.add(new FreeFall(h, size, n, "xyz".charAt(c), s[c] / h, s[c + 3], s[c + 6] / h / h, s[c + 9]
                        / h));
            }
        }
        return falls;
    }

    /** Whether a number is another one; what an iteration that diverged left is none. */
    private boolean off(double value, double right) {
        double off = Math.abs(value - right);
        return off > SAME * steps && off < Double.POSITIVE_INFINITY;
    }

    private Optional<Finding> mistake() {
        return Phrase.FLIGHT.when(off(moved, steps) || off(kept, 1), steps, deltaT, size, axis, moved, steps, kept).or(
                () -> Phrase.FALL.when(off(speed, steps), steps, deltaT, size, axis, speed, steps, fell, steps * steps
                / 2.0));
    }

    /**
     * @param steps the number of steps of each length; more for a solver that uses earlier ones
     * @return the first motion that is not exact
     */
    public static Optional<Finding> mistake(Supplier<DESolver> maker, int steps) {
        return Arrays.stream(TRIALS).flatMap(trial -> of(maker, steps, trial).stream()).flatMap(fall -> fall.mistake()
                .stream()).findFirst();
    }
}
