package particles.teaching.figures;

import deSolvers.DESolver;
import deSolvers.text.Digits;
import java.util.List;
import java.util.Optional;
import java.util.function.Supplier;
import particles.experiments.stability.SolverStability;
import particles.experiments.stability.StabilityLimit;
import particles.view.Look;
import particles.view.Panel;

/**
 * The stability limits and the stability region of a solver, measured on its steps.
 *
 * @param rows   the limits, or why there are none: property, value, meaning
 * @param region the part of the plane where a step does not grow
 */
record StabilityFigures(List<List<Object>> rows, Optional<Panel> region) {
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
        SolverStability own = SolverStability.of(name, Look.OWN, trial.amplification().get());
        boolean springs = own.amplification().ofSprings();
        String how = multistep ? ", from the growth over many steps" : "";
        List<Object> damped = springs ? List.of(DAMPED, text(own.damped()), "of a critically damped spring" + how)
                : List.of(REAL, text(own.damped()), "of drag alone: on the negative real axis" + how);
        List<Object> undamped = List.of(IMAGINARY, text(own.undamped()), "of an undamped spring"
                + (springs ? "" : ": on the imaginary axis") + (own.undamped().value() == 0 ? "; grows at any deltaT"
                : "") + how);
        Panel region = own.region(own.reach());
        return new StabilityFigures(springs ? List.of(undamped, damped) : List.of(damped, undamped),
                Optional.of(region.with(name + ": stability region", region.charts())));
    }

    private static String text(StabilityLimit limit) {
        return limit.value() == Double.POSITIVE_INFINITY ? "unbounded" : limit.value() == 0 ? "0"
                : Digits.format("%.8g", limit.value());
    }
}
