package particles.teaching.measured;

import deSolvers.DESolver;
import java.util.Optional;
import java.util.function.Supplier;
import java.util.stream.Stream;
import particles.teaching.Finding;
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
 */
public record Orders(OrderMeasurement bodies, OrderMeasurement clock, OrderMeasurement drag) {
    private static final double HALF = 0.5;

    public static Orders of(Supplier<DESolver> maker) {
        return new Orders(OrderMeasurement.of(maker, Bodies::new), OrderMeasurement.of(maker), OrderMeasurement.of(
                maker, () -> WindyOscillators.withDrag().from(HALF)));
    }

    /** @return the lower one of the orders without drag; NaN if the error does not follow deltaT */
    public double order() {
        return lower().order();
    }

    /** @return the order as a number of its own; empty if the error does not follow deltaT */
    public Optional<Long> whole() {
        return Optional.of(order()).filter(order -> order > HALF).map(Math::round);
    }

    private OrderMeasurement lower() {
        return bodies.order() < clock.order() ? bodies : clock;
    }

    private String where(OrderMeasurement measured) {
        return measured == drag ? " where the acceleration depends on the velocity" : measured == clock
                && lowersWithClock() ? " where a force changes with the clock" : measured == bodies && !(bodies.order()
                > clock.order() - HALF) ? " where bodies attract each other" : "";
    }

    /** @return whether it is lower where a force changes with the clock */
    public boolean lowersWithClock() {
        return clock.order() < bodies.order() - HALF;
    }

    /** @return the order with two digits */
    public String digits() {
        return lower().digits();
    }

    /** @return the mistake of errors that do not go to 0, or not as fast as declared, or far slower on one source */
    public Optional<Finding> mistake(Optional<Method> meant, boolean withDrag) {
        return Stream.of(bodies, clock, drag).filter(OrderMeasurement::isFar).map(one -> Phrase.NO_CONVERGENCE.of(where(
                one), one.smallest()[1], one.smallest()[0])).findFirst().or(() -> meant.flatMap(method -> Stream.of(
                lower(), withDrag ? drag : clock).filter(one -> one.order() < method.order() - HALF).map(one ->
                Phrase.LOW_ORDER.of(one.digits(), where(one), method.title(), method.order(), method.isFamily()
                ? " or more" : "")).findFirst())).or(() -> Phrase.OTHER_ORDER.when(
                Math.abs(bodies.order() - clock.order()) > 3 * HALF, bodies.digits(), clock.digits()));
    }

    /** @return the note on a method whose order falls with drag */
    public Optional<Finding> note() {
        return Phrase.DRAG.when(drag.order() < order() - 0.7, digits(), drag.digits());
    }
}
