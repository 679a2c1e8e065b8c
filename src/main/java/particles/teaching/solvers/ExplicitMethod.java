package particles.teaching.solvers;

import deSolvers.DESolver;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.function.DoubleSupplier;
import java.util.function.Supplier;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import particles.teaching.Finding;
import particles.teaching.Formula;
import particles.teaching.sources.Springs;
import particles.teaching.sources.StiffDecay;

/**
 * Identifies a method whose step is a combination with fixed weights, and its mistakes: first those that all methods
 * can have, then the difference from the nearest known method.
 */
final class ExplicitMethod {
    private static final double H = 1.0 / 4;
    private static final String OWN = "This is a method of your own, apart from the mistake below.";
    /** Up to this number of evaluations a method should have full order; one with more may aim at stability instead. */
    private static final int MANY = 4;
    private static final double ALMOST = 0.3;

    private final Supplier<DESolver> maker;
    private final Optional<NamePromise> promise;
    private final DoubleSupplier measured;
    private final List<Finding> findings = new ArrayList<>();
    private StepReading step;
    private int order;

    ExplicitMethod(Supplier<DESolver> maker, Optional<NamePromise> promise, DoubleSupplier measured) {
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
        Optional<StepReading> once = StepReading.of(maker, H, size, 1);
        Optional<StepReading> twice = StepReading.of(maker, 2 * H, size, 1);
        Optional<StepReading> back = StepReading.of(maker, -H, size, 1).filter(reading -> reading.evaluations() > 0);
        if (once.isEmpty() || twice.isEmpty() || Stream.concat(twice.stream(), back.stream()).anyMatch(other ->
                other.evaluations() != once.get().evaluations())) {
            return Optional.empty();
        }
        step = once.get();
        if (size == 1 && step.isStill() && StepReading.of(maker, H, StepReading.TINY, 1).stream()
                .noneMatch(StepReading::isStill)) {
            return Optional.of(new Diagnosis("This is a method with step-size control.",
                    List.of(Phrase.REJECTED_CLOCK.of())));
        }
        StepRules rules = new StepRules(step, twice.get(), back, findings::add);
        if (rules.isNoPower()) {
            return Optional.empty();
        }
        step.calls().wrongLengths().stream().limit(1).forEach(length -> findings.add(Phrase.ARRAY_LENGTH.of(length)));
        findings.addAll(step.findings());
        if (step.evaluations() == 0) {
            findings.add(Phrase.NO_DERIVATIVE.of());
            return Optional.of(new Diagnosis("It makes no step.", List.copyOf(findings)));
        }
        Scheme scheme = step.isOneFormula() ? oneFormula() : ofParticles();
        boolean clock = rules.checkClock();
        boolean end = rules.checkState(scheme) && rules.checkDeltaT(scheme);
        String identity = identity(scheme, end, clock);
        return Optional.of(new Diagnosis(identity, List.copyOf(findings), order));
    }

    static String twoDigits(double x) {
        return String.format(Locale.ROOT, "%.2f", x);
    }

    private boolean isWrong() {
        return findings.stream().anyMatch(Finding::isWrong);
    }

    private List<Scheme> meant(Scheme scheme) {
        return promise.map(name -> KnownMethods.like(scheme).stream().filter(method -> name.allows(method.name(), method
                .order())).toList()).orElse(List.of());
    }

    private double[] clocks() {
        return IntStream.range(0, step.evaluations()).mapToDouble(step::clock).toArray();
    }

    /** The rows of the evaluations and of the new state. */
    private List<double[]> rows(double[][] all) {
        List<double[]> rows = new ArrayList<>(Arrays.asList(all).subList(0, step.evaluations()));
        rows.add(all[step.evaluations() + 1]);
        return rows;
    }

    private Scheme oneFormula() {
        return Scheme.oneFormula("", 0, rows(step.positions()).stream().map(row -> scaled(row, 2, 1 / H, row[0]))
                .toList(), clocks());
    }

    /** The first weights, then some of the row's in other units. */
    private double[] scaled(double[] row, int from, double factor, double... first) {
        double[] all = Arrays.copyOf(first, first.length + step.evaluations());
        IntStream.range(0, step.evaluations()).forEach(j -> all[first.length + j] = factor * row[from + j]);
        return all;
    }

    /** The derivative of a position is the velocity at that evaluation, which is a combination itself. */
    private Scheme ofParticles() {
        int n = step.evaluations();
        List<double[]> rows = new ArrayList<>();
        for (double[] row : rows(step.positions())) {
            double[] position = scaled(row, 2 + n, 1 / (H * H), row[0], row[1] / H);
            for (int j = 0; j < n; j++) {
                double[] velocity = step.velocities()[j];
                position = Combination.plus(position, row[2 + j] / H, scaled(velocity, 2, 1 / H, 0, velocity[0]));
            }
            rows.add(position);
        }
        rows.add(scaled(step.newVelocity(), 2, 1 / H, step.newVelocity()[0]));
        return Scheme.ofParticles("", 0, rows, clocks()).withoutUnused();
    }

    /** The method in a sentence; adds what differs from it. */
    private String identity(Scheme read, boolean end, boolean clock) {
        boolean waste = end && !read.isOfParticles() && read.ends().get(0).increment() != 0
                && !KnownMethods.isStagesOfAny(read);
        Scheme scheme = waste ? read.withoutUnused() : read;
        if (scheme.size() < read.size()) {
            findings.add(Phrase.UNUSED.of());
        }
        boolean mistaken = isWrong();
        String but = mistaken ? ", apart from the mistake below." : ".";
        boolean[] set = new boolean[step.evaluations()];
        IntStream.range(0, set.length).forEach(i -> set[i] = step.calls().recorded().get(i).stateSet());
        Comparison nearest = Comparison.nearest(KnownMethods.like(scheme), scheme, set, clock);
        if (nearest.isEmpty()) {
            Scheme method = nearest.known();
            order = method.order();
            promise.filter(name -> end && clock).flatMap(name -> name.contradicted(method)).ifPresent(finding ->
                    findings.add(0, finding));
            return "This is " + method.name() + but;
        }
        Optional<Finding> unsolved = !end || !clock ? Optional.empty() : SolvedEquation.rounds(maker, scheme, promise)
                .or(() -> KnownMethods.mistake(scheme)).or(() ->
                promise.filter(NamePromise::isImplicit).map(name -> Phrase.EXPLICIT.of("an explicit method with "
                + count(scheme), name.says())));
        if (unsolved.isPresent()) {
            findings.add(0, unsolved.get());
            return "This is an explicit method.";
        }
        if (mistaken && !(end && clock)) {
            return "Its step is not that of a method yet.";
        }
        List<Scheme> meant = meant(scheme);
        return unknown(scheme, meant.isEmpty() ? nearest : Comparison.nearest(meant, scheme, set, clock), but);
    }

    private static String count(Scheme scheme) {
        return scheme.size() + (scheme.isOfParticles() ? " acceleration" : " evaluation") + (scheme.size() == 1 ? ""
                : "s") + " per step";
    }

    /** Judges coefficients that are those of no known method by their measured order, and by the nearest one. */
    private String unknown(Scheme scheme, Comparison nearest, String but) {
        boolean particles = scheme.isOfParticles();
        double full = Math.max(0, measured.getAsDouble());
        full = Double.isNaN(full) ? 0 : full;
        int wanted = promise.map(NamePromise::order).orElse(nearest.isNear() ? nearest.known().order() : 1);
        order = (int) Math.round(full);
        boolean keepsArea = particles && keepsArea();
        boolean pays = full > 1.7 || full > 1 - ALMOST && (particles ? keepsArea : isStableBeyondEuler(scheme));
        if (!nearest.isRounded() && (!particles || !isWrong()) && full >= wanted - ALMOST && pays) {
            return (particles ? "This is a method of order " + order
                    + " that moves positions and velocities in turn," + (keepsArea ? " symplectic," : "")
                    : "This is a Runge-Kutta method of order " + order) + " with " + count(scheme)
                    + "; its coefficients match no named method" + but;
        }
        if (nearest.isNear() || promise.filter(NamePromise::isWhole).isPresent() && nearest.known().size()
                == scheme.size() && (particles || scheme.size() <= MANY)) {
            findings.add(nearest.first());
            return "This is nearest to " + nearest.known().name() + ", apart from the mistake below.";
        }
        Combination row = scheme.ends().get(0);
        Optional<Finding> time = IntStream.range(0, particles ? 0 : scheme.size()).filter(i -> !Formula.same(
                scheme.stages().get(i).increment(), scheme.times()[i])).mapToObj(i -> Phrase.TIME_OF_STAGE.of(scheme
                .slope(i), scheme.stages().get(i).formula(), Formula.time(scheme.times()[i]), scheme.stages().get(i)
                .increment(), scheme.times()[i])).findFirst();
        String order = twoDigits(full);
        findings.add(time.orElseGet(() -> particles || Formula.same(row.increment(), 1) ? Phrase.LOW_ORDER.of(order,
                count(scheme), promise.map(p -> "; the name promises " + p.saysWithOrder()).orElse(""), row.what(), row
                .formula()) : Phrase.WEIGHTS_SUM.of(row.increment())));
        return OWN;
    }

    private boolean keepsArea() {
        Springs springs = new Springs();
        maker.get().stepState(springs, 1);
        return Math.abs(springs.steps().determinant() - 1) < 1e-10;
    }

    /** On the negative real axis s Euler steps are stable to 2 s; a method of order 1 has to do as well to pay. */
    private boolean isStableBeyondEuler(Scheme scheme) {
        return IntStream.range(1, 16 * scheme.size()).allMatch(z -> {
            StiffDecay decay = new StiffDecay();
            maker.get().stepState(decay, z / 8.0 / StiffDecay.RATE);
            return decay.size() <= 1 + 1e-9;
        });
    }
}
