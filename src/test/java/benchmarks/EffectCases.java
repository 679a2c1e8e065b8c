package benchmarks;

import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import particles.ParticleSystem;
import particles.law.Effect;
import particles.scene.SceneBuilder;
import particles.scene.SceneReader;

/** Cases for {@link EffectBenchmark}: a cloth of 40 x 40 particles with one effect that acts on all of them. */
final class EffectCases {
    private static final String DRAG = "drag: {coefficient: 0.01}";
    private static final String SPRINGS = "springs";

    private static final String SCENE = """
            title: A cloth with one effect
            teaches: What its forces cost.
            solver: rk4
            deltaT: 0.001
            duration: 1
            shapes:
              - cloth: {corner: [-1, 0, -1], across: [2, 0.1, 0], down: [0.1, 0, 2], columns: 40, rows: 40,
                    totalMass: 1,
                        structural: {stiffness: 5, damping: 0.001}, shear: {stiffness: 2, damping: 0.001}}
            """;

    /** By the name in scenes: the lines of a scene. */
    private static final Map<String, List<String>> LINES = new TreeMap<>(Map.of(
            SPRINGS, List.of(),
            "gravity", List.of("gravity"),
            "wind", List.of("wind: {mean: [1, 0, 0], gust: [0, 0, 1]}", DRAG),
            "turbulence", List.of("turbulence: {strength: 1}", DRAG),
            "drag", List.of(DRAG),
            "quadraticDrag", List.of("quadraticDrag: {coefficient: 0.01}"),
            "attraction", List.of("attraction: {strength: 1, centre: [0, -3, 0]}"),
            "cohesion", List.of("cohesion: {range: 0.08, depth: 1e-6}"),
            "penaltyPlane", List.of("penaltyPlane: {point: [0, 1, 0], stiffness: 1, loss: 0.1}"),
            "penaltySphere", List.of("penaltySphere: {centre: [0, -3, 0], radius: 6, stiffness: 1, loss: 0.1}")));

    static {
        LINES.put("repulsion", List.of("repulsion: {radius: 0.04, stiffness: 1}"));
    }

    private EffectCases() {
    }

    static List<String> names() {
        return List.copyOf(LINES.keySet());
    }

    static ParticleSystem build(String name) {
        StringBuilder scene = new StringBuilder(SCENE);
        String heading = "effects:\n";
        for (String line : LINES.get(name)) {
            scene.append(heading).append("  - ").append(line).append('\n');
            heading = "";
        }
        byte[] bytes = scene.toString().getBytes(StandardCharsets.UTF_8);
        ParticleSystem system = SceneBuilder.build(SceneReader.read("a cloth with " + name, bytes)).system();
        double[] state = system.getStateArray();
        for (int i = 0; i < state.length; i++) {
            state[i] += 1e-3 * (i * 7919 % 101);            // moved, so that drag and springs exert forces
        }
        return system;
    }

    /** The effect of a case: the last one, or the springs if there is no other. */
    static Effect effect(String name, ParticleSystem system) {
        return system.getEffects().get(name.equals(SPRINGS) ? 0 : 1);
    }
}
