package deSolvers.problems;

import deSolvers.SecondOrderStateSource;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.EnumMap;
import java.util.List;
import java.util.Map;

/**
 * A test double in front of a problem: counts calls, fails at a chosen one, returns non-finite numbers on request, and
 * keeps every array it received, to spoil them later.
 */
public class SpySource implements SecondOrderStateSource {
    /** The methods of a source. */
    public enum Call { SIZE, GET_STATE, SET_STATE, DERIVATIVE, TIME, INC_TIME, DIMENSION, VELOCITY_ASKED, STATE_ARRAY }

    /** The exception of a planned failure. */
    public static final class Failure extends RuntimeException {
        private static final long serialVersionUID = 1L;
    }

    private SecondOrderProblem problem;
    private final Map<Call, Integer> calls = new EnumMap<>(Call.class);
    private final List<double[]> arraysSeen = new ArrayList<>();
    private Call failingCall;
    private int failAt;
    private boolean failsForEver;
    private int badEntry = -1;
    private double badValue;
    private double badAfter;

    /** @param problem what is really stepped */
    public SpySource(SecondOrderProblem problem) {
        this.problem = problem;
    }

    /** Makes the k-th call of a method from now on throw a {@link Failure}, once, after spoiling its array. */
    public void failAt(Call call, int k) {
        calls.clear();
        failingCall = call;
        failAt = k;
    }

    /** Makes every call of a method from now on throw a {@link Failure}. */
    public void failFrom(Call call) {
        failAt(call, 1);
        failsForEver = true;
    }

    /** Makes the derivative's entry the given value at all times after t. */
    public void spoilDerivative(int entry, double value, double t) {
        badEntry = entry;
        badValue = value;
        badAfter = t;
    }

    /** Writes NaN into every array that was handed to this source so far. */
    public void spoilArrays() {
        arraysSeen.forEach(array -> Arrays.fill(array, Double.NaN));
    }

    /** @return how often a method was called since the last {@link #failAt}, or ever */
    public int calls(Call call) {
        return calls.getOrDefault(call, 0);
    }

    /** @param other the problem to step from now on */
    public void become(SecondOrderProblem other) {
        problem = other;
    }

    /** @return the problem behind */
    public SecondOrderProblem problem() {
        return problem;
    }

    final void note(Call call, double[] array) {
        if (array != null && arraysSeen.stream().noneMatch(seen -> seen == array)) {
            arraysSeen.add(array);
        }
        int count = calls.merge(call, 1, Integer::sum);
        if (call == failingCall && (failsForEver || count == failAt)) {
            failingCall = failsForEver ? call : null;
            if (call == Call.GET_STATE || call == Call.DERIVATIVE) {
                Arrays.fill(array, Double.NaN);
            }
            throw new Failure();
        }
    }

    @Override
    public int getStateSize() {
        note(Call.SIZE, null);
        return problem.getStateSize();
    }

    @Override
    public void getState(double[] state) {
        note(Call.GET_STATE, state);
        problem.getState(state);
    }

    @Override
    public void setState(double[] state) {
        note(Call.SET_STATE, state);
        problem.setState(state);
    }

    @Override
    public void getStateDerivative(double[] dSdt) {
        note(Call.DERIVATIVE, dSdt);
        problem.getStateDerivative(dSdt);
        spoil(dSdt);
    }

    final void spoil(double[] dSdt) {
        if (badEntry >= 0 && problem.getTime() > badAfter) {
            dSdt[badEntry] = badValue;
        }
    }

    @Override
    public double getTime() {
        note(Call.TIME, null);
        return problem.getTime();
    }

    @Override
    public void incTime(double deltaT) {
        note(Call.INC_TIME, null);
        problem.incTime(deltaT);
    }

    @Override
    public int getDimension() {
        note(Call.DIMENSION, null);
        return problem.getDimension();
    }

    @Override
    public boolean accelerationDependsOnVelocity() {
        note(Call.VELOCITY_ASKED, null);
        return problem.accelerationDependsOnVelocity();
    }
}
