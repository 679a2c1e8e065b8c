package particles.teaching.figures;

import deSolvers.DESolver;
import deSolvers.text.Digits;
import java.util.List;
import java.util.Optional;
import java.util.function.Supplier;
import java.util.stream.DoubleStream;
import particles.experiments.stability.Amplification;
import particles.experiments.stability.StabilityLimit;
import particles.experiments.stability.StabilityMap;
import particles.experiments.stability.StabilityRegion;
import particles.experiments.stability.StabilityRegion.Window;
import particles.experiments.stability.StepTrial;
import particles.view.Look;
import particles.view.Panel;

/**
 * The stability limits and the stability region of a solver, measured on its steps.
 *
 * @param rows   the limits, or why there are none: property, value, meaning
 * @param region the part of the plane where a step does not grow
 */
record StabilityFigures(List<List<Object>> rows, Optional<Panel> region) {
    /** So far is shown of a plane where all limits are unbounded or 0. */
    private static final double EMPTY = 3.2;
    private static final double MARGIN = 1.3;
    private static final int CELLS = 128;
    /** The growth over many steps is measured at each point of the grid. */
    private static final int FEW_CELLS = 48;
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
        if (trial.amplification().isEmpty()) {
            return new StabilityFigures(List.of(List.of(REAL, "-", trial.objection()),
                    List.of(IMAGINARY, "-", "the same")), Optional.empty());
        }
        Amplification own = trial.amplification().get();
        boolean springs = own.ofSprings();
        double noise = 10 * trial.noise();
        StabilityLimit damping = StabilityLimit.measure(h -> own.at(-h, 0) - noise);
        StabilityLimit spring = StabilityLimit.measure(h -> own.at(0, h) - noise);
        String how = own.manySteps() ? ", from the growth over many steps" : "";
        List<Object> damped = springs ? List.of(DAMPED, text(damping), "of a critically damped spring" + how)
                : List.of(REAL, text(damping), "of drag alone: on the negative real axis" + how);
        List<Object> undamped = List.of(IMAGINARY, text(spring), "of an undamped spring"
                + (springs ? "" : ": on the imaginary axis") + (spring.value() == 0 ? "; grows at any deltaT" : "")
                + how);
        String answer = "stable: " + (springs ? "critical damping " : "damping ") + most(damping)
                + ", undamped springs " + most(spring);
        double far = MARGIN * DoubleStream.of(damping.value(), spring.value()).filter(limit -> limit > 0
                && Double.isFinite(limit)).max().orElse(EMPTY);
        Window window = new Window(-far, far, -far, far, 2 * far / (own.manySteps() ? FEW_CELLS : CELLS));
        StabilityMap map = new StabilityMap(own::at, window);
        return new StabilityFigures(springs ? List.of(undamped, damped) : List.of(damped, undamped), Optional.of(
                Panel.map(name + ": stability region", StabilityRegion.chart(List.of(map.outline(Look.OWN, name),
                map.filled(Look.OWN)), window)).answered(answer)));
    }

    private static String text(StabilityLimit limit) {
        return limit.value() == Double.POSITIVE_INFINITY ? "unbounded" : limit.value() == 0 ? "0"
                : Digits.format("%.8g", limit.value());
    }

    private static String most(StabilityLimit limit) {
        return limit.value() == 0 ? "never" : limit.value() == Double.POSITIVE_INFINITY ? "always"
                : Digits.format("to %.4g", limit.value());
    }
}
