package deSolvers.adaptive;

import deSolvers.DEStateSource;
import java.util.ArrayList;
import java.util.List;
import java.util.function.DoubleUnaryOperator;

/** s' = f(t), one entry. */
class Ramp implements DEStateSource {
    private final DoubleUnaryOperator slope;
    /** When the derivative was asked for. */
    final List<Double> asked = new ArrayList<>();
    double state;
    double time;

    Ramp(double state, DoubleUnaryOperator slope) {
        this.state = state;
        this.slope = slope;
    }

    @Override
    public int getStateSize() {
        return 1;
    }

    @Override
    public void getState(double[] copy) {
        copy[0] = state;
    }

    @Override
    public void setState(double[] values) {
        state = values[0];
    }

    @Override
    public void getStateDerivative(double[] dSdt) {
        asked.add(time);
        dSdt[0] = slope.applyAsDouble(time);
    }

    @Override
    public double getTime() {
        return time;
    }

    @Override
    public void incTime(double deltaT) {
        time += deltaT;
    }
}
