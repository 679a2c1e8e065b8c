package deSolvers.implicit;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.function.DoubleUnaryOperator;

/** r(u) = 0 for each unknown by itself, with the matrix -dr/du, both as they are given. */
final class EquationsOfOne implements NewtonProblem {
    private final int n;
    private final DoubleUnaryOperator residual;
    private final DoubleUnaryOperator matrix;
    private final double[] diagonal;
    double floor;
    double definite;
    final List<Double> asked = new ArrayList<>();
    final List<Double> corrected = new ArrayList<>();
    int linearisations;

    EquationsOfOne(int n, DoubleUnaryOperator residual, DoubleUnaryOperator matrix) {
        this.n = n;
        this.residual = residual;
        this.matrix = matrix;
        diagonal = new double[n];
    }

    @Override
    public int size() {
        return n;
    }

    @Override
    public void evaluate(double[] u, double[] result) {
        asked.add(u[0]);
        Arrays.setAll(result, i -> residual.applyAsDouble(u[i]));
    }

    @Override
    public void linearise(double[] u) {
        linearisations++;
        Arrays.setAll(diagonal, i -> matrix.applyAsDouble(u[i]));
    }

    @Override
    public boolean lineariseDefinite(double[] u) {
        Arrays.fill(diagonal, definite);
        return definite > 0;
    }

    @Override
    public boolean correct(double[] given, double[] correction) {
        corrected.add(given[0]);
        Arrays.setAll(correction, i -> given[i] / diagonal[i]);
        return diagonal[0] != 0;
    }

    @Override
    public void rounding(double[] u, double[] limits) {
        Arrays.fill(limits, floor);
    }
}
