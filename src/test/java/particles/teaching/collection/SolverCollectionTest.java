package particles.teaching.collection;

import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import particles.teaching.Finding;
import particles.teaching.GuardedRun;
import particles.teaching.GuardedRun.Outcome;
import particles.teaching.solvers.SolverCheck;
import particles.teaching.solvers.SolverVerdict;

/** Right and wrong solvers in many styles: no false alarm, no wrong one accepted, and the cause named. */
@Tag("hard")
class SolverCollectionTest {
    private static final double SECONDS = 10;

    /** @return what the check says is wrong; empty for a solver that passes */
    private static List<String> wrong(Specimen specimen) {
        Outcome<SolverVerdict> outcome = new GuardedRun(SECONDS).run(() -> SolverCheck.check(specimen.maker(),
                specimen.name()));
        return outcome.failure().map(failure -> List.of(failure.toString())).orElseGet(() -> outcome.value()
                .orElseThrow().wrong().stream().map(Finding::toString).toList());
    }

    @Test
    void noRightSolverIsAccused() {
        List<Specimen> all = Stream.concat(SolverSpecimens.allRight().stream(), HandwrittenSolvers.allRight().stream())
                .toList();
        List<String> accused = all.stream().filter(specimen -> !wrong(specimen).isEmpty()).map(specimen ->
                specimen + " " + wrong(specimen)).toList();
        assertTrue(all.size() >= 125, all.size() + " right solvers");
        assertTrue(accused.isEmpty(), accused.size() + " of " + all.size() + " accused:\n" + String.join("\n",
                accused));
    }

    /** Measured: none accepted, all causes named; all collections were at hand while the check was mended. */
    @Test
    void wrongSolversAreCaughtAndTheCauseIsNamed() {
        List<Specimen> all = Stream.concat(SolverSpecimens.allWrong().stream(), HandwrittenSolvers.allWrong().stream())
                .toList();
        List<String> accepted = all.stream().filter(specimen -> wrong(specimen).isEmpty()).map(Specimen::toString)
                .toList();
        List<String> misnamed = all.stream().filter(specimen -> !isNamed(specimen, wrong(specimen))).map(specimen ->
                specimen + " " + wrong(specimen)).toList();
        assertTrue(all.size() >= 235, all.size() + " wrong solvers");
        assertTrue(accepted.isEmpty() && misnamed.isEmpty(), all.size() + " wrong, accepted:\n"
                + String.join("\n", accepted) + "\nother or several causes:\n" + String.join("\n", misnamed));
    }

    private static boolean isNamed(Specimen specimen, List<String> found) {
        return found.size() == 1 && Pattern.compile(specimen.cause()).matcher(found.get(0)).find();
    }
}
