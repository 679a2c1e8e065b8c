package particles.teaching.solvers;

import deSolvers.DESolver;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.function.Supplier;
import particles.teaching.Finding;
import particles.teaching.Finding.Kind;
import particles.teaching.Formula;
import particles.teaching.sources.WindyOscillators;

/** Compares a solver's measured order with that of its coefficients and of its name. */
final class AccuracyCheck {
    /** Below this order the error does not go to 0; Euler measures 0.97 to 1.03. */
    private static final double LOWEST_ORDER = 0.7;
    private static final double HALF_AN_ORDER = 0.5;
    /** Adaptive methods have an error that does not follow deltaT, and a small one. */
    private static final double SMALL_ERROR = 1e-4;

    private final Supplier<DESolver> maker;
    private final Optional<NamePromise> promise;
    private Optional<OrderMeasurement> measured = Optional.empty();

    AccuracyCheck(Supplier<DESolver> maker, Optional<NamePromise> promise) {
        this.maker = maker;
        this.promise = promise;
    }

    private OrderMeasurement measurement() {
        if (measured.isEmpty()) {
            measured = Optional.of(OrderMeasurement.lowest(maker));
        }
        return measured.get();
    }

    /** @return the measured order; NaN if the error does not follow deltaT */
    double order() {
        return measurement().order();
    }

    private boolean vanishes(OrderMeasurement measurement) {
        return measurement.order() >= LOWEST_ORDER || measurement.smallestError() < SMALL_ERROR;
    }

    /** @return the mistake if the measured order is not that of the coefficients */
    Optional<Finding> held(Diagnosis diagnosis) {
        double order = diagnosis.order() == 0 ? Double.NaN : order();
        return order < diagnosis.order() - HALF_AN_ORDER ? Optional.of(new Finding(Kind.METHOD, String.format(
                Locale.ROOT, "the measured order is %.2f, and the coefficients of a step are those of a method of order"
                + " %d: on other sources it makes another step", order, diagnosis.order()))) : Optional.empty();
    }

    /** @return the mistake if only one particle is moved as it should be */
    Optional<Finding> layout() {
        OrderMeasurement two = OrderMeasurement.of(maker, () -> new WindyOscillators(2));
        return order() >= LOWEST_ORDER && !vanishes(two)
                ? Optional.of(new Finding(Kind.STATE, "with one particle the error goes to 0 with deltaT, with two it "
                + "does not: the state is three positions and three velocities for each particle in turn, (x1, v1, x2,"
                + " v2, ...), and not all positions and then all velocities")) : Optional.empty();
    }

    /**
     * @param causes looks for the cause where the state after a step tells none
     * @return the mistake if the error does not go to 0, or not as fast as the class's name promises
     */
    Optional<Finding> poorOrder(Supplier<Optional<Finding>> causes) {
        boolean vanishes = vanishes(measurement());
        boolean kept = Double.isNaN(order()) || promise.isEmpty() || order() > promise.get().order() - HALF_AN_ORDER;
        if (vanishes && kept) {
            return Optional.empty();
        }
        Optional<String> far = vanishes ? Optional.empty() : new UnreadMethod(maker).elsewhere();
        return far.map(text -> new Finding(Kind.METHOD, text)).or(causes)
                .or(() -> Optional.of(new Finding(Kind.METHOD, vanishes ? tooLow() : notToZero())));
    }

    private String tooLow() {
        return String.format(Locale.ROOT, "the measured order is %.2f; the name promises %s: compare the coefficients"
                + " with those of the book, and the times of the stages", order(), promise.get().saysWithOrder());
    }

    private String notToZero() {
        return "the error does not go to 0 with deltaT: over the same time it is " + text(1) + " with deltaT = "
                + text(0) + " s. Check that each evaluation is at its own state and time, and that the weights add up"
                + " to 1";
    }

    /** @return the first, a middle and the last of the measured points */
    private String text(int column) {
        List<double[]> points = measurement().points();
        return List.of(points.get(0), points.get(points.size() / 2), points.get(points.size() - 1)).stream()
                .map(point -> Formula.number(point[column])).toList().toString().replaceAll("[\\[\\]]", "");
    }
}
