package particles.app.course;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static particles.Texts.assertHas;
import static particles.Texts.assertStarts;

import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import particles.OtherSystems;
import particles.app.cli.ExitCode;
import particles.app.cli.OptionStyle;
import particles.app.cli.Screen;
import particles.app.student.ExerciseCommand;
import particles.app.student.NewClassCommand;
import particles.teaching.exercises.Exercises;

/** The exercises through the program: the list, a text, a mark,
        and a grade with its report for people and for autograders. */
class GradeCommandTest {
    private static final String STUDENT = "s-123";

    @TempDir
    private Path folder;
    private Path classes;

    @BeforeEach
    void makeFolders() throws Exception {
        classes = Files.createDirectories(folder.resolve("exercises"));
    }

    private void write(String name, String text) throws Exception {
        Files.writeString(classes.resolve(name + ".java"), text);
    }

    private void answer(String text) throws Exception {
        Files.writeString(folder.resolve("answers.yaml"), text);
    }

    private void euler(String name, String increment) throws Exception {
        write(name, StudentWork.solver(name, increment));
    }

    private String run(ExitCode expected, String... args) {
        return Screen.of(expected, List.of(new ExerciseCommand(), new GradeCommand(folder, classes)),
                OptionStyle.GRADLE, args);
    }

    private String grade(ExitCode expected, String... more) {
        List<String> args = new ArrayList<>(List.of("grade", "--student=" + STUDENT,
                "--out=" + folder.resolve("report")));
        args.addAll(List.of(more));
        return run(expected, args.toArray(new String[0]));
    }

    private String assignment(String text) throws Exception {
        return "--assignment=" + Files.writeString(folder.resolve("assignment.yaml"), text);
    }

    @Test
    void theListHasTwelve() {
        assertEquals(12, run(ExitCode.DONE, "exercise").lines().count());
        assertHas(run(ExitCode.DONE, "exercise"), " 5  What midpoint costs against RK4");
    }

    @Test
    void anExerciseIsShownAndMarked() {
        String text = run(ExitCode.DONE, "exercise", "--number=2", "--student=" + STUDENT);
        assertStarts(text, "2. Why Euler spirals");
        assertHas(text, "Give five significant digits");
        assertEquals("This is right.", run(ExitCode.DONE, "exercise", "--number=2", "--student=" + STUDENT, "--answer="
                + spiral(text, 1)).strip());
        assertEquals("This is the factor of the amplitude; energy goes with its square.",
                run(ExitCode.BAD_INPUT, "exercise", "--number=2", "--student=" + STUDENT, "--answer=" + spiral(text,
                        0.5)).strip());
    }

    /** The factor of the energy, to a power, from the text's own numbers. */
    private static double spiral(String text, double power) {
        double h = number(text, "deltaT = ");
        return Math.pow(1 + h * h * number(text, "k = ") / number(text, "m = "), power * number(text, "have "));
    }

    private static double number(String text, String words) {
        Matcher matcher = Pattern.compile(Pattern.quote(words) + "([0-9.]*\\d)").matcher(text);
        assertTrue(matcher.find(), text);
        return Double.parseDouble(matcher.group(1));
    }

    @Test
    void whatIsNoExerciseOrStudentIsRefused() {
        for (String none : List.of("0", "13", "-1")) {
            assertStarts(run(ExitCode.BAD_INPUT, "exercise", "--number=" + none, "--student=a"),
                    "option -Pnumber: " + none + " has to be from 1 to 12");
        }
        assertStarts(run(ExitCode.BAD_INPUT, "exercise", "--answer=1", "--student=a"),
                "option -Panswer: goes with -Pnumber only");
        assertEquals("option -Pstudent: a student's id has to have something in it", run(ExitCode.BAD_INPUT, "exercise",
                "--number=1", "--student= ").strip());
        assertEquals("option -Pstudent: the id is empty", run(ExitCode.BAD_INPUT, "grade", "--student= ").strip());
    }

    @Tag("slow")
    @Test
    void everyAnswerAndSolverGetsItsMark() throws Exception {
        String text = run(ExitCode.DONE, "exercise", "--number=2", "--student=" + STUDENT);
        answer("# mine\n1: NaN\n2: " + spiral(text, 1)
                + "\n3: 0,5 kg\n12: no <such> & scene.yaml\n");
        euler("GoodSolver", "deltaT * dSdt[i]");
        euler("WrongSolver", "0.5 * deltaT * dSdt[i]");
        euler("BrokenSolver", "deltaT * dSdx[i]");
        String screen = grade(ExitCode.BAD_INPUT);
        assertHas(screen, "2 of 15 points for " + STUDENT);
        assertEquals(8, screen.lines().filter(line -> line.startsWith("missing   ")).count(), screen);
        assertTrue(screen.strip().endsWith("marks that are missing: 13"), screen);

        String report = Files.readString(folder.resolve("report/grade.md"));
        assertHas(report, "| 2. Why Euler spirals: the energy that steps add | 1 | 1 | This is right",
                "| 1. Three steps of the Euler method | 0 | 1 | 'NaN' is no finite number",
                "'kg' after the number is not understood: the answer is wanted in m/s",
                "| solver GoodSolver | 1 | 1 | GoodSolver: right. This is the Euler m",
                " / order, measured ", "report: GoodSolver/checkSolver.md |",
                "| solver BrokenSolver | 0 | 1 | exercises.BrokenSolver: wrong. It cannot be checked. / WRONG, f",
                "WRONG, failure: it does not compile: BrokenSolver.java:11: cannot find symbol: variable dSdx",
                "| solver WrongSolver | 0 | 1 | WrongSolver: ");
        assertEquals(Exercises.ALL.size() + 3,
                report.lines().filter(line -> line.matches("\\| .* \\| [01] \\| .*")).count());
    }

    private static final String PRANK = """
            package exercises;

            public class %s extends deSolvers.DESolver {
                static {
                    System.out.println("%s: right. This is the Euler method.");
                    System.out.println("DONE");
                    Runtime.getRuntime().halt(0);
                }

                @Override
                public void stepState(deSolvers.DEStateSource source, double deltaT) {
                }
            }
            """;

    /** Exit code 0 and the words of a right solver are no mark. */
    @Test
    void whoEndsTheProcessGetsNoMark() throws Exception {
        write("HaltSolver", PRANK.formatted("HaltSolver", "HaltSolver"));
        String screen = grade(ExitCode.BAD_INPUT);
        assertHas(screen, "no mark   solver HaltSolver" + System.lineSeparator()
                + "            wrong: the check did not finish; the class ended the program", "0 of 13 points");
    }

    /** Each wrong solver does something hostile first; their names come before that of the right one. */
    @Tag("slow")
    @Test
    void noHostileClassGetsOrSpoilsAMark() throws Exception {
        String verdict = """
                System.getProperty("sun.java.command").replaceFirst(".* ", "")""";
        String forge = """
                java.nio.file.Files.writeString(java.nio.file.Path.of(%s), "00\\nDONE\\nright");""".formatted(verdict);
        hostile("AppendSolver", """
                Runtime.getRuntime().addShutdownHook(new Thread(() -> {
                    try { %s } catch (java.io.IOException e) { throw new java.io.UncheckedIOException(e); }
                }));""".formatted(forge));
        hostile("ForgeSolver", forge + " Runtime.getRuntime().halt(0);");
        hostile("ReachSolver", """
                var loader = ReachSolver.class.getClassLoader();
                var field = loader.getClass().getDeclaredField("sources");
                field.setAccessible(true);
                for (var inner : field.get(loader).getClass().getDeclaredFields()) {
                    inner.setAccessible(true);
                    Object task = inner.get(field.get(loader));
                    var outcome = particles.app.student.StudentProcess.Outcome.class;
                    var sign = task.getClass().getDeclaredMethod("sign", outcome);
                    sign.setAccessible(true);
                    java.nio.file.Files.write(java.nio.file.Path.of(%s), (byte[]) sign.invoke(task,
                            outcome.getConstructors()[0].newInstance(particles.app.cli.ExitCode.DONE,
                            java.util.List.of("right"))));
                    Runtime.getRuntime().halt(0);
                }""".formatted(verdict));
        hostile("LitterSolver", "java.nio.file.Files.createDirectory(java.nio.file.Path.of(" + verdict + " + 2));");
        hostile("MoreSolver", """
                new Thread(() -> { while (true) {
                    try { %s } catch (java.io.IOException e) { continue; }
                } }).start();""".formatted(forge));
        hostile("PrintSolver", """
                var all = new java.io.FileOutputStream(java.io.FileDescriptor.out);
                for (int k = 0; k < 2048; k++) { all.write(new byte[1 << 20]); }""");
        hostile("RewriteSolver", """
                java.nio.file.Files.writeString(java.nio.file.Path.of("%s"), "broken");"""
                .formatted(classes.resolve("VictimSolver.java").toString().replace('\\', '/')));
        hostile("SaysSolver", "if (true) throw new java.io.IOException(\"red \\u001b[31m\\r\\u202e\");");
        write("CheckerSolver", StudentWork.solver("CheckerSolver", "deltaT * dSdt[i]")
                .replace("package exercises", "package particles.teaching.solvers"));
        euler("VictimSolver", "deltaT * dSdt[i]");
        String screen = grade(ExitCode.BAD_INPUT);
        assertEquals(List.of("mark      solver VictimSolver"), screen.lines().filter(line ->
                line.startsWith("mark ")).toList(), screen);
        assertEquals("broken", Files.readString(classes.resolve("VictimSolver.java")), "the attack did take place");
        assertHas(screen, "PrintSolver: wrong. ", "'package exercises;'", "red \ufffd[31m");
        assertFalse(screen.matches("(?s).*[\\p{Cc}\\p{Cf}&&[^\r\n]].*"), screen);
    }

    /** Right as long as it is checked; then it makes half steps. */
    @Tag("slow")
    @Test
    void aClassThatIsOtherwiseOutsideOfTheCheckGetsNoMark() throws Exception {
        String[] names = {"HereSolver", "LaterSolver", "ThrowsSolver", "CountsSolver", "ResetSolver", "ClockSolver"};
        String[] when = {"calls > 0", "calls > 9000", "calls > 9000 && 1 / (calls % 1) > 0", "steps > 1000",
            "sinceReset > 1000", "source.getTime() > 40"};
        for (int k = 0; k < names.length; k++) {
            write(names[k], StudentWork.solver(names[k],
                    "(" + when[k] + " ? 0.5 : 1) * deltaT * dSdt[i]").replaceFirst("\\{\n", """
                    {
                        static int calls;
                        int steps;
                        int sinceReset;
                        @Override
                        public void reset() {
                            sinceReset = 0;
                        }
                        final boolean checked = java.util.Arrays.stream(Thread.currentThread().getStackTrace())
                                .anyMatch(frame -> frame.getClassName().startsWith("particles.teaching."));
                    """).replace("double[] state =", "calls = checked ? 0 : calls + 1; steps++; sinceReset++;\n"
                    + "double[] state ="));
        }
        euler("TrueSolver", "deltaT * dSdt[i]");
        String screen = grade(ExitCode.BAD_INPUT);
        assertEquals(1, screen.lines().filter(line -> line.startsWith("mark ")).count(), screen);
        assertEquals(names.length, screen.split("its steps differ from those in this check").length - 1, screen);
    }

    /** Half a step of Euler, after these statements. */
    private void hostile(String name, String statements) throws Exception {
        write(name, StudentWork.solver(name, "0.5 * deltaT * dSdt[i]")
                .replaceFirst("\\{\n", Matcher.quoteReplacement("{\n    static { try { " + statements
                + " } catch (Exception e) { throw new IllegalStateException(e); } }\n")));
    }

    /** A constant force; in the wrong one, the energy that it declares has the wrong sign. */
    @Tag("slow")
    @Test
    void effectsAreMarkedToo() throws Exception {
        String law = NewClassCommand.NewEffect.SKELETON.replace("NAME", "RightForce")
                .replaceAll("// (?=@|    ret|}\n)", "")
                .replace("return Vector3.ZERO;", "return new Vector3(0, -mass, 0);").replace(
                "return 0.5 * strength * position.dot(position);", "return mass * position.y();");
        write("RightForce", law);
        write("WrongForce", law.replace("RightForce", "WrongForce")
                .replace("return mass * ", "return -mass * "));
        write("HereForce", law.replace("RightForce", "HereForce").replace("-mass", """
                java.util.Arrays.stream(Thread.currentThread().getStackTrace()).anyMatch(frame ->
                        frame.getClassName().startsWith("particles.teaching.")) ? -mass : 0"""));
        String screen = grade(ExitCode.BAD_INPUT, assignment(
                "effects: {RightForce: 1, WrongForce: 1, HereForce: 1, NoForce: 1}"));
        assertHas(screen, "outside this check, or after many calls, its forces differ from those in this",
                "mark      effect RightForce", "no mark   effect WrongForce", "there is no file NoForce.java");
    }

    @Test
    void aSceneOutsideOfTheHandInIsNotRead() throws Exception {
        Path secret = Files.writeString(folder.resolveSibling("secret-of-" + folder.getFileName()), "root: secret");
        OtherSystems.link(folder.resolve("linked.yaml"), secret);
        for (String path : List.of(secret.toString(), "../" + secret.getFileName(), "/etc/shadow", "linked.yaml",
                "a/../linked.yaml")) {
            answer("12: " + path + "\n");
            String screen = grade(ExitCode.BAD_INPUT);
            assertHas(screen, path + ": there is no such file in the hand-in");
            assertFalse(screen.contains("root"), screen);
        }
        Files.delete(folder.resolve("answers.yaml"));
        OtherSystems.link(folder.resolve("answers.yaml"), secret);
        String screen = grade(ExitCode.BAD_INPUT);
        assertTrue(screen.contains("there is no answers.yaml") && !screen.contains("root"), screen);
        Files.delete(secret);
    }

    @Test
    void aBadLineCostsOnlyItsOwnAnswer() throws Exception {
        String right = "2: " + spiral(run(ExitCode.DONE, "exercise", "--number=2", "--student=" + STUDENT), 1);
        for (String bad : List.of("\t3: 5", "3: [1", "3: 'x", "3: 1: 2", "3:5", "3: &a", "%", "3: \0",
                "2: 5")) {
            for (String text : List.of("\u00ef\u00bb\u00bf" + right + "\n" + bad + "\n1: 7 # end", right + "\r\n" + bad
                    + "\r\n")) {
                Files.write(folder.resolve("answers.yaml"), text.getBytes(StandardCharsets.ISO_8859_1));
                String screen = grade(ExitCode.BAD_INPUT);
                assertHas(bad + ": " + screen, "mark      2. Why Euler spirals", "answers.yaml:2:");
                assertEquals(text.contains("1: 7") ? 10 : 11, screen.lines().filter(line ->
                        line.startsWith("missing ")).count(), bad + ": " + screen);
            }
        }
    }

    @Test
    void solversThatAreAskedForHaveToBeThere() throws Exception {
        String screen = grade(ExitCode.BAD_INPUT, assignment("solvers: {HeunSolver: any}"));
        assertHas(screen, "missing   solver HeunSolver" + System.lineSeparator()
                + "            there is no file HeunSolver.java");
        List<String> lines = screen.lines().toList();
        assertTrue(lines.get(0).equals("there is no answers.yaml"), screen);
        assertEquals(1, lines.stream().filter(line -> line.contains("answers.yaml")).count(),
                "it is said once: " + screen);
        assertEquals("missing   1. Three steps of the Euler method", lines.get(1));
        assertEquals("missing   12. Design a scene", lines.get(12));
        assertTrue(Files.exists(folder.resolve("report/grade.md")), "who hands in nothing gets a report too");
    }

    /** What gradeClass cannot read has no marks here either, so that a student sees it before the hand-in. */
    @Test
    void aDamagedFileCostsTheMarksAsInAClass() throws Exception {
        String assignment = assignment("exercises: {2: 1}\nsolvers: {}\n");
        answer("2: " + spiral(run(ExitCode.DONE, "exercise", "--number=2", "--student=" + STUDENT), 1));
        assertHas(grade(ExitCode.DONE, assignment), "1 of 1 points");
        Path handIn = Files.createDirectories(folder.resolve("build/class")).resolve(STUDENT);
        Files.createDirectory(handIn);
        Files.copy(folder.resolve("answers.yaml"), handIn.resolve("answers.yaml"));
        for (Path place : List.of(folder, handIn)) {
            Files.writeString(place.resolve("work.zip"), "no zip");
        }
        String screen = grade(ExitCode.BAD_INPUT, assignment);
        assertTrue(screen.matches("cannot be read: " + STUDENT + ", work[.]zip: .*\\R"), screen);
        assertHas(Files.readString(folder.resolve("report/grade.json")), "\"status\": \"error\"", "\"tests\": []");
        assertHas(Screen.of(ExitCode.DONE, List.of(new GradeClassCommand()), OptionStyle.GRADLE, "gradeClass",
                "--folder=" + handIn.getParent(), "--out=" + folder.resolve("marks"), assignment), screen.strip());
    }

    /** A student may put a result where grade writes its own. */
    @Test
    void aResultThatIsThereAlreadyIsNotTaken() throws Exception {
        String assignment = assignment("exercises: {1: 1}\nsolvers: {}\n");
        answer("1: 7\n");
        grade(ExitCode.BAD_INPUT, assignment);
        Path made = folder.resolve("report/grade.json");
        Files.writeString(made, Files.readString(made).replace("\"fail\"", "\"pass\""));
        assertHas(grade(ExitCode.BAD_INPUT, assignment), "no mark   1. ");
    }

    /** Right solvers get no mark where another method is asked for. */
    @Tag("slow")
    @Test
    void aSolverHasToBeTheMethodThatIsAskedFor() throws Exception {
        for (String name : List.of("ASolver", "BSolver", "CSolver")) {
            euler(name, "deltaT * dSdt[i]");
        }
        String screen = grade(ExitCode.BAD_INPUT, assignment("""
                exercises: {2: 3}
                solvers:
                  ASolver: euler
                  BSolver: {method: heun, weight: 4}
                  CSolver: {weight: 0.5}
                """));
        assertHas(screen, "mark      solver ASolver", "no mark   solver BSolver", "PROMISE, name: ",
                "mark      solver CSolver");
        assertTrue(screen.contains("1.5 of 8.5 points") && !screen.contains("12. Design"), screen);
    }

    /** adams and others of the catalogue are no methods that can be asked for. */
    @ParameterizedTest
    @CsvSource(delimiter = '|', quoteCharacter = '`', textBlock = """
            solver: {A: heun}              | :1:1: unknown key 'solver'; did you mean 'solvers'?
            solvers: {A: huen}             | :1:14: unknown method 'huen'; did you mean 'heun'? known: ab2, ab3, ab4, \
            adaptive, backward-euler, bdf2, bdf3, euler, heun, implicit-midpoint, kutta3, midpoint, multistep, \
            ralston, rk2, rk3, rk38, rk4, rk45, rk5, symplectic-euler, trapezoidal, verlet, yoshida4, any<end>
            solvers: {A: }                | :1:13: 'A' is nothing; it has to be one of
            solvers: {A: {method: adams}}  | :1:23: unknown method 'adams'; known: ab2, ab3,
            exercises: {13: 1}             | :1:13: a key of 'exercises' is 13; it has to be a whole number from 1 to 12
            exercises: {1: -2}             | :1:16: '1' is -2; it has to be
            effects: {my force: 1}         | :1:11: a key of 'effects' is the text 'my force'; it has
            effects: {A: 1, A: 2}          | :1:17: 'A' appears twice in 'effects'
            numbers: all                   | :1:10: unknown choice
            x                              | :1:1: the assignment is the text 'x'; it has to be
            numbers: [                     | :1:
            """)
    void aMistakeInTheAssignmentIsOneLineWithItsPlace(String text, String problem) throws Exception {
        String screen = grade(ExitCode.BAD_INPUT, assignment(text));
        assertHas(screen.strip() + "<end>", "assignment.yaml" + problem);
        assertEquals(1, screen.strip().lines().count(), screen);
    }

    @Test
    void linesThatAreNoAnswersAreSaid() throws Exception {
        answer("1: [1, 2]\n2:\n13: 5\nx: 1\n1: 3\n");
        String screen = grade(ExitCode.BAD_INPUT);
        for (String place : List.of(":1:4: '1' is [1, 2]; it has to be the answer", ":2:1: '2' has no value",
                ":3:1: unknown key '13'", ":4:1: unknown key 'x'")) {
            assertHas(screen, "answers.yaml" + place);
        }
    }
}
