package deSolvers.implicit;

import deSolvers.JacobianBlocks;

/** Takes what is named one block at a time: a pair is four of them. */
public abstract class BlockByBlock implements JacobianBlocks {

    /** Adds the blocks of particle i by particle j, times the sign. */
    public abstract void put(int i, int j, double[] dFdX, double[] dFdV, double sign);

    @Override
    public final void add(int i, int j, double[] dFdX, double[] dFdV) {
        put(i, j, dFdX, dFdV, 1);
    }

    @Override
    public final void addPair(int i, int j, double[] dFdX, double[] dFdV) {
        put(i, i, dFdX, dFdV, 1);
        put(j, j, dFdX, dFdV, 1);
        put(i, j, dFdX, dFdV, -1);
        put(j, i, dFdX, dFdV, -1);
    }
}
