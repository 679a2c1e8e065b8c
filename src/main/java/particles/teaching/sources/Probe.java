package particles.teaching.sources;

import java.util.ArrayList;
import java.util.List;
import java.util.function.IntFunction;
import particles.teaching.sources.StudentSource.SecondOrderSource;

/** A source that answers each evaluation with a given derivative, and records where and when it was asked. */
public final class Probe extends StudentSource implements SecondOrderSource {
    /**
     * An evaluation of the derivative.
     *
     * @param state the state at which it was
     * @param time  the time at which it was (s)
     */
    public record Evaluation(double[] state, double time) {
    }

    private final IntFunction<double[]> answer;
    private final List<Evaluation> recorded = new ArrayList<>();

    /**
     * @param start  the state
     * @param time   the clock (s)
     * @param answer supplies the derivative at each evaluation, counted from 0; what it throws, the evaluation throws
     */
    public Probe(double[] start, double time, IntFunction<double[]> answer) {
        super(time, start);
        this.answer = answer;
    }

    /** @return the evaluations, in their order */
    public List<Evaluation> recorded() {
        return recorded;
    }

    @Override
    protected void rates(double t, double[] s, double[] dSdt) {
        double[] given = answer.apply(recorded.size());
        recorded.add(new Evaluation(s.clone(), t));
        System.arraycopy(given, 0, dSdt, 0, s.length);
    }
}
