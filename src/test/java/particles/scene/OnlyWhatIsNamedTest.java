package particles.scene;

import static deSolvers.problems.Bounds.assertBetween;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import java.util.stream.Collectors;
import javax.tools.ToolProvider;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import particles.effects.EffectCatalog;
import particles.effects.EffectKind;
import particles.scene.parts.RuleCatalog;
import particles.scene.parts.RuleKind;

/**
 * A scene builds only the laws that it names: they are counted, and in a freshly started program the class of a law
 * that is not named is not even loaded.
 */
class OnlyWhatIsNamedTest {
    private static final String SPRINGS = """
            title: Springs alone
            teaches: what is not named is not there
            solver: rk4
            deltaT: 0.01
            duration: 0.2
            particles:
              - {id: wall, position: [0, 2, 0], fixed: true}
              - {id: bob, position: [1.2, 2, 0]}
            springs:
              - {from: wall, to: bob, stiffness: 10, restLength: 1}
            """;

    /** Additions to the scene, and the classes of laws that each needs. */
    private static final String ADDITIONS = """
            effects: [] |
            effects: [gravity] | Gravity
            effects: [drag: {coefficient: 1}] | AirDrag
            effects: [drag: {coefficient: 1}, wind: {mean: [1, 0, 0]}] | AirDrag
            effects: [quadraticDrag: {coefficient: 1}] | AirDrag
            effects: [quadraticDrag: {coefficient: 1}, turbulence: {strength: 1}] | AirDrag
            effects: [drag: {coefficient: 1}, vortex: {speed: 1}] | AirDrag
            effects: [push: {force: [0, 1, 0]}] | Push
            effects: [muscles: {amplitude: 0.1, period: 1}] | Muscles
            effects: [attraction: {strength: 1}] | PointAttraction
            effects: [gravitation] | Gravitation PairForce
            effects: [magneticField: {field: [0, 0, 1]}] | MagneticField
            effects: [cohesion: {range: 2, depth: 1}] | Cohesion PairForce ShortRangeForce
            effects: [repulsion: {radius: 1, stiffness: 1}] | Repulsion PairForce ShortRangeForce
            effects: [penaltyPlane: {stiffness: 1}] | Penalty
            effects: [penaltySphere: {centre: [9, 9, 9], radius: 1, stiffness: 1}] | Penalty
            impact: clamp; rules: [ground] | RestingContacts ClampedImpacts Impacts
            impact: exact; rules: [ground] | RestingContacts ExactImpacts Impacts
            impact: exact; rules: [sphere: {centre: [9, 9, 9], radius: 1}] | RestingContacts ExactImpacts Impacts
            rules: [collisions: {radius: 0.1}] | Collisions RestingContacts ExactImpacts Impacts RigidConstraints
            rods: [{from: wall, to: bob}] | RigidConstraints
            wires: [line: {bead: bob, direction: [1, 0, 0]}] | RigidConstraints
            rules: [tear: {strain: 9}] | SpringTear
            rules: [shake: {particle: wall, amplitude: [1, 0, 0], period: 1}] |
            rules: [emitter: {id: e, position: [0, 0, 0], speed: 1, rate: 1}] | Emitter
            rules: [emitter: {id: e, position: [0, 0, 0], speed: 1, rate: 1, lifetime: 1}] | Deaths Emitter
            rules: [kill: {point: [0, -9, 0]}] | Deaths
            rules: [samples: {farthest: 9, lightest: 1}] | ParticleResampler
            """;

    private record Addition(String yaml, Set<String> laws) {
    }

    static List<Addition> additions() {
        return ADDITIONS.lines().map(line -> line.split(" ?[|] ?", -1)).map(row -> new Addition(
                row[0].replace("; ", "\n") + "\n", row[1].isEmpty() ? Set.of() : Set.of(row[1].split(" ")))).toList();
    }

    /** Seven scenes in each of three programs; neighbours in the list, which share laws, are in different ones. */
    @ParameterizedTest
    @ValueSource(ints = {0, 1, 2})
    void nothingElseIsEvenLoaded(int first) throws Exception {
        try (FreshProgram program = new FreshProgram()) {
            Set<String> laws = new TreeSet<>();
            for (int n = first; n < additions().size(); n += 3) {
                program.run(SPRINGS + additions().get(n).yaml());
                laws.addAll(withSprings(additions().get(n)));
                assertEquals(laws, program.loadedLaws(), additions().get(n).yaml());
            }
        }
    }

    /**
     * Not the laws' classes alone, but all that belongs to them, such as the cells of cohesion or the waves of
     * turbulence: of a class that is not loaded no method runs and no object takes memory. What is loaded beside the
     * springs is the list of effects with the keys that each declares, and two interfaces without code.
     */
    @Test
    void ofLawsThatAreNotNamedOnlyTheKeysAreLoaded() throws Exception {
        try (FreshProgram program = new FreshProgram()) {
            program.run(SPRINGS);
            Set<String> classes = new TreeSet<>();
            List.of("particles.effects.", "particles.reactions.", "particles.rules.")
                    .forEach(room -> classes.addAll(program.loadedFrom(room)));
            classes.removeIf(name -> name.matches(".*(\\$|Muscle)\\w*Keys")
                    || name.startsWith("particles.effects.springs."));
            assertEquals(Set.of("particles.effects.EffectCatalog", "particles.effects.EffectKind",
                    "particles.effects.EffectContext", "particles.effects.SharedKeys", "particles.effects.Wind",
                    "particles.reactions.Curve"), classes);
            program.run(SPRINGS + "effects:\n  - cohesion: {range: 2, depth: 1}\n");
            assertTrue(program.loadedFrom("particles.effects.").contains("particles.effects.Cohesion"), "when named");
        }
    }

    /**
     * The same program, but with a list of effects that is empty: to build and run a scene that names none takes the
     * same memory to the byte (measured: 260,552 for a moving rope of 100 particles, and 368 more with gravity).
     */
    @Test
    void lawsThatAreNotNamedTakeNoByte(@TempDir Path without) throws Exception {
        String rope = SPRINGS.replaceFirst("(?s)particles:.*", """
                shapes:
                  - rope: {start: [0, 0, 0], end: [9, 0, 0], particles: 100, mass: 1, velocity: [1, 0, 0],
                      structural: {stiffness: 10}}
                """);
        Path source = Files.writeString(without.resolve("EffectCatalog.java"), """
                package particles.effects;

                public final class EffectCatalog {
                    public static final java.util.List<EffectKind> ALL = java.util.List.of();
                }
                """);
        assertEquals(0, ToolProvider.getSystemJavaCompiler().run(null, null, null, "-proc:none", "-cp",
                System.getProperty("java.class.path"), "-d", without.toString(), source.toString()));
        try (FreshProgram all = new FreshProgram(); FreshProgram none = new FreshProgram(without)) {
            long bytes = none.allocated(rope);
            assertFalse(none.loadedFrom("particles.effects.").contains("particles.effects.Gravity$Keys"), "none");
            assertTrue(all.loadedFrom("particles.effects.").isEmpty());
            assertEquals(bytes, all.allocated(rope));
            assertTrue(all.loadedFrom("particles.effects.").contains("particles.effects.Gravity$Keys"), "all");
            long named = all.allocated(rope + "effects:\n  - gravity\n") - bytes;
            assertBetween(0, 1000, named);
        }
    }

    private static Set<String> withSprings(Addition addition) {
        Set<String> all = new TreeSet<>(addition.laws());
        all.addAll(Set.of("SpringForce", "EnergyLimit"));       // the scene's springs, and what ends any run
        return all;
    }

    /** The list above has every effect and every kind of rule except similar ones: other motions, and the plane. */
    @Test
    void everyKindIsTested() {
        String all = additions().stream().map(Addition::yaml).collect(Collectors.joining());
        for (EffectKind kind : EffectCatalog.ALL) {
            assertTrue(all.contains(kind.getName()), kind.getName());
        }
        Set<String> missing = RuleCatalog.ALL.stream().map(RuleKind::getName).filter(name -> !all.contains(name))
                .collect(Collectors.toSet());
        assertEquals(Set.of("plane", "circle", "glide"), missing);
    }
}
