package particles.scene;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Map;
import java.util.stream.Stream;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import particles.ParticleSystem;
import particles.effects.EffectCatalog;
import particles.effects.EffectKind;
import particles.law.DifferentiableEffect;
import particles.law.Effect;
import particles.spec.ClassNames;
import particles.teaching.effects.EffectCheck;
import particles.teaching.effects.EffectSample;

/**
 * Every effect that a scene can name has the properties that it claims: force and potential, Newton's third law,
 * symmetries, energy and derivatives. The list is that of the scene reader, so new effects are tested too.
 */
class RegisteredEffectsTest {
    static List<String> known() {
        return Stream.concat(EffectCatalog.ALL.stream().map(EffectKind::getName), Stream.of("springs",
                "damped-springs")).toList();
    }

    /** checkEffect uses the same names as scenes. */
    @ParameterizedTest
    @MethodSource("known")
    void everyEffectHasItsClaimedProperties(String name) {
        ParticleSystem system = EffectSample.system();
        Effect effect = EffectSample.create(name, system.getParticles(), ClassNames.none());
        assertEquals(Map.of("wind", "drag", "turbulence", "drag", "vortex", "drag", "damped-springs", "springs")
                .getOrDefault(name, name), effect.getName());
        assertTrue(effect instanceof DifferentiableEffect, "it knows its derivatives");
        assertEquals(List.of("wind", "turbulence", "vortex", "muscles").contains(name),
                effect.getTraits().contains(Effect.Trait.DRIVING),
                "only what blows or lives drives");
        assertEquals(List.of(), EffectCheck.check(particles -> EffectSample.create(name, particles,
                ClassNames.none())));
    }
}
