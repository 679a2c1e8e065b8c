package particles.app.course;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static particles.Texts.assertHas;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.charset.Charset;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.text.Normalizer;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Set;
import java.util.TreeMap;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import java.util.zip.GZIPOutputStream;
import java.util.zip.ZipEntry;
import java.util.zip.ZipOutputStream;
import org.apache.commons.compress.archivers.tar.TarArchiveEntry;
import org.apache.commons.compress.archivers.tar.TarArchiveOutputStream;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.TestInstance;
import org.junit.jupiter.api.io.TempDir;
import particles.app.cli.ExitCode;
import particles.app.cli.OptionStyle;
import particles.app.cli.Screen;
import particles.output.files.OutputFolder;

/** A class of a hundred as Moodle and GitHub Classroom lay it out, with real names, files and mistakes of packing. */
@TestInstance(TestInstance.Lifecycle.PER_CLASS)         // it is marked once
@Tag("slow")
class ClassOfAHundredTest {
    private static final int STUDENTS = 100;
    private static final String EULER = StudentWork.euler();

    @TempDir
    private static Path folder;
    private Path in;
    private Path worksheet;
    private String screen;

    /** The names that matter; all others are called Student and a number. */
    private static String name(int student) {
        return switch (student) {
            case 1, 2 -> "Dora Berg";
            case 3 -> "Zo\u00eb M\u00fcller";
            case 4 -> "Doe, Jane";
            case 5 -> "Eoin O'Brien";
            default -> "Student " + student;
        };
    }

    private static String answers(int student) {
        return StudentWork.answer("s" + student);
    }

    private static byte[] utf8(String text) {
        return text.getBytes(StandardCharsets.UTF_8);
    }

    private void put(String path, byte[] bytes) throws IOException {
        Path file = in.resolve(path);
        Files.createDirectories(file.getParent());
        Files.write(file, bytes);
    }

    /** Moodle's folder of a student, and the name with which all files of its other download begin. */
    private static String moodle(int student) {
        return name(student).replaceAll("[',]", "") + "_" + (1000 + student) + "_assignsubmission_file_";
    }

    private static byte[] zip(Charset names, String name, String text) throws IOException {
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        try (ZipOutputStream zip = new ZipOutputStream(bytes, names)) {
            zip.putNextEntry(new ZipEntry(name));
            zip.write(utf8(text));
        }
        return bytes.toByteArray();
    }

    private static byte[] tar(String name, String text) throws IOException {
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        try (TarArchiveOutputStream tar = new TarArchiveOutputStream(new GZIPOutputStream(bytes))) {
            TarArchiveEntry entry = new TarArchiveEntry(name);
            entry.setSize(utf8(text).length);
            tar.putArchiveEntry(entry);
            tar.write(utf8(text));
            tar.closeArchiveEntry();
        }
        return bytes.toByteArray();
    }

    private void handIn(int student) throws IOException {
        String own = moodle(student) + "/";
        byte[] right = utf8(answers(student));
        switch (student) {
            case 3 -> put(Normalizer.normalize("Zo\u00eb M\u00fcller", Normalizer.Form.NFD) + "/answers.yaml", right);
            case 4 -> put("Jane Doe/answers.yaml", right);
            case 5 -> put("Eoin OBrien_1005_assignsubmission_file_/answers.yaml", right);
            case 6 -> put(own + "work.zip", zip(Charset.forName("IBM437"), "L\u00f6sung/answers.yaml",
                    answers(student)));
            case 7 -> put(own + "work.zip", Arrays.copyOf(zip(StandardCharsets.UTF_8, "answers.yaml", answers(student)
                    .repeat(100)), 60));
            case 8 -> {
                put(moodle(student) + "answers.yaml", right);           // the download without folders
                put(moodle(student) + "MySolver.java", utf8("\ufeff" + EULER));
            }
            case 9 -> put(own + "answers.yml", right);
            case 10 -> put(own + "Answers.yaml", right);
            case 11 -> put(own + "answers.yaml.txt", right);
            case 12 -> put(own + "work.tar.gz", tar("work/answers.yaml", answers(student)));
            case 13 -> put(own + "work.rar", new byte[100]);
            case 14 -> put("homework-s14/answers.yaml", right);         // GitHub Classroom
            case 15 -> put(own + "answers.yaml", ("# gr\u00fc\u00dfe\n" + answers(student).strip()
                    + "   # s\u00fc\u00df\n").getBytes(StandardCharsets.ISO_8859_1));
            case 16 -> put(own + "answers.yaml", ("\ufeff" + answers(student)).getBytes(StandardCharsets.UTF_16LE));
            case 17 -> put(own + "answers.docx", new byte[100]);
            case 18 -> { }                                              // nothing
            case 19 -> {
                put(own + "answers.yaml", right);
                byte[] damaged = zip(StandardCharsets.UTF_8, "MySolver.java", EULER);
                damaged[100] ^= 1;                                      // of the packed bytes
                put(own + "work.zip", damaged);
            }
            case 20 -> {
                put(own + "answers.yml", utf8("2: 1\n"));
                put(own + "answers.yaml", right);
                put(own + "photo.jpg", new byte[100]);
            }
            default -> put(own + "answers.yaml", right);
        }
    }

    private String run(String... options) {
        String[] all = Stream.concat(Stream.of("gradeClass", "--students=" + worksheet, "--assignment="
                + folder.resolve("assignment.yaml")), Stream.of(options)).toArray(String[]::new);
        return Screen.of(ExitCode.DONE, List.of(new GradeClassCommand()), OptionStyle.GRADLE, all);
    }

    @BeforeAll
    void markTheClass() throws Exception {
        in = folder.resolve("in");
        List<String> lines = new ArrayList<>(List.of("Identifier,\"Full name\",\"ID number\",\"Email address\",Status,"
                + "Grade,\"Maximum Grade\",\"Last modified (grade)\",\"Feedback comments\""));
        for (int student = 1; student <= STUDENTS; student++) {
            handIn(student);
            lines.add("\"Participant " + (1000 + student) + "\",\"" + name(student) + "\",s" + student + ",s" + student
                    + "@uni.example,\"Submitted, for grading\",,100.00,-,");
        }
        put("Nobody Known_4711_assignsubmission_file_/answers.yaml", utf8(answers(1)));
        put("Dora Berg/answers.yaml", utf8(answers(1)));                // two have this name
        put("Student 22_1023_assignsubmission_file_/answers.yaml", utf8(answers(22)));      // 1023 is another student
        worksheet = Files.writeString(folder.resolve("worksheet.csv"), "\ufeff" + String.join("\r\n", lines) + "\r\n");
        Files.writeString(folder.resolve("assignment.yaml"), "exercises: {2: 3}\nsolvers: {MySolver: euler}\n");
        screen = run("--folder=" + in, "--out=" + folder.resolve("out"));
    }

    private List<List<String>> table(String name) {
        return ClassList.rows(folder.resolve("out").resolve(name));
    }

    /** The cell of a student in the table of students. */
    private String cell(String student, String column) {
        List<List<String>> rows = table("students.csv");
        return rows.stream().filter(row -> row.get(1).equals(student)).map(row -> row.get(rows.get(0)
                .indexOf(column))).collect(Collectors.joining(" and "));
    }

    private void assertPoints(String expected, int... students) {
        for (int student : students) {
            assertEquals(expected + ".0", cell("s" + student, "points"), "s" + student);
        }
    }

    @Test
    void everyOtherStudentHasTheMark() {
        assertPoints("3", IntStream.rangeClosed(21, STUDENTS).toArray());
        assertEquals(1 + STUDENTS + 3, table("students.csv").size(), "a header, the students, and three of nobody");
    }

    @Test
    void aNumberDecidesBetweenTwoOfOneName() {
        assertPoints("3", 1, 2);
    }

    @Test
    void namesAreTheSameInEachFormOfUnicodeAndOrder() {
        assertPoints("3", 3, 4, 5);
        assertEquals("Doe, Jane", cell("s4", "name"));
    }

    @Test
    void whatIsNobodysIsListedFirstWithoutAMark() {
        List<List<String>> first = table("students.csv").subList(1, 4).stream().map(row -> row.stream().limit(6)
                .toList()).toList();
        assertEquals(Set.of("Dora Berg", "Nobody Known_4711_assignsubmission_file_",
                "Student 22_1023_assignsubmission_file_"), first.stream().map(row -> row.get(1)).collect(Collectors
                .toSet()));
        first.forEach(row -> assertEquals(List.of("whose?", row.get(1), "", "", "", ""), row));
        assertHas(screen, "whose?: Nobody Known_4711");
    }

    @Test
    void aZipWithNamesInACodePageIsRead() {
        assertPoints("3", 6);
        assertEquals(Set.of("L\u00f6sung/answers.yaml"), Submission.read("", List.of(in.resolve(moodle(6)))).files()
                .keySet());
    }

    @Test
    void whatCannotBeReadIsAStateOfItsOwn() {
        for (int student : new int[] {7, 13, 19}) {
            assertEquals(List.of("cannot be read", ""), List.of(cell("s" + student, "state"), cell("s" + student,
                    "points")));
        }
        assertHas(cell("s7", "remarks"), "work.zip: ");
        assertHas(cell("s19", "remarks"), "MySolver.java: invalid ");
        assertHas(cell("s13", "remarks"), "work.rar: only .zip and .tar.gz are read");
        assertEquals("cannot be read", table("students.csv").get(4).get(0), "next after those that are nobody's");
        assertEquals("nothing handed in", cell("s18", "state"));
    }

    @Test
    void theDownloadWithoutFoldersIsRead() {
        assertPoints("4", 8);
    }

    @Test
    void answersUnderSimilarNamesAndInArchivesAreRead() {
        assertPoints("3", 9, 10, 11, 12, 14, 20);
        assertHas(cell("s20", "remarks"), "answers.yml is not read: the answers are in answers.yaml");
        assertFalse(cell("s20", "remarks").contains("photo.jpg"));
        assertPoints("0", 17);
        assertHas(cell("s17", "remarks"), "answers.docx is not read");
    }

    /** A byte order mark in a class (s8), Latin-1 in comments, UTF-16. */
    @Test
    void encodingsCostNothing() {
        assertPoints("4", 8);
        assertPoints("3", 15, 16);
        assertEquals("", cell("s15", "remarks"));
    }

    @Test
    void tablesHaveNamesAddressesAndNumbers() {
        assertEquals(List.of("Zo\u00eb M\u00fcller", "s3@uni.example", "1003"), Stream.of("name", "e-mail",
                "participant").map(column -> cell("s3", column)).toList());
    }

    /** All but the grade is as it was, for Moodle looks at the other columns, too. */
    @Test
    void theWorksheetHasTheGrades() {
        List<List<String>> before = ClassList.rows(worksheet);
        List<List<String>> after = table("worksheet.csv");
        assertEquals(before.size(), after.size());
        for (int row = 0; row < before.size(); row++) {
            List<String> cells = new ArrayList<>(before.get(row));
            cells.set(5, row == 0 ? "Grade" : List.of(7, 13, 18, 19).contains(row) ? "" : row == 8 ? "100.00"
                    : row == 17 ? "0.00" : "75.00");
            assertEquals(cells, after.get(row));
        }
    }

    /** Moodle takes a path apart at its underscores: name, number, assignsubmission, file, and the rest. */
    @Test
    void feedbackIsInFoldersThatMoodleKnows() throws IOException {
        for (String name : List.of("Dora Berg_1002", "Student 8_1008", "Student 100_1100")) {
            String text = Files.readString(folder.resolve("out").resolve(name + "_assignsubmission_file_/grade.md"));
            assertHas(text, (name.contains("8_") ? "4" : "3") + " of 4 points for s", "| 2. Why Euler spirals");
            assertFalse(text.contains(folder.toString()), "no path of the lecturer's machine");
        }
        assertEquals("Student 9_1009_assignsubmission_file_", new Submission("Student 9_1009_assignsubmission_file")
                .folder());
    }

    private TreeMap<String, byte[]> tables(String out) throws IOException {
        TreeMap<String, byte[]> tables = new TreeMap<>();
        for (String name : OutputFolder.made(folder.resolve(out))) {
            tables.put(name, Files.readAllBytes(folder.resolve(out).resolve(name)));
        }
        return tables;
    }

    @Test
    void partsMakeTheSameFilesAsOneRun() throws IOException {
        for (int part = 1; part <= 16; part++) {
            run("--folder=" + in, "--part=" + part + "/16", "--out=" + folder.resolve("parts/" + part));
        }
        run("--collect=" + folder.resolve("parts"), "--out=" + folder.resolve("collected"));
        TreeMap<String, byte[]> whole = tables("out");
        tables("collected").forEach((name, bytes) -> assertArrayEquals(whole.get(name), bytes, name));
        Path damaged;
        try (Stream<Path> all = Files.walk(folder.resolve("parts"))) {
            damaged = all.filter(file -> file.toString().contains("Student 50_")
                    && file.endsWith("grade.json")).findFirst().orElseThrow();
        }
        Files.write(damaged, Arrays.copyOf(Files.readAllBytes(damaged), 300));
        assertHas(run("--collect=" + folder.resolve("parts"), "--out=" + folder.resolve("collected")),
                "cannot be read: s50, ", "grade.json is damaged");
        assertTrue(ClassList.rows(folder.resolve("collected/students.csv")).stream().anyMatch(row -> row.get(1)
                .equals("s51") && row.get(5).equals("3.0")), "nobody else loses anything");
    }
}
