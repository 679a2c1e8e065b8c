package particles.teaching.solvers;

import deSolvers.DESolver;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.function.Supplier;
import java.util.stream.Stream;
import particles.teaching.Finding;
import particles.teaching.Finding.Kind;
import particles.teaching.StudentFailure;
import particles.teaching.compared.Agreement;
import particles.teaching.compared.Agreement.Cause;
import particles.teaching.compared.Agreement.Match;
import particles.teaching.compared.Fit;
import particles.teaching.compared.Reading;
import particles.teaching.declared.Declaration;
import particles.teaching.declared.Method;
import particles.teaching.declared.Scheme;
import particles.teaching.measured.Control;
import particles.teaching.measured.FreeFall;
import particles.teaching.measured.Orders;
import particles.teaching.measured.Phrase;
import particles.teaching.measured.SolverContract;
import particles.teaching.measured.SolverMemory;
import particles.teaching.measured.Units;

/** Checks a student's solver: says which method it is, and names one mistake, the first that explains the rest. */
public final class SolverCheck {
    private static final int STEPS = 6;
    private static final double SHORT = 1.0 / 16;
    private static final double LOW = 1.5;
    private static final String UNKNOWN = "Its step cannot be judged yet.";

    private final Supplier<DESolver> maker;
    private final Optional<Declaration> declared;
    private final SolverContract contract;
    private final Control control;
    private final List<Finding> notes = new ArrayList<>();
    private String identity = UNKNOWN;
    private Optional<Match> match = Optional.empty();
    private Optional<Method> known = Optional.empty();
    private Optional<Scheme> read = Optional.empty();
    private boolean remembers;
    private boolean multistep;
    private Orders orders;

    /** A search for a mistake. */
    private interface Search {
        Optional<Finding> find();
    }

    private SolverCheck(Supplier<DESolver> maker, Optional<Declaration> declared) {
        this.maker = maker;
        this.declared = declared;
        contract = new SolverContract(maker);
        control = new Control(maker);
    }

    /**
     * Checks a solver.
     *
     * @param maker     makes a new one
     * @param className the simple name of its class, which may declare a method, as HeunSolver does
     * @return its method, at most one mistake, and advice
     */
    public static SolverVerdict check(Supplier<DESolver> maker, String className) {
        return new SolverCheck(maker, Declaration.of(className)).verdict();
    }

    /**
     * Checks a solver that has to be this method.
     *
     * @param maker makes a new one
     * @return its method, at most one mistake, and advice
     */
    public static SolverVerdict check(Supplier<DESolver> maker, Method method) {
        return new SolverCheck(maker, Optional.of(new Declaration(method, true, true))).verdict();
    }

    private SolverVerdict verdict() {
        List<Finding> findings = new ArrayList<>();
        try {
            Optional<Finding> wrong = contract.start();
            findings.addAll(wrong.isPresent() ? List.of(wrong.get()) : judge());
        } catch (RuntimeException e) {
            findings.add(Phrase.EXCEPTION.of(StudentFailure.describe(e)));
        }
        Optional<Finding> first = findings.stream().filter(Finding::isWrong).findFirst();
        return new SolverVerdict(known, identity, Stream.concat(first.stream(), Stream.concat(findings.stream(),
                notes.stream()).filter(finding -> !finding.isWrong()).distinct()).toList(), multistep);
    }

    private List<Finding> judge() {
        SolverMemory memory = new SolverMemory(maker, control.makesSubSteps());
        Optional<Finding> wrong = first(contract::clock, contract::entries, contract::alike).or(() -> {
            remembers = memory.remembers();
            return ofFormula();
        });
        return wrong.isPresent() ? List.of(wrong.get()) : Stream.concat(memory.mistake().stream(), contract.conduct()
                .stream()).toList();
    }

    /** @return the first of these that finds something; one whose steps the solver refuses finds nothing */
    private static Optional<Finding> first(Search... searches) {
        return Arrays.stream(searches).map(search -> {
            try {
                return search.find();
            } catch (RuntimeException e) {
                return Optional.<Finding>empty();       // it wants another source, or shorter steps
            }
        }).flatMap(Optional::stream).findFirst();
    }

    private Optional<Method> method() {
        return declared.map(Declaration::method);
    }

    private Optional<Finding> ofFormula() {
        Agreement agreement = new Agreement(maker);
        Optional<Scheme> own = Reading.of(maker).filter(scheme -> !remembers);
        match = agreement.known(own).filter(one -> !remembers);
        Fit fit = Fit.of(maker, remembers, false);
        known = match.map(Match::method).or(fit::known);
        known.filter(method -> match.isEmpty()).ifPresent(method -> {
            double off = Fit.of(maker, remembers, true).residual(method);
            Phrase.OTHER_TIMES.when(off > Fit.SOLVED, method.title(), off).ifPresent(notes::add);
        });
        multistep = remembers && (known.isPresent() || contract.evaluations(SHORT) == contract.evaluations(8));
        Optional<Method> kind = known.or(() -> Optional.of(Method.MULTISTEP).filter(method -> multistep));
        kind.ifPresent(method -> identity = "This is " + method.title() + ".");
        boolean isOther = known.isPresent() || remembers;
        read = own.filter(scheme -> match.isPresent() || !isOther).map(Reading::used);  // not rounds of an iteration
        Optional<Finding> wrong = measured(fit);
        Optional<Cause> cause = agreement.mistake(isOther ? Stream.empty() : suspects(), own);
        return cause.filter(one -> wrong.isPresent() || isMeant(one)).map(SolverCheck::named).or(() -> wrong.map(
                this::compared));
    }

    /** The methods of which it may be a mistake: the declared one, or all. */
    private Stream<Method> suspects() {
        Optional<Method> meant = method().filter(method -> !method.isFamily());
        return meant.isPresent() ? meant.stream() : Arrays.stream(Method.values());
    }

    /** Whether a step without a fault of its own is a mistake of the declared method, or of one of higher order. */
    private boolean isMeant(Cause cause) {
        return declared.map(one -> one.alone() && one.method() == cause.method()).orElse(orders.order()
                < cause.method().order() - 0.5);
    }

    /** What is wrong, as measured; empty for a right one. */
    private Optional<Finding> measured(Fit fit) {
        Optional<Declaration> alone = declared.filter(Declaration::alone);
        Optional<Method> implicit = alone.map(Declaration::method).filter(method -> method.isImplicit()
                && known.isEmpty() && !remembers);
        return first(
                () -> known.flatMap(method -> declared.filter(one -> !one.allows(method)).map(one ->
                        Phrase.CONTRADICTS.of(method.title(), one.method().title()))),
                () -> match.filter(one -> one.distance() > Agreement.PRINTED).map(one -> Phrase.SEVEN_DIGITS.of(
                        one.method().title(), one.distance())),
                () -> FreeFall.mistake(maker, remembers ? STEPS : 1),
                () -> Units.mistake(maker),
                () -> implicit.flatMap(method -> solved(method, fit)),
                this::ordered,
                this::inTime,
                this::controlled,
                () -> alone.filter(one -> !remembers && one.method().usesEarlier()).map(one ->
                        Phrase.NOTHING_EARLIER.of(one.method().title())),
                () -> method().filter(method -> declared.get().asked() && known.isEmpty() && (multistep || !method
                        .schemes().isEmpty()) && method != Method.MULTISTEP).map(method -> Phrase.NOT_THE_METHOD.of(
                        method.title())));
    }

    /** An evaluation at another time than that of its state is a mistake if it lowers the order, or leaves it at 1. */
    private Optional<Finding> inTime() {
        Optional<Finding> other = read.flatMap(own -> own.astray().map(where -> (
                orders.lowersWithClock() || declared.isEmpty() && orders.order() < LOW && Arrays.stream(own.times())
                .distinct().count() > 1 ? Phrase.OTHER_TIME : Phrase.EARLY_OR_LATE).of(where, orders.digits())));
        other.filter(finding -> !finding.isWrong()).ifPresent(notes::add);
        return other.filter(Finding::isWrong);
    }

    /** An implicit method solves its equation. */
    private Optional<Finding> solved(Method method, Fit fit) {
        return read.map(scheme -> Phrase.EXPLICIT.of(contract.evaluations(SHORT), method.title())).or(() ->
                method.equation().map(equation -> Phrase.EQUATION.of(method.title(), fit.residual(method), Fit.H)));
    }

    /** Sub-steps control the error, and a method with step-size control makes some. */
    private Optional<Finding> controlled() {
        return control.makesSubSteps() ? control.uncontrolled() : method().filter(method -> method == Method.ADAPTIVE)
                .flatMap(method -> control.none());
    }

    /** Measures the orders, and says what an unknown method is. */
    private Optional<Finding> ordered() {
        orders = Orders.of(maker);
        if (known.isEmpty() && !multistep) {
            identity = "This is a method" + orders.whole().map(whole -> " of order " + whole).orElse("") + (remembers
                    ? " that keeps something of earlier steps" : read.map(scheme -> " (evaluations in a step: "
                    + contract.evaluations(SHORT) + ")").orElse(control.makesSubSteps() ? " that makes sub-steps" : ""))
                    + "; it is none that the check knows by name.";
        }
        boolean alike = read.filter(scheme -> !scheme.particles()).isPresent();
        if (known.map(method -> method.schemes().stream().anyMatch(Scheme::particles)).orElse(!alike)) {
            orders.note().ifPresent(notes::add);
        }
        return orders.mistake(method().or(() -> known), alike);
    }

    private static Finding named(Cause cause) {
        String title = cause.method().title();
        Scheme right = cause.scheme();
        if (!(cause.changed() instanceof Scheme changed)) {
            return Phrase.STEP.of(title, cause.mistake());
        }
        int r = changed.unlike(right);
        return Phrase.DIFFERS.of(changed.what(r), changed.formula(r), title, right.formula(r), cause.mistake());
    }

    /** Says where the step leaves the method's, or the time, in numbers. */
    private Finding compared(Finding finding) {
        if (read.isEmpty() || finding.kind() != Kind.METHOD) {
            return finding;
        }
        Scheme own = read.get();
        Optional<Method> meant = match.map(Match::method).or(this::method);
        return match.map(Match::scheme).or(() -> meant.flatMap(method -> method.schemes().stream().findFirst())).filter(
                scheme -> scheme.particles() == own.particles()).map(known -> {
                    int r = own.size() == known.size() ? own.unlike(known) : own.size();
                    return r < 0 ? finding : Phrase.ROW.of(finding.text(), own.what(r), own.formula(r), meant
                            .orElseThrow().title(), known.formula(r == own.size() ? known.size() : r));
                }).or(() -> own.astray().map(where -> Phrase.ASTRAY.of(finding.text(), where))).orElse(finding);
    }
}
