package particles.app.student;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import javax.xml.parsers.DocumentBuilderFactory;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.w3c.dom.Element;
import org.w3c.dom.NodeList;
import particles.app.cli.ExitCode;
import particles.app.cli.OptionStyle;
import particles.app.cli.Program;
import particles.app.cli.ProgramCommand;
import particles.teaching.exercises.Exercises;

/** The exercises through the program: the list, a text, a mark,
        and a grade with its report for people and for autograders. */
class GradeCommandTest {
    private static final String STUDENT = "s-123";
    private static final String EULER = """
            package exercises;

            public class %s extends deSolvers.DESolver {
                @Override
                public void stepState(deSolvers.DEStateSource source, double deltaT) {
                    double[] state = new double[source.getStateSize()];
                    double[] dSdt = new double[source.getStateSize()];
                    source.getState(state);
                    source.getStateDerivative(dSdt);
                    for (int i = 0; i < state.length; i++) {
                        state[i] += %s;
                    }
                    source.setState(state);
                    source.incTime(deltaT);
                }
            }
            """;

    @TempDir
    private Path folder;
    private Path classes;

    @BeforeEach
    void makeFolders() throws Exception {
        classes = Files.createDirectories(folder.resolve("exercises"));
    }

    private String run(ExitCode expected, String... args) {
        StringWriter out = new StringWriter();
        PrintWriter both = new PrintWriter(out);
        List<ProgramCommand> commands = List.of(new ExercisesCommand(),
                new ExerciseCommand(),
                new GradeCommand(classes));
        assertEquals(expected, new Program(commands, OptionStyle.GRADLE, both, both).execute(args), out.toString());
        return out.toString();
    }

    private String grade(ExitCode expected, String... more) {
        List<String> args = new ArrayList<>(List.of("grade", "--student=" + STUDENT, "--answers="
                + folder.resolve("answers.yaml"), "--out=" + folder.resolve("report")));
        args.addAll(List.of(more));
        return run(expected, args.toArray(new String[0]));
    }

    @Test
    void theListHasTwelve() {
        assertEquals(13, run(ExitCode.DONE, "exercises").lines().count());
        assertTrue(run(ExitCode.DONE, "exercises").contains(" 5  What midpoint costs against RK4"));
    }

    @Test
    void anExerciseIsShownAndMarked() {
        String text = run(ExitCode.DONE, "exercise", "--number=2", "--student=" + STUDENT);
        assertTrue(text.startsWith("2. Why Euler spirals") && text.contains("Give four significant digits"), text);
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
        for (String none : List.of("0", "13", "two", "-1", "2.0", "")) {
            assertTrue(run(ExitCode.BAD_INPUT, "exercise", "--number=" + none,
                    "--student=a").startsWith("option -Pnumber: '" + none + "' is not an exercise"), none);
        }
        assertEquals("option -Pstudent: the id is empty", run(ExitCode.BAD_INPUT, "exercise", "--number=1",
                "--student= ").strip());
        assertEquals("option -Pstudent: the id is empty", run(ExitCode.BAD_INPUT, "grade", "--student= ").strip());
    }

    @Tag("slow")
    @Test
    void everyAnswerAndSolverGetsItsMark() throws Exception {
        String text = run(ExitCode.DONE, "exercise", "--number=2", "--student=" + STUDENT);
        Files.writeString(folder.resolve("answers.yaml"), "# mine\n1: NaN\n2: " + spiral(text, 1)
                + "\n3: 0,5 kg\n12: no <such> & scene.yaml\n");
        Files.writeString(classes.resolve("GoodSolver.java"), EULER.formatted("GoodSolver", "deltaT * dSdt[i]"));
        Files.writeString(classes.resolve("WrongSolver.java"),
                EULER.formatted("WrongSolver", "0.5 * deltaT * dSdt[i]"));
        Files.writeString(classes.resolve("BrokenSolver.java"), EULER.formatted("BrokenSolver", "deltaT * dSdx[i]"));
        String screen = grade(ExitCode.BAD_INPUT);
        assertTrue(screen.contains("2 of 15 marks for " + STUDENT), screen);
        assertEquals(8, screen.lines().filter(line -> line.startsWith("missing   ")).count(), screen);
        assertTrue(screen.strip().endsWith("13 marks are missing"), screen);

        String report = Files.readString(folder.resolve("report/grade.md"));
        assertTrue(report.contains("| 2. Why Euler spirals: the energy that steps add | 1 | This is right. |"), report);
        assertTrue(report.contains("| 1. Three steps of the Euler method | 0 | 'NaN' is no finite number"), report);
        assertTrue(report.contains("'kg' after the number is not understood: the answer is wanted in m/s"), report);
        assertTrue(report.contains("| solver GoodSolver | 1 | GoodSolver: right. This is the Euler method."), report);
        assertTrue(report.contains(
                "| solver BrokenSolver | 0 | exercises.BrokenSolver: it cannot be checked. WRONG, failure: "), report);
        assertTrue(report.contains(
                "WRONG, failure: it does not compile: BrokenSolver.java:11: cannot find symbol: variable dSdx"),
                report);
        assertTrue(report.contains("| solver WrongSolver | 0 | WrongSolver: "), report);
        assertEquals(Exercises.all().size() + 3,
                report.lines().filter(line -> line.matches("\\| .* \\| [01] \\| .*")).count());

        Element suite = DocumentBuilderFactory.newInstance().newDocumentBuilder()
                .parse(folder.resolve("report/TEST-grade.xml").toFile()).getDocumentElement();
        assertEquals("testsuite", suite.getTagName());
        assertEquals("15", suite.getAttribute("tests"));
        assertEquals("13", suite.getAttribute("failures"));
        NodeList cases = suite.getElementsByTagName("testcase");
        assertEquals(15, cases.getLength());
        assertEquals(13, suite.getElementsByTagName("failure").getLength());
        Element last = (Element) cases.item(11);
        assertEquals("12. Design a scene", last.getAttribute("name"));
        assertTrue(((Element) last.getElementsByTagName("failure").item(0)).getAttribute("message")
                .contains("no <such> & scene.yaml"));
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
        Files.writeString(classes.resolve("HaltSolver.java"), PRANK.formatted("HaltSolver", "HaltSolver"));
        String screen = grade(ExitCode.BAD_INPUT);
        assertTrue(screen.contains("no mark   solver HaltSolver" + System.lineSeparator()
                + "            wrong: the check did not finish; the class ended the program"), screen);
        assertTrue(screen.contains("0 of 13 marks"), screen);
    }

    @Test
    void onlyLinesWithTheNumberOfThisRunCount() {
        List<String> fake = List.of("5 DONE", "DONE", " DONE", "17", "17DONE");
        assertEquals(ExitCode.BAD_INPUT, StudentProcess.outcome(fake, "17").code());
        assertEquals(new StudentProcess.Outcome(ExitCode.DONE, List.of("a line")),
                StudentProcess.outcome(List.of("noise", "17 a line", "5 BAD_INPUT", "17 DONE", "noise"), "17"));
        assertEquals(ExitCode.BAD_INPUT, StudentProcess.outcome(List.of("17 DONE", "17 a line"), "17").code(),
                "not the last");
    }

    @Test
    void solversThatAreAskedForHaveToBeThere() {
        String screen = grade(ExitCode.BAD_INPUT, "--solvers=exercises.HeunSolver");
        assertTrue(screen.contains("no mark   solver HeunSolver" + System.lineSeparator()
                + "            there is no file HeunSolver.java"), screen);
        List<String> lines = screen.lines().toList();
        assertTrue(lines.get(0).endsWith("answers.yaml: there is no such file"), screen);
        assertEquals(1, lines.stream().filter(line -> line.contains("answers.yaml")).count(),
                "it is said once: " + screen);
        assertEquals("missing   1. Three steps of the Euler method", lines.get(1));
        assertEquals("missing   12. Design a scene", lines.get(12));
        assertTrue(Files.exists(folder.resolve("report/TEST-grade.xml")), "who hands in nothing gets a report too");
    }

    @Test
    void linesThatAreNoAnswersAreSaid() throws Exception {
        Files.writeString(folder.resolve("answers.yaml"), "1: [1, 2]\n2:\n13: 5\nx: 1\n1: 3\n");
        String screen = grade(ExitCode.BAD_INPUT);
        for (String place : List.of(":1:4: '1' is [1, 2]; it has to be the answer", ":2:1: '2' has no value",
                ":3:1: unknown key '13'", ":4:1: unknown key 'x'", ":5:1: '1' appears twice")) {
            assertTrue(screen.contains("answers.yaml" + place), screen);
        }
    }
}
