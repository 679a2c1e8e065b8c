package particles.app;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static particles.Texts.assertStarts;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import particles.app.student.NewClassCommand;
import particles.app.student.StudentClasses;
import particles.app.student.StudentLoader;
import particles.scene.Scene;
import particles.scene.SceneBuilder;
import particles.scene.SceneReader;
import particles.spec.messages.InvalidInputException;
import particles.teaching.effects.EffectCheck;
import particles.teaching.effects.EffectSample;

/** A student's own effect is one class that a scene names: the example in the javadoc of {@code particles.effects}. */
class OwnEffectTest {
    private static final String LAW = """
            package exercises;

            import java.util.Set;
            import particles.law.ParticleForce;
            import particles.law.Particles;
            import particles.law.Vector3;
            import particles.effects.EffectContext;
            import particles.effects.EffectKind;
            import particles.spec.Key;
            import particles.spec.Values;
            import particles.spec.VectorType;

            // The Coriolis force of a frame that turns with the angular velocity w: F = 2 m v x w. It does no work.
            public final class Coriolis extends ParticleForce {
                private final Vector3 w;

                public Coriolis(Particles particles, Vector3 w) {
                    super(particles);
                    this.w = w;
                }

                @Override
                public Set<Trait> getTraits() {
                    return Set.of(Trait.TRANSLATION_INVARIANT);
                }

                @Override
                protected Vector3 getForce(Vector3 position, Vector3 velocity, double mass, double time) {
                    return velocity.cross(w).times(2 * mass);
                }

                // In a scene: - exercises.Coriolis: {angularVelocity: [0, 1.57, 0]}
                public static final class Keys extends EffectKind {
                    private static final Key<Vector3> ANGULAR_VELOCITY = VectorType.of("rad/s").required(
                            "angularVelocity", "How fast the frame turns, about which axis (rad/s).");

                    public Keys() {
                        super("exercises.Coriolis", "The Coriolis force of a turning frame.", ANGULAR_VELOCITY);
                    }

                    @Override
                    public void build(Values values, EffectContext scene) {
                        scene.add(new Coriolis(scene.particles(), values.get(ANGULAR_VELOCITY)));
                    }
                }
            }
            """;

    /** A turn takes pi/w = 2 s. */
    private static final String SCENE = """
            title: A puck on a turntable
            teaches: On a parabolic turntable gravity cancels the centrifugal force, and a puck circles twice per turn.
            solver: rk4
            deltaT: 0.01
            duration: 2
            particles:
              - {id: puck, position: [0, 0, 0], velocity: [1, 0, 0]}
            effects:
              - exercises.Coriolis: {angularVelocity: [0, 1.5707963267948966, 0]}
            """;

    private final ClassLoader before = Thread.currentThread().getContextClassLoader();
    @TempDir
    private Path folder;

    @BeforeEach
    void findClasses() {
        new StudentLoader(folder).install();
    }

    @AfterEach
    void findThemNoMore() {
        Thread.currentThread().setContextClassLoader(before);
    }

    private void write(String name, String text) throws IOException {
        Files.writeString(folder.resolve(name + ".java"), text);
    }

    private static Scene scene(String text) {
        return SceneBuilder.build(SceneReader.read("x.yaml", text.getBytes(StandardCharsets.UTF_8),
                new StudentClasses(), List.of()));
    }

    private static void assertRefused(String line, String effect) {
        String text = SCENE.replaceFirst("  - exercises.*", "  - " + effect);
        assertEquals("x.yaml:9:" + line, assertThrows(InvalidInputException.class, () -> scene(text)).getMessage());
    }

    @Test
    void theExampleIsThatOfTheJavadoc() throws IOException {
        String javadoc = Files.readString(Path.of("src/main/java/particles/effects/package-info.java"))
                .replaceAll("(?m)^ \\* ?", "");
        for (String part : List.of(LAW, SCENE)) {
            assertTrue(javadoc.contains(part), () -> "the package-info of particles.effects lacks:\n" + part);
        }
    }

    /** The radius is v/(2 w) = 1/pi m: after half a circle, in 1 s, the puck is a diameter away and comes back. */
    @ParameterizedTest
    @CsvSource({"1, 0.6366197723675814, -1", "2, 0, 1"})
    void aSceneNamesTheClass(String duration, double z, double speed) throws IOException {
        write("Coriolis", LAW);
        Scene scene = scene(SCENE.replace("duration: 2", "duration: " + duration));
        scene.simulation().run();
        assertArrayEquals(new double[] {0, 0, z, speed, 0, 0}, scene.system().getOwnState(), 1e-7);
    }

    @Test
    void anEffectThatFailsWhenBuiltIsOneLine() throws IOException {
        write("Coriolis",
                LAW.replace("this.w = w;", "this.w = w;\n        int[] none = {};\n        none[w.hashCode() & 1]++;"));
        InvalidInputException e = assertThrows(InvalidInputException.class, () -> scene(SCENE));
        assertEquals(1, e.getLines().size());
        assertStarts(e.getMessage(), "x.yaml:9:5: exercises.Coriolis cannot be built: java.lang.ArrayIndex");
    }

    @Test
    void checkEffectCreatesTheEffectFromItsKeys() throws IOException {
        write("Coriolis", LAW);
        assertEquals(List.of(), EffectCheck.check(particles -> EffectSample.create("Coriolis", particles,
                new StudentClasses())));
    }

    @Test
    void theSkeletonOfNewEffectRunsInAScene() throws IOException {
        write("MyForce", NewClassCommand.NewEffect.SKELETON.replace("NAME", "MyForce"));
        assertEquals("MyForce", scene(SCENE.replaceFirst("exercises.*",
                "exercises.MyForce: {strength: 2}")).system().getEffects()
                .get(0).getName());
    }

    @Test
    void keysOfAStudentsEffectAreChecked() throws IOException {
        write("Coriolis", LAW);
        assertRefused("26: unknown key 'angularVelocty'; did you mean 'angularVelocity'? known in 'exercises.Coriolis':"
                + " angularVelocity", "exercises.Coriolis: {angularVelocty: [0, 0, 1], angularVelocity: [0, 0, 1]}");
        assertRefused("43: 'angularVelocity' is 3; it has to be three numbers [x, y, z] (rad/s)",
                "exercises.Coriolis: {angularVelocity: 3}");
        assertRefused("""
                5: 'exercises.Coriolis' needs a value for at least one key: write \
                '- exercises.Coriolis: {angularVelocity: ...}'""", "exercises.Coriolis");
    }

    @Test
    void anUnusableClassIsOneLine() throws IOException {
        assertRefused("5: there is no class exercises.Missing with a 'public static final class Keys extends"
                + " EffectKind' in src/main/java/exercises; gradle newEffect writes one",
                "exercises.Missing: {strength: 2}");
        write("Bare", "package exercises; public class Bare { }");
        assertRefused("""
                5: there is no class exercises.Bare with a 'public static final class Keys extends EffectKind' in \
                src/main/java/exercises; gradle newEffect writes one""", "exercises.Bare");
        write("Broken", "package exercises;\npublic class Broken {\n    int x = y;\n}\n");
        assertRefused("5: it does not compile: Broken.java:3: cannot find symbol: variable y", "exercises.Broken");
        write("Hidden", LAW.replace("Coriolis", "Hidden").replace("public Keys()", "Keys()"));
        assertRefused("""
                5: the Keys of exercises.Hidden cannot be created; they have to be a 'public static final class Keys \
                extends EffectKind' with a 'public Keys()': java.lang.NoSuchMethodException: \
                exercises.Hidden$Keys.<init>()""", "exercises.Hidden");
        write("Copied", LAW.replace("class Coriolis", "class Copied").replace("new Coriolis", "new Copied")
                .replace("public Coriolis", "public Copied"));
        assertRefused("""
                5: the Keys of exercises.Copied call it 'exercises.Coriolis'; write super("exercises.Copied", ...) \
                in their constructor""", "exercises.Copied");
    }

    @Test
    void withoutClassesTheSceneIsRefused() {
        byte[] text = SCENE.getBytes(StandardCharsets.UTF_8);
        assertEquals("x.yaml:9:5: class 'exercises.Coriolis' cannot be used here; take an effect from the list in the"
                + " scene reference",
                assertThrows(InvalidInputException.class, () -> SceneReader.read("x.yaml", text)).getMessage());
    }
}
