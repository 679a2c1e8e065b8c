package particles.teaching.figures;

import deSolvers.DESolver;
import deSolvers.catalog.SolverCatalog;
import deSolvers.problems.StepMatrix;
import deSolvers.text.Digits;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.function.Supplier;
import java.util.stream.Stream;
import particles.teaching.GuardedRun;
import particles.teaching.solvers.SolverVerdict;
import particles.teaching.sources.OrderMeasurement;
import particles.teaching.sources.Springs;
import particles.teaching.sources.WindyOscillators;
import particles.view.Axis;
import particles.view.Chart;
import particles.view.DataTable;
import particles.view.Look;
import particles.view.Panel;
import particles.view.Series;
import particles.view.Series.Mark;

/**
 * Measurements of a solver on motions with known solutions, as numbers and charts.
 *
 * @param facts  the numbers
 * @param order  error against deltaT
 * @param region the stability region; empty if it cannot be measured
 * @param energy the energy of a spring over time, beside other solvers
 */
public record SolverFigures(DataTable facts, Panel order, Optional<Panel> region, Panel energy) {
    private static final double ENERGY_STEP = 0.1;
    private static final Axis ENERGY = Axis.log("|energy / first energy - 1|", "");
    private static final int ENERGY_STEPS = 2000;
    private static final int BEGINNING = 12;
    private static final long REFUSED = -1;
    private static final double BACK = 0.25;
    private static final String THERE_AND_BACK = "distance from the start after a step of " + BACK + " and a step back";
    private static final double BLOWN_UP = 1e12;
    private static final List<String> BESIDE = List.of("midpoint", "rk4", "verlet");

    /**
     * Measures.
     *
     * @param name    the solver's name in the charts
     * @param plain   makes a new solver
     * @param verdict the result of the check
     * @return the numbers and charts
     */
    public static SolverFigures of(String name, Supplier<DESolver> plain, SolverVerdict verdict) {
        Supplier<DESolver> maker = () -> {
            GuardedRun.goesOn();                        // the solver before has made its steps
            return plain.get();
        };
        OrderMeasurement order = OrderMeasurement.of(maker);
        List<double[]> energy = energy(maker);
        StabilityFigures stability = StabilityFigures.of(name, maker, verdict.multistep());
        // a wide band, so that it shows below an equal curve of a built-in solver
        List<Series> energies = new ArrayList<>(List.of(series(Look.OWN, name, Mark.BAND, energy)));
        BESIDE.stream().filter(other -> !other.equals(name)).forEach(other -> energies.add(series(Look.of(
                SolverCatalog.info(other)), other, Mark.LINE, energy(() -> SolverCatalog.create(other)))));
        return new SolverFigures(facts(maker, verdict, order, energy, stability),
                Panel.of(name + ": error against deltaT", List.of(new Chart(Axis.log("deltaT", "s"),
                        Axis.log("error after 2 s", ""), List.of(series(Look.OWN, name, Mark.LINE_AND_POINTS,
                        order.points()))))).answered(Double.isNaN(order.order()) ? "" : "order " + order.digits()),
                stability.region(),
                Panel.of(name + ": energy of a spring, deltaT = " + ENERGY_STEP + " s", List.of(new Chart(Axis.TIME,
                        ENERGY, energies.stream().map(one -> one.ending(Digits.few(Arrays.stream(one.y()).max()
                        .orElse(Double.NaN), 2))).toList()))));
    }

    private static Series series(Look look, String name, Mark mark, List<double[]> points) {
        return Series.of(look, name, mark, points.stream().filter(p -> p[1] > 0 && p[1] < BLOWN_UP).toList());
    }

    private static List<double[]> energy(Supplier<DESolver> maker) {
        Springs springs = new Springs();
        DESolver solver = maker.get();
        double first = springs.energy();
        List<double[]> points = new ArrayList<>();
        for (int step = 1; step <= ENERGY_STEPS && springs.energy() < BLOWN_UP
                && springs.accepts(solver, ENERGY_STEP); step++) {
            if (step % 7 == 0 || step == ENERGY_STEPS) {
                points.add(new double[] {step * ENERGY_STEP, Math.abs(springs.energy() / first - 1)});
            }
        }
        return points;
    }

    private static DataTable facts(Supplier<DESolver> maker, SolverVerdict verdict, OrderMeasurement order,
            List<double[]> energy, StabilityFigures stability) {
        List<List<Object>> rows = new ArrayList<>();
        rows.add(Double.isNaN(order.order())
                ? List.of("order, measured", "-", "the error does not follow a power of deltaT, as with sub-steps")
                : List.of("order, measured", text(order.order()),
                "over a fixed time, the error falls as deltaT^order"));
        long small = evaluations(maker, 0.1);
        long large = evaluations(maker, 1);
        rows.add(List.of("evaluations in a step", String.valueOf(small), small == large ? "with any deltaT"
                : "with deltaT = 0.1 s; " + (large == REFUSED ? "a step of 1 s is refused" : large + " with 1 s")));
        rows.addAll(stability.rows());
        if (!verdict.multistep() && large != REFUSED) { // else a step does not multiply the state by a matrix
            Springs springs = new Springs();
            springs.step(maker.get(), 1);
            StepMatrix step = springs.steps();
            double area = step.determinant() - 1;
            rows.add(List.of("areas in state space, factor in a step of deltaT omega = 1",
                    text(step.determinant()), small != large
                    ? "differs from 1 by what the tolerance allows" : Math.abs(area) > 1e-10
                    ? "not symplectic: areas " + (area > 0 ? "grow" : "shrink")
                    : "symplectic on the spring: areas are kept"));
        }
        rows.add(List.of("largest energy error of a spring, 2000 steps of 0.1", text(energy.stream().mapToDouble(p ->
                p[1]).max().orElse(Double.NaN)),
                "relative to the energy at the start"));
        WindyOscillators there = new WindyOscillators(1);
        boolean back = there.accepts(maker.get(), BACK) && there.accepts(maker.get(), -BACK);
        double distance = there.error();
        rows.add(List.of(THERE_AND_BACK, back ? text(distance) : "-", !back ? "it refuses a step back"
                : distance < 1e-12 ? "reversible: it ends where it began" : "not reversible"));
        return new DataTable("facts", "What it does", Stream.of("property", "value", "meaning")
                .map(DataTable::column).toList(), rows);
    }

    private static String text(double x) {
        return Digits.format("%.8g", x);
    }

    /** Counted in a later step, when a multistep method has its history; {@link #REFUSED} if it makes none. */
    private static long evaluations(Supplier<DESolver> maker, double h) {
        Springs springs = new Springs();
        DESolver solver = maker.get();
        long before = 0;
        for (int step = 0; step < BEGINNING; step++) {
            before = springs.getEvaluations();
            if (!springs.accepts(solver, h)) {
                return REFUSED;
            }
        }
        return springs.getEvaluations() - before;
    }
}
