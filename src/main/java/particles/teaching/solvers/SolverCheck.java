package particles.teaching.solvers;

import deSolvers.DESolver;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.function.Supplier;
import java.util.stream.Stream;
import particles.teaching.Finding;
import particles.teaching.Finding.Kind;
import particles.teaching.Formula;
import particles.teaching.StudentFailure;
import particles.teaching.compared.Agreement;
import particles.teaching.compared.Agreement.Match;
import particles.teaching.compared.Fit;
import particles.teaching.compared.Mistake;
import particles.teaching.compared.Reading;
import particles.teaching.declared.Declaration;
import particles.teaching.declared.Equation;
import particles.teaching.declared.Method;
import particles.teaching.declared.Scheme;
import particles.teaching.measured.Control;
import particles.teaching.measured.FreeFall;
import particles.teaching.measured.Orders;
import particles.teaching.measured.Phrase;
import particles.teaching.measured.SolverContract;
import particles.teaching.measured.SolverMemory;

/** Checks a student's solver: says which method it is, and names one mistake, the first that explains the rest. */
public final class SolverCheck {
    private static final int STEPS = 6;
    private static final double SHORT = 1.0 / 16;
    private static final String UNKNOWN = "Its step cannot be judged yet.";

    private final Supplier<DESolver> maker;
    private final Optional<Declaration> declared;
    private final SolverContract contract;
    private final Control control;
    private final List<Finding> notes = new ArrayList<>();
    private String identity = UNKNOWN;
    private Optional<Method> known = Optional.empty();
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
        Optional<Finding> formula = first(contract::clock, contract::entries, contract::alike).or(() ->
                memory.remembers() ? ofEarlierSteps() : ofOneStep());
        List<Finding> findings = new ArrayList<>(formula.stream().toList());
        if (formula.isEmpty()) {
            findings.addAll(memory.mistake().stream().toList());
            findings.addAll(contract.conduct());
        }
        return findings;
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

    private Optional<Finding> ofOneStep() {
        Agreement agreement = new Agreement(maker);
        Optional<Match> match = agreement.known();
        Fit fit = Fit.of(maker, false);
        known = match.map(Match::method).or(fit::known);
        Optional<Scheme> read = known.isPresent() ? Optional.empty() : Reading.of(maker);
        known.ifPresent(method -> identity = "This is " + method.title() + ".");
        Optional<Finding> wrong = measured(match, fit, read);
        return wrong.isPresent() ? agreement.mistake(suspects()).map(SolverCheck::named).or(() -> wrong.map(finding ->
                compared(finding, read))) : known.isPresent() ? Optional.empty() : agreement.mistake(suspects())
                .filter(this::isMeant).map(SolverCheck::named).or(() -> asked(agreement, read));
    }

    /** The methods of which it may be a mistake: the declared one, or those with as many evaluations, then others. */
    private Stream<Method> suspects() {
        long evaluations = contract.evaluations(SHORT);
        Optional<Method> meant = method().filter(method -> !method.isFamily());
        return known.isPresent() ? Stream.empty() : meant.isPresent() ? meant.stream() : Arrays.stream(Method.values())
                .sorted(Comparator.comparing(method -> method.schemes().stream().noneMatch(scheme -> scheme.size()
                == evaluations)));
    }

    /** Whether a right step is a mistake of the method that is declared, or of one that is not done in turns. */
    private boolean isMeant(Agreement.Cause cause) {
        return declared.map(one -> one.alone() && one.method() == cause.method()).orElse(orders.order()
                < cause.method().order() - 0.5 || cause.mistake().isInTurn());
    }

    /** What is wrong, as measured; empty for a right one. */
    private Optional<Finding> measured(Optional<Match> match, Fit fit, Optional<Scheme> read) {
        Optional<Finding> other = known.filter(method -> declared.filter(one -> !one.allows(method)).isPresent()).map(
                method -> Phrase.CONTRADICTS.of(method.title(), method().orElseThrow().title()));
        if (other.isPresent()) {
            return other;
        }
        Optional<Method> implicit = known.isPresent() ? Optional.empty() : declared.filter(Declaration::alone).map(
                Declaration::method).filter(Method::isImplicit);
        return first(() -> match.filter(Match::isFloat).map(one -> Phrase.SEVEN_DIGITS.of(one.method().title(),
                one.distance())), () -> FreeFall.mistake(maker, 1), contract::units, () -> implicit.flatMap(method ->
                solved(method, fit, read)), () -> ordered(read), this::controlled, () -> implicit.flatMap(method ->
                control.unstable()), this::earlier);
    }

    /** An implicit method solves its equation. */
    private static Optional<Finding> solved(Method method, Fit fit, Optional<Scheme> read) {
        return read.map(scheme -> Phrase.EXPLICIT.of(scheme.size(), method.title())).or(() -> method.equation().map(
                equation -> Phrase.EQUATION.of(method.title(), fit.residual(method), Fit.H)));
    }

    /** Sub-steps control the error, and a method with step-size control makes some. */
    private Optional<Finding> controlled() {
        return control.makesSubSteps() ? control.uncontrolled() : Phrase.NO_CONTROL.when(method().equals(Optional.of(
                Method.ADAPTIVE)));
    }

    /** A multistep method uses earlier steps. */
    private Optional<Finding> earlier() {
        return declared.filter(Declaration::alone).map(Declaration::method).flatMap(method ->
                Phrase.NOTHING_EARLIER.when(method == Method.MULTISTEP || method.equation().filter(
                Equation::usesEarlier).isPresent(), method.title()));
    }

    /** Measures the orders, and says what an unknown method is. */
    private Optional<Finding> ordered(Optional<Scheme> read) {
        orders = Orders.of(maker);
        identity = known.isPresent() ? identity : "This is a method" + orders.whole().map(whole -> " of order " + whole)
                .orElse("") + read.map(scheme -> " (evaluations in a step: " + scheme.size() + ")").orElse(
                control.makesSubSteps() ? " that makes sub-steps" : "") + "; it is none that the check knows by name.";
        boolean turns = known.filter(method -> method.schemes().stream().anyMatch(Scheme::particles)).isPresent();
        if (turns || known.isEmpty() && read.isEmpty()) {
            orders.note().ifPresent(notes::add);
        }
        return orders.mistake(declared, read.isPresent());
    }

    /** A step that is right, where another method was asked for. */
    private Optional<Finding> asked(Agreement agreement, Optional<Scheme> read) {
        return declared.filter(one -> one.asked() && !one.method().schemes().isEmpty()).map(one -> compared(
                Phrase.NOT_THE_METHOD.of(one.method().title(), agreement.distance(one.method().schemes().get(0)),
                Agreement.H), read));
    }

    private static Finding named(Agreement.Cause cause) {
        String title = cause.method().title();
        Scheme right = cause.scheme();
        if (!(cause.changed() instanceof Scheme changed)) {
            return Phrase.STEP.of(title, cause.mistake());
        }
        int r = changed.unlike(right);
        return cause.mistake() == Mistake.BY_DELTA_T ? Phrase.STEP.of(title, right.what(r) + " " + right.formula(r)
                + ", and here " + cause.mistake()) : r < 0 ? times(changed, right, title, cause.mistake().toString())
                : Phrase.DIFFERS.of(changed.what(r), changed.formula(r), title, right.formula(r), cause.mistake());
    }

    private static Finding times(Scheme made, Scheme right, String title, String mistake) {
        int j = 0;
        while (Formula.same(made.times()[j], right.times()[j])) {
            j++;
        }
        return Phrase.STAGE_TIMES.of(j + 1, Formula.time(made.times()[j]), title, Formula.time(right.times()[j]),
                mistake);
    }

    /** Says where the step leaves the declared method's, in numbers. */
    private Finding compared(Finding finding, Optional<Scheme> read) {
        Optional<Scheme> right = method().flatMap(method -> method.schemes().stream().findFirst());
        if (right.isEmpty() || finding.kind() != Kind.METHOD || finding.cause() == Phrase.FALL) {
            return finding;
        }
        String title = method().orElseThrow().title();
        Scheme known = right.get();
        return read.filter(scheme -> !known.particles()).map(scheme -> {
            int r = scheme.unlike(known);
            return scheme.size() != known.size() ? Phrase.COUNT.of(finding.text(), scheme.size(), title, known.size())
                    : r < 0 ? finding : Phrase.ROW.of(finding.text(), scheme.what(r), scheme.formula(r), title,
                    known.formula(r));
        }).or(() -> FreeFall.inUnits(maker).flatMap(own -> FreeFall.inUnits(known::solver).filter(own::isUnlike).map(
                other -> Phrase.OTHER_STEP.of(finding.text(), own.fell(), own.speed(), title, other.fell(),
                other.speed())))).orElse(finding);
    }

    private Optional<Finding> ofEarlierSteps() {
        known = Fit.of(maker, true).known();
        multistep = known.isPresent() || contract.evaluations(SHORT) == contract.evaluations(8);
        identity = known.or(() -> Optional.of(Method.MULTISTEP).filter(method -> multistep)).map(method -> "This is "
                + method.title() + ".").orElse("This is a method that keeps something of earlier steps.");
        return first(() -> FreeFall.mistake(maker, STEPS), contract::units, () -> Orders.of(maker).mistake(declared,
                false), this::controlled).map(finding -> compared(finding, Optional.empty())).or(() -> declared
                .filter(one -> !one.allows(known, multistep)).map(one -> Phrase.CONTRADICTS.of(known.orElse(
                Method.MULTISTEP).title(), one.method().title())));
    }
}
