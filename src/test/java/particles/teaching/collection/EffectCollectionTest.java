package particles.teaching.collection;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static particles.Texts.assertStarts;

import java.util.List;
import java.util.function.BiPredicate;
import java.util.regex.Pattern;
import org.junit.jupiter.api.Test;
import particles.law.Effect.Trait;
import particles.law.Particles;
import particles.teaching.Finding;
import particles.teaching.GuardedRun;
import particles.teaching.GuardedRun.Outcome;
import particles.teaching.effects.EffectCheck;
import particles.teaching.effects.ForceDirection;

/** Right and wrong force laws in many styles: no false alarm, none accepted, and the cause named. */
class EffectCollectionTest {
    private static final double SECONDS = 10;

    /** @return what the check says is wrong; empty for a law that passes */
    private static List<String> wrong(EffectSpecimen specimen) {
        Outcome<List<Finding>> outcome = new GuardedRun(SECONDS).run(() -> EffectCheck.check(specimen.maker()));
        return outcome.failure().map(List::of).orElseGet(() -> outcome.value().orElseThrow()).stream()
                .filter(Finding::isWrong).map(Finding::toString).toList();
    }

    private static void hold(List<EffectSpecimen> all, BiPredicate<EffectSpecimen, List<String>> expected) {
        List<String> others = all.stream().filter(specimen -> !expected.test(specimen, wrong(specimen))).map(specimen ->
                specimen.about() + ": " + wrong(specimen)).toList();
        assertTrue(others.isEmpty(), others.size() + " of " + all.size() + ":\n" + String.join("\n", others));
    }

    @Test
    void noRightLawIsAccused() {
        hold(RightEffects.all(), (specimen, found) -> found.isEmpty());
    }

    @Test
    void wrongLawsAreCaughtAndTheCauseIsNamed() {
        hold(WrongEffects.all(), (specimen, found) -> found.size() == 1 && Pattern.compile(specimen.cause()).matcher(
                found.get(0)).find());
    }

    /** Symmetries are claims too, and say nothing of the power. */
    @Test
    void aLawThatClaimsOnlyASymmetryGetsANote() {
        assertStarts(EffectCheck.check(p -> Law.law(Trait.TRANSLATION_INVARIANT).force(Law.each(p, (s, f, x, m)
                -> f[x + 3] += s[0] - s[x]))).toString(), "[style: it claims no account of its energy");
    }

    /** Force and energy agree, and both may be upside down: the measured force is shown, and the reader knows. */
    @Test
    void theForceOnOneParticleIsMeasured() {
        String at = " Measured on 'p0' at (0.1394, 0.1184, -0.2502) m: at rest the force is ";
        String moving = ", and with v = (0.1897, -0.2734, -0.1562) m/s it is ";
        assertEquals(at + "(0, 11.68, 0) N" + moving + "(0, 11.68, 0) N.", ForceDirection.of(p ->
                WrongEffects.gravity(p, -1, -1)));
        // -0.4 v, of v = (0.18974, -0.27337, -0.15615)
        assertEquals(at + "(0, 0, 0) N" + moving + "(-0.07590, 0.1093, 0.06246) N.", ForceDirection.of(p ->
                WrongEffects.drag(p, 1)));
    }
}
