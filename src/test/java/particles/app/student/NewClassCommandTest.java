package particles.app.student;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static particles.Texts.assertHas;
import static particles.Texts.assertStarts;

import deSolvers.DESolver;
import java.io.IOException;
import java.net.URL;
import java.net.URLClassLoader;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import javax.tools.ToolProvider;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import particles.app.cli.ExitCode;
import particles.app.cli.OptionStyle;
import particles.app.cli.Screen;
import particles.law.Effect;
import particles.teaching.Finding;
import particles.teaching.effects.EffectCheck;
import particles.teaching.solvers.SolverCheck;
import particles.teaching.solvers.SolverVerdict;

/** Skeletons compile without a warning, do nothing yet, say how to go on, and never replace what is there. */
class NewClassCommandTest {
    @TempDir
    private Path folder;

    private String run(ExitCode expected, String command, String name, String... options) {
        List<String> args = new ArrayList<>(List.of(command));
        args.addAll(name.isEmpty() ? List.of() : List.of("--class=" + name));
        args.addAll(List.of(options));
        return Screen.of(expected, List.of(new NewClassCommand.NewSolver(folder.resolve("exercises")),
                new NewClassCommand.NewEffect(folder.resolve("exercises"))), OptionStyle.GRADLE,
                args.toArray(new String[0]));
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

    @ParameterizedTest
    @CsvSource({"MyRK4Solver, DESolver", "HeunSolver, FixedStepSolver"})
    void aSolverCompilesAndIsToldWhatIsMissing(String name, String base) throws Exception {
        assertHas(run(ExitCode.DONE, "newSolver", name, "--from=" + base),
                "gradle checkSolver -Psolver=exercises." + name);
        Class<?> solver = compiled(name);
        assertEquals(List.of("not yet: the step does nothing yet: write it, then check again"), SolverCheck.check(() ->
                make(solver), name).wrong().stream().map(Finding::toString).toList());
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
    void everySlidesOutlineIsThere() throws IOException {
        Map<String, String> names = Map.of("gMid", "MidpointSolver RK2 ModifiedEuler",
                "k4/6", "RK4Solver RungeKutta4", "v += a * deltaT", "SymplecticEulerSolver Leapfrog",
                "weights add up to 1", "HeunSolver ImplicitMidpoint RungeKuttaFehlberg Smith");
        for (Map.Entry<String, String> entry : names.entrySet()) {
            for (String name : entry.getValue().split(" ")) {
                run(ExitCode.DONE, "newSolver", name);
                assertHas(Files.readString(folder.resolve("exercises").resolve(name + ".java")), entry.getKey());
            }
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
        assertEquals(List.of("STYLE"), filledIn("MyDrag", "velocity.times(-strength)", ""));
        assertEquals(List.of(), filledIn("MyTether", "position.times(-strength)",
                "0.5 * strength * position.dot(position)", "--conservative=true"));
        assertEquals(List.of("METHOD"), filledIn("MyMistake", "position.times(strength)",
                "0.5 * strength * position.dot(position)", "--conservative=true"));
    }

    private List<String> filledIn(String name, String force, String energy, String... options)
            throws ReflectiveOperationException, IOException {
        run(ExitCode.DONE, "newEffect", name, options);
        Path file = folder.resolve("exercises").resolve(name + ".java");
        Files.writeString(file, Files.readString(file).replace("return Vector3.ZERO;", "return " + force + ";").replace(
                "return 0;", "return " + energy + ";"));
        Class<?> law = compiled(name);
        return EffectCheck.check(particles -> made(Effect.class, law, particles, 2.0)).stream()
                .map(found -> found.kind().name()).toList();
    }

    @ParameterizedTest
    @ValueSource(strings = {"euler", "heun", "midpoint"})
    void anExampleIsARightSolver(String method) throws ReflectiveOperationException, IOException {
        String name = method.substring(0, 1).toUpperCase(Locale.ROOT) + method.substring(1) + "Example";
        run(ExitCode.DONE, "newSolver", "", "--example=" + method);
        Class<?> solver = compiled(name);
        SolverVerdict verdict = SolverCheck.check(() -> make(solver), name);
        assertEquals(List.of(), verdict.wrong());
        assertTrue(verdict.identity().toLowerCase(Locale.ROOT).contains(method), verdict.identity());
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
    @CsvSource(delimiter = '|', textBlock = """
            3rd       |                  | class: '3rd' is not a class name
            class     |                  | class: 'class' is not a class name
            My Solver |                  | class: 'My Solver' is not a class name
            ../Up     |                  | class: '../Up' is not a class name
            a.B       |                  | class: 'a.B' is not a class name
            Mine      | --example=rk5    | example: expected one of [EULER, MIDPOINT, HEUN]
            Mine      | --from=RK4Solver | from: expected one of [DESOLVER, FIXEDSTEPSOLVER]
            """)
    void whatCannotBeWrittenIsRefused(String name, String option, String why) {
        String[] options = option == null ? new String[0] : new String[] {option};     // null: an empty cell
        assertStarts(run(ExitCode.BAD_INPUT, "newSolver", name, options), "option -P" + why);
        assertFalse(Files.exists(folder.resolve("exercises/Mine.java")));
    }
}
