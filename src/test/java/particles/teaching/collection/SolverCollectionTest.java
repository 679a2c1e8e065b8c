package particles.teaching.collection;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.regex.Pattern;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import particles.teaching.Finding;
import particles.teaching.GuardedRun;
import particles.teaching.GuardedRun.Outcome;
import particles.teaching.solvers.PlantedSolvers;
import particles.teaching.solvers.SolverCheck;
import particles.teaching.solvers.SolverVerdict;

/** Right and wrong solvers in many styles: no false alarm, no wrong one accepted, and the cause named. */
class SolverCollectionTest {
    private static final double SECONDS = 10;

    /** @return what the check says is wrong; empty for a solver that passes */
    private static List<String> wrong(Specimen specimen) {
        Outcome<SolverVerdict> outcome = new GuardedRun(SECONDS).run(() -> SolverCheck.check(specimen.maker(),
                specimen.name()));
        return outcome.failure().map(failure -> List.of(failure.toString())).orElseGet(() -> outcome.value()
                .orElseThrow().wrong().stream().map(Finding::toString).toList());
    }

    private static void assertAccepted(List<Specimen> right) {
        List<String> accused = right.stream().filter(specimen -> !wrong(specimen).isEmpty()).map(specimen -> specimen
                + " " + wrong(specimen)).toList();
        assertTrue(accused.isEmpty(), accused.size() + " of " + right.size() + " accused:\n" + String.join("\n",
                accused));
    }

    /** Measured: none accepted, all causes named; all collections were at hand while the check was mended. */
    private static void assertNamed(List<Specimen> wrong) {
        List<String> misnamed = wrong.stream().filter(specimen -> !isNamed(specimen, wrong(specimen))).map(specimen ->
                specimen + " " + wrong(specimen)).toList();
        assertTrue(misnamed.isEmpty(), wrong.size() + " wrong; accepted, or other or several causes:\n" + String.join(
                "\n", misnamed));
    }

    @Test
    void handwrittenSolversGetTheirVerdict() {
        assertAccepted(HandwrittenSolvers.allRight());
        assertNamed(HandwrittenSolvers.allWrong());
    }

    @Test
    void mistakesAreNamedInTheseWords() {
        assertNamed(SolverSpecimens.sentences());
    }

    /** A number word tells the order where it follows the family, and something else before a word such as Stage. */
    @Test
    void namesPromiseNoMoreThanTheySay() {
        assertAccepted(SolverTable.read("""
                FiveStageRungeKuttaSolver | Merson, order 4 | | rk 1/3; 1/6 1/6; 1/8 0 3/8; 1/2 0 -3/2 2 \
                -> 1/6 0 0 2/3 1/6
                FiveRungeKutta4 | RK4 | | rk RK4 SIXTHS
                FourStageAdams | order 2 | | adams 2 1
                RungeKuttaHeun | the family first | | rk HEUN
                TwoPhaseImplicitBdf | one step | | irk ; 0.2928932188134524 0.2928932188134524; \
                0.3535533905932738 0.3535533905932738 0.2928932188134524 \
                -> 0.3535533905932738 0.3535533905932738 0.2928932188134524 : newton 1e-11 60
                GaussSolver | one stage | | IMPLICIT_MIDPOINT NEWTON
                EulerMejoradoSolver | Heun | | rk HEUN
                AnnasEulerSolver | midpoint | | rk 1/2 -> 0 1
                PseudoRungeKuttaSolver | order 3 | | rk 1/2; -1 2 -> 1/6 2/3 1/6
                KuttaDreiAchtel | its name | | rk THREE_EIGHTHS EIGHTHS
                BulirschStoer4Team7 | RK4 | | rk RK4 SIXTHS
                GraggSolver | the modified midpoint method | | rk 1/2 -> 0 1
                SecondOrderSymplectic | for equations of second order | | turns 0 1 -> 1
                SdirkTwo | one stage | | IMPLICIT_MIDPOINT NEWTON
                NewmarkSolver | average acceleration | | TRAPEZOID NEWTON
                NewmarkSolver | central differences | | LEAPFROG
                ImpliziterEulerSolver | its name | | BACKWARD NEWTON
                EulerHaciaAtras | its name | | BACKWARD NEWTON
                Mine | two halves of backward Euler | | irk 1/2; 1/2 1/2 -> 1/2 1/2 NEWTON
                DirkTwo | the trapezoidal rule | | TRAPEZOID NEWTON
                RueckwaertsEuler | its name | | BACKWARD NEWTON
                SymplektischerEuler | its name | | turns 0 1 -> 1
                ThirdRungeKuttaSolver | its name | | rk 1/2; -1 2 -> 1/6 2/3 1/6
                RombergEuler | one extrapolation | | rk 1/2 -> 0 1
                ImplicitRungeKutta | one stage | | BACKWARD NEWTON
                ImplicitRungeKutta2 | two stages | | TRAPEZOID NEWTON
                AdamsMoultonSolver | one step | | TRAPEZOID NEWTON
                """));
        assertNamed(SolverTable.read("""
                FourthOrderGaussSolver | one stage | not a Gauss method of order 4, | IMPLICIT_MIDPOINT NEWTON
                ThirdOrderSdirk2 | one stage | not a diagonally implicit method of order 3, | IMPLICIT_MIDPOINT NEWTON
                FifthRungeKutta | RK4 | not a Runge-Kutta method of order 5, | rk RK4 SIXTHS
                FourthOrderRungeKutta | Heun | not a Runge-Kutta method of order 4, | rk HEUN
                ImplicitMidpoint | order 2 and an unused evaluation | an explicit method with 4 evaluations .* solved \
                | rk 1/3; 1/2; 0 1/2 -> 1/4 0 0 3/4
                SdirkTwoSolver | gamma, order 1 | k1 is evaluated at s [+] 0.7071 k1; Alexander's .* 0.2929 k1 \
                | irk 0.7071067811865476; 0.2928932188134524 0.7071067811865476 \
                -> 0.2928932188134524 0.7071067811865476 NEWTON
                DormandPrinceFiveSolver | order 4 | not a Runge-Kutta method of order 5 | rk DOPRI DOPRI4
                EulerSolver | Heun | not the Euler method, as its name says | rk HEUN
                MyEulerSolverX | Heun | not the Euler method, as its name says | rk HEUN
                SymplecticEulerSolverX | Euler | updated with the old velocity | rk -> 1
                RungeKuttaSolver | Heun | not a Runge-Kutta method of order 4 | rk HEUN
                RungeKuttaSechs | RK4 | not a Runge-Kutta method of order 6 | rk RK4 SIXTHS
                ThirdOrderSolver | Heun | not a method of order 3 | rk HEUN
                GaussSolver | RK4 | explicit, and not a Gauss method | rk RK4 SIXTHS
                NewmarkSolver | symplectic Euler | not Newmark's method | turns 0 1 -> 1
                BulirschStoer6 | RK4 | not an extrapolation method of order 6, as | rk RK4 SIXTHS
                GraggBulirschStoer | midpoint | not an extrapolation method, as | rk 1/2 -> 0 1
                RungeKuttaFour | Heun | not a Runge-Kutta method of order 4 | rk HEUN
                TwoStageGauss | the trapezoidal rule | not a Gauss method | TRAPEZOID NEWTON
                ExponentialRosenbrockEuler | backward Euler | not an exponential method of order 2 | BACKWARD NEWTON
                """));
    }

    /** The loop of the slide "Euler Solver Code (cont'd)". */
    @Test
    void theSlidesOwnEulerIsRightAndAdvisedOfNaN() {
        SolverVerdict verdict = SolverCheck.check(() -> PlantedSolvers.solver(HandwrittenSolvers::euler), "SlideEuler");
        assertEquals(List.of(), verdict.wrong());
        assertEquals("This is the Euler method.", verdict.identity());
        assertTrue(verdict.findings().stream().anyMatch(advice -> advice.text().contains("the NaN goes unnoticed")),
                verdict.findings().toString());
    }

    @Test
    void notesNameALossOfOrderAndShortCoefficients() {
        SolverTable.read("""
                Leapfrog | style: its order is 2.00, and 1.09 where the acceleration depends | | LEAPFROG
                GillSolver | style: the coefficients are those of Gill's method to eight digits | | rk 1/2; \
                0.20710678 0.29289322; 0 -0.70710678 1.70710678 -> 1/6 0.09763107 0.56903559 1/6
                """).forEach(one -> assertTrue(SolverCheck.check(one.maker(), one.name()).findings().stream().anyMatch(
                note -> note.toString().startsWith(one.about())), one.name()));
    }

    @Test
    void aLoopAtNaNIsToldAfterFewEvaluations() {
        long[] evaluations = {0};
        assertNamed(List.of(Specimen.wrong("EulerSolver", "waits for a number", "derivative NaN .* endless loop",
                (source, h) -> {
                    do {
                        evaluations[0]++;
                    } while (Double.isNaN(PlantedSolvers.slope(source)[0]));
                    HandwrittenSolvers.euler(source, h);
                })));
        assertTrue(evaluations[0] < 100_000, evaluations[0] + " evaluations");
    }

    @Test
    void methodsWithoutANameArePlaced() {
        List<SolverVerdict> found = SolverTable.read("""
                Mine | Adams | | adams 2 1
                Mine | Euler | | rk 1/4; 1/4 1/4; 1/4 1/4 1/4 -> 1/4 1/4 1/4 1/4
                """).stream().map(one -> SolverCheck.check(one.maker(), "Mine")).toList();
        assertTrue(found.get(0).multistep());
        assertFalse(found.get(1).multistep());
        assertEquals("This is the Euler method in 4 sub-steps.", found.get(1).identity());
    }

    @Test
    @Tag("hard")
    void noRightSolverIsAccused() {
        assertAccepted(SolverSpecimens.allRight());
    }

    @Test
    @Tag("hard")
    void wrongSolversAreCaughtAndTheCauseIsNamed() {
        assertNamed(SolverSpecimens.allWrong());
    }

    private static boolean isNamed(Specimen specimen, List<String> found) {
        return found.size() == 1 && Pattern.compile(specimen.cause()).matcher(found.get(0)).find();
    }
}
