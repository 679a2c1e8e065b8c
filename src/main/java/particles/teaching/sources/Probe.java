package particles.teaching.sources;

import java.util.ArrayList;
import java.util.List;

/**
 * A source that records all calls of a solver, and answers evaluations with given derivatives. It copies every array
 * and keeps no reference, as the contract says.
 */
public class Probe extends StudentSource {
    /** The largest number of evaluations in a step that counts as a tableau. */
    public static final int MOST_EVALUATIONS = 16;

    /** Supplies the derivatives. */
    public interface Answer {
        /**
         * @param evaluation the number of this evaluation, from 0
         * @param dSdt       receives the derivative; filled with 0 before
         */
        void fill(int evaluation, double[] dSdt);
    }

    /**
     * An evaluation of the derivative.
     *
     * @param state     the state at which it was
     * @param time      the time at which it was (s)
     * @param stateSet  whether the state was set since the evaluation before
     */
    public record Evaluation(double[] state, double time, boolean stateSet) {
    }

    /** Ends a step that asks for more evaluations than a tableau has. */
    public static final class TooManyEvaluations extends RuntimeException {
        private static final long serialVersionUID = 1L;

        TooManyEvaluations() {
            super("more than " + MOST_EVALUATIONS + " evaluations", null, false, false);
        }
    }

    private final Answer answer;
    private final int most;
    private boolean stateSet;
    private boolean everSet;
    private final List<Evaluation> recorded = new ArrayList<>();
    private final List<Double> clockMoves = new ArrayList<>();

    /**
     * @param start  the state
     * @param time   the clock (s)
     * @param answer supplies the derivatives
     */
    public Probe(double[] start, double time, Answer answer) {
        this(start, time, answer, MOST_EVALUATIONS);
    }

    /**
     * @param start  the state
     * @param time   the clock (s)
     * @param answer supplies the derivatives
     * @param most   the number of evaluations after which it throws {@link TooManyEvaluations}
     */
    public Probe(double[] start, double time, Answer answer, int most) {
        super(time, start);
        this.answer = answer;
        this.most = most;
    }

    /** @return the evaluations, in their order */
    public List<Evaluation> recorded() {
        return recorded;
    }

    /** @return all movements of the clock (s) */
    public List<Double> clockMoves() {
        return clockMoves;
    }

    /** @return whether the state was set after the last evaluation */
    public boolean setAfterLast() {
        return stateSet;
    }

    /** @return whether the state was set at all */
    public boolean everSet() {
        return everSet;
    }

    @Override
    public void setState(double[] s) {
        super.setState(s);
        stateSet = true;
        everSet = true;
    }

    @Override
    protected void rates(double t, double[] s, double[] dSdt) {
        if (recorded.size() == most) {
            throw new TooManyEvaluations();
        }
        double[] all = new double[s.length];
        answer.fill(recorded.size(), all);
        recorded.add(new Evaluation(s.clone(), t, stateSet));
        stateSet = false;
        System.arraycopy(all, 0, dSdt, 0, Math.min(s.length, dSdt.length));
    }

    @Override
    public void incTime(double deltaT) {
        clockMoves.add(deltaT);
        super.incTime(deltaT);
    }
}
