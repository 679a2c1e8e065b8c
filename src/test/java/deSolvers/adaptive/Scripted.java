package deSolvers.adaptive;

import static org.junit.jupiter.api.Assertions.assertEquals;

import deSolvers.StepTransaction;
import java.util.ArrayList;
import java.util.List;
import java.util.function.DoubleBinaryOperator;
import java.util.function.DoubleUnaryOperator;

/** An adaptive Euler solver whose error estimate is given by the test. */
final class Scripted extends AdaptiveSolver {
    private final DoubleBinaryOperator error;
    private final boolean knowsEndSlope;
    /** The sub-steps tried: offset, length and slope. */
    final List<Double> offsets = new ArrayList<>();
    final List<Double> tried = new ArrayList<>();
    final List<Double> slopes = new ArrayList<>();
    /** The growth of the next sub-step as a function of the length; NaN for the solver's own rule. */
    DoubleUnaryOperator growth = h -> Double.NaN;
    private double end;

    /** @param error from offset and length, in units of the tolerance */
    Scripted(boolean knowsEndSlope, DoubleBinaryOperator error) {
        super(0, 1);
        this.error = error;
        this.knowsEndSlope = knowsEndSlope;
    }

    /** One with the same error for each sub-step, which evaluates the slope at its end. */
    Scripted(double error) {
        this(false, (offset, h) -> error);
    }

    @Override
    protected void resize(int n) {
        assertEquals(1, n);
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
        double factor = growth.applyAsDouble(h);    // the test's own rule, if it has one
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
