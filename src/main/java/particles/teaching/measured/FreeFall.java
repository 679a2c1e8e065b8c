package particles.teaching.measured;

import deSolvers.DESolver;
import java.util.Arrays;
import java.util.Optional;
import java.util.function.Supplier;
import java.util.stream.DoubleStream;
import particles.teaching.Finding;
import particles.teaching.sources.StudentSource;
import particles.teaching.sources.StudentSource.SecondOrderSource;

/**
 * What a solver makes of particles without forces and with a constant acceleration, which every method of order 1 moves
 * exactly, but for the position that falls.
 *
 * @param h     the length of the steps (s)
 * @param steps their number
 * @param moved the distance of a particle without forces, in units of v deltaT
 * @param kept  its velocity in units of v
 * @param fell  the distance of one that falls from rest, in units of a deltaT^2
 * @param speed its velocity, in units of a deltaT
 */
public record FreeFall(double h, int steps, double moved, double kept, double fell, double speed) {
    /** What an iteration may leave. */
    private static final double SAME = 1e-6;
    /** 1/3 as a float is off by 1e-8, and coefficients with eight digits add up to 1 to 1e-9. */
    private static final double FLOAT = 8e-9;
    private static final double ROUNDED = 1e-3;
    /** No powers of 2, so that float numbers show. */
    private static final double[] LENGTHS = {0.1, 0.3, 0.001, 2};
    /** Sizes of velocities and accelerations, to detect what is cut off or rounded; no powers of 2 either. */
    private static final double[] SIZES = {1.3140625123, 1.7e-4, 2.9e3};

    /** A particle that flies, and one that falls from rest, each in all three coordinates. */
    private static final class Falling extends StudentSource implements SecondOrderSource {
        private final double speed;

        Falling(double speed) {
            super(0, 0, 0, speed, speed, speed, 0, 0, 0, 0, 0, 0);
            this.speed = speed;
        }

        @Override
        protected void rates(double t, double[] s, double[] dSdt) {
            for (int k = 0; k < Math.min(dSdt.length, s.length); k++) {
                dSdt[k] = k % 6 < 3 ? s[k + 3] : k > 6 ? speed : 0;
            }
        }
    }

    /** @return what it makes in steps of this length; empty if it refuses them */
    public static Optional<FreeFall> of(Supplier<DESolver> maker, double h, int steps) {
        return of(maker, h, steps, SIZES[0]);
    }

    private static Optional<FreeFall> of(Supplier<DESolver> maker, double h, int steps, double size) {
        Falling source = new Falling(size);
        DESolver solver = maker.get();
        for (int step = 0; step < steps; step++) {
            if (!source.accepts(solver, h)) {
                return Optional.empty();
            }
        }
        double[] s = source.getState();
        return Optional.of(new FreeFall(h, steps, s[0] / size / h, s[3] / size, s[6] / size / h / h, s[9] / size
                / h)).filter(fall -> Arrays.stream(s).allMatch(Double::isFinite));
    }

    /** @return a step's numbers, if they are the same multiples of deltaT with another deltaT */
    public static Optional<FreeFall> inUnits(Supplier<DESolver> maker) {
        return of(maker, LENGTHS[0], 1).filter(one -> of(maker, LENGTHS[1], 1).filter(other -> !one.isUnlike(other))
                .isPresent());
    }

    /** @return whether what falls does so in another way */
    public boolean isUnlike(FreeFall other) {
        return off(fell, other.fell) || off(speed, other.speed);
    }

    private boolean off(double value, double right) {
        return Math.abs(value - right) > SAME * steps;
    }

    private String length() {
        return steps == 1 ? "a step" : steps + " steps";
    }

    private Optional<Finding> mistake() {
        double digits = Math.abs(moved / steps - 1);
        return Phrase.DIGITS.when(digits > FLOAT && digits < ROUNDED, digits).or(() -> Phrase.FLIGHT.when(off(moved,
                steps), length(), h, moved, steps)).or(() -> Phrase.FLIGHT_VELOCITY.when(
                off(kept, 1), kept, length())).or(() -> Phrase.FALL.when(off(speed, steps), length(), speed, steps,
                fell, steps * steps / 2.0));
    }

    /**
     * @param steps the number of steps of each length; more for a solver that uses earlier ones
     * @return the first motion that is not exact
     */
    public static Optional<Finding> mistake(Supplier<DESolver> maker, int steps) {
        Optional<FreeFall> one = of(maker, LENGTHS[0], 1);
        Optional<FreeFall> other = of(maker, LENGTHS[1], 1);
        if (one.isPresent() && other.isPresent()) {
            double seconds = one.get().moved * LENGTHS[0];
            if (seconds != 0 && one.get().off(one.get().moved, 1) && !one.get().off(other.get().moved * LENGTHS[1]
                    / seconds, 1)) {
                return Optional.of(Phrase.FLIGHT_FIXED.of(seconds));
            }
        }
        for (double h : LENGTHS) {
            for (int n = 1; n <= steps; n++) {
                Optional<Finding> found = of(maker, h, n).flatMap(FreeFall::mistake);
                if (found.isPresent()) {
                    return found;
                }
            }
        }
        return DoubleStream.of(SIZES).skip(1).boxed().flatMap(size -> of(maker, LENGTHS[0], 1, size).flatMap(
                FreeFall::mistake).map(found -> Phrase.CUT_OFF.of(size)).stream()).findFirst();
    }
}
