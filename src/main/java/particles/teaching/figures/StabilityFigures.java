package particles.teaching.figures;

import deSolvers.DESolver;
import deSolvers.catalog.SolverCatalog;
import deSolvers.text.Digits;
import java.util.List;
import java.util.Optional;
import java.util.function.Supplier;
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
import particles.view.Look;
import particles.view.Panel;

/**
 * The stability limits and the stability region of a solver, measured on its steps.
 *
 * @param rows   the limits, or why there are none: property, value, meaning
 * @param region the part of the plane where a step does not grow
 */
record StabilityFigures(List<List<Object>> rows, Optional<Panel> region) {
    private static final double STABLE = 1 + 1e-8;
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
                    Optional.empty());
        }
        Amplification own = measured.get();
        boolean springs = own.ofSprings();
        boolean subStep = builtIn && SolverCatalog.info(name).adaptive();
        double noise = builtIn ? 0 : 10 * trial.noise();
        StabilityLimit damping = StabilityLimit.measure(h -> own.at(-h, 0) - noise);
        StabilityLimit spring = StabilityLimit.measure(h -> own.at(0, h) - noise);
        String how = own.manySteps() ? ", from the growth over many steps" : subStep ? ", of one sub-step" : "";
        List<Object> damped = springs ? List.of(DAMPED, text(damping), "of a critically damped spring" + how)
                : List.of(REAL, text(damping), "of drag alone: on the negative real axis" + how);
        List<Object> undamped = List.of(IMAGINARY, text(spring), "of an undamped spring"
                + (springs ? "" : ": on the imaginary axis") + (spring.value() == 0 ? "; grows at any deltaT" : "")
                + how);
        String answer = "stable: " + (springs ? "critical damping " : "damping ") + most(damping)
                + ", undamped springs " + most(spring);
        double cost = (own.manySteps() ? MANY_STEPS : 1) * LENGTHS.stream().mapToLong(deltaT -> Math.max(
                evaluations(maker, new Springs(), deltaT), springs ? 0 : evaluations(maker, new StiffDecay(), deltaT
                / StiffDecay.RATE))).average().orElseThrow();
        double cells = Math.max(FEW_CELLS, Math.min(CELLS, Math.sqrt(EVALUATIONS / cost)));
        return new StabilityFigures(springs ? List.of(undamped, damped) : List.of(damped, undamped), Optional.of(
                Panel.map(name + ": stability region", chart(name, own, cells)).answered(answer)));
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

    private static Chart chart(String name, Amplification own, double cells) {
        Window window = window(own, cells);
        StabilityMap map = new StabilityMap(own::at, window);
        Look look = SolverCatalog.find(name).map(Look::of).orElse(Look.OWN);
        return StabilityRegion.chart(List.of(map.outline(look, name), map.filled(look)), window);
    }

    /** Looks from 0 in all directions for places where stable and unstable meet, and shows all of them. */
    private static Window window(Amplification own, double cells) {
        double factor = cells > FEW_CELLS ? FINE : COARSE;
        double left = 0;
        double right = 0;
        double top = 0;
        for (int k = 0; k <= DIRECTIONS; k++) {
            double cos = StrictMath.cos(Math.PI * k / DIRECTIONS);
            double sin = StrictMath.sin(Math.PI * k / DIRECTIONS);
            boolean stable = own.at(NEAREST * cos, NEAREST * sin) <= STABLE;
            for (double size = NEAREST; size < FARTHEST; size *= factor) {
                if (own.at(size * cos, size * sin) <= STABLE != stable) {
                    stable = !stable;
                    left = Math.min(left, size * cos);
                    right = Math.max(right, size * cos);
                    top = Math.max(top, size * sin);
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
}
