package particles.teaching.contract;

import deSolvers.DESolver;
import deSolvers.RK4Solver;
import java.util.Arrays;
import java.util.Optional;
import java.util.function.BiConsumer;
import java.util.function.Supplier;
import java.util.stream.IntStream;
import particles.teaching.Finding;
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
    /** Where nothing is symmetric in time (s). */
    private static final double HERE = 1;
    /** Steps of RK4 in one: exact to 1e-11. */
    private static final int FINE = 16;
    private static final double LATER = 3;
    /** An adaptive method takes more evaluations in such a step, a multistep method does not. */
    private static final double LONG = 8;

    /** @return the memory that shows in later steps of a solver */
    public static SolverMemory of(SolverContract contract) {
        SolverMemory memory = new SolverMemory(contract.maker(), true, false);
        DESolver solver = contract.maker().get();
        WindyOscillators source = WindyOscillators.nonlinear(2);
        boolean remembers = !IntStream.range(0, STEPS).allMatch(step -> memory.isFresh(solver, source, H));
        return new SolverMemory(contract.maker(), remembers, remembers && contract.evaluations(1, H)
                == contract.evaluations(1, LONG) && !contract.solvesWithMatrix());
    }

    /** @return the first mistake */
    public Optional<Finding> mistake() {
        return after("the state was set from outside, as a collision does,", (solver, source) -> {
            double[] moved = source.getState();
            Arrays.setAll(moved, k -> moved[k] + 1);
            source.setState(moved);
        }).or(() -> after("reset() was called, as it is when the forces change,", (solver, source) -> solver.reset()))
                .or(this::otherSources).or(this::objects).or(this::changedDeltaT);
    }

    /** @return whether a clock that was set from outside goes unnoticed, which matters only if the law depends on it */
    boolean ignoresTheClock() {
        return after("", (solver, source) -> source.incTime(LATER)).isPresent();
    }

    /** Makes a step, and the same one with a new solver, from the same place on a copy of the source. */
    private boolean isFresh(DESolver solver, WindyOscillators source, double deltaT) {
        WindyOscillators twin = source.copy();
        twin.step(maker.get(), deltaT);
        source.step(solver, deltaT);
        return SolverContract.distance(twin.getState(), source.getState()) <= SAME;
    }

    /** Makes steps and a change from outside; the next step has to be that of a new solver. */
    private Optional<Finding> after(String changed, BiConsumer<DESolver, WindyOscillators> change) {
        DESolver solver = maker.get();
        WindyOscillators source = StudentSource.after(WindyOscillators.nonlinear(2), solver, STEPS, H);
        change.accept(solver, source);
        double[] start = source.getState();
        source.startRecord();
        boolean fresh = isFresh(solver, source, H);
        return (multistep ? Phrase.USES_STEPS_BEFORE : source.readStates() == 0 ? Phrase.KEPT_ARRAY
                : source.hasEvaluated(start) ? Phrase.KEPT_SOMETHING : Phrase.KEPT_DERIVATIVE).when(!fresh, changed);
    }

    /** Steps several sources with one solver, of the same size at first. */
    private Optional<Finding> otherSources() {
        DESolver solver = maker.get();
        WindyOscillators first = new WindyOscillators(3);
        first.step(solver, H);
        WindyOscillators left = first.copy();
        long evaluations = first.getEvaluations();
        int last = 18;
        for (int pairs : new int[] {3, 3, 3, 6, 3, 1}) {
            WindyOscillators source = new WindyOscillators(pairs);
            source.incTime(LATER * pairs);
            String cause = last == 6 * pairs ? ": something is kept from the step before (an array that is not filled"
                    + " anew, a derivative that is not asked for again, a count of steps)" : ": the size is cached from"
                    + " the first source. source.getStateSize() has to be asked in every step";
            String found = "";
            try {
                found = isFresh(solver, source, H) ? "" : "the second step is not what a new solver makes" + cause;
            } catch (IndexOutOfBoundsException | NegativeArraySizeException e) {
                found = "ended in " + e + cause;
            }
            boolean kept = first.getEvaluations() > evaluations || first.getTime() != left.getTime()
                    || !Arrays.equals(first.getState(), left.getState());
            if (kept) {
                found = "the first one is still used, which is kept in a field. Each step has to use the source"
                        + " that it is given";
            } else if (source.wrongLength().isPresent()) {
                found = "handed it an array of " + source.wrongLength().get() + cause;
            }
            if (!found.isEmpty()) {
                return Optional.of(Phrase.OTHER_SOURCE.of(last, 6 * pairs, found));
            }
            last = 6 * pairs;
        }
        return Optional.empty();
    }

    /** A search for an impact steps with a solver of its own, in between. */
    private Optional<Finding> objects() {
        WindyOscillators one = new WindyOscillators(1);
        WindyOscillators two = one.copy();
        two.incTime(LATER);
        WindyOscillators alone = StudentSource.after(one.copy(), maker.get(), STEPS, H);
        DESolver first = maker.get();
        DESolver second = maker.get();
        for (int step = 0; step < STEPS; step++) {
            one.step(first, H);
            two.step(second, H);
        }
        return Phrase.STATIC.when(!(SolverContract.distance(alone.getState(), one.getState()) <= SAME));
    }

    /**
     * The simulation shortens the last step before an event, so that deltaT changes from step to step. A multistep
     * method then begins anew, or has weights for it, which make a shorter step more accurate.
     */
    private Optional<Finding> changedDeltaT() {
        DESolver solver = maker.get();
        WindyOscillators source = StudentSource.after(new WindyOscillators(1), solver, 2, H);
        return (remembers ? Phrase.DELTA_T_CHANGES : Phrase.DELTA_T_KEPT).when((!isFresh(solver, source, H / 4)
                || !isFresh(solver, source, H / 2)) && !(multistep && error(0.5) < error(1))).or(() ->
                Phrase.TURNS_BACK.when(source.copy().accepts(maker.get(), -H) && !turnsBack(solver, source)));
    }

    /** A length of sub-steps that is remembered has the sign of the step before. */
    private boolean turnsBack(DESolver solver, WindyOscillators source) {
        try {
            return isFresh(solver, source, -H) || multistep && error(-0.5) < error(-1);
        } catch (RuntimeException e) {
            return false;
        }
    }

    /** The error of a step of a part of deltaT, after steps of deltaT. */
    private double error(double part) {
        DESolver solver = maker.get();
        WindyOscillators source = StudentSource.after(new WindyOscillators(1).from(HERE - STEPS * H), solver, STEPS, H);
        WindyOscillators fine = StudentSource.after(source.copy(), new RK4Solver(), FINE, part * H / FINE);
        source.step(solver, part * H);
        return SolverContract.distance(fine.getState(), source.getState());
    }
}
