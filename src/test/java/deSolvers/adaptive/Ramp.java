package deSolvers.adaptive;

import deSolvers.problems.ReferenceProblem;
import java.util.ArrayList;
import java.util.List;
import java.util.function.DoubleUnaryOperator;

/** s' = f(t), one entry. */
class Ramp extends ReferenceProblem {
    private final DoubleUnaryOperator slope;
    /** The times at which the derivative was evaluated. */
    final List<Double> asked = new ArrayList<>();

    Ramp(double state, DoubleUnaryOperator slope) {
        super(state);
        this.slope = slope;
    }

    @Override
    protected void rates(double t, double[] s, double[] dSdt) {
        asked.add(t);
        dSdt[0] = slope.applyAsDouble(t);
    }
}
