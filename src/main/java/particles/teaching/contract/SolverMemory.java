package particles.teaching.contract;

import deSolvers.DESolver;
import java.util.Arrays;
import java.util.Optional;
import java.util.function.BiConsumer;
import java.util.function.Supplier;
import java.util.stream.IntStream;
import particles.teaching.Finding;
import particles.teaching.Finding.Kind;
import particles.teaching.sources.StudentSource;
import particles.teaching.sources.WindyOscillators;

/**
 * Looks for memory of earlier steps that is used where it must not be: a step from another place than that where the
 * last step ended has to be the step of a new solver.
 *
 * @param maker     makes a new solver
 * @param remembers whether its steps differ from those of a new solver
 * @param multistep whether it uses earlier steps as a method does
 */
public record SolverMemory(Supplier<DESolver> maker, boolean remembers, boolean multistep) {
    private static final double H = 1.0 / 16;
    /** Two runs of one method differ by rounding only: measured 0 for all of ours. */
    private static final double SAME = 1e-9;
    private static final int STEPS = 6;
    private static final double LATER = 3;
    private static final String FORGET = ". What is remembered of earlier steps may be used only while source, time, "
            + "state and deltaT are what the last step left, and has to be forgotten in reset()";

    /** @return whether a later step differs from the one that a new solver makes from the same place */
    public static boolean isIn(Supplier<DESolver> maker) {
        SolverMemory memory = new SolverMemory(maker, true, false);
        DESolver solver = maker.get();
        WindyOscillators source = new WindyOscillators(2);
        return !IntStream.range(0, STEPS).allMatch(step -> memory.isFresh(solver, source, H));
    }

    /** @return the first mistake */
    public Optional<Finding> mistake() {
        return after("the state was set from outside, as a collision does,", (solver, source) -> {
            double[] moved = source.getState();
            Arrays.setAll(moved, k -> moved[k] + 1);
            source.setState(moved);
        }).or(() -> after("reset() was called, as it is when the forces change,", (solver, source) -> solver.reset()))
                .or(this::otherSources).or(this::objects).or(this::changedDeltaT)
                .map(text -> new Finding(Kind.STATE, text));
    }

    /** @return whether a clock that was set from outside goes unnoticed, which matters only if the law depends on it */
    boolean ignoresTheClock() {
        return after("", (solver, source) -> source.incTime(LATER)).isPresent();
    }

    /** Makes a step, and the same one with a new solver, from the same place on a copy of the source. */
    private boolean isFresh(DESolver solver, WindyOscillators source, double deltaT) {
        WindyOscillators twin = source.copy();
        maker.get().stepState(twin, deltaT);
        solver.stepState(source, deltaT);
        return SolverContract.distance(twin.getState(), source.getState()) <= SAME;
    }

    /** Makes steps and a change from outside; the next step has to be that of a new solver. */
    private Optional<String> after(String changed, BiConsumer<DESolver, WindyOscillators> change) {
        DESolver solver = maker.get();
        WindyOscillators source = StudentSource.after(new WindyOscillators(2), solver, STEPS, H);
        change.accept(solver, source);
        double[] start = source.getState();
        source.startRecord();
        return isFresh(solver, source, H) ? Optional.empty() : Optional.of(changed + " and the step afterwards "
                + (multistep ? "still uses the steps before it" + FORGET
                : source.readStates() == 0 ? "does not start there: an array is kept from the step before. getState has"
                + " to be called in every step, and the arrays filled anew"
                : !source.hasEvaluated(start) ? "begins with a derivative that was kept from the step before, as none"
                + " is asked for at the new state. It may be kept only while state and time are what the last step left"
                : "is not the one that a new solver makes: something is kept from the step before" + FORGET));
    }

    /** Steps several sources with one solver, of the same size at first. */
    private Optional<String> otherSources() {
        DESolver solver = maker.get();
        int last = 3;
        for (int pairs : new int[] {3, 3, 3, 3, 6, 3, 1}) {
            WindyOscillators source = new WindyOscillators(pairs);
            source.incTime(LATER * pairs);
            double[] start = source.getState();
            double time = source.getTime();
            String text = "the solver stepped a source of " + 6 * last + " numbers and then one of "
                    + 6 * pairs + ", and ";
            String cause = last == pairs ? ": something is kept from the step before (an array that is not filled anew,"
                    + " a derivative that is not asked for again, a count of steps)" : ": the size is cached from the"
                    + " first source. source.getStateSize() has to be asked in every step";
            boolean fresh;
            try {
                fresh = isFresh(solver, source, H);
            } catch (IndexOutOfBoundsException | NegativeArraySizeException e) {
                return Optional.of(text + "ended in " + e + cause);
            }
            if (source.wrongLength().isPresent()) {
                return Optional.of(text + "handed it an array of " + source.wrongLength().get() + cause);
            }
            if (!fresh) {
                return Optional.of(text + (Arrays.equals(start, source.getState()) && source.getTime() == time
                        ? "the second one stays as it was: the first source is kept in a field. Each step has to use"
                        + " the source that it is given" : "the second step is not what a new solver makes" + cause));
            }
            last = pairs;
        }
        return Optional.empty();
    }

    /** A search for an impact steps with a solver of its own, in between. */
    private Optional<String> objects() {
        WindyOscillators one = new WindyOscillators(1);
        WindyOscillators two = one.copy();
        two.incTime(LATER);
        WindyOscillators alone = StudentSource.after(one.copy(), maker.get(), STEPS, H);
        DESolver first = maker.get();
        DESolver second = maker.get();
        for (int step = 0; step < STEPS; step++) {
            first.stepState(one, H);
            second.stepState(two, H);
        }
        return SolverContract.distance(alone.getState(), one.getState()) <= SAME ? Optional.empty() : Optional.of(
                "two solvers of this class step in turn, each its own source, and one disturbs the other: something is"
                + " static, and shared by all of them");
    }

    /** The simulation shortens the last step before an event, so that deltaT changes from step to step. */
    private Optional<String> changedDeltaT() {
        DESolver solver = maker.get();
        WindyOscillators source = StudentSource.after(new WindyOscillators(1), solver, 2, H);
        return isFresh(solver, source, H / 4) && isFresh(solver, source, H / 2) ? Optional.empty() : Optional.of(
                "deltaT changes from one step to the next, and the step is not the one that a new solver makes with it"
                + (remembers ? FORGET : ": deltaT of an earlier step is kept. It is an argument of each call, and may"
                + " differ in each"));
    }
}
