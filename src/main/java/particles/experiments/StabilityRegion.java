package particles.experiments;

import deSolvers.catalog.SolverCatalog;
import deSolvers.catalog.SolverInfo;
import java.util.ArrayList;
import java.util.List;
import particles.ChartData;
import particles.ChartData.Mark;
import particles.ChartData.Series;

/** Where in the plane of z = deltaT lambda a step does not grow: the outline |R(z)| = 1, found on the solvers' real code. */
public final class StabilityRegion {
    private StabilityRegion() {
    }

    /**
     * A part of the plane, symmetric to the real axis, and how finely it is looked at.
     *
     * @param left  the smallest real part
     * @param right the largest
     * @param top   the largest imaginary part, and with a minus the smallest
     * @param cell  the side of a square of the grid
     */
    public record Window(double left, double right, double top, double cell) {
    }

    /**
     * @param title   of the chart
     * @param solvers whose outlines it shows
     * @param window  the part of the plane
     * @return a line for each solver, broken where the outline is in pieces, and the imaginary axis
     */
    public static ChartData outlines(String title, List<String> solvers, Window window) {
        List<Series> series = new ArrayList<>();
        for (String solver : solvers) {
            series.add(outline(SolverCatalog.info(solver), window));
        }
        series.add(new Series("imaginary axis", Mark.LINE, new double[] {0, 0}, new double[] {-window.top, window.top}));
        return new ChartData(title, "Re(deltaT lambda): decay to the left, growth to the right", "Im(deltaT lambda): oscillation",
                false, false, series);
    }

    /** The upper half is measured, from one row below the axis, and mirrored: R of the conjugate is the conjugate of R. */
    static Series outline(SolverInfo info, Window window) {
        Amplification amplification = new Amplification(info);
        int columns = (int) Math.round((window.right - window.left) / window.cell);
        int rows = (int) Math.round(window.top / window.cell);
        double[][] excess = new double[rows + 1][columns + 1];
        for (int r = 0; r <= rows; r++) {
            for (int c = 0; c <= columns; c++) {
                // half a cell off both axes, so that |R| = 1 on an axis is a line between points and not on them
                double modulus = amplification.at(window.left + (c + 0.5) * window.cell, Math.abs(r - 0.5) * window.cell);
                excess[r][c] = Math.max(-1, Math.min(1, modulus - 1 - Amplification.ROUNDING));
            }
        }
        List<double[]> points = new ArrayList<>();
        for (int r = 0; r < rows; r++) {
            for (int c = 0; c < columns; c++) {
                cross(excess, r, c, window, points);
            }
        }
        return series(info.name(), points);
    }

    /** The straight piece of the outline in one square, from edge to edge (W. E. Lorensen, H. E. Cline 1987, in the plane). */
    private static void cross(double[][] excess, int r, int c, Window window, List<double[]> points) {
        double[][] corners = {{c, r}, {c + 1, r}, {c + 1, r + 1}, {c, r + 1}};
        List<double[]> cuts = new ArrayList<>();
        for (int k = 0; k < 4; k++) {
            double[] p = corners[k];
            double[] q = corners[(k + 1) % 4];
            double a = excess[(int) p[1]][(int) p[0]];
            double b = excess[(int) q[1]][(int) q[0]];
            if (a > 0 != b > 0) {
                double part = a / (a - b);
                cuts.add(new double[] {window.left + (p[0] + part * (q[0] - p[0]) + 0.5) * window.cell,
                    (p[1] + part * (q[1] - p[1]) - 0.5) * window.cell});
            }
        }
        for (int k = 0; k + 1 < cuts.size(); k += 2) {
            points.add(new double[] {cuts.get(k)[0], cuts.get(k)[1], cuts.get(k + 1)[0], cuts.get(k + 1)[1]});
        }
    }

    /** Pieces strung together where they meet, so that dashes run on; then once more below the axis. */
    private static Series series(String name, List<double[]> pieces) {
        List<double[]> line = new ArrayList<>();
        List<double[]> left = new ArrayList<>(pieces);
        while (!left.isEmpty()) {
            List<double[]> chain = chain(left);
            line.addAll(chain);
            line.add(new double[] {Double.NaN, Double.NaN});
            chain.forEach(point -> line.add(new double[] {point[0], -point[1]}));
            line.add(new double[] {Double.NaN, Double.NaN});
        }
        return new Series(name, Mark.LINE, line.stream().mapToDouble(p -> p[0]).toArray(),
                line.stream().mapToDouble(p -> p[1]).toArray());
    }

    private static List<double[]> chain(List<double[]> left) {
        List<double[]> chain = new ArrayList<>();
        double[] first = left.remove(left.size() - 1);
        chain.add(new double[] {first[0], first[1]});
        chain.add(new double[] {first[2], first[3]});
        boolean grown = true;
        while (grown) {
            grown = false;
            for (int k = 0; k < left.size() && !grown; k++) {
                double[] p = left.get(k);
                grown = attach(chain, p[0], p[1], p[2], p[3]) || attach(chain, p[2], p[3], p[0], p[1]);
                if (grown) {
                    left.remove(k);
                }
            }
        }
        return chain;
    }

    private static boolean attach(List<double[]> chain, double x, double y, double otherX, double otherY) {
        if (same(chain.get(chain.size() - 1), x, y)) {
            return chain.add(new double[] {otherX, otherY});
        }
        if (same(chain.get(0), x, y)) {
            chain.add(0, new double[] {otherX, otherY});
            return true;
        }
        return false;
    }

    private static boolean same(double[] point, double x, double y) {
        return Math.abs(point[0] - x) + Math.abs(point[1] - y) < 1e-9;
    }
}
