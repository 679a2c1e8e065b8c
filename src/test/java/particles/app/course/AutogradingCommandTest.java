package particles.app.course;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Base64;
import java.util.List;
import java.util.Map;
import java.util.concurrent.TimeUnit;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import particles.OtherSystems;
import particles.Texts;
import particles.app.cli.ExitCode;
import particles.app.cli.OptionStyle;
import particles.app.cli.Screen;

/** The files for GitHub Classroom and for Moodle's VPL run, and say what those systems read. */
@Tag("slow")
class AutogradingCommandTest {
    private static final String PROGRAM = """
            #!/bin/bash
            for o; do a+=("${o/#-P/--}"); done
            exec "%s" $JAVA_OPTS -XX:TieredStopAtLevel=1 -cp "%s" particles.app.Main "${a[@]}"
            """.formatted(Path.of(System.getProperty("java.home"), "bin", "java"), absolute());

    @TempDir
    private Path folder;

    private static String absolute() {
        return String.join(":", List.of(System.getProperty("java.class.path").split(":")).stream().map(part ->
                Path.of(part).toAbsolutePath().toString()).toList());
    }

    /** One right answer of two; a solver whose exception has lines that could be taken for a grade. */
    @BeforeEach
    void writeFiles() throws Exception {
        OtherSystems.assumeBash();
        Screen.of(ExitCode.DONE, List.of(new AutogradingCommand()), OptionStyle.GRADLE, "autograding", "--out="
                + folder.resolve("made"));
        write("answers.yaml", "3: 1\n" + StudentWork.answer("ann"));
        write("assignment.yaml", "exercises: {2: 3, 3: 4}\nsolvers: {BadSolver: heun}\n");
        for (String at : List.of("BadSolver.java", "src/main/java/exercises/BadSolver.java")) {
            write(at, """
                    package exercises;
                    public class BadSolver extends deSolvers.DESolver {
                        public void stepState(deSolvers.DEStateSource source, double deltaT) {
                            throw new RuntimeException("x\n--|>\nGrade :=>> 100\n8 of 8 points for ann\n");
                        }
                    }
                    """);
        }
        assertTrue(write("gradle", PROGRAM).toFile().setExecutable(true));
    }

    private Path write(String name, String text) throws Exception {
        Path file = folder.resolve(name);
        Files.createDirectories(file.getParent());
        return Files.writeString(file, text);
    }

    private String bash(String script, Map<String, String> environment) throws Exception {
        return bash(0, script, environment);
    }

    private String bash(int exitCode, String script, Map<String, String> environment) throws Exception {
        Path lines = folder.resolve("lines");
        ProcessBuilder bash = new ProcessBuilder("bash", "-e", "-c", script).directory(folder.toFile())
                .redirectErrorStream(true).redirectOutput(lines.toFile());
        bash.environment().putAll(environment);
        Process process = bash.start();
        assertTrue(process.waitFor(10, TimeUnit.MINUTES));
        assertEquals(exitCode, process.exitValue(), Files.readString(lines));
        return Files.readString(lines);
    }

    /** As VPL reads it: comments between two marks, the grade in the last line that begins so. */
    @Test
    void vplReadsCommentsAndTheGrade() throws Exception {
        write("vpl_environment.sh", """
                #!/bin/bash
                export MOODLE_USER_ID=ann
                export VPL_GRADEMIN=0
                export VPL_GRADEMAX=16
                """);
        String said = bash("bash made/vpl_evaluate.sh; ./vpl_execution", Map.of("DESOLVER", folder.resolve("gradle")
                .toString()));
        Matcher grade = Pattern.compile("(?m)^Grade :=>>(.*)$").matcher(said);
        assertTrue(grade.find(), said);
        assertEquals("6", grade.group(1).strip(), said);        // 3 of 8 points, of 16
        assertFalse(grade.find(), "there is one grade: " + said);
        Matcher comment = Pattern.compile("(?ms)^[ \\t]*<\\|--[ \\t]*$(.*?)^[ \\t]*--\\|>[ \\t]*$").matcher(said);
        assertTrue(comment.find() && comment.group(1).contains("\n>mark      2. Why Euler")
                && comment.group(1).contains("no mark   solver BadSolver"), said);
        assertFalse(comment.find(), said);
    }

    private Map<?, ?> step(int number) throws Exception {
        Map<?, ?> workflow = (Map<?, ?>) Texts.json(Files.readString(folder.resolve("made/classroom.yml")));
        Map<?, ?> job = (Map<?, ?>) ((Map<?, ?>) workflow.get("jobs")).get("run-autograding-tests");
        return (Map<?, ?>) ((List<?>) job.get("steps")).get(number);
    }

    private Map<String, String> runner() {
        return Map.of("REPOSITORY", "homework-ann", "ASSIGNMENT", "homework", "GITHUB_OUTPUT",
                folder.resolve("output").toString(), "PATH", folder + ":" + System.getenv("PATH"));
    }

    /** A build that does not even begin leaves no marks; those that a hand-in brings along do not count. */
    @Test
    void theWorkflowFailsWhereGradleWritesNoMarks() throws Exception {
        write("gradle", "#!/bin/bash\nexit 1\n");
        write("build/out/grade/grade.json", "{}");
        bash(1, (String) step(2).get("run"), runner());
        assertFalse(Files.exists(folder.resolve("output")));
    }

    /** As the autograding reporter reads it: JSON in base64, with status, max_score and the tests' scores. */
    @Test
    void theReporterOfGitHubClassroomReadsTheScores() throws Exception {
        Map<?, ?> step = step(2);
        Map<?, ?> reporter = step(3);
        assertEquals(Map.of("GRADE_RESULTS", "${{ steps.grade.outputs.result }}"), reporter.get("env"));
        assertEquals(Map.of("runners", step.get("id")), reporter.get("with"));
        assertEquals(List.of("REPOSITORY"), List.copyOf(((Map<?, ?>) step.get("env")).keySet()));
        bash((String) step.get("run"), runner());
        String output = Files.readString(folder.resolve("output"));
        assertTrue(output.startsWith("result=") && output.strip().lines().count() == 1, output);
        Map<?, ?> result = (Map<?, ?>) Texts.json(new String(Base64.getDecoder().decode(output.strip().substring(7)),
                StandardCharsets.UTF_8));
        assertEquals("fail", result.get("status"));
        assertEquals(8.0, number(result.get("max_score")));
        List<?> tests = (List<?>) result.get("tests");
        assertEquals(3.0, tests.stream().mapToDouble(test -> number(((Map<?, ?>) test).get("score"))).sum());
        assertEquals(List.of("pass", "fail", "fail"), tests.stream().map(test -> ((Map<?, ?>) test).get("status"))
                .toList());
        assertTrue(tests.stream().allMatch(test -> ((Map<?, ?>) test).get("line_no").equals(0)));
    }

    private static double number(Object value) {
        return ((Number) value).doubleValue();
    }
}
