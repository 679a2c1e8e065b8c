package particles.teaching.measured;

import deSolvers.DESolver;
import java.util.Optional;
import java.util.function.Supplier;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import particles.teaching.Finding;
import particles.teaching.StudentFailure;
import particles.teaching.sources.StudentSource;
import particles.teaching.sources.WindyOscillators;

/**
 * Whether a solver forgets earlier steps in {@code reset()}, which the program calls before it changes state, source
 * or deltaT from outside: the step that follows has to be that of a new solver.
 *
 * @param maker    makes a new solver
 * @param subSteps whether it makes sub-steps within a tolerance
 */
public record SolverMemory(Supplier<DESolver> maker, boolean subSteps) {
    private static final double H = 1.0 / 16;
    /** Two runs of one method differ by rounding only: measured 0 for all of ours. */
    private static final double ROUNDING = 1e-9;
    /** A kept length of sub-steps changes what the tolerance allows. */
    private static final double TOLERATED = 1e-4;
    private static final int STEPS = 6;
    private static final double LATER = 3;

    /** @return whether its steps differ from those of a new solver */
    public boolean remembers() {
        DESolver solver = maker.get();
        WindyOscillators source = new WindyOscillators(2);
        return !IntStream.range(0, STEPS).allMatch(step -> isFresh(solver, source, H));
    }

    /** @return the mistake if after a reset a step, of the same or of another source, is not a new solver's */
    public Optional<Finding> mistake() {
        DESolver solver = maker.get();
        WindyOscillators first = StudentSource.after(new WindyOscillators(2), solver, STEPS, H);
        Stream<WindyOscillators> others = Stream.of(2, 3, 6, 1).map(particles -> new WindyOscillators(particles).from(
                LATER));
        return Stream.concat(Stream.of(first), others).flatMap(source -> Stream.of(H, H / 4, -H / 4).flatMap(h -> {
            solver.reset();
            String kept = "";
            try {
                kept = isFresh(solver, source, h) ? "" : "ends elsewhere";
            } catch (IndexOutOfBoundsException | NegativeArraySizeException | IllegalArgumentException e) {
                kept = "ends in " + StudentFailure.describe(e);
            }
            return Phrase.KEPT.when(!kept.isEmpty(), source.getStateSize() / 6, h, kept).stream();
        })).findFirst();
    }

    /** Makes a step, and the same one with a new solver, unless that refuses, from the same place on a copy. */
    private boolean isFresh(DESolver solver, WindyOscillators source, double deltaT) {
        WindyOscillators twin = source.copy();
        if (!twin.accepts(maker.get(), deltaT)) {
            return true;
        }
        source.step(solver, deltaT);
        return StudentSource.distance(twin.getState(), source.getState()) <= (subSteps ? TOLERATED : ROUNDING)
                && twin.getTime() == source.getTime();
    }
}
