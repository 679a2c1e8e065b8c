package particles.app.course;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static particles.Texts.assertHas;
import static particles.app.course.StudentWork.answer;

import java.nio.file.FileSystem;
import java.nio.file.FileSystems;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.FileTime;
import java.time.Instant;
import java.util.List;
import java.util.Map;
import java.util.stream.Stream;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import particles.app.cli.ExitCode;
import particles.app.cli.OptionStyle;
import particles.app.cli.Screen;

/** A class is marked as each student is alone, and one bad hand-in spoils only itself. */
class GradeClassCommandTest {
    private static final String EULER = StudentWork.euler();

    @TempDir
    private Path folder;

    private String mark(ExitCode expected, Path list) {
        return grade(expected, options("--folder=" + folder.resolve("in"), "--students=" + list));
    }

    @BeforeEach
    void writeAssignment() throws Exception {
        assign("solvers: {MySolver: any}\n");
    }

    private void assign(String text) throws Exception {
        Files.writeString(folder.resolve("assignment.yaml"), text);
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

    private List<String> rows(String student) throws Exception {
        return made("class.csv").lines().filter(line -> line.startsWith(student + ","))
                .toList();
    }

    private String made(String name) throws Exception {
        return Files.readString(folder.resolve("out").resolve(name));
    }

    /** The cells of a student in the table of students, with the columns that are not empty. */
    private List<String> cells(String student, String... columns) {
        List<List<String>> table = ClassList.rows(folder.resolve("out/students.csv"));
        return table.stream().filter(row -> row.contains(student)).flatMap(row -> Stream.of(columns).map(column ->
                row.get(table.get(0).indexOf(column)))).toList();
    }

    private void points(int expected, String student) {
        assertEquals(List.of(expected + ".0"), cells(student, "points"), student);
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
        handIn("hw1-loop", "MySolver.java", EULER.replace("source.setState(state);", "while (deltaT != 0) { }"));
        Path zip = folder.resolve("in/Fay_103_assignsubmission_file_.zip");
        try (FileSystem in = FileSystems.newFileSystem(zip, Map.of("create", "true"))) {
            Files.writeString(in.getPath("/answers.yaml"), answer("s3"));
        }
        Files.writeString(folder.resolve("in/broken.zip"), "no zip");
        Files.setLastModifiedTime(handIn("Fay_103_assignsubmission_file_old", "answers.yaml", "2: 1\n")
                .resolve("answers.yaml"), FileTime.fromMillis(0));
        Path list = Files.writeString(folder.resolve("list.csv"), "\ufeffid,name\ns1,\"Ann Lee\"\ns2,102\ns3,Fay\n"
                + "carl\ndora\nloop\nnobody,No Body\n");
        String screen = mark(ExitCode.DONE, list);
        points(2, "s1");
        points(0, "s2");
        points(1, "s3");
        points(2, "carl");
        points(0, "dora");
        points(0, "loop");
        points(0, "nobody");
        assertHas(screen, "whose?: broken", "nothing handed in: nobody");
        String own = made("Bob_102_assignsubmission_file_/grade.md");
        assertTrue(own.contains("\nsub/answers.yaml:2:")
                && own.contains("| no.yaml: there is no such file")
                && !own.contains("s1") && !own.contains("desolver-class"), own);
    }

    private String gradeAll(String... more) {
        return grade(ExitCode.DONE, options(Stream.concat(Stream.of("--folder=" + folder.resolve("in")),
                Stream.of(more)).toArray(String[]::new)));
    }

    private String grade(ExitCode expected, String... options) {
        return Screen.of(expected, List.of(new GradeClassCommand(), new GradeCommand(folder)), OptionStyle.GRADLE,
                options);
    }

    private String[] options(String... more) {
        return Stream.concat(Stream.of("gradeClass", "--out=" + folder.resolve("out"), "--assignment="
                + folder.resolve("assignment.yaml")), Stream.of(more)).toArray(String[]::new);
    }

    private void dated(String name, String time, String answers) throws Exception {
        Files.setLastModifiedTime(handIn(name, "answers.yaml", answers).resolve("answers.yaml"),
                FileTime.from(Instant.parse(time)));
    }

    /** Three hand-ins of one student, the latest one right. */
    @Test
    void theLatestHandInCounts() throws Exception {
        assign("""
                exercises: {2: 2}
                solvers: {}
                """);
        dated("Ann_7_assignsubmission_file_a", "2026-03-14T10:00:00Z", "2: 1\n");
        dated("Ann_7_assignsubmission_file_b", "2026-03-14T11:59:59.5Z", answer("7"));
        dated("Ann_7_assignsubmission_file_c", "2026-03-14T09:59:59Z", "2: 1\n");
        gradeAll();
        assertEquals(List.of("2.0", "2.0", "2026-03-14T11:59:59Z", "Ann_7_assignsubmission_file_b"), cells("7",
                "points", "of", "latest file", "hand-in"));
    }

    @Test
    void whatAStudentWritesBreaksNoTable() throws Exception {
        assign("exercises: {2: 1}\nsolvers: {NoSolver: heun}\n");
        handIn("hw1-bob", "answers.yaml", "2: x \u00e9 \ud83d\ude00 \\ \"\n3: 1\n\t4: 2\n");
        handIn("=1+1", "answers.yaml", "2: 7");
        gradeAll();
        assertHas(made("class.csv"), "\n'=1+1,");
        Result bob = Result.read(folder.resolve("out/hw1-bob/grade.json")).orElseThrow();
        assertHas(bob.tests().get(0).message(), "x \u00e9 \ud83d\ude00 \\ \"");
        grade(ExitCode.DONE, "gradeClass", "--collect=" + folder.resolve("out"), "--out=" + folder.resolve("again"),
                "--assignment=" + folder.resolve("assignment.yaml"));
        assertEquals(made("class.csv"), Files.readString(folder.resolve("again/class.csv")));
    }

    @Test
    void aPartOrASourceThatIsNoneIsRefused() {
        for (String part : List.of("0/3", "4/3", "1", "1/0", "a/b", "1/2/3", "99999999999/1")) {
            assertHas(grade(ExitCode.BAD_INPUT, options("--folder=" + folder, "--part=" + part)), "option -Ppart");
        }
        assertHas(grade(ExitCode.BAD_INPUT, options("--collect=" + folder, "--part=1/2")),
                "option -Ppart: is for marking");
        assertHas(grade(ExitCode.BAD_INPUT, options()), "option -Pfolder needs a value");
        assertHas(grade(ExitCode.BAD_INPUT, options("--folder=a", "--collect=b")), "mutually exclusive");
    }

    /** After a stop those who are marked stay so; what changed is marked again. */
    @Test
    void onlyHandInsThatChangedAreMarkedAgain() throws Exception {
        assign("exercises: {2: 1}\nsolvers: {}\n");
        for (String name : List.of("a", "b", "c", "d")) {
            handIn(name, "answers.yaml", answer(name));
        }
        gradeAll();
        for (String name : List.of("a", "b", "c", "d")) {       // a mark that only a new marking would change
            Path result = folder.resolve("out").resolve(name).resolve("grade.json");
            Files.writeString(result, Files.readString(result).replace("\"pass\"", name.equals("d") ? "\"error\""
                    : "\"fail\"").replace("\"score\": 1.0", "\"score\": 0.0").replace("This is right.", "kept"));
        }
        Files.setLastModifiedTime(folder.resolve("in/a/answers.yaml"), FileTime.fromMillis(0));     // as a new clone
        handIn("b", "answers.yaml", answer("b") + "# changed\n");
        Files.writeString(folder.resolve("out/c/grade.json"), "damaged");
        gradeAll();
        for (String name : List.of("a", "b", "c", "d")) {
            assertTrue(rows(name).get(0).contains(name.equals("a") ? ",0.0,1.0,kept" : ",1.0,1.0"), rows(name)
                    .toString());
        }
        assign("exercises: {2: 2}\nsolvers: {}\n");
        gradeAll();
        assertTrue(rows("a").get(0).contains(",2.0,2.0"), "another assignment: " + rows("a"));
    }

    /** A folder in the place of a report, or a hand-in that another one deletes, costs nobody a mark. */
    @Tag("slow")
    @Test
    void whatAClassDoesToFilesStopsNobody() throws Exception {
        String plant = """
                static {
                    for (String name : new String[] {"/zoe/grade.json/x", "/zoe/grade.md/x"}) {
                        new java.io.File("%s/out" + name).mkdirs();
                    }
                    new java.io.File("%s/in/zoe/answers.yaml").delete();
                }
                """.replace("%s", folder.toString());
        handIn("ann", "MySolver.java", EULER.replaceFirst("\\{\n", "{\n" + plant));
        handIn("zoe", "answers.yaml", answer("zoe"));
        gradeAll();
        assertFalse(Files.exists(folder.resolve("in/zoe/answers.yaml")), "the attack did take place");
        points(1, "zoe");
        points(1, "ann");
        assertHas(made("ann/grade.md"), "1 of 13 points for ann");
    }

    @Test
    void aFolderThatIsNotThereIsToldAsSuch() throws Exception {
        Path list = Files.writeString(folder.resolve("list.csv"), "id\n");
        assertHas(mark(ExitCode.BAD_INPUT, list), "option -Pfolder: ");
    }
}
