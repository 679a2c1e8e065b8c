package particles.teaching.sources;

import java.util.ArrayList;
import java.util.List;
import particles.teaching.sources.StudentSource.SecondOrderSource;

/**
 * A source that records all calls of a solver, and answers evaluations with given derivatives. It copies every array
 * and keeps no reference, as the contract says.
 */
public class Probe extends StudentSource {
    /** The largest number of evaluations in a step that is usually read. */
    public static final int MOST_EVALUATIONS = 16;
    private static final double ROUNDING = 1e-14;
    private static final double SAME_TIME = 1e-9;

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
     * @param state    the state at which it was
     * @param time     the time at which it was (s)
     * @param stateSet whether the state was set since the evaluation before
     */
    public record Evaluation(double[] state, double time, boolean stateSet) {
    }

    /** Ends a step that asks for more evaluations than are read. */
    public static final class TooManyEvaluations extends RuntimeException {
        private static final long serialVersionUID = 1L;

        TooManyEvaluations(int most) {
            super("more than " + most + " evaluations", null, false, false);
        }
    }

    private final Answer answer;
    private final int most;
    private final boolean moving;
    private final boolean byClock;
    private boolean stateSet;
    private final List<Evaluation> recorded = new ArrayList<>();

    /**
     * @param start  the state
     * @param time   the clock (s)
     * @param answer supplies the derivatives
     * @param most   the number of evaluations after which it throws {@link TooManyEvaluations}
     */
    public Probe(double[] start, double time, Answer answer, int most) {
        this(start, time, answer, most, false, false);
    }

    private Probe(double[] start, double time, Answer answer, int most, boolean moving, boolean byClock) {
        super(time, start);
        this.answer = answer;
        this.most = most;
        this.moving = moving;
        this.byClock = byClock;
    }

    /** @return the evaluations, in their order */
    public final List<Evaluation> recorded() {
        return recorded;
    }

    /** @return whether the state was set after the last evaluation */
    public final boolean setAfterLast() {
        return stateSet;
    }

    @Override
    public final void setState(double[] s) {
        super.setState(s);
        stateSet = true;
    }

    /** @return the evaluation, from 0, whose derivative is the answer to this one */
    private int answerFor(double t, double[] s) {
        for (int j = 0; (moving || byClock) && j < recorded.size(); j++) {
            if (byClock ? Math.abs(recorded.get(j).time() - t) < SAME_TIME : recorded.get(j).time() == t
                    && samePositions(recorded.get(j).state(), s)) {
                return j;
            }
        }
        return recorded.size();
    }

    private static boolean samePositions(double[] one, double[] two) {
        for (int k = 0; k < one.length; k += k % 6 == 2 ? 4 : 1) {
            if (Math.abs(one[k] - two[k]) > ROUNDING * Math.abs(one[k])) {
                return false;
            }
        }
        return true;
    }

    @Override
    protected final void rates(double t, double[] s, double[] dSdt) {
        int number = answerFor(t, s);
        if (number == most) {
            throw new TooManyEvaluations(most);
        }
        double[] all = new double[s.length];
        answer.fill(number, all);
        for (int k = 0; moving && k < s.length; k += k % 6 == 2 ? 4 : 1) {
            all[k] = s[k + 3];
        }
        Evaluation made = new Evaluation(s.clone(), t, stateSet);
        if (byClock && number < recorded.size()) {
            recorded.set(number, made);
        } else {
            recorded.add(made);
        }
        stateSet = false;
        System.arraycopy(all, 0, dSdt, 0, Math.min(s.length, dSdt.length));
    }

    /** A probe of particles: three positions and three velocities for each in turn. */
    public static final class OfParticles extends Probe implements SecondOrderSource {
        /**
         * @param start  the state
         * @param time   the clock (s)
         * @param answer supplies the derivatives
         * @param most   the number of evaluations after which it throws {@link TooManyEvaluations}
         * @param moving whether the derivative of a position is the velocity, and an evaluation at the same positions
         *               and time as an earlier one has the same answer, so that iterations for the velocity end
         * @param byClock whether all evaluations at the same time have the same answer, and the last one is recorded
         */
        public OfParticles(double[] start, double time, Answer answer, int most, boolean moving, boolean byClock) {
            super(start, time, answer, most, moving, byClock);
        }
    }
}
