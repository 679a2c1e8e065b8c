package deSolvers.problems;

import deSolvers.SecondOrderStateSource;

/** A reference problem x'' = a(x, v, t) in blocks of d positions and d velocities. */
public abstract class SecondOrderProblem extends ReferenceProblem implements SecondOrderStateSource {
    private final int d;

    /**
     * @param d     the number of positions in a block
     * @param start the state at t = 0, whole blocks; a copy is taken
     */
    protected SecondOrderProblem(int d, double... start) {
        super(start);
        this.d = d;
    }

    /**
     * Writes the acceleration into the velocity entries of the derivative.
     *
     * @param t    the time (s)
     * @param s    the state; to be read only
     * @param dSdt receives the acceleration
     */
    protected abstract void accelerate(double t, double[] s, double[] dSdt);

    @Override
    protected final void rates(double t, double[] s, double[] dSdt) {
        for (int x = 0; x < s.length; x += 2 * d) {
            System.arraycopy(s, x + d, dSdt, x, d);
        }
        accelerate(t, s, dSdt);
    }

    @Override
    public final int getDimension() {
        return d;
    }
}
