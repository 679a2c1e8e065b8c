package particles.experiments.stability;

import deSolvers.catalog.SolverInfo;
import deSolvers.text.Digits;
import java.util.ArrayList;
import java.util.List;
import particles.experiments.runs.SolverChoice;
import particles.view.Axis;
import particles.view.Chart;
import particles.view.Look;
import particles.view.Panel;
import particles.view.Series;
import particles.view.Series.Mark;

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

    /** @return a line for each solver, broken where the outline is in pieces, and the imaginary axis */
    static Chart outlines(List<SolverChoice> solvers, Window window) {
        return chart(solvers.stream().map(solver -> new StabilityMap(Amplification.of(solver)::at, window)
                .outline(solver.look(), solver.label())).toList(), window);
    }

    /** @return the region of a solver, filled, with its stated limits below its name */
    public static Panel filled(SolverInfo solver, Window window) {
        StabilityMap map = new StabilityMap(Amplification.of(solver)::at, window);
        Look look = Look.of(solver);
        return Panel.map(solver.name(), chart(List.of(map.filled(look), map.outline(look, solver.name())), window))
                .named(solver.name()).answered(limits(solver));
    }

    /**
     * @param regions lines and stripes; the imaginary axis comes to them
     * @param window  the part of the plane
     * @return the chart
     */
    public static Chart chart(List<Series> regions, Window window) {
        List<Series> series = new ArrayList<>(regions);
        series.add(new Series(Look.REFERENCE, "imaginary axis", Mark.LINE, new double[] {0, 0},
                new double[] {window.bottom, window.top}));
        return new Chart(Axis.linear("Re(deltaT lambda): decay to the left", ""),
                Axis.linear("Im(deltaT lambda): oscillation", ""), series).scaledTo(List.of(new Series(Look.REFERENCE,
                "window", Mark.LINE, new double[] {window.left, window.right},
                new double[] {window.bottom, window.top})));
    }

    /** The limits of a step, in a line. */
    private static String limits(SolverInfo info) {
        return Double.isNaN(info.dampedLimit()) ? "the first step of its table"
                : "stable: damped " + limit(info.dampedLimit()) + ", undamped " + limit(info.imaginaryLimit());
    }

    private static String limit(double value) {
        return value == 0 ? "never" : value == Double.POSITIVE_INFINITY ? "always" : "to " + Digits.few(value, 4);
    }
}
