package deSolvers.problems;

import deSolvers.DEStateSource;

/** A source behind the simple interface: without its arrays, its order and its Jacobian. */
public class PlainSource implements DEStateSource {
    private final DEStateSource source;

    /** @param source the source to hide */
    public PlainSource(DEStateSource source) {
        this.source = source;
    }

    @Override
    public int getStateSize() {
        return source.getStateSize();
    }

    @Override
    public void getState(double[] state) {
        source.getState(state);
    }

    @Override
    public void setState(double[] state) {
        source.setState(state);
    }

    @Override
    public void getStateDerivative(double[] dSdt) {
        source.getStateDerivative(dSdt);
    }

    @Override
    public double getTime() {
        return source.getTime();
    }

    @Override
    public void incTime(double deltaT) {
        source.incTime(deltaT);
    }
}
