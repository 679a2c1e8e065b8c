package particles.teaching.measured;

import deSolvers.DESolver;
import java.util.Optional;
import java.util.function.Supplier;
import java.util.stream.IntStream;
import particles.teaching.Finding;
import particles.teaching.sources.StudentSource;
import particles.teaching.sources.StudentSource.SecondOrderSource;

/**
 * Whether a step is the same with another unit of time, as it is unless the class holds a number of seconds or adds up
 * numbers of unlike units.
 */
public final class Units {
    /** So short that an adaptive method takes it in one go, and that its tolerance does not matter. */
    private static final double H = 1.0 / 256;
    /** A velocity for an acceleration is 2e-4 off, and the tolerance of an adaptive method allows 1e-6. */
    private static final double SAME = 2e-5;

    private Units() {
    }

    /** A falling particle on a spring with drag, in a unit of time of 1/parts s. */
    private static final class Spring extends StudentSource implements SecondOrderSource {
        private final double parts;

        Spring(double parts) {
            super(0.7, -0.4, 0.9, 5 / parts, 7 / parts, -6 / parts);
            this.parts = parts;
        }

        @Override
        public boolean accelerationDependsOnVelocity() {
            return true;
        }

        @Override
        protected void rates(double t, double[] s, double[] dSdt) {
            for (int k = 0; k < 6; k++) {
                dSdt[k] = k < 3 ? s[k + 3] : (1 + k * k - 40 * s[k - 3] - 2 * parts * s[k] + 4 * t / parts) / parts
                        / parts;
            }
        }
    }

    /** @return an entry of the new state that depends on the unit of time */
    public static Optional<Finding> mistake(Supplier<DESolver> maker) {
        double[] seconds = StudentSource.after(new Spring(1), maker.get(), 1, H).getState();
        double[] halves = StudentSource.after(new Spring(2), maker.get(), 1, 2 * H).getState();
        return IntStream.range(0, 6).mapToObj(k -> {
            double same = (k < 3 ? 1 : 2) * halves[k];
            return Phrase.UNITS.when(Math.abs(same - seconds[k]) > SAME, k, k < 3 ? "position" : "velocity", same
                    - seconds[k]);
        }).flatMap(Optional::stream).findFirst();
    }
}
