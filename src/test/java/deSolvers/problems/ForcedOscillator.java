package deSolvers.problems;

/** x'' = -x + cos 2t: an acceleration of position and time; x = 4/3 cos t + 1/2 sin t - 1/3 cos 2t. */
public final class ForcedOscillator extends SecondOrderProblem {
    public ForcedOscillator() {
        super(1, 1, 0.5);
    }

    @Override
    public double[] exactState(double t) {
        double c = StrictMath.cos(t);
        double s = StrictMath.sin(t);
        return new double[] {4.0 / 3 * c + 0.5 * s - StrictMath.cos(2 * t) / 3,
                -4.0 / 3 * s + 0.5 * c + 2.0 / 3 * StrictMath.sin(2 * t)};
    }

    @Override
    protected void accelerate(double t, double[] s, double[] dSdt) {
        dSdt[1] = -s[0] + StrictMath.cos(2 * t);
    }

    @Override
    public boolean accelerationDependsOnVelocity() {
        return false;
    }
}
