package deSolvers.problems;

/** s' = -rate s from 1. */
public final class Decay extends ReferenceProblem {
    private final double rate;

    /** @param rate how fast it decays (1/s) */
    public Decay(double rate) {
        super(1);
        this.rate = rate;
    }

    @Override
    public double[] exactState(double t) {
        return new double[] {StrictMath.exp(-rate * t)};
    }

    @Override
    protected void rates(double t, double[] s, double[] dSdt) {
        dSdt[0] = -rate * s[0];
    }
}
