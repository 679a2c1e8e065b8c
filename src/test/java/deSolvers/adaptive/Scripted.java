package deSolvers.adaptive;

import static org.junit.jupiter.api.Assertions.assertEquals;

import deSolvers.StepTransaction;
import java.util.ArrayList;
import java.util.List;
import java.util.function.DoubleBinaryOperator;
import java.util.function.DoubleUnaryOperator;

/** Integrates by Euler's step; its error falls with h squared, and is as large as it is told to be. */
final class Scripted extends AdaptiveSolver {
    private final DoubleBinaryOperator error;
    private final boolean knowsEndSlope;
    /** What was tried: where it began, how long it was, and the slope there. */
    final List<Double> offsets = new ArrayList<>();
    final List<Double> tried = new ArrayList<>();
    final List<Double> slopes = new ArrayList<>();
    /** By what the next sub-step is longer than one of a given length; the solver's own rule where it is NaN. */
    DoubleUnaryOperator growth = h -> Double.NaN;
    /** How often a new course was begun. */
    int restarts;
    private double end;

    /** @param error from offset and length, in units of the tolerance */
    Scripted(boolean knowsEndSlope, DoubleBinaryOperator error) {
        super(0, 1);
        this.error = error;
        this.knowsEndSlope = knowsEndSlope;
    }

    @Override
    protected void resize(int n) {
        assertEquals(1, n);
    }

    @Override
    protected void restart() {
        restarts++;
    }

    @Override
    protected double attempt(StepTransaction source, double[] state, double[] slope, double offset, double h,
                             double[] newState) {
        offsets.add(offset);
        tried.add(h);
        slopes.add(slope[0]);
        newState[0] = state[0] + h * slope[0];
        end = offset + h;
        return error.applyAsDouble(offset, h);
    }

    @Override
    protected int errorExponent() {
        return 2;
    }

    @Override
    protected double nextSubStep(double h, double error) {
        double factor = growth.applyAsDouble(h);    // a rule of its own, where the test has one
        return Double.isNaN(factor) ? super.nextSubStep(h, error) : h * factor;
    }

    @Override
    protected boolean endSlope(double[] newSlope) {
        if (knowsEndSlope) {
            newSlope[0] = 100 + end;
        }
        return knowsEndSlope;
    }
}
