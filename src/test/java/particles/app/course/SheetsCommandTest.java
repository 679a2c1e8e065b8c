package particles.app.course;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static particles.Texts.assertHas;

import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import particles.app.cli.ExitCode;
import particles.app.cli.OptionStyle;
import particles.app.cli.Screen;
import particles.teaching.exercises.Draw;
import particles.teaching.exercises.Exercises;
import particles.teaching.exercises.NumericExercise;

/** Handouts with numbers from a key file, and marking with it. */
class SheetsCommandTest {
    @TempDir
    private Path folder;

    private String run(ExitCode expected, String... args) {
        return Screen.of(expected, List.of(new SheetsCommand(), new GradeCommand(folder, folder.resolve("classes"))),
                OptionStyle.GRADLE, args);
    }

    private Map<String, String> sheets(int students) throws Exception {
        Files.writeString(folder.resolve("list.csv"), IntStream.range(0, students).mapToObj(n -> "s" + n + ",Name\n")
                .collect(Collectors.joining("", "id,name\n", "")));
        run(ExitCode.DONE, "sheets", "--students=" + folder.resolve("list.csv"), "--key=" + folder.resolve("key.csv"),
                "--out=" + folder.resolve("out"));
        return CourseOptions.secrets(folder.resolve("key.csv"));
    }

    private static double answer(String secret, int number) {
        return ((NumericExercise) Exercises.ALL.get(number - 1)).worked(new Draw(secret, number))
                .answer();
    }

    /** In a class of a hundred, no answer is right for somebody else too. */
    @Tag("slow")
    @Test
    void aHundredStudentsShareNoAnswer() throws Exception {
        Map<String, String> keys = sheets(100);
        for (int number = 1; number < Exercises.ALL.size(); number++) {
            int exercise = number;
            List<Double> all = keys.values().stream().map(secret -> answer(secret, exercise)).toList();
            assertEquals(0, all.stream().filter(mine -> all.stream().filter(other ->
                    NumericExercise.isNear(other, mine)).count() > 1).count(), "exercise " + number);
        }
    }

    /** It would lose the secrets of printed sheets. */
    @Test
    void aKeyFileWithAnotherNumberOfColumnsIsRefusedAndKept() throws Exception {
        Files.writeString(folder.resolve("list.csv"), "id,name\ns1,Name\n");
        Path key = folder.resolve("key.csv");
        for (String line : List.of("s1,a,b", "s1", "s1;a")) {
            Files.writeString(key, "student,secret\ns0,a\n" + line + "\n");
            assertHas(run(ExitCode.BAD_INPUT, "sheets", "--students=" + folder.resolve("list.csv"), "--key=" + key,
                    "--out=" + folder.resolve("out")), key + ":3: a key file has 2 columns, student and secret");
            assertHas(Files.readString(key), line);
        }
    }

    @Test
    void theLecturerIsToldOfAStudentWithASharedAnswer() {
        for (double other : new double[] {0, Double.POSITIVE_INFINITY}) {     // infinity is near to any number
            StringWriter screen = new StringWriter();
            SheetsCommand.secret("s7", Set.of(2), new ArrayList<>(List.of(List.of(other))), new PrintWriter(screen));
            assertEquals(other == 0 ? "" : "s7: an answer may also be right for another student", screen.toString()
                    .strip());
        }
    }

    @Test
    void whatIsOnTheSheetIsMarkedWithTheKeyAndOnlyWithIt() throws Exception {
        Map<String, String> keys = sheets(2);
        String mine = keys.get("s1");
        assertEquals(mine, sheets(3).get("s1"), "who has a sheet keeps its numbers");
        String sheet = Files.readString(folder.resolve("out/sheet-2-s1.html"));
        String text = Exercises.ALL.get(1).text(new Draw(mine, 2));
        assertHas(sheet, "<h1>Exercises for s1</h1>", text);
        assertFalse(sheet.contains(mine), "the secret is on no sheet");
        Files.writeString(folder.resolve("answers.yaml"), "2: " + answer(mine, 2));
        Files.writeString(folder.resolve("assignment.yaml"), "numbers: sheet\nexercises: {2: 1}\n");
        String[][] rows = {{"S1", "key.csv", "mark      2."}, {"s0", "key.csv", "no mark   2."},
            {"nobody", "key.csv", "undecided 2."}, {"s1", "", "undecided 2."}};
        for (String[] row : rows) {
            String screen = run(row[2].startsWith("mark") ? ExitCode.DONE : ExitCode.BAD_INPUT, "grade", "--student="
                    + row[0], "--assignment="
                    + folder.resolve("assignment.yaml"), row[1].isEmpty() ? "--out=" + folder.resolve("grade")
                    : "--key=" + folder.resolve(row[1]));
            assertHas(screen, row[2]);
        }
    }
}
