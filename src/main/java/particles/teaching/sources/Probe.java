package particles.teaching.sources;

import java.util.ArrayList;
import java.util.List;
import particles.teaching.sources.StudentSource.SecondOrderSource;

/** A source that answers each evaluation with a given derivative, and records where and when it was asked. */
public final class Probe extends StudentSource implements SecondOrderSource {
    /** Supplies the derivatives. */
    public interface Answer {
        /** @return the derivative at this evaluation, counted from 0 */
        double[] at(int evaluation);
    }

    /**
     * An evaluation of the derivative.
     *
     * @param state the state at which it was
     * @param time  the time at which it was (s)
     */
    public record Evaluation(double[] state, double time) {
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
    private final List<Evaluation> recorded = new ArrayList<>();

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

    @Override
    protected void rates(double t, double[] s, double[] dSdt) {
        if (recorded.size() == most) {
            throw new TooManyEvaluations(most);
        }
        double[] given = answer.at(recorded.size());
        recorded.add(new Evaluation(s.clone(), t));
        System.arraycopy(given, 0, dSdt, 0, Math.min(s.length, dSdt.length));
    }
}
