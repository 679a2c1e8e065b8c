package particles.teaching.collection;

import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.regex.Pattern;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import particles.teaching.Finding;
import particles.teaching.GuardedRun;
import particles.teaching.GuardedRun.Outcome;
import particles.teaching.effects.EffectCheck;

/** Right and wrong force laws in many styles: no false alarm, none accepted, and the cause named. */
@Tag("hard")
class EffectCollectionTest {
    private static final double SECONDS = 10;

    /** @return what the check says is wrong; empty for a law that passes */
    private static List<String> wrong(EffectSpecimen specimen) {
        Outcome<List<Finding>> outcome = new GuardedRun(SECONDS).run(() -> EffectCheck.check(specimen.maker()));
        return outcome.failure().map(List::of).orElseGet(() -> outcome.value().orElseThrow()).stream()
                .filter(Finding::isWrong).map(Finding::toString).toList();
    }

    private static String line(EffectSpecimen specimen, List<String> found) {
        return specimen.sentence() + " (" + specimen.about() + "): " + String.join(" | ", found);
    }

    @Test
    void noRightLawIsAccused() {
        List<EffectSpecimen> all = RightEffects.all();
        List<String> accused = new ArrayList<>();
        for (EffectSpecimen specimen : all) {
            List<String> found = wrong(specimen);
            if (!found.isEmpty()) {
                accused.add(line(specimen, found));
            }
        }
        assertTrue(all.size() >= 20, all.size() + " right laws");
        assertTrue(accused.isEmpty(), accused.size() + " of " + all.size() + " accused:\n" + String.join("\n",
                accused));
    }

    @Test
    void wrongLawsAreCaughtAndTheCauseIsNamed() {
        List<EffectSpecimen> all = WrongEffects.all();
        List<String> accepted = new ArrayList<>();
        List<String> misnamed = new ArrayList<>();
        for (EffectSpecimen specimen : all) {
            List<String> found = wrong(specimen);
            if (found.isEmpty()) {
                accepted.add(line(specimen, found));
            } else if (found.size() > 1 || !Pattern.compile(specimen.cause()).matcher(found.get(0)).find()) {
                misnamed.add(line(specimen, found));
            }
        }
        assertTrue(all.size() >= 30, all.size() + " wrong laws");
        String table = all.size() + " wrong, accepted " + accepted.size() + ":\n" + String.join("\n", accepted)
                + "\nother or several causes " + misnamed.size() + ":\n" + String.join("\n", misnamed);
        assertTrue(accepted.isEmpty() && misnamed.isEmpty(), table);
    }
}
