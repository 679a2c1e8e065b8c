package particles.teaching.measured;

import deSolvers.DESolver;
import java.util.Iterator;
import java.util.Optional;
import java.util.function.Supplier;
import particles.teaching.Finding;
import particles.teaching.declared.Declaration;
import particles.teaching.declared.Method;
import particles.teaching.sources.Bodies;
import particles.teaching.sources.OrderMeasurement;
import particles.teaching.sources.WindyOscillators;

/**
 * The order of a solver on three sources.
 *
 * @param bodies on two bodies that attract each other in space
 * @param clock  on a nonlinear spring whose force changes with the clock
 * @param drag   on one with drag
 * @param state  on the one with a clock, which is read off the state
 */
public record Orders(OrderMeasurement bodies, OrderMeasurement clock, OrderMeasurement drag, OrderMeasurement state) {
    private static final double HALF = 0.5;
    /** A step whose states and times belong together makes the same errors; Lawson's method makes 7 times as large. */
    private static final double OFF_CLOCK = 20;
    /** Smaller errors may be those of a tolerance. */
    private static final double TOLERATED = 1e-8;

    public static Orders of(Supplier<DESolver> maker) {
        return new Orders(OrderMeasurement.measure(maker, Bodies::new), OrderMeasurement.of(maker, () ->
                WindyOscillators.nonlinear(1)), OrderMeasurement.of(maker, WindyOscillators::withDrag),
                OrderMeasurement.of(maker, WindyOscillators::timeless));
    }

    /** @return the lower one of the orders without drag; NaN if the error does not follow deltaT */
    public double order() {
        return bodies.order() < clock.order() ? bodies.order() : clock.order();
    }

    /** @return the order as a number of its own; empty if the error does not follow deltaT */
    public Optional<Long> whole() {
        return Optional.of(order()).filter(order -> order > HALF).map(Math::round);
    }

    private OrderMeasurement lower() {
        return bodies.order() < clock.order() ? bodies : clock;
    }

    private String where() {
        return bodies.order() < clock.order() - HALF ? " where bodies attract each other" : "";
    }

    /** @return the mistake of errors that do not go to 0, or not as fast as declared, or only without a clock */
    public Optional<Finding> mistake(Optional<Declaration> declared, boolean withDrag) {
        return far(bodies, " where bodies attract each other").or(() -> far(clock, "")).or(this::clocks).or(() ->
                Phrase.DRAG_DIVERGES.when(drag.isFar(), drag.digits())).or(() -> declared.map(Declaration::method)
                .flatMap(method -> low(lower(), where(), method).or(() -> !withDrag ? Optional.empty() : low(drag,
                " where the acceleration depends on the velocity", method)))).or(() -> Phrase.OTHER_ORDER.when(
                bodies.order() < clock.order() - 3 * HALF, bodies.digits(), clock.digits()));
    }

    private static Optional<Finding> far(OrderMeasurement measured, String where) {
        return Phrase.NO_CONVERGENCE.when(measured.isFar(), where, measured.smallest()[1], measured.smallest()[0]);
    }

    private static Optional<Finding> low(OrderMeasurement measured, String where, Method method) {
        return Phrase.LOW_ORDER.when(measured.order() < method.order() - HALF, measured.digits(), where, method.title(),
                method.order(), method.isFamily() ? " or more" : "");
    }

    /** Whether the law that is read off the clock leads astray, and the same law without a clock does not. */
    private Optional<Finding> clocks() {
        Iterator<double[]> others = state.points().iterator();
        for (double[] point : clock.points()) {
            double error = point[1];
            double without = others.hasNext() ? others.next()[1] : error;
            if (error > OFF_CLOCK * without && error > TOLERATED && Double.isFinite(error)) {
                return Optional.of(Phrase.STAGE_CLOCKS.of(error, point[0], without));
            }
        }
        return Optional.empty();
    }

    /** @return the note on a method whose order falls with drag */
    public Optional<Finding> note() {
        return Phrase.DRAG.when(drag.order() < order() - 0.7, lower().digits(), drag.digits());
    }
}
