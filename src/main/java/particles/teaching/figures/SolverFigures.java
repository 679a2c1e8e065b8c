package particles.teaching.figures;

import deSolvers.DESolver;
import deSolvers.catalog.SolverCatalog;
import deSolvers.problems.StepMatrix;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.function.Supplier;
import particles.teaching.Finding;
import particles.teaching.StudentFailure;
import particles.teaching.solvers.OrderMeasurement;
import particles.teaching.solvers.SolverVerdict;
import particles.teaching.sources.Springs;
import particles.teaching.sources.WindyOscillators;
import particles.view.ChartData.Mark;
import particles.view.ChartData.Series;
import particles.view.ChartData;
import particles.view.DataTable;

/**
 * What a solver does, measured on motions with known solutions.
 *
 * @param facts         the numbers
 * @param order         error against deltaT
 * @param region        where it is stable, if steps of its own have something to say of that
 * @param growth        what a step multiplies by, likewise
 * @param energy        the energy of a spring over time
 * @param workPrecision error against evaluations, beside other solvers
 */
public record SolverFigures(DataTable facts, ChartData order, Optional<ChartData> region, Optional<DataTable> growth,
        ChartData energy,
                             ChartData workPrecision) {
    private static final double ENERGY_STEP = 0.1;
    private static final int ENERGY_STEPS = 2000;
    private static final int BEGINNING = 12;
    private static final double BLOWN_UP = 1e12;
    private static final List<String> BESIDE = List.of("midpoint", "rk4", "verlet");

    /**
     * Measures.
     *
     * @param name    what the solver is called in the charts
     * @param maker   makes a new one
     * @param verdict what was found out about it
     * @return the numbers and charts
     */
    public static SolverFigures of(String name, Supplier<DESolver> maker, SolverVerdict verdict) {
        OrderMeasurement order = OrderMeasurement.of(maker);
        List<double[]> energy = energy(maker);
        StabilityFigures stability = StabilityFigures.of(name, maker, verdict.multistep());
        boolean builtIn = SolverCatalog.names().contains(name);
        // what does as a built-in one does is seen below it, and not hidden
        List<Series> energies = new ArrayList<>(List.of(series(name, builtIn ? Mark.LINE : Mark.BAND, energy)));
        List<Series> work = new ArrayList<>();
        for (String other : BESIDE) {
            if (!other.equals(name)) {
                energies.add(series(other, Mark.LINE, energy(() -> SolverCatalog.create(other))));
                work.add(series(other, Mark.LINE_AND_POINTS, work(() -> SolverCatalog.create(other))));
            }
        }
        work.add(series(name, builtIn ? Mark.LINE_AND_POINTS : Mark.LINE_AND_OPEN_POINTS, work(maker)));
        return new SolverFigures(facts(maker, verdict, order, energy, stability),
                new ChartData(String.format(Locale.ROOT, "The error falls as deltaT^%.2f", order.order()), "deltaT (s)",
                        "error after 2 s", true,
                        true, List.of(series(name, Mark.LINE_AND_POINTS, order.points()))), stability.region(),
                stability.growth(),
                new ChartData(String.format(Locale.ROOT, "Energy of a spring, deltaT = 0.1 s: off by up to %.2g of it",
                        largest(energy)),
                        "time (s)", "|energy / first energy - 1|", false, true, energies),
                new ChartData("Error against work", "evaluations of the derivative", "error after 8 s", true, true,
                        work));
    }

    /** @return what to say of an exception of the solver's in the midst of this */
    public static Finding failure(RuntimeException thrown) {
        return new Finding(Finding.Kind.FAILURE, "while it was measured on springs, stepState ended in an exception: "
                + StudentFailure.describe(thrown));
    }

    private static Series series(String name, Mark mark, List<double[]> points) {
        List<double[]> shown = points.stream().filter(p -> p[1] > 0 && p[1] < BLOWN_UP).toList();
        return new Series(name, mark, shown.stream().mapToDouble(p -> p[0]).toArray(),
                shown.stream().mapToDouble(p -> p[1]).toArray());
    }

    private static List<double[]> energy(Supplier<DESolver> maker) {
        Springs springs = new Springs();
        DESolver solver = maker.get();
        double first = springs.energy();
        List<double[]> points = new ArrayList<>();
        for (int step = 1; step <= ENERGY_STEPS && springs.energy() < BLOWN_UP; step++) {
            solver.stepState(springs, ENERGY_STEP);
            if (step % 7 == 0) {
                points.add(new double[] {step * ENERGY_STEP, Math.abs(springs.energy() / first - 1)});
            }
        }
        return points;
    }

    private static List<double[]> work(Supplier<DESolver> maker) {
        List<double[]> points = new ArrayList<>();
        for (int steps = 16; steps <= 1024; steps *= 2) {
            WindyOscillators source = new WindyOscillators(1);
            DESolver solver = maker.get();
            for (int i = 0; i < steps; i++) {
                solver.stepState(source, 8.0 / steps);
            }
            source.incTime(8 - source.getTime());
            points.add(new double[] {source.evaluations(), source.error()});
        }
        return points;
    }

    private static DataTable facts(Supplier<DESolver> maker, SolverVerdict verdict, OrderMeasurement order,
            List<double[]> energy,
                                   StabilityFigures stability) {
        List<List<Object>> rows = new ArrayList<>();
        rows.add(List.of("order, measured", text(order.order()), "over the same time the error falls as deltaT to this "
                + "power"));
        long small = evaluations(maker, 0.1);
        long large = evaluations(maker, 1);
        rows.add(List.of("evaluations in a step", String.valueOf(large), small == large ? "for any deltaT"
                : "with deltaT = 1 s; " + small + " with 0.1 s"));
        if (!verdict.multistep()) {                     // else a step does not multiply the state by a matrix
            StepMatrix step = step(maker, 1);
            rows.add(List.of("amplitude of a spring, a step of deltaT omega = 1", text(step.radius()),
                    "exactly 1; more grows without end, less is damped"));
            rows.add(List.of("the same with deltaT omega = 0.1", text(step(maker, 0.1).radius()), "exactly 1"));
            double area = step.determinant() - 1;
            rows.add(List.of("area in state space, a step of deltaT omega = 1", text(step.determinant()), small != large
                    ? "off by what the tolerance lets pass" : Math.abs(area) > 1e-10
                    ? "not symplectic: " + (area > 0 ? "gains" : "loses") + " area"
                    : "symplectic on the spring: areas are kept"));
        }
        double back = back(maker);
        rows.add(List.of("a step and the same step back", text(back), back < 1e-12
                ? "reversible: it ends where it began"
                : "not reversible"));
        rows.add(List.of("largest energy error of a spring, 2000 steps of 0.1", text(largest(energy)), "relative"));
        rows.addAll(stability.rows());
        return new DataTable("facts", "What it does", List.of(DataTable.column("property"), DataTable.column("value"),
                DataTable.column("meaning")),
                rows);
    }

    private static String text(double x) {
        return String.format(Locale.ROOT, "%.8g", x);
    }

    private static double largest(List<double[]> energy) {
        return energy.stream().mapToDouble(p -> p[1]).max().orElse(Double.NaN);
    }

    private static StepMatrix step(Supplier<DESolver> maker, double h) {
        Springs springs = new Springs();
        maker.get().stepState(springs, h);
        return springs.steps();
    }

    /** In a later step, when what is needed to begin with is there. */
    private static long evaluations(Supplier<DESolver> maker, double h) {
        Springs springs = new Springs();
        DESolver solver = maker.get();
        long before = 0;
        for (int step = 0; step < BEGINNING; step++) {
            before = springs.evaluations();
            solver.stepState(springs, h);
        }
        return springs.evaluations() - before;
    }

    private static double back(Supplier<DESolver> maker) {
        WindyOscillators source = new WindyOscillators(1);
        double[] before = source.state();
        maker.get().stepState(source, 0.25);
        maker.get().stepState(source, -0.25);
        double[] after = source.state();
        double distance = 0;
        for (int k = 0; k < before.length; k++) {
            distance = Math.max(distance, Math.abs(after[k] - before[k]));
        }
        return distance;
    }
}
