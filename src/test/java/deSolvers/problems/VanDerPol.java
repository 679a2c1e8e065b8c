package deSolvers.problems;

/**
 * Van der Pol's oscillator, eps y'' = (1 - y^2) y' - y with eps = 1e-6, from (2, 0) to t = 2: two slow stretches and
 * the jump between them.
 */
public final class VanDerPol extends ReferenceProblem {
    /** The end time, at which the solution is known (s). */
    public static final double END = 2;
    private static final double EPS = 1e-6;

    public VanDerPol() {
        super(2, 0);
    }

    /** Known at 0 and 2 only. */
    @Override
    public double[] exactState(double t) {
        return t == 0 ? new double[] {2, 0} : new double[] {1.706167732170483, -0.8928097010247975};
    }

    @Override
    protected void rates(double t, double[] s, double[] dSdt) {
        dSdt[0] = s[1];
        dSdt[1] = ((1 - s[0] * s[0]) * s[1] - s[0]) / EPS;
    }
}
