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
import particles.teaching.compared.Reading;
import particles.teaching.declared.Declaration;
import particles.teaching.declared.Equation;
import particles.teaching.declared.Method;
import particles.teaching.declared.Scheme;
import particles.teaching.measured.ClockCheck;
import particles.teaching.measured.Control;
import particles.teaching.measured.FreeFall;
import particles.teaching.measured.Orders;
import particles.teaching.measured.Phrase;
import particles.teaching.measured.SolverContract;
import particles.teaching.measured.SolverMemory;
import particles.teaching.sources.StudentSource;
import particles.teaching.sources.WindyOscillators;

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
        boolean remembers = memory.remembers();
        Optional<Finding> clock = first(() -> ClockCheck.mistake(maker));
        Optional<Finding> formula = clock.or(() -> remembers ? ofEarlierSteps() : ofOneStep());
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

    private Optional<Finding> ofOneStep() {
        Agreement agreement = new Agreement(maker);
        Optional<Match> match = agreement.known();
        Fit fit = new Fit(maker, false);
        Optional<Fit.Found> equation = match.isPresent() ? Optional.empty() : fit.known();
        known = match.map(Match::method).or(() -> equation.map(Fit.Found::method));
        match.filter(one -> one.isPrinted() && !one.isFloat()).ifPresent(one -> notes.add(Phrase.PRINTED.of()));
        Optional<Scheme> read = known.isPresent() ? Optional.empty() : Reading.of(maker).map(Reading::used);
        known.ifPresent(method -> identity = "This is " + method.title() + ".");
        Optional<Finding> wrong = measured(match, fit, equation, read);
        return wrong.isPresent() ? agreement.mistake(suspects()).map(SolverCheck::named).or(() -> wrong.map(finding ->
                compared(finding, read))) : known.isPresent() ? Optional.empty() : agreement.mistake(suspects())
                .filter(this::isMeant).map(SolverCheck::named).or(() -> asked(agreement, read));
    }

    /** The methods of which it may be a mistake: the declared one, or those with as many evaluations, then others. */
    private Stream<Method> suspects() {
        long evaluations = contract.evaluations(1, SHORT);
        Optional<Method> meant = declared.map(Declaration::method).filter(method -> !method.isFamily());
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
    private Optional<Finding> measured(Optional<Match> match, Fit fit, Optional<Fit.Found> equation,
            Optional<Scheme> read) {
        Optional<Finding> other = known.filter(method -> declared.filter(one -> !one.allows(method)).isPresent()).map(
                method -> Phrase.CONTRADICTS.of(method.title(), declared.get().method().title()));
        if (other.isPresent()) {
            return other;
        }
        boolean turns = known.filter(method -> method.schemes().stream().anyMatch(Scheme::particles)).isPresent();
        boolean implicit = declared.filter(one -> one.method().isImplicit()).isPresent();
        Optional<Finding> found = first(() -> match.filter(Match::isFloat).map(one -> Phrase.SEVEN_DIGITS.of(
                one.method().title(), one.distance())), () -> implicit && known.isEmpty() && declared.get().alone()
                ? fit.mistake(declared.map(Declaration::method)).map(SolverCheck::solved) : Optional.empty(),
                contract::entries, () -> FreeFall.mistake(maker, 1), contract::units,
                () -> equation.flatMap(one -> fit.loose(one, contract.makesDifferences())).map(SolverCheck::off));
        if (found.isPresent()) {
            return found;
        }
        orders = Orders.of(maker);
        identity = known.isPresent() ? identity : described(read);
        if (turns || known.isEmpty() && read.isEmpty()) {
            orders.note().ifPresent(notes::add);
        }
        return first(() -> implicit && known.isEmpty() && declared.get().alone() ? unsolved(fit, read)
                : Optional.empty(), () -> orders.mistake(declared, read.isPresent()), contract::asymmetric, () ->
                control.makesSubSteps() ? control.uncontrolled() : Phrase.NO_CONTROL.when(declared.filter(one ->
                one.method() == Method.ADAPTIVE).isPresent()), () -> known.isEmpty() && read.isEmpty()
                && (implicit || contract.makesDifferences()) ? control.unstable().filter(one ->
                one.isWrong() || notes.add(one)).filter(Finding::isWrong) : Optional.empty(), this::earlier,
                () -> read.flatMap(scheme -> Phrase.NO_BETTER.when(scheme.size() > 1 && orders.order() < 1.5
                && !control.isStableAs(scheme.size()), orders.clock().digits(), scheme.size())));
    }

    private Optional<Finding> earlier() {
        return declared.filter(Declaration::alone).map(Declaration::method).flatMap(method ->
                Phrase.NOTHING_EARLIER.when(method == Method.MULTISTEP
                        || method.equations().stream().anyMatch(Equation::usesEarlier), method.title()));
    }

    /** The equation of a declared implicit method is not fulfilled. */
    private Optional<Finding> unsolved(Fit fit, Optional<Scheme> read) {
        Method method = declared.get().method();
        if (method.equations().isEmpty()) {
            return Optional.empty();
        }
        Fit.Found best = fit.best(method, method.equations().get(0));
        return read.map(scheme -> Phrase.EXPLICIT.of(scheme.size(), method.title(), best.equation().formula(),
                best.deltaT(), best.residual())).or(() -> Optional.of(off(best)));
    }

    private static Finding off(Fit.Found found) {
        return Phrase.EQUATION_OFF.of(found.method().title(), found.equation().formula(), found.residual(),
                found.deltaT());
    }

    private static Finding solved(Fit.Found found) {
        return Phrase.EQUATION.of(found.equation().formula(), found.method().title(), found.method().equations().get(0)
                .formula());
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
        return cause.changed().map(changed -> {
            int r = changed.unlike(right);
            if (cause.mistake().isOfDeltaT()) {
                return Phrase.BY_DELTA_T.of(title, right.what(r), right.formula(r), cause.mistake());
            }
            if (r >= 0) {
                return Phrase.DIFFERS.of(changed.what(r), changed.formula(r), title, right.formula(r),
                        cause.mistake());
            }
            int j = 0;
            while (changed.times()[j] == right.times()[j]) {
                j++;
            }
            return Phrase.STAGE_TIMES.of(j + 1, Formula.time(changed.times()[j]), title,
                    Formula.time(right.times()[j]), cause.mistake());
        }).orElseGet(() -> Phrase.STEP.of(title, cause.mistake()));
    }

    /** Says where the step leaves the declared method's, in numbers. */
    private Finding compared(Finding finding, Optional<Scheme> read) {
        Optional<Scheme> right = declared.flatMap(one -> one.method().schemes().stream().findFirst());
        if (right.isEmpty() || finding.kind() != Kind.METHOD || finding.cause() == Phrase.FALL) {
            return finding;
        }
        String title = declared.get().method().title();
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

    private String described(Optional<Scheme> read) {
        return "This is a method" + orders.whole().map(whole -> " of order " + whole).orElse("")
                + (read.isPresent() ? " (evaluations in a step: " + read.get().size() + ")"
                : control.makesSubSteps() ? " that makes sub-steps" : "")
                + "; it is none that the check knows by name.";
    }

    private Optional<Finding> ofEarlierSteps() {
        Fit fit = new Fit(maker, true);
        Optional<Fit.Found> equation = fit.known();
        known = equation.map(Fit.Found::method);
        multistep = known.isPresent() || contract.evaluations(1, SHORT) == contract.evaluations(1, 8);
        identity = known.map(method -> "This is " + method.title() + ".").orElse(multistep ? "This is "
                + Method.MULTISTEP.title() + "." : "This is a method that keeps something of earlier steps.");
        Optional<Finding> wrong = first(() -> Phrase.STALE.when(StudentSource.after(new WindyOscillators(1),
                maker.get(), 2, SHORT).getEvaluations() == contract.evaluations(1, SHORT)), () ->
                FreeFall.mistake(maker, STEPS), contract::units, () -> {
            orders = Orders.of(maker);
            return orders.mistake(declared, false);
        }, contract::asymmetric, () -> control.makesSubSteps() ? control.uncontrolled() : Optional.empty(), () ->
                Phrase.LOW_ORDER.when(multistep && !contract.makesDifferences() && orders.order() < 1.5,
                orders.clock().digits(), "", Method.MULTISTEP.title(), 2, " or more"));
        return wrong.map(finding -> finding.kind() == Kind.STATE ? finding : known.isPresent()
                ? known.filter(method -> orders != null).map(method ->
                Phrase.START.of(method.order(), orders.clock().digits())).orElse(finding)
                : fit.mistake(declared.map(Declaration::method)).map(SolverCheck::solved)
                .orElseGet(() -> compared(finding, Optional.empty()))).or(() -> declared
                .filter(one -> !one.allows(known, multistep)).map(one -> Phrase.CONTRADICTS.of(known
                .orElse(Method.MULTISTEP).title(), one.method().title())));
    }
}
