package particles.teaching.sources;

import deSolvers.SecondOrderStateSource;

/**
 * A probe with positions and velocities in turn: dx/dt is the velocity that stands in the state, the rest is as told.
 */
public final class SecondOrderProbe extends Probe implements SecondOrderStateSource {
    private final int dimension;

    /**
     * @param start     the state
     * @param dimension positions in a block
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
    public int getDimension() {
        return dimension;
    }

    @Override
    public boolean accelerationDependsOnVelocity() {
        return false;
    }
}
