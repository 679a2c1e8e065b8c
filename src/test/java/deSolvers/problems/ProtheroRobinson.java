package deSolvers.problems;

/**
 * y' = L (y - cos t) - sin t, y(0) = 1: y = cos t for every L. The stiffer L is, the more a method's order on this
 * problem falls from its classical order towards the order of its stages.
 *
 * <p>Source: A. Prothero, A. Robinson (1974), Math. Comp. 28, 145.
 */
public final class ProtheroRobinson extends ReferenceProblem {
    private final double lambda;

    /** @param lambda L (1/s), negative and large for a stiff problem */
    public ProtheroRobinson(double lambda) {
        super(1);
        this.lambda = lambda;
    }

    @Override
    public double[] exactState(double t) {
        return new double[] {StrictMath.cos(t)};
    }

    @Override
    protected void rates(double t, double[] s, double[] dSdt) {
        dSdt[0] = lambda * (s[0] - StrictMath.cos(t)) - StrictMath.sin(t);
    }
}
