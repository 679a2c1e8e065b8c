package particles.experiments.stability;

import deSolvers.catalog.SolverCatalog;
import deSolvers.catalog.SolverInfo;
import java.math.BigDecimal;
import java.math.MathContext;
import java.util.ArrayList;
import java.util.List;
import particles.view.ChartData;
import particles.view.ChartData.Mark;
import particles.view.ChartData.Series;

/**
 * Charts of stability regions, the part of the plane of z = deltaT lambda in which a step does not grow. The outline
 * |R(z)| = 1 is found on the solvers' real code.
 */
public final class StabilityRegion {
    private StabilityRegion() {
    }

    /**
     * A part of the plane, symmetric to the real axis, and the width of its grid.
     *
     * @param left  the smallest real part
     * @param right the largest
     * @param top   the largest imaginary part, and minus the smallest
     * @param cell  the side of a square of the grid
     */
    public record Window(double left, double right, double top, double cell) {
    }

    /**
     * @param title   the title of the chart
     * @param solvers the solvers
     * @param window  the part of the plane
     * @return a line for each solver, broken where the outline is in pieces, and the imaginary axis
     */
    public static ChartData outlines(String title, List<String> solvers, Window window) {
        List<Series> series = new ArrayList<>();
        for (String solver : solvers) {
            series.add(new StabilityMap(Amplification.of(SolverCatalog.info(solver))::at, window,
                    true).outline(solver));
        }
        return chart(title, series, window);
    }

    /**
     * @param solver the solver
     * @param window the part of the plane
     * @return the region, filled, with its limits in the title
     */
    public static ChartData filled(String solver, Window window) {
        SolverInfo info = SolverCatalog.info(solver);
        StabilityMap map = new StabilityMap(Amplification.of(info)::at, window, true);
        return chart(solver + ": " + limits(info),
                new ArrayList<>(List.of(map.filled("stable"), map.outline(solver))), window);
    }

    private static ChartData chart(String title, List<Series> series, Window window) {
        series.add(new Series("imaginary axis", Mark.LINE, new double[] {0, 0},
                new double[] {-window.top, window.top}));
        return new ChartData(title, "Re(deltaT lambda): decay to the left", "Im(deltaT lambda): oscillation",
                false, false, series);
    }

    private static String digits(double limit) {
        return new BigDecimal(limit).round(new MathContext(4)).stripTrailingZeros().toPlainString();
    }

    /** The limits of a step, in a sentence. */
    private static String limits(SolverInfo info) {
        double damping = info.dampedLimit();
        double springs = info.imaginaryLimit();
        if (damping == Double.POSITIVE_INFINITY && springs == Double.POSITIVE_INFINITY) {
            return "stable at any step, whatever decays or swings";
        }
        if (Double.isNaN(damping)) {
            return "the first step of its table";
        }
        return (info.secondOrder() ? "critical damping to " : "damping to ") + digits(damping)
                + (springs > 0 ? ", undamped springs to " + digits(springs) : "; undamped springs always grow");
    }
}
