package particles.teaching.solvers;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import deSolvers.DESolver;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.EnumSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.function.Supplier;
import java.util.stream.Stream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.MethodSource;
import particles.teaching.Finding;
import particles.teaching.compared.Mistake;
import particles.teaching.declared.Declaration;
import particles.teaching.declared.Method;
import particles.teaching.declared.Scheme;
import particles.teaching.declared.Step;
import particles.teaching.measured.Phrase;
import particles.teaching.solvers.Kinds.Kind;

/** The check of solvers: no right one is accused, and each kind of wrong ones gets its verdict. */
class SolverCheckTest {
    /** Where the sentence of a mistake stands. */
    private static final Set<Phrase> NAMED = EnumSet.of(Phrase.DIFFERS, Phrase.STEP);

    static List<Kind> rightKinds() {
        return Kinds.right();
    }

    static List<Kind> wrongKinds() {
        return Kinds.wrong();
    }

    @ParameterizedTest
    @MethodSource("rightKinds")
    void aRightSolverIsNotAccused(Kind kind) {
        assertEquals(List.of(), SolverCheck.check(kind.maker(), kind.name()).wrong());
    }

    @ParameterizedTest
    @MethodSource("wrongKinds")
    void aWrongSolverGetsItsVerdict(Kind kind) {
        List<Finding> wrong = SolverCheck.check(kind.maker(), kind.name()).wrong();
        assertEquals(kind.verdict(), wrong.stream().map(Finding::cause).toList(),
                wrong.toString());
    }

    /** The first step that a mistake makes of a method; h stands in the weights of some. */
    private static Optional<Supplier<DESolver>> solver(Method method, Mistake mistake) {
        Scheme scheme = method.schemes().get(0);
        return mistake.steps(scheme).findFirst().map(step -> step::solver);
    }

    /**
     * Each mistake in each of the slides' methods is named, or an equal one before it; a few make another right method,
     * or no step at all.
     */
    private static List<String> unnamed(Method method) {
        List<String> unnamed = new ArrayList<>();
        for (Mistake mistake : Mistake.values()) {
            solver(method, mistake).ifPresent(maker -> {
                List<Finding> wrong = SolverCheck.check(maker, method).wrong();
                if (wrong.stream().noneMatch(finding -> NAMED.contains(finding.cause()))) {
                    unnamed.add(mistake.name() + " " + wrong);
                }
            });
        }
        return unnamed;
    }

    @Test
    void everyTypicalMistakeInRK4IsNamed() {
        assertEquals(List.of(), unnamed(Method.RK4));
    }

    @Tag("hard")
    @ParameterizedTest
    @MethodSource("explicitMethods")
    void everyTypicalMistakeIsFound(Method method) {
        assertTrue(unnamed(method).size() <= 4, unnamed(method).toString());
    }

    static Stream<Method> explicitMethods() {
        return Stream.of(Method.EULER, Method.MIDPOINT, Method.HEUN, Method.VERLET);
    }

    @Test
    void knownMethodsAreRecognisedByTheirSteps() {
        for (Method method : Method.values()) {
            for (Scheme scheme : method.schemes()) {
                SolverVerdict verdict = SolverCheck.check(scheme::solver, "Mine");
                assertEquals(Optional.of(method), verdict.method());
                assertEquals(List.of(), verdict.wrong(), method.title());
            }
        }
    }

    private static List<SolverVerdict> verdicts(Method method, Supplier<DESolver> maker) {
        return List.of(SolverCheck.check(maker, method), SolverCheck.check(maker, "Mine"));
    }

    /** The scheme with all evaluations at a clock so many deltaT after t. */
    private static Scheme atClock(Scheme scheme, double clock) {
        double[] times = new double[scheme.size()];
        Arrays.fill(times, clock);
        return new Scheme(scheme.rows(), times, scheme.particles());
    }

    /** The slides' own loop of particles moves the clock first. */
    @ParameterizedTest
    @CsvSource({"EULER,0.5", "EULER,1", "SYMPLECTIC_EULER,0", "SYMPLECTIC_EULER,0.5", "SYMPLECTIC_EULER,1"})
    void aClockElsewhereIsANoteIfTheOrderIsTheSame(Method method, double clock) {
        for (Scheme scheme : method.schemes()) {
            Scheme moved = atClock(scheme, clock);
            for (SolverVerdict verdict : verdicts(method, moved::solver)) {
                assertEquals(List.of(), verdict.wrong());
                assertEquals(Optional.of(method), verdict.method());
                assertEquals(moved.unlike(scheme) >= 0, verdict.findings().stream().anyMatch(finding ->
                        finding.cause() == Phrase.EARLY_OR_LATE));
            }
        }
    }

    @ParameterizedTest
    @CsvSource({"1,0,BACKWARD_EULER", "1,0.5,BACKWARD_EULER", "1,1,BACKWARD_EULER", "0.5,0.5,IMPLICIT_MIDPOINT"})
    void soItIsInAnImplicitMethod(double place, double clock, Method method) {
        for (SolverVerdict verdict : verdicts(method, Kinds.implicit(place, clock)::solver)) {
            assertEquals(List.of(), verdict.wrong());
            assertEquals(Optional.of(method), verdict.method());
            assertEquals(clock != place, verdict.findings().stream().anyMatch(finding -> finding.cause()
                    == Phrase.OTHER_TIMES));
        }
    }

    /** All known methods of order 2 or more measure 0.95 to 1.05 with their clock at t or t + deltaT all the time. */
    @ParameterizedTest
    @CsvSource({"0", "1"})
    void aClockThatLowersTheOrderIsAMistake(double clock) {
        for (Method method : Method.values()) {
            for (Scheme scheme : method.order() < 2 ? List.<Scheme>of() : method.schemes()) {
                for (SolverVerdict verdict : verdicts(method, atClock(scheme, clock)::solver)) {
                    assertEquals(List.of(Phrase.ROW), verdict.wrong().stream().map(Finding::cause).toList());
                    assertTrue(verdict.wrong().get(0).text().contains("where a force changes with the clock"));
                    assertEquals(Optional.of(method), verdict.method());
                }
            }
        }
        for (SolverVerdict verdict : verdicts(Method.IMPLICIT_MIDPOINT, Kinds.implicit(0.5, clock)::solver)) {
            assertEquals(List.of(Phrase.LOW_ORDER), verdict.wrong().stream().map(Finding::cause).toList());
        }
    }

    @ParameterizedTest
    @CsvSource({"MyRK4Solver,RK4", "HeunSolver,HEUN", "BackwardEuler,BACKWARD_EULER",
        "SemiImplicitEuler,SYMPLECTIC_EULER", "EulerSolver,EULER", "AB2Stepper,AB2", "LeapfrogIntegrator,VERLET",
                "RungeKutta4,RK4", "RKF45,RK45"})
    void aClassNameDeclaresAMethod(String name, Method method) {
        assertEquals(Optional.of(method), Declaration.of(name).map(Declaration::method));
    }

    @ParameterizedTest
    @CsvSource({"MySolver", "RungeKuttaSolver", "Homework4", "Heunisch", "SolverForVerlaine"})
    void nothingElseIsReadFromNames(String name) {
        assertEquals(Optional.empty(), Declaration.of(name).map(Declaration::method));
    }

    /** Richardson's extrapolation of Euler's method is the midpoint method. */
    @Test
    void anotherWordInTheNameMayMakeAnotherMethodOfIt() {
        Supplier<DESolver> midpoint = Method.MIDPOINT.schemes().get(0)::solver;
        assertEquals(List.of(), SolverCheck.check(midpoint, "RichardsonEuler").wrong());
        assertEquals(Phrase.CONTRADICTS, SolverCheck.check(midpoint, "EulerSolver").wrong().get(0).cause());
    }

    @Test
    void aMethodThatIsAskedForIsNoOther() {
        Supplier<DESolver> other = Method.RK38.schemes().get(0)::solver;
        assertEquals(List.of(), SolverCheck.check(other, "RK4Solver").wrong());
        assertEquals("this is Kutta's 3/8 rule and not RK4, the classical Runge-Kutta method", SolverCheck.check(other,
                Method.RK4).wrong().get(0).text());
    }

    /** A mistake says where the step leaves the method's, in multiples of deltaT. */
    @Test
    void aMistakeIsToldInTheWordsOfTheFormula() {
        Scheme rk4 = Method.RK4.schemes().get(0);
        Scheme changed = rk4.with(4, new double[] {1, 1.0 / 6, 1.0 / 3, 1.0 / 6, 1.0 / 6});
        assertTrue(SolverCheck.check(changed::solver, "RK4Solver").wrong().get(0).text().endsWith("the new state, where"
                + " each k includes deltaT, is s + k1/6 + k2/3 + k3/6 + k4/6, and RK4, the classical Runge-Kutta method"
                + " says s + k1/6 + k2/3 + k3/3 + k4/6"));
        Scheme unlike = rk4.with(3, new double[] {1, 0, 0.25, 0.75, 0});
        assertEquals("the measured order is 2.96, and that of RK4, the classical Runge-Kutta method is 4; k4 = deltaT f"
                + " is taken at (s + k2/4 + 3/4 k3, t + deltaT), and RK4, the classical Runge-Kutta method says (s +"
                + " k3, t + deltaT)", SolverCheck.check(unlike::solver, "RK4Solver").wrong().get(0).text());
    }

    @Test
    void notesTellWhatIsRightAndCouldBeBetter() {
        assertNotes(Kinds.right().get(0), Phrase.DRAG, Phrase.ONLY_PARTICLES);
        assertNotes(Kinds.right().get(1), Phrase.NOTHING_BACK);
    }

    private static void assertNotes(Kind kind, Phrase... notes) {
        List<Object> found = SolverCheck.check(kind.maker(), kind.name()).findings().stream().map(Finding::cause)
                .toList();
        assertTrue(found.containsAll(Arrays.asList(notes)), found.toString());
    }
}
