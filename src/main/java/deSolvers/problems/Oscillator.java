package deSolvers.problems;

/**
 * The slides' example oscillator, x'' = -omega^2 x: a particle on a spring, as a state source with its exact solution.
 * The state is (x, v). {@link ReferenceProblem} holds it and the clock; {@link SecondOrderProblem} writes dx/dt = v.
 */
public final class Oscillator extends SecondOrderProblem {
    private final double omega;
    private final double x0;
    private final double v0;

    /** The oscillator of the lecture's figures: omega = 1, released at rest at x = 1. */
    public Oscillator() {
        this(1, 1, 0);
    }

    /**
     * @param omega angular frequency (1/s)
     * @param x0    position at t = 0
     * @param v0    velocity at t = 0
     */
    public Oscillator(double omega, double x0, double v0) {
        super(1, x0, v0);                               // dimension d = 1, x, v
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
        dSdt[1] = -omega * omega * s[0];                // dv/dt
    }

    @Override
    public boolean accelerationDependsOnVelocity() {
        return false;
    }
}
