package particles.teaching.solvers;

import deSolvers.DESolver;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.function.DoubleSupplier;
import java.util.function.Supplier;
import particles.teaching.Finding;
import particles.teaching.Finding.Kind;
import particles.teaching.Formula;

/**
 * Reads the coefficients of a solver from its steps, and tests with other numbers whether they describe it completely.
 */
final class TableauReading {
    private static final double H = 1.0 / 4;
    /** A few roundings of double arithmetic; measured 3e-16 for RK4. */
    private static final double DOUBLE_ROUNDING = 1e-13;
    /** Below this it may be float arithmetic, with roundings of 6e-8, or numbers that are rounded to a few decimals. */
    private static final double FLOAT_ROUNDING = 1e-3;
    /** Unusually large derivatives, to detect a solver that limits them. */
    static final double LARGE = 1e3;
    /** So small that an adaptive method accepts its first step. */
    static final double TINY = StrictMath.pow(2, -40);

    private final Supplier<DESolver> maker;
    private final Optional<NamePromise> promise;
    private final DoubleSupplier measured;
    private final List<Finding> findings = new ArrayList<>();

    TableauReading(Supplier<DESolver> maker, Optional<NamePromise> promise, DoubleSupplier measured) {
        this.maker = maker;
        this.promise = promise;
        this.measured = measured;
    }

    /**
     * @param size the size of the derivatives in the reading: 1, or so small that an adaptive method accepts its first
     *             step
     * @return the diagnosis; empty if its steps have no fixed coefficients
     */
    Optional<Diagnosis> diagnosis(double size) {
        findings.clear();
        try {
            ExtractedTableau step = ExtractedTableau.of(maker.get(), H, size);
            ExtractedTableau twice = ExtractedTableau.of(maker.get(), 2 * H, size);
            if (takesDifferences(step, twice)) {
                return Optional.of(differences());
            }
            Optional<ExtractedTableau> back = back(size);
            if (step.stages() != twice.stages() || back.stream().anyMatch(other -> step.stages() != other.stages())
                    || step.wrongLengths().isEmpty() && !fits(step.compare(maker.get(), size))) {
                return Optional.empty();
            }
            if (size == 1 && step.isStill() && !ExtractedTableau.of(maker.get(), H, TINY).isStill()) {
                return Optional.of(new Diagnosis("This is a method with step-size control.", List.of(new Finding(
                        Kind.TIME, "with derivatives up to 1 the clock moves and the state stays, with tiny ones both"
                        + " move: the clock may move only when a sub-step is accepted"))));
            }
            List<EntryComparison> large = size == 1 ? step.compare(maker.get(), LARGE) : List.of();
            if (size == 1 && large.isEmpty()) {
                return Optional.empty();                // more evaluations where more is to be done
            }
            if (size == 1 && last(large).largest() > FLOAT_ROUNDING) {
                findings.add(new Finding(Kind.METHOD, "with derivatives up to " + Formula.number(LARGE)
                        + " the step is not the"
                        + " one that it makes with derivatives up to 1: something is cut off, or depends on the size"));
            }
            Diagnosis diagnosis = TableauDiagnosis.of(step, twice, back, promise, measured);
            boolean old = promise.map(name -> name.methods().contains(NamePromise.SYMPLECTIC)).orElse(false);
            findings.addAll(diagnosis.findings());
            return Optional.of(diagnosis.identity().startsWith("This is the Euler method") && old
                    ? new Diagnosis("This is the Euler method.", List.of(KicksDiagnosis.oldVelocity()))
                    : new Diagnosis(diagnosis.identity(), List.copyOf(findings), diagnosis.order()));
        } catch (RuntimeException e) {
            return Optional.empty();                    // adaptive, or it wants positions and velocities
        }
    }

    /**
     * Whether a stage lies a little ahead or behind, by the same length in state and clock whatever deltaT is, and
     * enters with deltaT^2: a difference quotient of the derivative.
     */
    private static boolean takesDifferences(ExtractedTableau step, ExtractedTableau twice) {
        for (int i = 1; i < Math.min(step.stages(), twice.stages()); i++) {
            double ahead = MethodDifferences.sum(step.a()[i]);
            if (ahead != 0 && Formula.same(MethodDifferences.sum(twice.a()[i]) / ahead, 1)
                    && Math.abs(step.c()[i] - ahead) < DOUBLE_ROUNDING && Math.abs(twice.c()[i] - ahead)
                    < DOUBLE_ROUNDING && step.b()[i] != 0 && Formula.same(twice.b()[i] / step.b()[i], 4)) {
                return true;
            }
        }
        return false;
    }

    private Diagnosis differences() {
        double order = measured.getAsDouble();
        int wanted = Math.max(2, promise.map(NamePromise::order).orElse(2));
        List<Finding> found = order > wanted - 0.5 ? List.of() : List.of(new Finding(Kind.METHOD, String.format(
                Locale.ROOT, "the measured order is %.2f and should be %d: compare the difference quotient and its"
                + " factor, deltaT^2/2, with the Taylor series", order, wanted)));
        return new Diagnosis("This is a method with a difference quotient for the second derivative.", found);
    }

    private Optional<ExtractedTableau> back(double size) {
        try {
            return Optional.of(ExtractedTableau.of(maker.get(), -H, size));
        } catch (RuntimeException e) {
            return Optional.empty();                    // it refuses negative deltaT, which is a note elsewhere
        }
    }

    /** Whether a step with random numbers agrees with the coefficients; some differences become findings. */
    private boolean fits(List<EntryComparison> states) {
        if (states.isEmpty() || last(states).isWithout(FLOAT_ROUNDING)) {
            return false;
        }
        findings.addAll(EntryComparison.leftOut(states, FLOAT_ROUNDING));
        double largest = last(states).largest();
        if (largest > DOUBLE_ROUNDING) {
            findings.add(new Finding(Kind.STATE, "digits get lost: the new state is off by " + Formula.number(largest)
                    + " of its size, as " + (largest < 1e-6 ? "in float arithmetic; all numbers have to be double"
                            : "if a number were rounded on the way; only what is printed may be")));
        }
        return true;
    }

    private static EntryComparison last(List<EntryComparison> states) {
        return states.get(states.size() - 1);
    }
}
