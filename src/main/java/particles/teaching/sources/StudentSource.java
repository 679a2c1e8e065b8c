package particles.teaching.sources;

import deSolvers.DESolver;
import deSolvers.SecondOrderStateSource;
import deSolvers.problems.ReferenceProblem;
import java.util.HashSet;
import java.util.Set;
import particles.teaching.GuardedRun;
import particles.teaching.GuardedRun.EndlessLoop;
import particles.teaching.StudentFailure;

/** A source for a student's solver: it counts what a step does, and ends one that evaluates without an end. */
public abstract class StudentSource extends ReferenceProblem {
    private static final int MOST_TIMES = 100_000;
    /** In one step; a right adaptive solver needs 100,000 in its longest measurement. */
    private static final long MOST_EVALUATIONS = 2_000_000;

    private final Set<Float> times = new HashSet<>();
    private boolean isSet;
    private long before;

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
        super.incTime(deltaT);
        if (times.size() < MOST_TIMES) {
            times.add((float) getTime());
        }
    }

    @Override
    public void getStateDerivative(double[] dSdt) {
        if (getEvaluations() - before == MOST_EVALUATIONS) {
            throw new EndlessLoop("the derivative was evaluated " + MOST_EVALUATIONS + " times");
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
