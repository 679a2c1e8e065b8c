package deSolvers.problems;

import deSolvers.ArrayStateSource;

/** A {@link SpySource} that is also an array source. */
public final class ArraySpySource extends SpySource implements ArrayStateSource {
    private final double[] own;

    /** @param problem what is really stepped */
    public ArraySpySource(SecondOrderProblem problem) {
        super(problem);
        own = problem.getState();
    }

    @Override
    public void setState(double[] state) {
        super.setState(state);
        System.arraycopy(state, 0, own, 0, own.length);
    }

    @Override
    public double[] getStateArray() {
        note(Call.STATE_ARRAY, null);
        return own;
    }

    @Override
    public void getStateDerivative(double[] state, double[] dSdt) {
        note(Call.DERIVATIVE, dSdt);
        problem().setState(state);
        problem().getStateDerivative(dSdt);
        problem().setState(own);
        spoil(dSdt);
    }
}
