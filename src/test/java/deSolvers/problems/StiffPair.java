package deSolvers.problems;

/** u' = 998 u + 1998 v, v' = -999 u - 1999 v from (1, 0): u = 2 e^-t - e^-1000t, v = -e^-t + e^-1000t. */
public final class StiffPair extends ReferenceProblem {
    public StiffPair() {
        super(1, 0);
    }

    @Override
    public double[] exactState(double t) {
        double slow = StrictMath.exp(-t);
        double fast = StrictMath.exp(-1000 * t);
        return new double[] {2 * slow - fast, -slow + fast};
    }

    @Override
    protected void rates(double t, double[] s, double[] dSdt) {
        dSdt[0] = 998 * s[0] + 1998 * s[1];
        dSdt[1] = -999 * s[0] - 1999 * s[1];
    }
}
