package deSolvers.problems;

/** x'' = -x from (1, 0), and beside it x'' = -omega^2 x - 2 gamma x' from (0.5, 0). */
public final class SlowAndFastSpring extends ReferenceProblem {
    private final double omega;
    private final double gamma;

    /**
     * @param omega angular frequency of the fast spring without damping (1/s)
     * @param gamma its damping, less than omega (1/s)
     */
    public SlowAndFastSpring(double omega, double gamma) {
        super(1, 0, 0.5, 0);
        this.omega = omega;
        this.gamma = gamma;
    }

    @Override
    public double[] exactState(double t) {
        double damped = Math.sqrt(omega * omega - gamma * gamma);
        double c = 0.5 * StrictMath.exp(-gamma * t) * StrictMath.cos(damped * t);
        double s = 0.5 * StrictMath.exp(-gamma * t) * StrictMath.sin(damped * t);
        return new double[] {StrictMath.cos(t), -StrictMath.sin(t), c + gamma / damped * s,
                -omega * omega / damped * s};
    }

    @Override
    protected void rates(double t, double[] s, double[] dSdt) {
        dSdt[0] = s[1];
        dSdt[1] = -s[0];
        dSdt[2] = s[3];
        dSdt[3] = -omega * omega * s[2] - 2 * gamma * s[3];
    }
}
