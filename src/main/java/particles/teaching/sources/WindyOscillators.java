package particles.teaching.sources;

import deSolvers.SecondOrderStateSource;
import java.util.Arrays;
import particles.teaching.EndlessLoop;

/**
 * Particles on springs in a field that changes with time: in each coordinate x'' = -4 x + 3 cos t, from x = 1.5 at rest
 * at t = 0. Exact: x = cos t + 0.5 cos 2t. As the law depends on time, it shows a clock that is wrong within a step.
 */
public final class WindyOscillators extends StudentSource implements SecondOrderStateSource {
    /** The exception that the source throws on request. */
    public static final class Failure extends RuntimeException {
        private static final long serialVersionUID = 1L;

        Failure() {
            super("the source fails, as it was told to");
        }
    }

    private int failFrom = Integer.MAX_VALUE;
    private boolean failed;
    private boolean spoilt;
    private long endFrom;

    /** @param particles the number of particles; six numbers each */
    public WindyOscillators(int particles) {
        super(start(6 * particles));
    }

    private static double[] start(int size) {
        double[] start = new double[size];
        Arrays.setAll(start, k -> k % 6 < 3 ? 1.5 : 0);
        return start;
    }

    /** @return a copy in the same state and time */
    public WindyOscillators copy() {
        WindyOscillators copy = new WindyOscillators(getStateSize() / 6);
        copy.setState(getState());
        copy.incTime(getTime());
        return copy;
    }

    @Override
    public double[] exactState(double t) {
        double[] exact = new double[getStateSize()];
        double x = StrictMath.cos(t) + 0.5 * StrictMath.cos(2 * t);
        double v = -StrictMath.sin(t) - StrictMath.sin(2 * t);
        Arrays.setAll(exact, k -> k % 6 < 3 ? x : v);
        return exact;
    }

    /** @return the length of the first array that was not as long as the state, or -1 */
    public int wrongLength() {
        return wrongLengths().isEmpty() ? -1 : wrongLengths().get(0);
    }

    /** @param evaluation the number of the first evaluation, from 0, that is to fail */
    public void failFromEvaluation(int evaluation) {
        failFrom = evaluation;
    }

    /** @return whether an evaluation failed */
    public boolean hasFailed() {
        return failed;
    }

    /**
     * Makes the derivative NaN from now on.
     *
     * @param most the number of evaluations after which it throws {@link EndlessLoop}
     */
    public void spoilDerivative(long most) {
        spoilt = true;
        endFrom = getEvaluations() + most;
    }

    @Override
    public int getDimension() {
        return 3;
    }

    @Override
    public boolean accelerationDependsOnVelocity() {
        return false;
    }

    @Override
    protected void rates(double t, double[] s, double[] dSdt) {
        if (getEvaluations() - 1 >= failFrom) {
            failed = true;
            throw new Failure();
        }
        if (spoilt && getEvaluations() > endFrom) {
            throw new EndlessLoop("the derivative was evaluated " + endFrom + " times");
        }
        double field = 3 * StrictMath.cos(t);
        for (int k = 0; k < Math.min(s.length, dSdt.length); k++) {
            dSdt[k] = spoilt ? Double.NaN : k % 6 < 3 ? s[k + 3] : -4 * s[k - 3] + field;
        }
    }
}
