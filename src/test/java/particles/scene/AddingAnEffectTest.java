package particles.scene;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.io.StringWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import javax.tools.ToolProvider;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/**
 * Adding an effect is one new class, one registration and one scene: here all three, as README has them, are put beside the
 * project's own sources, compiled and run.
 */
class AddingAnEffectTest {
    /** src/main/java/particles/effects/Coriolis.java */
    private static final String NEW_CLASS = """
            package particles.effects;

            import java.util.EnumSet;
            import java.util.Set;
            import particles.Effect;
            import particles.Particles;
            import particles.Vector3;

            /** The Coriolis force of a frame that turns with the angular velocity w: F = 2 m v x w. It does no work. */
            public final class Coriolis implements Effect {
                private static final int STRIDE = Particles.STRIDE;

                private final Particles particles;
                private final Vector3 w;

                /**
                 * @param particles on whom it acts
                 * @param w         the frame's angular velocity (rad/s)
                 */
                public Coriolis(Particles particles, Vector3 w) {
                    this.particles = particles;
                    this.w = w;
                }

                @Override
                public String getName() {
                    return "coriolis";
                }

                @Override
                public Set<Trait> getTraits() {
                    return EnumSet.of(Trait.TRANSLATION_INVARIANT);
                }

                @Override
                public int size() {
                    return particles.count();
                }

                @Override
                public boolean dependsOnVelocity() {
                    return true;
                }

                @Override
                public void addForces(double[] state, double time, double[] force, int from, int to) {
                    double[] masses = particles.masses();
                    for (int i = from, v = STRIDE * from + 3; i < to; i++, v += STRIDE) {
                        force[v] += 2 * masses[i] * (state[v + 1] * w.z() - state[v + 2] * w.y());
                        force[v + 1] += 2 * masses[i] * (state[v + 2] * w.x() - state[v] * w.z());
                        force[v + 2] += 2 * masses[i] * (state[v] * w.y() - state[v + 1] * w.x());
                    }
                }
            }
            """;

    /** In src/main/java/particles/scene/EffectKind.java, above the list ALL, and its name into the list. */
    private static final String REGISTRATION = """
                private static final Key<Vector3> TURNING = Key.required("angularVelocity", VectorType.of("rad/s"),
                        "How fast the frame turns, about which axis (rad/s).");

                private static final EffectKind CORIOLIS = new EffectKind("coriolis", "The Coriolis force of a turning frame.", TURNING) {
                    @Override
                    void build(Values values, SceneAssembly assembly) {
                        assembly.add(new particles.effects.Coriolis(assembly.particles(), values.get(TURNING)));
                    }
                };

            """;
    private static final String LIST = "    /** All effects, in the order in which they are built";

    /** scenes/60-coriolis.yaml; a turn takes pi/w = 2 s. */
    private static final String SCENE = """
            title: A puck on a turntable
            teaches: Seen from a turning frame a free puck goes in circles, of half the frame's period.
            solver: rk4
            deltaT: 0.01
            duration: 0.5
            particles:
              - {id: puck, position: [0, 0, 0], velocity: [1, 0, 0]}
            effects:
              - coriolis: {angularVelocity: [0, 0, 1.5707963267948966]}
            """;

    @Test
    void theyAreWhatReadmeShows() throws IOException {
        String readme = Files.readString(Path.of("README.md"));
        for (String part : List.of(NEW_CLASS, REGISTRATION.stripTrailing(), SCENE)) {
            assertTrue(readme.contains(part), () -> "README lacks:\n" + part);
        }
    }

    @Test
    void oneClassOneRegistrationOneScene(@TempDir Path folder) throws Exception {
        Path sources = folder.resolve("src");
        Path newClass = write(sources.resolve("particles/effects/Coriolis.java"), NEW_CLASS);
        String kinds = Files.readString(Path.of("src/main/java/particles/scene/EffectKind.java"));
        String registered = kinds.replace(LIST, REGISTRATION
                + LIST).replaceFirst("(static final List<EffectKind> ALL = List\\.of\\([^)]*)\\)",
                "$1, CORIOLIS)");
        assertTrue(registered.contains(", CORIOLIS)"));
        compile(folder, newClass, write(sources.resolve("particles/scene/EffectKind.java"), registered));
        try (FreshProgram program = new FreshProgram(folder)) {
            double[] state = program.run(SCENE);
            double radius = 1 / Math.PI;                // v/(2 w)
            assertEquals(radius, state[0], 1e-8, "a quarter of the circle");
            assertEquals(-radius, state[1], 1e-8);
            assertEquals(0, state[3], 1e-7);
            assertEquals(-1, state[4], 1e-7);
        }
    }

    private static Path write(Path file, String text) throws IOException {
        Files.createDirectories(file.getParent());
        return Files.writeString(file, text);
    }

    private static void compile(Path out, Path... sources) {
        StringWriter messages = new StringWriter();
        List<String> options = List.of("-d", out.toString(), "-Xlint:all", "-proc:none", "-classpath", String.join(
                System.getProperty("path.separator"), Path.of(uri(SceneReader.class)).toString(),
                Path.of(uri(org.snakeyaml.engine.v2.api.Load.class)).toString(), System.getProperty("java.class.path")));
        try (var files = ToolProvider.getSystemJavaCompiler().getStandardFileManager(null, null, null)) {
            boolean done = ToolProvider.getSystemJavaCompiler().getTask(messages, files, null, options, null,
                    files.getJavaFileObjects(sources)).call();
            assertTrue(done, messages.toString());
        } catch (IOException e) {
            throw new AssertionError(e);
        }
    }

    private static java.net.URI uri(Class<?> type) {
        try {
            return type.getProtectionDomain().getCodeSource().getLocation().toURI();
        } catch (java.net.URISyntaxException e) {
            throw new AssertionError(e);
        }
    }
}
