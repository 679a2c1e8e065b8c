package particles.teaching.exercises;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.junit.jupiter.api.DynamicTest;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.TestFactory;
import particles.teaching.marking.CommonMistake;
import particles.teaching.marking.Draw;
import particles.teaching.marking.Mark;
import particles.teaching.marking.NumericExercise;
import particles.teaching.marking.Question;

/** A thousand students get numbers of their own, and none gets numbers with which two answers look alike. */
class ThousandStudentsTest {
    private static final int STUDENTS = 1000;

    private static Stream<Integer> numeric() {
        return IntStream.rangeClosed(1,
                Exercises.all().size()).boxed().filter(n -> Exercises.all().get(n - 1) instanceof NumericExercise);
    }

    private static void hold(int number, int students) {
        NumericExercise exercise = (NumericExercise) Exercises.all().get(number - 1);
        Set<String> answers = new HashSet<>();
        for (int s = 0; s < students; s++) {
            Question question = exercise.question(new Draw("id-" + s, number));
            assertTrue(question.mistakes().size() >= 5, "at least five typical mistakes");
            assertEquals(List.of("This is right."), NumericExercise.mark(question,
                    Double.toString(question.answer())).lines());
            for (CommonMistake slip : question.mistakes()) {
                Mark mark = NumericExercise.mark(question, Double.toString(slip.value()));
                assertFalse(mark.right(), slip.hint());
                assertEquals(List.of(slip.hint()), mark.lines(), "for id-" + s);
            }
            answers.add(String.format("%.3g", question.answer()));
        }
        // to three digits; of a thousand students measured 252 (symplectic Euler's energy) to 630
        assertTrue(answers.size() > students / 5, answers.size() + " different answers");
    }

    @Tag("slow")
    @TestFactory
    Stream<DynamicTest> fiftyStudents() {
        return numeric().map(n -> DynamicTest.dynamicTest(n + ". " + Exercises.all().get(n - 1).title(), () -> hold(n,
                50)));
    }

    @Tag("slow")
    @TestFactory
    Stream<DynamicTest> aThousandStudents() {
        return numeric().map(n -> DynamicTest.dynamicTest(n + ". " + Exercises.all().get(n - 1).title(), () -> hold(n,
                STUDENTS)));
    }

    @Test
    void hintsNameDifferentMistakes() {
        numeric().forEach(n -> {
            List<String> hints = ((NumericExercise) Exercises.all().get(n - 1)).question(new Draw("a",
                    n)).mistakes().stream().map(CommonMistake::hint).toList();
            assertEquals(hints.size(), new HashSet<>(hints).size(), hints.toString());
        });
    }

    @Test
    void whatLooksLikeTheAnswerIsNotClear() {
        assertTrue(new Question("", "", 1e-3, 1, 0, List.of(new CommonMistake(1.01, ""), new CommonMistake(1.02, "")))
                .isClear());
        assertFalse(new Question("", "", 1e-3, 1, 0, List.of(new CommonMistake(1.004, ""))).isClear());
        assertFalse(new Question("", "", 1e-3, 1, 0, List.of(new CommonMistake(2, ""), new CommonMistake(2.008, "")))
                .isClear());
        assertFalse(new Question("", "", 1e-3, 1, 1.5, List.of()).isClear());
        assertFalse(new Question("", "", 1e-3, Double.NaN, 0, List.of()).isClear());
    }
}
