package particles.app.course;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static particles.Texts.assertHas;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
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
        return Screen.of(expected, List.of(new SheetsCommand(), new GradeCommand(folder.resolve("classes"))),
                OptionStyle.GRADLE, args);
    }

    private String sheets(ExitCode expected, int students) throws Exception {
        Files.writeString(folder.resolve("list.csv"), IntStream.range(0, students).mapToObj(n -> "s" + n + ",Name\n")
                .collect(Collectors.joining("", "id,name\n", "")));
        return run(expected, "sheets", "--students=" + folder.resolve("list.csv"), "--key=" + key(), "--out="
                + folder.resolve("out"));
    }

    private Path key() {
        return folder.resolve("key.txt");
    }

    /** The draw of an exercise, from what is in the key file and the id. */
    private Draw draw(String student, int number) throws Exception {
        return new Draw(Files.readString(key()).strip() + student, number);
    }

    private double answer(String student, int number) throws Exception {
        return ((NumericExercise) Exercises.ALL.get(number - 1)).worked(draw(student, number)).answer();
    }

    @Test
    void whatIsOnTheSheetIsMarkedWithTheKeyAndOnlyWithIt() throws Exception {
        sheets(ExitCode.DONE, 2);
        String secret = Files.readString(key()).strip();
        String sheet = Files.readString(folder.resolve("out/sheet-2-s1.html"));
        assertHas(sheet, "<h1>Exercises for s1</h1>", Exercises.ALL.get(1).text(draw("s1", 2)));
        assertFalse(sheet.contains(secret), "the secret is not on the sheet");
        sheets(ExitCode.DONE, 3);
        assertEquals(sheet, Files.readString(folder.resolve("out/sheet-2-s1.html")), "a sheet keeps its numbers");
        Files.writeString(folder.resolve("answers.yaml"), "2: " + answer("s1", 2));
        Files.writeString(folder.resolve("assignment.yaml"), "numbers: sheet\nexercises: {2: 1}\n");
        String[][] rows = {{" s1 ", "key.txt", "mark      2."}, {"S1", "key.txt", "mark      2."},
            {"s0", "key.txt", "no mark   2."}, {"s1", "", "undecided 2."}};
        for (String[] row : rows) {
            String screen = run(row[2].startsWith("mark") ? ExitCode.DONE : ExitCode.BAD_INPUT, "grade", "--student="
                    + row[0], "--folder=" + folder, "--assignment="
                    + folder.resolve("assignment.yaml"), row[1].isEmpty() ? "--out=" + folder.resolve("grade")
                    : "--key=" + folder.resolve(row[1]));
            assertHas(screen, row[2]);
        }
    }

    /** The numbers follow from the secret: with another one, or with the id alone, they are others. */
    @Test
    void anotherKeyGivesOtherNumbers() throws Exception {
        List<Double> answers = new ArrayList<>(List.of(((NumericExercise) Exercises.ALL.get(1)).worked(new Draw("s1",
                2)).answer()));
        for (int key = 0; key < 2; key++) {
            Files.deleteIfExists(key());
            sheets(ExitCode.DONE, 2);
            answers.add(answer("s1", 2));
        }
        assertEquals(3, Set.copyOf(answers).size(), answers.toString());
    }

    @Test
    void aFileWithoutASecretIsNoKey() throws Exception {
        Files.writeString(key(), "id,name\ns1,Name\n");
        assertHas(sheets(ExitCode.BAD_INPUT, 2), "key.txt cannot be read as a key file: it holds no secret;");
    }
}
