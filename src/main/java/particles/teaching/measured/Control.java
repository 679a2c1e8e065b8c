package particles.teaching.measured;

import deSolvers.DESolver;
import java.util.Optional;
import java.util.function.Supplier;
import particles.teaching.Finding;
import particles.teaching.sources.WindyOscillators;

/** What is measured of step-size control. */
public record Control(Supplier<DESolver> maker) {
    private static final double START = 0.5;
    private static final double LONG = 4;
    private static final int STEPS = 16;
    /** The oscillators start at 1.5. */
    private static final double FAR = 0.5;
    private static final double LITTLE = 1e-3;
    private static final double MUCH = 100;
    /** An iteration that diverges leaves more. */
    private static final double DIVERGED = 1e6;

    private WindyOscillators after(int steps, double deltaT) {
        WindyOscillators source = WindyOscillators.besideOneAtRest().from(START);
        DESolver solver = maker.get();
        for (int step = 0; step < steps; step++) {
            source.accepts(solver, deltaT);
        }
        return source;
    }

    /** @return whether a longer step has more parts */
    public boolean makesSubSteps() {
        return none().isEmpty();
    }

    /** @return the mistake of a method with step-size control whose longer steps do not have more parts */
    public Optional<Finding> none() {
        int parts = after(1, LONG).times();
        int few = after(1, LONG / STEPS).times();
        return Phrase.NO_CONTROL.when(parts < 2 * few, parts, few);
    }

    /** @return the mistake of sub-steps with which one long step is far less accurate than several short ones */
    public Optional<Finding> uncontrolled() {
        double error = after(1, LONG).error();
        double often = after(STEPS, LONG / STEPS).error();
        return Phrase.UNCONTROLLED.when(error < DIVERGED && (error > FAR || error > LITTLE && error > MUCH * often),
                error, LONG, often, STEPS);
    }
}
