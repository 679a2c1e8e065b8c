package particles.teaching.marking;

import java.util.List;
import java.util.Optional;
import java.util.function.Function;
import java.util.stream.IntStream;
import particles.teaching.marking.Draw.Picks;

/**
 * An exercise with a number as its answer. Numbers with which two answers look alike are not used: others are drawn.
 */
public final class NumericExercise implements Exercise {
    private static final int MOST_DRAWS = 1000;
    private static final double CLOSE = 0.02;

    private final String title;
    private final double lowest;
    private final double highest;
    private final String unit;
    private final String task;
    private final List<String> hints;
    private final Function<Picks, Worked> work;

    /**
     * @param title   its subject
     * @param unit    the unit of the answer; empty for a pure number
     * @param lowest  the lowest right answer of all students, which the text states
     * @param highest the highest one
     * @param page    the task, with %s for each of the student's numbers; after a line of --- the hint for a wrong
     *                answer that no typical mistake explains, how to begin, without the formula; then a line with the
     *                hint for each typical mistake
     * @param work    draws the student's numbers and works the exercise out with them
     */
    public NumericExercise(String title, String unit, double lowest, double highest, String page,
            Function<Picks, Worked> work) {
        this.title = title;
        this.unit = unit;
        this.lowest = lowest;
        this.highest = highest;
        this.work = work;
        String[] parts = page.split("\n---\n");
        task = parts[0];
        hints = parts[1].lines().toList();
    }

    /**
     * An exercise worked out with one student's numbers.
     *
     * @param answer   the right answer
     * @param smallest the smallest size of an answer that is used
     * @param numbers  the student's numbers in the task
     * @param mistakes the answers to which the typical mistakes lead, in the order of their hints
     */
    public record Worked(double answer, double smallest, List<?> numbers, double... mistakes) {
    }

    private Question question(Worked worked) {
        double[] wrong = worked.mistakes;
        return new Question(task.formatted(worked.numbers.stream().map(x -> x instanceof Double d ? Draw.text(d) : x)
                .toArray()), unit, worked.answer, worked.smallest, IntStream.range(0, Math.max(wrong.length,
                hints.size() - 1)).mapToObj(i -> new CommonMistake(wrong[i], hints.get(i + 1))).toList());
    }

    @Override
    public String title() {
        return title;
    }

    /**
     * @return the student's question: the first one in which no wrong answer looks like another or like the right one
     */
    public Question question(Draw draw) {
        Picks picks = draw.picks();
        for (int attempt = 0; attempt < MOST_DRAWS; attempt++) {
            Question question = question(work.apply(picks));
            if (question.isClear() && question.answer() >= lowest && question.answer() <= highest) {
                return question;
            }
        }
        throw new IllegalStateException("no clear numbers among " + MOST_DRAWS + " for '" + title + "'");
    }

    @Override
    public String text(Draw draw) {
        Question question = question(draw);
        return question.text() + "\nGive five significant digits; accepted within " + Draw.text(100
                * Question.TOLERANCE) + " %. The answer is " + (question.unit().isEmpty() ? "a pure number" : "in "
                + question.unit()) + " and lies between " + Draw.text(lowest) + " and " + Draw.text(highest) + ".";
    }

    @Override
    public Mark mark(Draw draw, String answer) {
        return mark(question(draw), answer, hints.get(0));
    }

    /**
     * @param question one student's question
     * @param answer   the answer as the student typed it
     * @param hint     the hint for an answer that is not understood
     * @return the mark
     */
    public static Mark mark(Question question, String answer, String hint) {
        AnswerText typed = AnswerText.read(answer, question.unit());
        if (typed.value().isEmpty()) {
            return Mark.wrong(typed.problem());
        }
        double value = typed.value().get();
        return question.isNear(value, question.answer()) ? new Mark(true, List.of("This is right."))
                : Mark.wrong(reason(question, value, hint));
    }

    private static String reason(Question question, double value, String hint) {
        Optional<CommonMistake> mistake = question.mistakes().stream().filter(s -> question.isNear(value, s.value()))
                .findFirst();
        if (mistake.isPresent()) {
            return mistake.get().hint();
        }
        double answer = question.answer();
        if (question.isNear(-value, answer)) {
            return "The size is right and the sign is not.";
        }
        for (double power : new double[] {10, 100, 1000, 0.1, 0.01, 0.001}) {
            if (question.isNear(value * power, answer)) {
                return "The digits are right, and the decimal point is not where it belongs: look at the units.";
            }
        }
        if (Math.abs(value - answer) < CLOSE * Math.abs(answer)) {
            return "This is close, but off by more than " + Draw.text(100 * Question.TOLERANCE)
                    + " %: calculate with all digits and round at the very end.";
        }
        return "This is not right yet. " + hint;
    }
}
