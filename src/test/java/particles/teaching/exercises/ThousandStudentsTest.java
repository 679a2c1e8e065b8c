package particles.teaching.exercises;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static particles.Texts.assertStarts;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.DoubleStream;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.junit.jupiter.api.DynamicTest;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.TestFactory;
import particles.teaching.exercises.Exercise.Mark;
import particles.teaching.exercises.NumericExercise.Worked;

/** A thousand students get numbers of their own, and none gets numbers with which two answers look alike. */
class ThousandStudentsTest {
    private static final int STUDENTS = 1000;
    private static final double SHARED = 0.02;
    private static final int CLASS = 100;
    /** Of any class; 4 in exercises 2, 4 and 9 to 8 in 10 were measured. */
    private static final int MOST_SHARING = 10;

    /** @return an exercise with a number as its answer */
    static NumericExercise numeric(int number) {
        return (NumericExercise) Exercises.ALL.get(number - 1);
    }

    private static Stream<Integer> all() {
        return IntStream.rangeClosed(1,
                Exercises.ALL.size()).boxed().filter(n -> Exercises.ALL.get(n - 1) instanceof NumericExercise);
    }

    /** @return what is said to each of a student's typical mistakes */
    private static List<String> hints(NumericExercise exercise, Worked question) {
        return DoubleStream.of(question.mistakes()).mapToObj(mistake -> {
            Mark mark = exercise.mark(question, Double.toString(mistake));
            assertFalse(mark.right(), mark.lines().toString());
            return String.join(" ", mark.lines());
        }).toList();
    }

    private static void hold(int number) {
        NumericExercise exercise = numeric(number);
        List<Worked> questions = new ArrayList<>();
        String text = exercise.text(new Draw("id-0", number));
        List<String> hints = hints(exercise, exercise.worked(new Draw("id-0", number)));
        Matcher range = Pattern.compile("and lies between (-?[\\d.]+) and ([\\d.]+)[.]$").matcher(text);
        assertTrue(range.find(), text);
        for (int s = 0; s < STUDENTS; s++) {
            Worked question = exercise.worked(new Draw("id-" + s, number));
            assertTrue(question.mistakes().length >= 5, "at least five typical mistakes");
            assertEquals(List.of("This is right."), exercise.mark(question,
                    Double.toString(question.answer())).lines());
            assertEquals(hints, hints(exercise, question), "for id-" + s);
            assertTrue(Double.parseDouble(range.group(1)) <= question.answer()
                    && question.answer() <= Double.parseDouble(range.group(2)), text + question.answer());
            questions.add(question);
        }
        int shared = IntStream.range(0, STUDENTS / CLASS).map(k -> sharing(questions.subList(k * CLASS, (k + 1)
                * CLASS))).max().orElse(0);
        assertTrue(shared <= MOST_SHARING, shared + " of " + CLASS + " share an answer with somebody");
        int most = mostThatOneGuessFits(questions);
        assertTrue(most <= SHARED * STUDENTS, most + " of " + STUDENTS + " share an answer");
    }

    /** @return how many have an answer that is right for somebody else, or the other way round */
    private static int sharing(List<Worked> questions) {
        return (int) questions.stream().filter(mine -> questions.stream().anyMatch(other -> other != mine
                && (NumericExercise.isNear(other.answer(), mine.answer())
                || NumericExercise.isNear(mine.answer(), other.answer()))))
                .count();
    }

    /** The most students for whom one number counts as right. */
    private static int mostThatOneGuessFits(List<Worked> questions) {
        int most = 0;
        for (Worked guessed : questions) {
            for (double edge : new double[] {1 - NumericExercise.TOLERANCE, 1, 1 + NumericExercise.TOLERANCE}) {
                double guess = guessed.answer() * edge;
                most = Math.max(most, (int) questions.stream().filter(of ->
                        NumericExercise.isNear(guess, of.answer())).count());
            }
        }
        return most;
    }

    @Tag("slow")
    @TestFactory
    Stream<DynamicTest> aThousandStudents() {
        return all().map(n -> DynamicTest.dynamicTest(n + ". " + Exercises.ALL.get(n - 1).title(), () ->
                hold(n)));
    }

    @Test
    void hintsNameDifferentMistakes() {
        all().forEach(n -> {
            NumericExercise exercise = numeric(n);
            List<String> hints = hints(exercise, exercise.worked(new Draw("a", n)));
            assertEquals(hints.size(), new HashSet<>(hints).size(), hints.toString());
            assertFalse(hints.toString().contains("This is not right yet."), hints.toString());
            assertStarts(exercise.mark(new Draw("a", n), "123456789").lines().get(0), "This is not right yet. ");
        });
    }

    /** A wrong answer that no typical mistake explains gets a hint where to begin, and no formula. */
    @Test
    void hintsGiveNoFormulaAway() {
        for (int n : new int[] {6, 7, 8}) {
            NumericExercise exercise = numeric(n);
            String hint = String.join(" ", exercise.mark(new Draw("a", n), "123456").lines());
            assertStarts(hint, "This is not right yet. ");
            assertFalse(hint.matches(".*[=^/*].*|.*(sqrt|omega).*"), hint);
        }
    }

    @Test
    void whatLooksLikeTheAnswerIsNotClear() {
        assertTrue(new Worked(1, 0, List.of(), 1.01, 1.02).isClear());
        assertFalse(new Worked(1, 0, List.of(), 1.004).isClear());
        assertFalse(new Worked(1, 0, List.of(), 2, 2.008).isClear());
        assertFalse(new Worked(1, 1.5, List.of()).isClear());
        assertFalse(new Worked(Double.NaN, 0, List.of()).isClear());
    }
}
