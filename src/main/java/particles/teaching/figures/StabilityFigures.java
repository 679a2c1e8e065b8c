package particles.teaching.figures;

import static particles.view.DataTable.column;

import deSolvers.DESolver;
import deSolvers.catalog.SolverCatalog;
import deSolvers.text.Digits;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Supplier;
import java.util.stream.Stream;
import particles.experiments.stability.Amplification;
import particles.experiments.stability.StabilityLimit;
import particles.experiments.stability.StabilityMap;
import particles.experiments.stability.StabilityRegion;
import particles.experiments.stability.StabilityRegion.Window;
import particles.experiments.stability.StepTrial;
import particles.teaching.sources.Springs;
import particles.teaching.sources.StiffDecay;
import particles.teaching.sources.StudentSource;
import particles.view.Chart;
import particles.view.DataTable;
import particles.view.DataTable.Cells;
import particles.view.Look;
import particles.view.Panel;
import particles.view.Series;
import particles.view.Series.Mark;

/**
 * The stability limits and the stability region of a solver, measured on its steps.
 *
 * @param rows   the limits, or why there are none: property, value, meaning
 * @param region the part of the plane where a step does not grow, beside the most similar built-in solver's
 * @param growth the factor by which a step multiplies the solution, beside the exact one and those of built-in solvers
 */
record StabilityFigures(List<List<Object>> rows, Optional<Panel> region, Optional<DataTable> growth) {
    /** With more noise the coefficients of R are not known well enough to be named. */
    private static final double CLEAN = 1e-9;
    private static final double STABLE = 1 + 1e-8;
    /** Growth is compared up to this factor. */
    private static final double MOST = 4;
    /** So much is shown of a plane without a border between stable and unstable. */
    private static final double EMPTY = 4;
    private static final int DIRECTIONS = 12;
    private static final double NEAREST = 0.05;
    private static final double FARTHEST = 20;
    private static final double FINE = 1.1;
    private static final double COARSE = 1.3;
    private static final double MARGIN = 0.15;
    private static final int CELLS = 80;
    /** The square of the cells, times the evaluations of a step: a costly method has a coarser grid. */
    private static final double EVALUATIONS = 25_600;
    /** The growth over many steps, measured at each point of the grid, counts as so many. */
    private static final int MANY_STEPS = 44;
    private static final int FEW_CELLS = 24;
    /** An iteration needs more rounds the longer the step: up to 500 in some that are to end at 1e-15. */
    private static final List<Double> LENGTHS = List.of(0.5, 1.0, 2.0, 4.0);
    private static final String REAL = "real limit: largest stable deltaT |lambda|";
    private static final String IMAGINARY = "imaginary limit: largest stable deltaT omega";
    private static final String DAMPED = "damped limit: largest stable deltaT omega";
    private static final List<String> FOR_ALL = List.of("euler", "midpoint", "rk4", "backward-euler",
            "implicit-midpoint");
    private static final List<String> FOR_SPRINGS = List.of("symplectic-euler", "verlet", "yoshida4");
    private static final double[][] PLACES = {{-0.5, 0}, {-1, 0}, {-2, 0}, {-4, 0}, {0, 0.5}, {0, 1}, {0, 2}, {0, 4},
            {-1, 1}};

    /**
     * @param name      the solver's name in charts
     * @param maker     makes a new solver
     * @param multistep whether it uses earlier steps
     * @return the figures
     */
    static StabilityFigures of(String name, Supplier<DESolver> maker, boolean multistep) {
        StepTrial trial = StepTrial.of(maker, multistep);
        boolean builtIn = SolverCatalog.names().contains(name);
        Optional<Amplification> measured = builtIn ? Optional.of(Amplification.of(SolverCatalog.info(name)))
                : trial.amplification();
        if (measured.isEmpty()) {
            return new StabilityFigures(List.of(List.of(REAL, "-", trial.objection()),
                    List.of(IMAGINARY, "-", "the same")),
                    Optional.empty(), Optional.empty());
        }
        Amplification own = measured.get();
        boolean springs = own.ofSprings();
        boolean subStep = builtIn && SolverCatalog.info(name).adaptive();
        double noise = builtIn ? 0 : 10 * trial.noise();
        Map<String, Amplification> others = others(name, own);
        String nearest = Collections.min(others.keySet(), Comparator.comparing(other -> distance(own,
                others.get(other))));
        List<List<Object>> rows = new ArrayList<>();
        if (!subStep && !springs && !multistep && trial.noise() < CLEAN) {
            StabilityFunction.of(maker, trial.noise())
                    .ifPresent(r -> rows.add(List.of("R(z), factor of a step in y' = lambda y, z = lambda deltaT",
                    r.text(), r.owner().isEmpty() ? "z is deltaT lambda" : r.owner())));
        }
        StabilityLimit damping = StabilityLimit.measure(h -> own.at(-h, 0) - noise);
        StabilityLimit spring = StabilityLimit.measure(h -> own.at(0, h) - noise);
        String how = own.manySteps() ? ", from the growth over many steps" : subStep ? ", of one sub-step" : "";
        List<Object> damped = springs ? List.of(DAMPED, text(damping), "of a critically damped spring" + how)
                : List.of(REAL, text(damping), "of drag alone: on the negative real axis" + how);
        List<Object> undamped = List.of(IMAGINARY, text(spring), "of an undamped spring"
                + (springs ? "" : ": on the imaginary axis") + (spring.value() == 0 ? "; grows at any deltaT" : "")
                + how);
        rows.addAll(springs ? List.of(undamped, damped) : List.of(damped, undamped));
        String answer = "stable: " + (springs ? "critical damping " : "damping ") + most(damping)
                + ", undamped springs " + most(spring);
        double cost = (own.manySteps() ? MANY_STEPS : 1) * LENGTHS.stream().mapToLong(deltaT -> Math.max(
                evaluations(maker, new Springs(), deltaT), springs ? 0 : evaluations(maker, new StiffDecay(), deltaT
                / StiffDecay.RATE))).average().orElseThrow();
        double cells = Math.max(FEW_CELLS, Math.min(CELLS, Math.sqrt(EVALUATIONS / cost)));
        return new StabilityFigures(rows, Optional.of(Panel.map(name + ": stability region",
                chart(name, own, nearest, others.get(nearest), cells)).answered(answer)),
                Optional.of(table(name, own, nearest, others)));
    }

    private static long evaluations(Supplier<DESolver> maker, StudentSource source, double deltaT) {
        source.accepts(maker.get(), deltaT);
        return source.getEvaluations();
    }

    private static String text(StabilityLimit limit) {
        return limit.value() == Double.POSITIVE_INFINITY ? "unbounded" : limit.value() == 0 ? "0"
                : Digits.format("%.8g", limit.value());
    }

    private static String most(StabilityLimit limit) {
        return limit.value() == 0 ? "never" : limit.value() == Double.POSITIVE_INFINITY ? "always"
                : Digits.format("to %.4g", limit.value());
    }

    /** @return the built-in solvers with which it is compared, tried as it is: on springs, or on the test equation */
    private static Map<String, Amplification> others(String name, Amplification own) {
        List<String> names = new ArrayList<>(FOR_ALL);
        if (own.ofSprings()) {
            names.addAll(FOR_SPRINGS);
        }
        if (own.manySteps()) {
            names.add("adams");
        }
        names.remove(name);
        Map<String, Amplification> others = new LinkedHashMap<>();
        names.forEach(other -> others.put(other, own.ofSprings()
                ? new Amplification(() -> SolverCatalog.create(other), true, false)
                : Amplification.of(SolverCatalog.info(other))));
        return others;
    }

    /** @return how much the growth of two solvers differs at the places of the table */
    private static double distance(Amplification own, Amplification other) {
        return Arrays.stream(PLACES).mapToDouble(at -> Math.abs(Math.min(MOST, own.at(at[0], at[1]))
                - Math.min(MOST, other.at(at[0], at[1])))).sum();
    }

    private static Chart chart(String name, Amplification own, String nearest, Amplification other, double cells) {
        Window window = window(List.of(own, other), cells);
        StabilityMap map = new StabilityMap(own::at, window);
        Series beside = new StabilityMap(other::at, window).outline(Look.of(SolverCatalog.info(nearest)), nearest);
        Look look = SolverCatalog.find(name).map(Look::of).orElse(Look.OWN);
        // pale and wide, so that a line along which it runs is seen
        return StabilityRegion.chart(List.of(map.outline(look, name), map.filled(look),
                new Series(beside.look(), nearest, Mark.BAND, beside.x(), beside.y())), window);
    }

    /** Looks from 0 in all directions for places where stable and unstable meet, and shows all of them. */
    private static Window window(List<Amplification> solvers, double cells) {
        double factor = cells > FEW_CELLS ? FINE : COARSE;
        double left = 0;
        double right = 0;
        double top = 0;
        for (int k = 0; k <= DIRECTIONS; k++) {
            double cos = StrictMath.cos(Math.PI * k / DIRECTIONS);
            double sin = StrictMath.sin(Math.PI * k / DIRECTIONS);
            for (Amplification one : solvers) {
                boolean stable = one.at(NEAREST * cos, NEAREST * sin) <= STABLE;
                for (double size = NEAREST; size < FARTHEST; size *= factor) {
                    if (one.at(size * cos, size * sin) <= STABLE != stable) {
                        stable = !stable;
                        left = Math.min(left, size * cos);
                        right = Math.max(right, size * cos);
                        top = Math.max(top, size * sin);
                    }
                }
            }
        }
        double size = Math.max(right - left, top);
        if (size == 0) {                                // all stable, or the imaginary axis for an outline
            size = EMPTY;
            left = -size;
        }
        double margin = MARGIN * size;
        left -= 2 * margin;
        right = Math.max(right, left + 2 * margin + size / 2) + margin;
        top = Math.max(top, size / 2) + margin;
        return new Window(left, right, -top, top, size / cells);
    }

    private static DataTable table(String name, Amplification own, String nearest,
            Map<String, Amplification> others) {
        List<String> beside = new ArrayList<>(Stream.of("euler", "midpoint", "rk4", nearest).distinct().toList());
        beside.remove(name);
        List<Cells<double[]>> columns = new ArrayList<>(List.of(column("deltaT lambda", StabilityFigures::place),
                column("exactly", at -> digits(StrictMath.exp(at[0]))),
                column(name, at -> digits(own.at(at[0], at[1])))));
        beside.forEach(other -> columns.add(column(other, at -> digits(others.get(other).at(at[0], at[1])))));
        return DataTable.of("growth", own.ofSprings()
                ? "By how much a step multiplies the amplitude of a damped spring; exactly |exp(deltaT lambda)|"
                : "By how much a step multiplies the size of y in y' = lambda y; exactly |exp(deltaT lambda)|",
                List.of(PLACES), columns);
    }

    private static String place(double[] at) {
        return at[1] == 0 ? number(at[0]) : at[0] == 0 ? number(at[1]) + " i"
                : number(at[0]) + " + " + number(at[1]) + " i";
    }

    private static String number(double x) {
        return Digits.exact(x);
    }

    private static String digits(double x) {
        return x == Double.POSITIVE_INFINITY ? "refused" : Digits.format("%.6f", x);
    }
}
