package deSolvers.problems;

/** y' = y^2, y(0) = 1: y = 1/(1 - t), which has a pole at t = 1. */
public final class Pole extends ReferenceProblem {
    public Pole() {
        super(1);
    }

    @Override
    public double[] exactState(double t) {
        return new double[] {1 / (1 - t)};
    }

    @Override
    protected void rates(double t, double[] s, double[] dSdt) {
        dSdt[0] = s[0] * s[0];
    }
}
