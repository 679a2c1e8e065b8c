package deSolvers.symplectic;

import deSolvers.SecondOrderStateSource;

/** Blocks of d positions and d velocities, as simple as a source can be, for tests that look into it and change it. */
abstract class Blocks implements SecondOrderStateSource {
    double[] state;
    double time;
    private final int d;

    /**
     * @param d     positions in a block
     * @param state where the blocks begin; not copied
     */
    Blocks(int d, double... state) {
        this.d = d;
        this.state = state;
    }

    @Override
    public final int getDimension() {
        return d;
    }

    @Override
    public final int getStateSize() {
        return state.length;
    }

    @Override
    public final void getState(double[] copy) {
        System.arraycopy(state, 0, copy, 0, state.length);
    }

    @Override
    public final void setState(double[] values) {
        System.arraycopy(values, 0, state, 0, state.length);
    }

    @Override
    public final double getTime() {
        return time;
    }

    @Override
    public final void incTime(double deltaT) {
        time += deltaT;
    }

    @Override
    public boolean accelerationDependsOnVelocity() {
        return false;
    }
}
