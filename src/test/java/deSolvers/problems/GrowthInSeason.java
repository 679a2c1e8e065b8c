package deSolvers.problems;

/**
 * s' = s cos t, s(0) = 1: s = exp(sin t). Its derivative depends on time, so a wrong stage time shows: a Runge-Kutta
 * method that moves the clock only at the end has order 1 here and full order on the oscillator.
 */
public final class GrowthInSeason extends ReferenceProblem {
    public GrowthInSeason() {
        super(1);
    }

    @Override
    public double[] exactState(double t) {
        return new double[] {StrictMath.exp(StrictMath.sin(t))};
    }

    @Override
    protected void rates(double t, double[] s, double[] dSdt) {
        dSdt[0] = s[0] * StrictMath.cos(t);
    }
}
