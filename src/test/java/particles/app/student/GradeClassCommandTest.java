package particles.app.student;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.charset.StandardCharsets;
import java.nio.file.FileSystem;
import java.nio.file.FileSystems;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.FileTime;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import particles.app.cli.ExitCode;
import particles.app.cli.OptionStyle;
import particles.app.cli.Program;
import particles.teaching.exercises.Exercises;
import particles.teaching.marking.Draw;
import particles.teaching.marking.NumericExercise;

/** A class is marked as each student is alone, and one bad hand-in spoils only itself. */
class GradeClassCommandTest {
    private static final String EULER = """
            package exercises;

            public class MySolver extends deSolvers.DESolver {
                @Override
                public void stepState(deSolvers.DEStateSource source, double deltaT) {
                    double[] state = new double[source.getStateSize()];
                    double[] dSdt = new double[source.getStateSize()];
                    source.getState(state);
                    source.getStateDerivative(dSdt);
                    for (int i = 0; i < state.length; i++) {
                        state[i] += deltaT * dSdt[i];
                    }
                    source.setState(state);
                    source.incTime(deltaT);
                }
            }
            """;
    private static final String CALLS = EULER.replaceFirst("(?s)double.. state.*incTime.deltaT.;",
            "new deSolvers.RK4Solver().stepState(source, deltaT);");

    @TempDir
    private Path folder;

    private String mark(ExitCode expected, Path list) {
        StringWriter out = new StringWriter();
        PrintWriter both = new PrintWriter(out);
        assertEquals(expected, new Program(List.of(new GradeClassCommand()), OptionStyle.GRADLE, both, both)
                .execute("gradeClass", "--folder=" + folder.resolve("in"), "--out=" + folder.resolve("out"),
                "--students=" + list, "--solvers=MySolver"), out.toString());
        return out.toString();
    }

    private Path handIn(String name, String... namesAndTexts) throws Exception {
        Path root = folder.resolve("in").resolve(name);
        for (int k = 0; k < namesAndTexts.length; k += 2) {
            Path file = root.resolve(namesAndTexts[k]);
            Files.createDirectories(file.getParent());
            Files.writeString(file, namesAndTexts[k + 1]);
        }
        return root;
    }

    private static String answer(String student) {
        NumericExercise second = (NumericExercise) Exercises.all().get(1);
        return "2: " + second.question(new Draw(student, 2)).answer() + "\n";
    }

    private List<String> rows(String student) throws Exception {
        return Files.readString(folder.resolve("out/class.csv")).lines().filter(line -> line.startsWith(student + ","))
                .toList();
    }

    private void points(int expected, String student) throws Exception {
        assertEquals(expected, rows(student).stream().filter(line -> line.matches("\\w+,(\"[^\"]*\"|[^,]*),1,.*"))
                .count(), student + rows(student));
    }

    @Tag("slow")
    @Test
    void eachStudentGetsHisOwnMarks() throws Exception {
        handIn("Ann Lee_101_assignsubmission_file_", "MySolver.java", EULER, "answers.yaml", answer("s1"));
        handIn("Bob_102_assignsubmission_file_", "sub/answers.yaml", "2: 1\n\t3: 4\n12: no.yaml\n", "sub/MySolver.java",
                EULER.replace("deltaT * ", "0.5 * deltaT * "));
        handIn("hw1-carl", "src/main/java/exercises/MySolver.java", EULER.replace("dSdt", "slope") + "// mine\n",
                "src/main/java/particles/Cheat.java", "package particles; class Cheat { }", "answers.yaml",
                answer("carl"));
        handIn("hw1-dora", "MySolver.java", EULER.replace("incTime(", "incTime)"));
        handIn("hw1-eve", "MySolver.java", CALLS);
        handIn("hw1-loop", "MySolver.java", EULER.replace("source.setState(state);", "while (deltaT != 0) { }"));
        Path zip = folder.resolve("in/Fay_103_assignsubmission_file_.zip");
        try (FileSystem in = FileSystems.newFileSystem(zip, Map.of("create", "true"))) {
            Files.writeString(in.getPath("/answers.yaml"), answer("s3"));
        }
        Files.writeString(folder.resolve("in/broken.zip"), "no zip");
        Files.setLastModifiedTime(handIn("Fay_103_assignsubmission_file_old", "answers.yaml", "2: 1\n")
                .resolve("answers.yaml"), FileTime.fromMillis(0));
        Path list = Files.writeString(folder.resolve("list.csv"), "\ufeffid,name\ns1,\"Ann Lee\"\ns2;102\ns3,Fay\n"
                + "carl\ndora\neve\nloop\nnobody,No Body\n");
        String screen = mark(ExitCode.DONE, list);
        points(2, "s1");
        points(0, "s2");
        points(1, "s3");
        points(2, "carl");
        points(0, "dora");
        points(1, "eve");
        points(0, "loop");
        points(0, "nobody");
        assertTrue(screen.contains("broken.zip cannot be read") && screen.contains("nothing was handed in by nobody"),
                screen);
        String html = Files.readString(folder.resolve("out/class.html"));
        assertTrue(html.contains("the same but for names, comments and layout: carl (MySolver), s1 (MySolver)"), html);
        assertTrue(html.contains("uses a solver of the project: eve (MySolver)"), html);
        assertFalse(html.contains("project: s1"), html);
        String own = Files.readString(folder.resolve("out/s2/grade.md"));
        assertTrue(own.contains("\nanswers.yaml:2:")
                && own.contains("| no.yaml: there is no such file")
                && !own.contains("s1") && !own.contains("desolver-class"), own);
    }

    @Test
    void aLinkInAHandInIsNotFollowed() throws Exception {
        Path secret = Files.writeString(folder.resolve("secret.yaml"), "2: 1\n");
        Path root = Files.createDirectories(folder.resolve("in/one"));
        Files.createSymbolicLink(root.resolve("answers.yaml"), secret);
        Files.createSymbolicLink(root.resolve("MySolver.java"), secret);
        Submission read = Submission.read(root);
        assertEquals(Map.of(), read.files());
        Path zip = folder.resolve("slip.zip");
        try (FileSystem in = FileSystems.newFileSystem(zip, Map.of("create", "true"))) {
            Files.writeString(in.getPath("/answers.yaml"), "1: 1\n");
            Files.writeString(in.getPath("/xx_evil.yaml"), "1: 1\n");
        }
        byte[] bytes = new String(Files.readAllBytes(zip), StandardCharsets.ISO_8859_1).replace("xx_evil", "../evil")
                .getBytes(StandardCharsets.ISO_8859_1);
        Files.write(zip, bytes);
        try {
            Submission.read(zip).copyAnswers(Files.createDirectories(folder.resolve("copy")));
        } catch (java.io.IOException refused) {
            assertTrue(refused.getMessage().contains(".."), refused.getMessage());
        }
        assertFalse(Files.exists(folder.resolve("evil.yaml")), "a zip writes only below its copy");
    }

    @Test
    void onlyNamesCommentsAndLayoutMakeNoDifference() {
        String other = EULER.replace("dSdt", "slope").replace("MySolver", "YourSolver").replace("\n", "\n // x\n")
                .replace("package exercises;", "package exercises; import java.util.List;");
        assertEquals(Copies.shape(EULER), Copies.shape(other));
        assertNotEquals(Copies.shape(EULER), Copies.shape(EULER.replace("i++", "++i")));
        String skeleton = SolverSkeleton.solver("HeunSolver", SolverSkeleton.SLIDES_WAY);
        assertEquals(List.of(), Copies.toLookAt(Map.of("a", Map.of("HeunSolver", skeleton), "b",
                Map.of("HeunSolver", skeleton))));
    }

    @Test
    void aFolderThatIsNotThereIsToldAsSuch() {
        assertTrue(mark(ExitCode.BAD_INPUT, folder).contains("option -Pfolder: "));
    }
}
