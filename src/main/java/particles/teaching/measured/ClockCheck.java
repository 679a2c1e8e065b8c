package particles.teaching.measured;

import deSolvers.DESolver;
import java.util.Optional;
import java.util.function.Supplier;
import particles.teaching.Finding;
import particles.teaching.Formula;
import particles.teaching.sources.Springs;
import particles.teaching.sources.WindyOscillators;

/** Whether the clock ends where the step does: for steps of several lengths, and later ones. */
public final class ClockCheck {
    private static final double START = 2;
    /** The last one is no power of 2, so that a clock in float arithmetic shows. */
    private static final double[] LENGTHS = {1.0 / 32, 0.25, 0.1};
    private static final double ROUNDING = 1e-13;
    private static final int STEPS = 6;

    private ClockCheck() {
    }

    /** @return the first clock that is wrong */
    public static Optional<Finding> mistake(Supplier<DESolver> maker) {
        for (double h : LENGTHS) {
            DESolver solver = maker.get();
            WindyOscillators source = new WindyOscillators(1).from(START);
            for (int step = 1; step <= STEPS; step++) {
                double before = source.getTime();
                source.step(solver, h);
                double moved = source.getTime() - before;
                if (Math.abs(moved - h) > STEPS * ROUNDING * h) {
                    return Optional.of(wrong(maker, h, moved, step));
                }
            }
        }
        Springs resting = new Springs(0, 0);
        resting.step(maker.get(), LENGTHS[0]);
        return Phrase.CLOCK_AT_REST.when(!Formula.sameTime(resting.getTime() / LENGTHS[0], 1), resting.getTime(),
                LENGTHS[0]);
    }

    private static Finding wrong(Supplier<DESolver> maker, double h, double moved, int step) {
        WindyOscillators other = new WindyOscillators(1).from(START);
        other.step(maker.get(), 2 * h);
        if (moved == 0 && step == 1) {
            return Phrase.CLOCK_STILL.of();
        } else if (step == 1 && Formula.sameTime(other.getTime() - START, moved)) {
            return Phrase.CLOCK_FIXED.of(moved);
        }
        Optional<FreeFall> fall = FreeFall.of(maker, h, 1).filter(one -> step == 1 && Formula.same(one.moved(), moved
                / h));
        return fall.isPresent() ? Phrase.LENGTH.of(Formula.time(moved / h)) : Phrase.CLOCK_ENDS.of(step == 1 ? ""
                : "from step " + step + " on ", Formula.time(moved / h), h);
    }
}
