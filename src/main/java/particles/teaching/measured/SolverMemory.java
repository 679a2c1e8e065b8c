package particles.teaching.measured;

import deSolvers.DESolver;
import java.util.Arrays;
import java.util.Optional;
import java.util.function.Supplier;
import java.util.stream.IntStream;
import particles.teaching.Finding;
import particles.teaching.StudentFailure;
import particles.teaching.sources.StudentSource;
import particles.teaching.sources.WindyOscillators;

/**
 * Whether a solver forgets earlier steps in {@code reset()}, which the program calls before it changes state, source
 * or deltaT from outside: the step that follows has to be that of a new solver.
 */
public final class SolverMemory {
    private static final double H = 1.0 / 16;
    /** Two runs of one method differ by rounding only: measured 0 for all of ours. */
    private static final double ROUNDING = 1e-9;
    /** A kept length of sub-steps changes what the tolerance allows. */
    private static final double TOLERATED = 1e-4;
    private static final int STEPS = 6;
    private static final double LATER = 3;

    private final Supplier<DESolver> maker;
    private final double same;

    /**
     * @param maker    makes a new solver
     * @param subSteps whether it makes sub-steps within a tolerance
     */
    public SolverMemory(Supplier<DESolver> maker, boolean subSteps) {
        this.maker = maker;
        same = subSteps ? TOLERATED : ROUNDING;
    }

    /** @return whether its steps differ from those of a new solver */
    public boolean remembers() {
        DESolver solver = maker.get();
        WindyOscillators source = WindyOscillators.nonlinear(2);
        return !IntStream.range(0, STEPS).allMatch(step -> isFresh(solver, source, H));
    }

    /** @return the first mistake */
    public Optional<Finding> mistake() {
        return after("after the state was set from outside", H, source -> {
            double[] moved = source.getState();
            Arrays.setAll(moved, k -> moved[k] + 1);
            source.setState(moved);
            return source;
        }).or(() -> after("when deltaT changes", H / 4, source -> source)).or(() -> after("when the clock was set", H,
                source -> source.from(LATER))).or(() -> after("when another source comes", H, source ->
                WindyOscillators.nonlinear(2).from(LATER))).or(this::sizes).or(this::objects);
    }

    /** A source after some steps, or another one in its place. */
    private interface Change {
        WindyOscillators of(WindyOscillators source);
    }

    private Optional<Finding> after(String changed, double deltaT, Change change) {
        DESolver solver = maker.get();
        WindyOscillators stepped = StudentSource.after(WindyOscillators.nonlinear(2), solver, STEPS, H);
        WindyOscillators left = stepped.copy();
        WindyOscillators source = change.of(stepped);
        solver.reset();
        double[] start = source.getState();
        source.startRecord();
        boolean fresh = isFresh(solver, source, deltaT);
        boolean old = source != stepped && !Arrays.equals(left.getState(), stepped.getState());
        return Phrase.KEPT.when(!fresh || old, changed, old ? "the earlier source is still used, which is kept in a"
                + " field" : source.readStates() == 0 ? "getState is not called in it, an array is kept"
                : !source.hasEvaluated(start) ? "no derivative is asked for at its start, one is kept"
                : "something is kept of earlier steps");
    }

    /** Makes a step, and the same one with a new solver, from the same place on a copy of the source. */
    private boolean isFresh(DESolver solver, WindyOscillators source, double deltaT) {
        WindyOscillators twin = source.copy();
        twin.step(maker.get(), deltaT);
        source.step(solver, deltaT);
        return StudentSource.distance(twin.getState(), source.getState()) <= same && twin.getTime()
                == source.getTime();
    }

    /** Sources of other sizes. */
    private Optional<Finding> sizes() {
        DESolver solver = maker.get();
        int before = 0;
        for (int particles : new int[] {3, 6, 1}) {
            WindyOscillators source = new WindyOscillators(particles);
            String found = "another state than with a new solver";
            try {
                found = isFresh(solver, source, H) ? "" : found;
            } catch (IndexOutOfBoundsException | NegativeArraySizeException e) {
                found = StudentFailure.describe(e);
            }
            if (!found.isEmpty() || source.wrongLength().isPresent()) {
                return Optional.of(Phrase.OTHER_SIZE.of(6 * before, 6 * particles, found.isEmpty()
                        ? "an array of another length" : found));
            }
            before = particles;
            solver.reset();
        }
        return Optional.empty();
    }

    /** A search for an impact steps with a solver of its own, in between. */
    private Optional<Finding> objects() {
        WindyOscillators one = new WindyOscillators(1);
        WindyOscillators two = one.copy().from(LATER);
        WindyOscillators alone = StudentSource.after(one.copy(), maker.get(), STEPS, H);
        DESolver first = maker.get();
        DESolver second = maker.get();
        for (int step = 0; step < STEPS; step++) {
            one.step(first, H);
            two.step(second, H);
        }
        return Phrase.STATIC.when(!(StudentSource.distance(alone.getState(), one.getState()) <= same));
    }
}
