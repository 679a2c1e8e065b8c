package deSolvers.problems;

/** A pendulum, theta'' = -sin theta, released at rest. */
public final class Pendulum extends SecondOrderProblem {
    private static final int HALVINGS = 6;

    private final double release;

    /** @param release the angle at t = 0 (rad), below pi */
    public Pendulum(double release) {
        super(1, release, 0);
        this.release = release;
    }

    @Override
    protected void accelerate(double t, double[] s, double[] dSdt) {
        dSdt[1] = -StrictMath.sin(s[0]);
    }

    @Override
    public boolean accelerationDependsOnVelocity() {
        return false;
    }

    /**
     * sin(theta/2) = k sn(K + t, k) with k = sin(release/2): Jacobi's elliptic function, by the arithmetic-geometric
     * mean (M. Abramowitz and I. Stegun, Handbook of Mathematical Functions, 16.4).
     */
    @Override
    public double[] exactState(double t) {
        double k = StrictMath.sin(release / 2);
        double[] a = new double[HALVINGS + 1];
        double[] c = new double[HALVINGS + 1];
        a[0] = 1;
        double b = Math.sqrt(1 - k * k);
        for (int n = 0; n < HALVINGS; n++) {
            c[n + 1] = (a[n] - b) / 2;
            a[n + 1] = (a[n] + b) / 2;
            b = Math.sqrt(a[n] * b);
        }
        double quarter = Math.PI / 2 / a[HALVINGS];
        double phi = (1 << HALVINGS) * a[HALVINGS] * (quarter + t);
        for (int n = HALVINGS; n > 0; n--) {
            phi = (phi + StrictMath.asin(c[n] / a[n] * StrictMath.sin(phi))) / 2;
        }
        double s = k * StrictMath.sin(phi);
        return new double[] {2 * StrictMath.asin(s), 2 * k * StrictMath.cos(phi)};
    }
}
