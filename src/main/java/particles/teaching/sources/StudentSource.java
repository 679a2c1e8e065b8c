package particles.teaching.sources;

import deSolvers.DESolver;
import deSolvers.SecondOrderStateSource;
import deSolvers.problems.ReferenceProblem;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import particles.teaching.GuardedRun;
import particles.teaching.GuardedRun.EndlessLoop;
import particles.teaching.StudentFailure;

/** A source for a student's solver: it records arrays of a wrong length, and uses the part of them that fits. */
public abstract class StudentSource extends ReferenceProblem {
    private static final int MOST_RECORDED = 6;
    private static final int MOST_TIMES = 100_000;
    /** In one step; a right adaptive solver needs 100,000 in its longest measurement. */
    private static final long MOST_EVALUATIONS = 2_000_000;

    private Optional<Integer> wrongLength = Optional.empty();
    private final List<double[]> evaluatedAt = new ArrayList<>();
    private int reads;
    private int timeMoves;
    private final Set<Float> times = new HashSet<>();
    private boolean isSet;
    private long before;
    private long most = MOST_EVALUATIONS;

    /** @param start the state at t = 0 */
    public StudentSource(double... start) {
        super(start);
    }

    /**
     * @param time  the clock at the start (s)
     * @param start the state at that time
     */
    public StudentSource(double time, double[] start) {
        super(time, start);
    }

    /**
     * Lets a solver make steps.
     *
     * @param deltaT the length of each step (s)
     * @return the source
     */
    public static <S extends StudentSource> S after(S source, DESolver solver, int steps, double deltaT) {
        source.step(solver, steps, deltaT);
        return source;
    }

    /**
     * Lets a solver make a step, and tells that it came back.
     *
     * @param deltaT its length (s)
     */
    @Override
    public final void step(DESolver solver, double deltaT) {
        before = getEvaluations();
        super.step(solver, deltaT);
        GuardedRun.goesOn();
    }

    /**
     * Lets a solver make a step, unless it refuses.
     *
     * @param deltaT its length (s)
     * @return whether it made the step
     */
    public final boolean accepts(DESolver solver, double deltaT) {
        try {
            step(solver, deltaT);
            return true;
        } catch (RuntimeException e) {
            if (StudentFailure.isRefusal(e)) {
                return false;
            }
            throw e;
        }
    }

    /** @param evaluations the number in one step that tells an endless loop */
    protected final void endAfter(long evaluations) {
        most = evaluations;
    }

    /** @return the length of the first array that was not as long as the state */
    public final Optional<Integer> wrongLength() {
        return wrongLength;
    }

    @Override
    protected final int checkLength(double[] array) {
        if (array.length != getStateSize() && wrongLength.isEmpty()) {
            wrongLength = Optional.of(array.length);
        }
        return Math.min(array.length, getStateSize());
    }

    /** Records from now on the reads of the state and the states at which the derivative is evaluated. */
    public final void startRecord() {
        reads = 0;
        evaluatedAt.clear();
    }

    /** @return the number of reads of the state */
    public final int readStates() {
        return reads;
    }

    /** @return the first states at which the derivative was evaluated */
    public final List<double[]> evaluatedAt() {
        return evaluatedAt;
    }

    /** @return whether the derivative was evaluated at this state */
    public final boolean hasEvaluated(double[] state) {
        return evaluatedAt.stream().anyMatch(at -> Arrays.equals(at, state));
    }

    /** @return how often the clock was moved */
    public final int timeMoves() {
        return timeMoves;
    }

    /** @return the number of times (s) that the clock was moved to, which rounds of an iteration have in common */
    public final int times() {
        return times.size();
    }

    /** @return whether the state was ever set */
    public final boolean isSet() {
        return isSet;
    }

    @Override
    public void setState(double[] newState) {
        isSet = true;
        super.setState(newState);
    }

    @Override
    public void incTime(double deltaT) {
        timeMoves++;
        super.incTime(deltaT);
        if (times.size() < MOST_TIMES) {
            times.add((float) getTime());
        }
    }

    @Override
    public void getState(double[] copy) {
        reads++;
        super.getState(copy);
    }

    @Override
    public void getStateDerivative(double[] dSdt) {
        if (getEvaluations() - before == most) {
            throw new EndlessLoop("the derivative was evaluated " + most + " times");
        }
        if (evaluatedAt.size() < MOST_RECORDED) {
            evaluatedAt.add(getState());
        }
        super.getStateDerivative(dSdt);
    }

    /** @return the largest difference of two entries; NaN if there is one */
    public static double distance(double[] x, double[] y) {
        double distance = 0;
        for (int k = 0; k < x.length; k++) {
            distance = Math.max(distance, Math.abs(x[k] - y[k]));
        }
        return distance;
    }

    /** A source of positions and velocities in space, whose accelerations do not depend on velocities. */
    public interface SecondOrderSource extends SecondOrderStateSource {
        @Override
        default int getDimension() {
            return 3;
        }

        @Override
        default boolean accelerationDependsOnVelocity() {
            return false;
        }
    }
}
