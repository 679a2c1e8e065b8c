package deSolvers.problems;

/** n unit masses between two walls on n + 1 unit springs, in one of the chain's modes: x_j = sin(j m pi / (n + 1)) cos wt. */
public final class Chain extends SecondOrderProblem {
    private final int n;
    private final int mode;

    /**
     * @param n    how many masses
     * @param mode which mode, 1 (slowest) to n (fastest)
     */
    public Chain(int n, int mode) {
        super(1, n);
        this.n = n;
        this.mode = mode;
        startAt(0);
    }

    /** @return the mode's angular frequency, 2 sin(m pi / (2 (n + 1))) */
    public double omega() {
        return 2 * StrictMath.sin(mode * Math.PI / (2 * (n + 1)));
    }

    @Override
    public double[] exactState(double t) {
        double[] s = new double[2 * n];
        for (int j = 0; j < n; j++) {
            double shape = StrictMath.sin((j + 1) * mode * Math.PI / (n + 1));
            s[2 * j] = shape * StrictMath.cos(omega() * t);
            s[2 * j + 1] = -shape * omega() * StrictMath.sin(omega() * t);
        }
        return s;
    }

    @Override
    protected void accelerate(double t, double[] s, double[] dSdt) {
        for (int j = 0; j < n; j++) {
            double left = j == 0 ? 0 : s[2 * j - 2];
            double right = j == n - 1 ? 0 : s[2 * j + 2];
            dSdt[2 * j + 1] = left - 2 * s[2 * j] + right;
        }
    }

    @Override
    public boolean accelerationDependsOnVelocity() {
        return false;
    }
}
