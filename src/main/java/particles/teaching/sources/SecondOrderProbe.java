package particles.teaching.sources;

import deSolvers.SecondOrderStateSource;

/**
 * A probe with positions and velocities in turn: dx/dt is the velocity in the state, and accelerations are given. The
 * acceleration does not depend on the velocity: asked again at the same positions and time, it is the same.
 */
public final class SecondOrderProbe extends Probe implements SecondOrderStateSource {
    private final int dimension;
    private double[] last = {};

    /**
     * @param start     the state
     * @param dimension the number of positions in a block
     * @param time      the clock (s)
     * @param answer    gives the accelerations
     */
    public SecondOrderProbe(double[] start, int dimension, double time, Answer answer) {
        super(start, time, answer);
        this.dimension = dimension;
    }

    @Override
    public void getStateDerivative(double[] dSdt) {
        super.getStateDerivative(dSdt);
        double[] state = state();
        for (int k = 0; k < Math.min(state.length, dSdt.length); k++) {
            if (k % (2 * dimension) < dimension) {
                dSdt[k] = state[k + dimension];
            }
        }
    }

    @Override
    protected void rates(double t, double[] s, double[] dSdt) {
        if (recorded().isEmpty() || recorded().get(recorded().size() - 1).time() != t || hasMoved(s)) {
            super.rates(t, s, dSdt);
            last = dSdt.clone();
        } else {
            System.arraycopy(last, 0, dSdt, 0, Math.min(last.length, dSdt.length));
        }
    }

    /** Whether a position is another one than at the last evaluation. */
    private boolean hasMoved(double[] s) {
        double[] before = recorded().get(recorded().size() - 1).state();
        for (int k = 0; k < s.length; k++) {
            if (k % (2 * dimension) < dimension && s[k] != before[k]) {
                return true;
            }
        }
        return false;
    }

    @Override
    public int getDimension() {
        return dimension;
    }

    @Override
    public boolean accelerationDependsOnVelocity() {
        return false;
    }
}
