package particles.experiments.stability;

import deSolvers.catalog.SolverCatalog;
import deSolvers.catalog.SolverInfo;
import deSolvers.text.Digits;
import java.util.ArrayList;
import java.util.List;
import java.util.function.Predicate;
import particles.experiments.runs.SolverChoice;
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
     * A part of the plane and the width of its grid.
     *
     * @param left   the smallest real part
     * @param right  the largest
     * @param bottom the smallest imaginary part: minus the largest, or 0 for the upper half
     * @param top    the largest imaginary part
     * @param cell   the side of a square of the grid
     */
    public record Window(double left, double right, double bottom, double top, double cell) {
    }

    /**
     * @param solvers the solvers
     * @param window  the part of the plane
     * @return a line for each solver, broken where the outline is in pieces, and the imaginary axis; without a title
     */
    static ChartData outlines(List<String> solvers, Window window) {
        return chart("", solvers.stream().map(solver -> map(solver, window).outline(solver)).toList(), window);
    }

    /** @return the same, titled, with each region filled, darker where several solvers are stable */
    public static ChartData filled(List<String> solvers, Window window) {
        List<Series> regions = new ArrayList<>();
        List<Series> outlines = new ArrayList<>();
        for (String solver : solvers) {
            StabilityMap map = map(solver, window);
            regions.add(map.filled(solver + ": stable"));
            outlines.add(map.outline(solver));
        }
        regions.addAll(outlines);
        regions.add(Series.point("shaded: stable", Mark.BAND, Double.NaN, Double.NaN));
        return chart(finding(solvers, window), regions, window);
    }

    private static StabilityMap map(String solver, Window window) {
        return new StabilityMap(Amplification.of(SolverCatalog.info(solver))::at, window);
    }

    /**
     * @param solver the solver
     * @param window the part of the plane
     * @return the region, filled, with its limits in the title
     */
    public static ChartData filled(String solver, Window window) {
        StabilityMap map = map(solver, window);
        return chart(solver + ": " + limits(SolverCatalog.info(solver)),
                List.of(map.filled("stable"), map.outline(solver)), window);
    }

    /**
     * @param finding the title
     * @param regions lines and stripes; the imaginary axis comes to them
     * @param window  the part of the plane
     * @return the chart
     */
    public static ChartData chart(String finding, List<Series> regions, Window window) {
        List<Series> series = new ArrayList<>(regions);
        series.add(new Series("imaginary axis", Mark.LINE, new double[] {0, 0},
                new double[] {window.bottom, window.top}));
        return new ChartData(finding, "Re(deltaT lambda): decay to the left", "Im(deltaT lambda): oscillation",
                false, false, series).scaledTo(List.of(new Series("window", Mark.LINE,
                new double[] {window.left, window.right}, new double[] {window.bottom, window.top})));
    }

    /**
     * @param solvers the solvers
     * @param window  the part of the plane
     * @return a sentence about undamped springs and decay, and about growth up to the window's right edge
     */
    public static String finding(List<String> solvers, Window window) {
        List<String> parts = new ArrayList<>();
        for (String solver : solvers) {
            double limit = SolverCatalog.info(solver).imaginaryLimit();
            if (limit > 0 && limit < Double.POSITIVE_INFINITY) {
                parts.add(Digits.few(limit, 4) + " with " + solver);
            }
        }
        List<String> never = those(solvers, info -> info.imaginaryLimit() == 0);
        List<String> always = those(solvers, info -> info.imaginaryLimit() == Double.POSITIVE_INFINITY
                && info.dampedLimit() == Double.POSITIVE_INFINITY);
        List<String> fast = those(solvers, info -> Amplification.of(info).at(window.right, 0) < 1);
        String springs = (parts.isEmpty() ? "" : " up to deltaT omega = " + String.join(", ", parts))
                + (never.isEmpty() ? "" : (parts.isEmpty() ? "" : ", at") + " no step with " + SolverChoice.few(never));
        return (springs.isEmpty() ? "" : "Undamped springs are stable" + (parts.isEmpty() ? " at" : "") + springs)
                + (always.isEmpty() ? "" : "All that decays is stable at any step with " + SolverChoice.few(always))
                + (fast.isEmpty() ? "" : "; " + SolverChoice.few(fast) + " also make fast growth decay");
    }

    private static List<String> those(List<String> solvers, Predicate<SolverInfo> which) {
        return solvers.stream().filter(solver -> which.test(SolverCatalog.info(solver))).toList();
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
        return (info.secondOrder() ? "critical damping to " : "damping to ") + Digits.few(damping, 4)
                + (springs > 0 ? ", undamped springs to " + Digits.few(springs, 4) : "; undamped springs always grow");
    }
}
