package particles.experiments.stability;

import deSolvers.catalog.SolverCatalog;
import java.util.ArrayList;
import java.util.List;
import particles.view.ChartData;
import particles.view.ChartData.Mark;
import particles.view.ChartData.Series;

/**
 * Where in the plane of z = deltaT lambda a step does not grow: the outline |R(z)| = 1, found on the solvers' real
 * code.
 */
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
            series.add(new StabilityMap(Amplification.of(SolverCatalog.info(solver))::at, window,
                    true).outline(solver));
        }
        series.add(new Series("imaginary axis", Mark.LINE, new double[] {0, 0},
                new double[] {-window.top, window.top}));
        return new ChartData(title, "Re(deltaT lambda): decay to the left, growth to the right",
                "Im(deltaT lambda): oscillation",
                false, false, series);
    }
}
