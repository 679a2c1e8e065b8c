package particles.experiments.stability;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Deque;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.function.DoubleBinaryOperator;
import particles.view.Axis;
import particles.view.Chart;
import particles.view.Look;
import particles.view.Series;
import particles.view.Series.Mark;

/**
 * The stability region in a square of the complex plane around 0, on a grid: its outline, also closed so that
 * it can be filled. Below the real axis it is mirrored, as R of the conjugate is the conjugate of R.
 */
final class StabilityMap {
    /** The number of bisections of a grid square by which a point on the outline is found. */
    private static final int HALVINGS = 8;
    /** The frame of a chart is this much higher than what it shows; the region goes on to its edge. */
    private static final double FRAME = 1.1;
    private static final int COLUMNS = 128;
    /** The growth over many steps is measured at each point of the grid. */
    private static final int FEW_COLUMNS = 48;

    private final DoubleBinaryOperator modulus;
    private final double far;
    private final double cell;
    private final boolean[][] grows;
    /** The points on the outline that are known, by the edges of squares that they are on. */
    private final Map<List<Integer>, double[]> borders = new HashMap<>();

    /**
     * @param modulus |R| at a point of the plane
     * @param far     half the side of the square
     * @param columns the number of columns of the grid, even
     */
    StabilityMap(DoubleBinaryOperator modulus, double far, int columns) {
        this.modulus = modulus;
        this.far = far;
        cell = 2 * far / columns;
        grows = new boolean[(int) Math.ceil(FRAME * columns / 2) + 1][columns + 1];
        for (int r = 0; r < grows.length; r++) {
            for (int c = 0; c <= columns; c++) {
                grows[r][c] = growsAt(c, r);
            }
        }
    }

    /** @return the map of a solver */
    static StabilityMap of(Amplification amplification, double far) {
        return new StabilityMap(amplification::at, far, amplification.manySteps() ? FEW_COLUMNS : COLUMNS);
    }

    /** @return the square with these outlines, areas or points, and the imaginary axis */
    static Chart plane(double far, List<Series> shown) {
        double[] ends = {-far, far};
        List<Series> series = new ArrayList<>(shown);
        series.add(new Series(Look.REFERENCE, "imaginary axis", Mark.LINE, new double[2], ends));
        return new Chart(Axis.linear("Re(deltaT lambda): decay to the left", ""),
                Axis.linear("Im(deltaT lambda): oscillation", ""), series).scaledTo(List.of(
                new Series(Look.REFERENCE, "square", Mark.LINE, ends, ends)));
    }

    private boolean growsAt(double column, double row) {
        return modulus.applyAsDouble(x(column), y(row)) > 1 + Amplification.ROUNDING;
    }

    /** At a point of the grid; beyond it every step grows, so that the region has an end. */
    private boolean grows(int column, int row) {
        int r = Math.abs(row);
        return column < 0 || r >= grows.length || column >= grows[r].length || grows[r][column];
    }

    /** The x of a column, half a cell off the imaginary axis, so that |R| = 1 on it is a line between grid points. */
    private double x(double column) {
        return (column + 0.5) * cell - far;
    }

    /** The y of a row; the first is the real axis, where the outline has the limit for damping. */
    private double y(double row) {
        return Math.max(0, row - 0.5) * cell;
    }

    /**
     * @param look its look
     * @param name the name in the legend
     * @return the outline |R| = 1, broken where it is in pieces
     */
    Series outline(Look look, String name) {
        return Series.of(look, name, Mark.LINE, lines(0));
    }

    /**
     * @param look its look
     * @return the region where a step does not grow
     */
    Series filled(Look look) {
        return Series.of(look, "stable", Mark.FILL, lines(1));
    }

    /** The lines of the outline, each with a gap after it, in the grid and these squares beyond it. */
    private List<double[]> lines(int beyond) {
        List<double[][]> pieces = new ArrayList<>();
        int rows = grows.length - 1 + beyond;
        for (int r = -rows; r < rows; r++) {
            for (int c = -beyond; c + 1 < grows[0].length + beyond; c++) {
                cross(r, c, pieces);
            }
        }
        List<double[]> line = new ArrayList<>();
        while (!pieces.isEmpty()) {
            line.addAll(chain(pieces));
            line.add(new double[] {Double.NaN, Double.NaN});
        }
        return line;
    }

    /** The point on the outline between a stable point and one where a step grows; below the real axis its mirror. */
    private double[] border(int[] stable, int[] growing) {
        int r = Math.abs(stable[1]);
        int growingR = Math.abs(growing[1]);
        double[] above = borders.computeIfAbsent(List.of(stable[0], r, growing[0], growingR), edge ->
                border(stable[0], r, growing[0], growingR));
        return stable[1] + growing[1] < 0 ? new double[] {above[0], -above[1]} : above;
    }

    /** Found by bisection. */
    private double[] border(int c, int r, int growingC, int growingR) {
        double still = 0;
        double growing = 1;
        for (int halving = 0; halving < HALVINGS; halving++) {
            double middle = (still + growing) / 2;
            if (growsAt(c + middle * (growingC - c), r + middle * (growingR - r))) {
                growing = middle;
            } else {
                still = middle;
            }
        }
        return new double[] {x(c + still * (growingC - c)), y(r + still * (growingR - r))};
    }

    /**
     * The straight piece of the outline in one square, from edge to edge (W. E. Lorensen, H. E. Cline 1987, in the
     * plane).
     */
    private void cross(int r, int c, List<double[][]> pieces) {
        int[][] corners = {{c, r}, {c + 1, r}, {c + 1, r + 1}, {c, r + 1}};
        List<double[]> cuts = new ArrayList<>();
        for (int k = 0; k < 4; k++) {
            int[] p = corners[k];
            int[] q = corners[(k + 1) % 4];
            if (grows(p[0], p[1]) != grows(q[0], q[1])) {
                cuts.add(grows(q[0], q[1]) ? border(p, q) : border(q, p));
            }
        }
        for (int k = 0; k + 1 < cuts.size(); k += 2) {
            pieces.add(new double[][] {cuts.get(k), cuts.get(k + 1)});
        }
    }

    /** Pieces strung together where they meet, so that dashes run on. */
    private static Deque<double[]> chain(List<double[][]> left) {
        Deque<double[]> chain = new ArrayDeque<>(List.of(left.remove(left.size() - 1)));
        while (left.removeIf(piece -> attach(chain, piece[0], piece[1]) || attach(chain, piece[1], piece[0]))) {
            // as long as a piece fits at an end
        }
        return chain;
    }

    private static boolean attach(Deque<double[]> chain, double[] here, double[] there) {
        if (Arrays.equals(chain.getLast(), here)) {
            chain.addLast(there);
            return true;
        }
        return Arrays.equals(chain.getFirst(), here) && chain.offerFirst(there);
    }
}
