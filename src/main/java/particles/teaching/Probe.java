package particles.teaching;

import deSolvers.DEStateSource;
import java.util.ArrayList;
import java.util.List;

/**
 * A source that writes down all that a solver does with it, and answers evaluations as it is told to. It copies every array
 * and keeps no reference, as the contract says.
 */
class Probe implements DEStateSource {
    /** More evaluations than this in a step are no tableau that anybody writes by hand. */
    static final int MOST_EVALUATIONS = 16;

    /** What the derivative is. */
    interface Answer {
        /**
         * @param evaluation the number of this evaluation, from 0
         * @param dSdt       receives the derivative; filled with 0 before
         */
        void fill(int evaluation, double[] dSdt);
    }

    /**
     * An evaluation of the derivative.
     *
     * @param state     where it was
     * @param time      when it was (s)
     * @param stateSet  whether the state was set since the evaluation before
     */
    record Evaluation(double[] state, double time, boolean stateSet) {
    }

    /** Ends a step that asks for more evaluations than a tableau has. */
    static final class TooManyEvaluations extends RuntimeException {
        private static final long serialVersionUID = 1L;

        TooManyEvaluations() {
            super("more than " + MOST_EVALUATIONS + " evaluations", null, false, false);
        }
    }

    private final double[] state;
    private final Answer answer;
    private double time;
    private boolean stateSet;
    private boolean everSet;
    private final List<Evaluation> evaluations = new ArrayList<>();
    private final List<Double> clockMoves = new ArrayList<>();
    private final List<Integer> wrongLengths = new ArrayList<>();

    /**
     * @param start  the state
     * @param time   the clock (s)
     * @param answer what evaluations give
     */
    Probe(double[] start, double time, Answer answer) {
        this.state = start.clone();
        this.time = time;
        this.answer = answer;
    }

    /** @return the evaluations, in their order */
    List<Evaluation> evaluations() {
        return evaluations;
    }

    /** @return by how much the clock was moved each time (s) */
    List<Double> clockMoves() {
        return clockMoves;
    }

    /** @return the lengths of arrays that were not as long as the state */
    List<Integer> wrongLengths() {
        return wrongLengths;
    }

    /** @return whether the state was set after the last evaluation */
    boolean setAfterLast() {
        return stateSet;
    }

    /** @return whether the state was set at all */
    boolean everSet() {
        return everSet;
    }

    /** @return a copy of the state */
    double[] state() {
        return state.clone();
    }

    @Override
    public int getStateSize() {
        return state.length;
    }

    @Override
    public void getState(double[] s) {
        System.arraycopy(state, 0, s, 0, common(s));
    }

    @Override
    public void setState(double[] s) {
        System.arraycopy(s, 0, state, 0, common(s));
        stateSet = true;
        everSet = true;
    }

    private int common(double[] array) {
        if (array.length != state.length) {
            wrongLengths.add(array.length);
        }
        return Math.min(array.length, state.length);
    }

    @Override
    public void getStateDerivative(double[] dSdt) {
        if (evaluations.size() == MOST_EVALUATIONS) {
            throw new TooManyEvaluations();
        }
        double[] all = new double[state.length];
        answer.fill(evaluations.size(), all);
        evaluations.add(new Evaluation(state.clone(), time, stateSet));
        stateSet = false;
        System.arraycopy(all, 0, dSdt, 0, common(dSdt));
    }

    @Override
    public double getTime() {
        return time;
    }

    @Override
    public void incTime(double deltaT) {
        clockMoves.add(deltaT);
        time += deltaT;
    }
}
