package deSolvers.problems;

/** The slides' example, x'' = -omega^2 x, from any (x0, v0). */
public final class Oscillator extends SecondOrderProblem {
    private final double omega;
    private final double x0;
    private final double v0;

    /** The lecture's figures: omega = 1 from (1, 0). */
    public Oscillator() {
        this(1, 1, 0);
    }

    /**
     * @param omega angular frequency (1/s)
     * @param x0    position at t = 0
     * @param v0    velocity at t = 0
     */
    public Oscillator(double omega, double x0, double v0) {
        super(1, x0, v0);
        this.omega = omega;
        this.x0 = x0;
        this.v0 = v0;
    }

    @Override
    public double[] exactState(double t) {
        double c = StrictMath.cos(omega * t);
        double s = StrictMath.sin(omega * t);
        return new double[] {x0 * c + v0 / omega * s, v0 * c - x0 * omega * s};
    }

    @Override
    protected void accelerate(double t, double[] s, double[] dSdt) {
        dSdt[1] = -omega * omega * s[0];
    }

    @Override
    public boolean accelerationDependsOnVelocity() {
        return false;
    }

    /** @return the present energy over the energy at t = 0 */
    public double energyFactor() {
        double[] s = state();
        return (s[1] * s[1] + omega * omega * s[0] * s[0]) / (v0 * v0 + omega * omega * x0 * x0);
    }
}
