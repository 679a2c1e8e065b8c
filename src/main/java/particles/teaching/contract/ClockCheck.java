package particles.teaching.contract;

import deSolvers.DESolver;
import java.util.Optional;
import java.util.function.Supplier;
import particles.teaching.Finding;
import particles.teaching.Formula;
import particles.teaching.sources.StudentSource;
import particles.teaching.sources.WindyOscillators;

/** Whether the clock ends where the step does: for steps of several lengths, and later ones. */
public final class ClockCheck {
    private static final double START = 2;
    private static final double H = 1.0 / 32;
    /** No power of 2, so that a clock in float arithmetic shows. */
    private static final double TENTH = 0.1;
    private static final double ROUNDING = 1e-13;
    private static final int LATER_STEPS = 6;
    /** The state belongs to the time at which it is this much more accurate. */
    private static final double MUCH_BETTER = 0.25;

    private ClockCheck() {
    }

    /** @return the first clock that is wrong, with its cause */
    public static Optional<Finding> mistake(Supplier<DESolver> maker) {
        for (double h : new double[] {H, 8 * H, TENTH}) {
            DESolver solver = maker.get();
            WindyOscillators source = begun();
            for (int step = 1; step <= LATER_STEPS; step++) {
                double before = source.getTime();
                int moves = source.timeMoves();
                source.step(solver, h);
                double moved = source.getTime() - before;
                if (Math.abs(moved - h) > LATER_STEPS * ROUNDING * h) {
                    return Optional.of(step == 1 ? wrong(maker, h, moved) : ends("from step " + step + " on ", h,
                            moved, source.timeMoves() == moves));
                }
            }
        }
        return Optional.empty();
    }

    private static WindyOscillators begun() {
        return new WindyOscillators(1).from(START);
    }

    private static Finding ends(String when, double h, double moved, boolean still) {
        return still ? Phrase.CLOCK_STILL.of(when) : Phrase.CLOCK_ENDS.of(when, Formula.time(moved / h), h);
    }

    private static Finding wrong(Supplier<DESolver> maker, double h, double moved) {
        double twice = StudentSource.after(begun(), maker.get(), 1, 2 * h).getTime() - START;
        if (!Formula.sameTime(moved / h, 0) && Formula.sameTime(twice, moved)) {
            return Phrase.CLOCK_FIXED.of(moved);
        } else if (Formula.sameTime(moved - h, START) && Formula.sameTime(twice - 2 * h, START)) {
            return Phrase.CLOCK_NEW_TIME.of(moved, h, START);
        }
        WindyOscillators source = StudentSource.after(begun(), maker.get(), 1, h);
        boolean still = source.timeMoves() == 0;
        double error = source.error();
        source.incTime(h - moved);
        return error < MUCH_BETTER * source.error() ? Phrase.PARTS.of(Formula.time(moved / h))
                : ends("", h, moved, still);
    }
}
