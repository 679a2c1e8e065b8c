package deSolvers.problems;

/**
 * n unit masses between two walls on n + 1 unit springs, in one of the chain's modes: x_j = sin(j m pi / (n + 1)) cos
 * wt, or damped where the springs are: a mode then obeys q'' = -w^2 (q + c q').
 */
public final class Chain extends SecondOrderProblem {
    private final int n;
    private final int mode;
    private final double damping;

    /**
     * @param n    how many masses
     * @param mode which mode, 1 (slowest) to n (fastest)
     */
    public Chain(int n, int mode) {
        this(n, mode, 0);
    }

    /**
     * @param n       how many masses
     * @param mode    which mode, 1 (slowest) to n (fastest)
     * @param damping c of every spring, less than 2/w
     */
    public Chain(int n, int mode, double damping) {
        super(1, new double[2 * n]);
        this.n = n;
        this.mode = mode;
        this.damping = damping;
        startAt(0);
    }

    /** @return the mode's angular frequency, 2 sin(m pi / (2 (n + 1))) */
    public double omega() {
        return 2 * StrictMath.sin(mode * Math.PI / (2 * (n + 1)));
    }

    @Override
    public double[] exactState(double t) {
        double w = omega();
        double g = w * w * damping / 2;
        double f = Math.sqrt(w * w - g * g);
        double decay = StrictMath.exp(-g * t);
        double q = decay * (StrictMath.cos(f * t) + g / f * StrictMath.sin(f * t));
        double rate = -decay * w * w / f * StrictMath.sin(f * t);
        double[] s = new double[2 * n];
        for (int j = 0; j < n; j++) {
            double shape = StrictMath.sin((j + 1) * mode * Math.PI / (n + 1));
            s[2 * j] = shape * q;
            s[2 * j + 1] = shape * rate;
        }
        return s;
    }

    @Override
    protected void accelerate(double t, double[] s, double[] dSdt) {
        for (int j = 0; j < n; j++) {
            dSdt[2 * j + 1] = bend(s, j, 0) + damping * bend(s, j, 1);
        }
    }

    /** Left neighbour - 2 own + right neighbour, of positions (part 0) or velocities (part 1); the walls are at 0. */
    private double bend(double[] s, int j, int part) {
        double left = j == 0 ? 0 : s[2 * j - 2 + part];
        double right = j == n - 1 ? 0 : s[2 * j + 2 + part];
        return left - 2 * s[2 * j + part] + right;
    }

    @Override
    public boolean accelerationDependsOnVelocity() {
        return damping != 0;
    }
}
