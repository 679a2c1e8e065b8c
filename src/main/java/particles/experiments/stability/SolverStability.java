package particles.experiments.stability;

import static particles.view.DataTable.column;

import deSolvers.catalog.SolverInfo;
import deSolvers.text.Digits;
import java.util.List;
import java.util.function.Function;
import java.util.function.ToDoubleFunction;
import java.util.stream.DoubleStream;
import particles.experiments.runs.SolverChoice;
import particles.view.DataTable;
import particles.view.Look;
import particles.view.Panel;

/**
 * The stability of a solver, measured on its steps: its limits and its region, the part of the plane of z = deltaT
 * lambda in which a step does not grow.
 *
 * @param name          its name in charts
 * @param look          its look in charts
 * @param amplification the growth in a step
 * @param undamped      the largest stable deltaT omega of a spring without damping
 * @param damped        that of a critically damped spring, both of whose eigenvalues are -omega; of methods that step
 *                      the state as a whole, on the negative real axis
 */
public record SolverStability(String name, Look look, Amplification amplification, StabilityLimit undamped,
        StabilityLimit damped) {
    private static final double MARGIN = 1.3;
    /** Half the side of a square without any limit in it, but for the margin. */
    private static final double EMPTY = 3.2;

    /** @return the stability of a solver with this name and look, from its growth */
    public static SolverStability of(String name, Look look, Amplification amplification) {
        return new SolverStability(name, look, amplification, StabilityLimit.measure(h -> amplification.at(0, h)),
                StabilityLimit.measure(h -> amplification.at(-h, 0)));
    }

    /** @return the stability of a solver */
    public static SolverStability of(SolverChoice solver) {
        return of(solver.label(), solver.look(), Amplification.of(solver));
    }

    /** @return half the side of a square that shows its limits, and where growing solutions no longer grow */
    public double reach() {
        StabilityLimit growing = StabilityLimit.measure(h -> 1 / amplification.at(h, 0));
        return MARGIN * DoubleStream.of(undamped.value(), damped.value(), growing.value()).filter(limit -> limit > 0
                && Double.isFinite(limit)).max().orElse(EMPTY);
    }

    /** @return its region, filled, in a square around 0 with this half side */
    public Panel region(double far) {
        StabilityMap map = StabilityMap.of(amplification, far);
        return Panel.map(name, StabilityMap.plane(far, List.of(map.filled(look), map.outline(look, name))))
                .named(name).answered("damped: " + damped.brief() + ", undamped: " + undamped.brief());
    }

    /**
     * @param measured the stability of solvers
     * @return their limits, beside those that the catalogue states
     */
    public static DataTable table(List<SolverStability> measured) {
        return DataTable.of("limits", "The largest stable deltaT omega of a spring without damping and of a critically"
                + " damped one. Where every step grows: by how much at deltaT omega = 0.1", measured,
                column("solver", SolverStability::name),
                column("undamped limit: stated", stated(SolverInfo::imaginaryLimit)),
                column("undamped limit: measured", one -> one.undamped.text()),
                column("damped limit: stated", stated(SolverInfo::dampedLimit)),
                column("damped limit: measured", one -> one.damped.text()));
    }

    /** Of a class of your own, nothing is stated. */
    private static Function<SolverStability, Object> stated(ToDoubleFunction<SolverInfo> limit) {
        return one -> one.look.solver().map(info -> new StabilityLimit(limit.applyAsDouble(info), Double.NaN).text())
                .orElse("-");
    }
}
