package particles.scene;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import particles.ParticleSystem;
import particles.effects.EffectCatalog;
import particles.effects.EffectKind;
import particles.law.DifferentiableEffect;
import particles.law.Effect;
import particles.spec.ClassNames;
import particles.teaching.effects.EffectCheck;
import particles.teaching.effects.EffectClaims;
import particles.teaching.effects.EffectSample;

/**
 * Every effect that a scene can name has the properties that it claims: force and potential, Newton's third law,
 * symmetries, energy and derivatives. The list is that of the scene reader, so new effects are tested too.
 */
class RegisteredEffectsTest {
    private static final String SIX = """
            title: Six particles
            teaches: What an effect claims of itself.
            solver: rk4
            deltaT: 0.001
            duration: 1
            particles:
              - {id: a, position: [0, 0, 0]}
              - {id: b, mass: 0.7, position: [1, 0, 0.5]}
              - {id: c, mass: 1.3, position: [2, 0, 1]}
              - {id: d, position: [0, 1, 1.5]}
              - {id: e, position: [1, 1, 2], fixed: true}
              - {id: f, mass: 0.6, position: [2, 1, 2.5]}
            """;
    private static final String SPRINGS = """
            springs:
              - {from: a, to: b, stiffness: 20, damping: 0.5}
              - {from: b, to: e, stiffness: 30, restLength: 0.8}
            """;

    /** How a scene names each effect; wind needs drag. */
    private static final Map<String, String> NAMED = Map.of(
            "repulsion", "repulsion: {radius: 0.9, law: hertz, stiffness: 20, damping: 0.8}",
            "gravity", "gravity",
            "wind", "wind: {mean: [2, 0, 1], gust: [1, 0.5, 0], period: 1.7}\n  - drag: {coefficient: 0.4}",
            "turbulence", "turbulence: {strength: 1.5, eddySize: 2, seed: 42}\n  - quadraticDrag: {coefficient: 0.4}",
            "drag", "drag: {coefficient: 0.4}",
            "quadraticDrag", "quadraticDrag: {coefficient: 0.4}",
            "attraction", "attraction: {centre: [0.5, -2, 0.4], strength: 3, softening: 0.2}",
            "cohesion", "cohesion: {range: 1.9, depth: 2, damping: 0.8}",
            "penaltyPlane", "penaltyPlane: {point: [1, 0.5, 1], normal: [1, 2, -1], stiffness: 30, loss: 0.8}",
            "penaltySphere", "penaltySphere: {centre: [1, 0.3, 0.8], radius: 1.2, stiffness: 30, loss: 0.8}");

    static List<String> registered() {
        return EffectCatalog.ALL.stream().map(EffectKind::getName).toList();
    }

    private static Scene scene(String rest) {
        return TestScenes.build(SIX + rest);
    }

    private static void keepTheirClaims(Scene scene) {
        assertFalse(scene.system().getEffects().isEmpty());
        for (Effect effect : scene.system().getEffects()) {
            assertTrue(effect instanceof DifferentiableEffect, effect.getName()
                    + " knows its derivatives");
            assertEquals(List.of(), EffectClaims.broken(scene.system(), effect, 2003), effect.getName());
        }
    }

    @Test
    void everyEffectHasAnExampleHere() {
        assertEquals(Set.copyOf(registered()), NAMED.keySet());
        assertEquals(registered().size(), new HashSet<>(registered()).size());
    }

    @ParameterizedTest
    @MethodSource("registered")
    void everyEffectHasItsClaimedProperties(String name) {
        assertTrue(NAMED.containsKey(name), "'" + name + "' needs an example here");
        keepTheirClaims(scene("effects:\n  - " + NAMED.get(name) + "\n"));
    }

    /** checkEffect uses the same names as scenes. */
    @ParameterizedTest
    @MethodSource("registered")
    void everyEffectCanBeCheckedByItsName(String name) {
        ParticleSystem system = EffectSample.system();
        Effect effect = EffectSample.create(name, system.getParticles(), ClassNames.none());
        assertEquals(Map.of("wind", "drag", "turbulence", "drag").getOrDefault(name, name), effect.getName());
        assertEquals(name.equals("wind") || name.equals("turbulence"),
                effect.getTraits().contains(Effect.Trait.DRIVING),
                "only what blows drives");
        assertEquals(List.of(), EffectCheck.check(particles -> EffectSample.create(name, particles,
                ClassNames.none())));
    }

    @Test
    void springsOfASceneKeepTheirClaims() {
        keepTheirClaims(scene(SPRINGS));
    }
}
