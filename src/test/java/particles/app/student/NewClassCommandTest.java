package particles.app.student;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static particles.Texts.assertHas;
import static particles.Texts.assertStarts;

import deSolvers.DESolver;
import java.io.IOException;
import java.net.URL;
import java.net.URLClassLoader;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import javax.tools.ToolProvider;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import particles.app.cli.ExitCode;
import particles.app.cli.OptionStyle;
import particles.app.cli.Screen;
import particles.law.Effect;
import particles.teaching.Finding;
import particles.teaching.effects.EffectCheck;
import particles.teaching.solvers.SolverCheck;

/** Skeletons compile without a warning, do nothing yet, say how to go on, and never replace what is there. */
class NewClassCommandTest {
    @TempDir
    private Path folder;

    private String run(ExitCode expected, String command, String name) {
        return Screen.of(expected, List.of(new NewClassCommand.NewSolver(folder.resolve("exercises")),
                new NewClassCommand.NewEffect(folder.resolve("exercises"))), OptionStyle.GRADLE, command, "--class="
                + name);
    }

    private Class<?> compiled(String name) throws ReflectiveOperationException, IOException {
        Path file = folder.resolve("exercises").resolve(name + ".java");
        // without the warning that Gradle's class path names a folder for resources that no one needs
        assertEquals(0, ToolProvider.getSystemJavaCompiler().run(null, null, null, "-Xlint:all,-path", "-Werror",
                "-proc:none",
                "-cp", System.getProperty("java.class.path"), "-d", folder.toString(), file.toString()),
                Files.readString(file));
        try (URLClassLoader loader = new URLClassLoader(new URL[] {folder.toUri().toURL()})) {
            return loader.loadClass("exercises." + name);
        }
    }

    @Test
    void aSolverCompilesAndIsToldWhatIsMissing() throws Exception {
        assertHas(run(ExitCode.DONE, "newSolver", "MyRK4Solver"), "gradle checkSolver -Psolver=exercises.MyRK4Solver");
        Class<?> solver = compiled("MyRK4Solver");
        assertEquals(List.of("not yet: the step does nothing yet: write it, then check again"), SolverCheck.check(() ->
                make(solver), "MyRK4Solver").wrong().stream().map(Finding::toString).toList());
    }

    private static DESolver make(Class<?> solver) {
        return made(DESolver.class, solver);
    }

    private static <T> T made(Class<T> type, Class<?> its, Object... arguments) {
        try {
            return type.cast(its.getConstructors()[0].newInstance(arguments));
        } catch (ReflectiveOperationException e) {
            throw new IllegalStateException(e);
        }
    }

    @Test
    void anEffectCompilesAndIsToldThatItAddsNoForce() throws ReflectiveOperationException, IOException {
        assertHas(run(ExitCode.DONE, "newEffect", "MyGravity"), "- exercises.MyGravity: {strength: 2}");
        Class<?> law = compiled("MyGravity");
        List<Finding> wrong = EffectCheck.check(particles -> made(Effect.class, law, particles, 2.0));
        assertEquals(1, wrong.size(), wrong.toString());
        assertStarts(wrong.get(0).toString(), "not yet: there is no force on any particle");
    }

    /** Filled in as the comments of the skeletons suggest. */
    @Test
    void aFilledInSkeletonPasses() throws ReflectiveOperationException, IOException {
        assertEquals(List.of("STYLE"), filledIn("MyDrag", "velocity.times(-strength)", false));
        assertEquals(List.of(), filledIn("MyTether", "position.times(-strength)", true));
        assertEquals(List.of("METHOD"), filledIn("MyMistake", "position.times(strength)", true));
    }

    private List<String> filledIn(String name, String force, boolean energy) throws ReflectiveOperationException,
            IOException {
        run(ExitCode.DONE, "newEffect", name);
        Path file = folder.resolve("exercises").resolve(name + ".java");
        Files.writeString(file, Files.readString(file).replace("return Vector3.ZERO;", "return " + force + ";")
                .replaceAll(energy ? "// (?=@|    ret|}\n)" : "^$", ""));
        Class<?> law = compiled(name);
        return EffectCheck.check(particles -> made(Effect.class, law, particles, 2.0)).stream()
                .map(found -> found.kind().name()).toList();
    }

    @Test
    void whatIsThereIsLeftAlone() throws IOException {
        run(ExitCode.DONE, "newSolver", "HeunSolver");
        Path file = folder.resolve("exercises/HeunSolver.java");
        Files.writeString(file, "my work");
        assertHas(run(ExitCode.BAD_INPUT, "newSolver", "HeunSolver"), "exists already and was not changed");
        assertHas(run(ExitCode.BAD_INPUT, "newEffect", "HeunSolver"), "exists already");
        assertEquals("my work", Files.readString(file));
    }

    @ParameterizedTest
    @ValueSource(strings = {"3rd", "class", "My Solver", "../Up", "a.B"})
    void whatIsNoNameIsRefused(String name) {
        assertStarts(run(ExitCode.BAD_INPUT, "newSolver", name), "option -Pclass: '" + name + "' is not a class name");
        assertFalse(Files.exists(folder.resolve("exercises")));
    }
}
