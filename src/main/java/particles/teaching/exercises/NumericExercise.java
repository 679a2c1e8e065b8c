package particles.teaching.exercises;

import java.util.List;
import java.util.function.Function;
import java.util.stream.DoubleStream;
import java.util.stream.IntStream;
import particles.spec.messages.InvalidInputException;
import particles.teaching.exercises.Draw.Picks;
import particles.teaching.exercises.Exercise.Mark;

/**
 * An exercise with a number as its answer. Numbers with which two answers look alike are not used: others are drawn.
 *
 * @param title   its subject
 * @param unit    the unit of the answer; empty for a pure number
 * @param lowest  the lowest right answer of all students, which the text states
 * @param highest the highest one
 * @param page    the task, with %s for each of the student's numbers; after a line of --- the hint for a wrong answer
 *                that no typical mistake explains, how to begin, without the formula; then a line with the hint for
 *                each typical mistake
 * @param work    draws the student's numbers and works the exercise out with them
 */
public record NumericExercise(String title, String unit, double lowest, double highest, String page,
        Function<Picks, Worked> work) implements Exercise {
    private static final int MOST_DRAWS = 1000;
    private static final double CLOSE = 0.02;
    /**
     * The relative error allowed: five significant digits, with a rounding on the way forgiven. With 1e-3, up
     * to 19 of a hundred students would have an answer that is right for another; with this, at most 8.
     */
    public static final double TOLERANCE = 2e-4;
    /**
     * The right answer and those of mistakes differ by at least this many tolerances, so that none is taken for
     * another.
     */
    private static final double APART = 25;
    private static final String END_OF_TASK = "\n---\n";

    /**
     * An exercise worked out with one student's numbers.
     *
     * @param answer   the right answer
     * @param smallest the smallest size of an answer that is used: below, it would be a difference of large numbers,
     *                 with visible round-off
     * @param numbers  the student's numbers in the task
     * @param mistakes the answers to which the typical mistakes lead, in the order of their hints
     */
    public record Worked(double answer, double smallest, List<?> numbers, double... mistakes) {
        /** @return whether the right answer and all typical wrong ones can be told from each other */
        public boolean isClear() {
            double[] all = DoubleStream.concat(DoubleStream.of(answer), DoubleStream.of(mistakes)).toArray();
            return Math.abs(answer) >= smallest && Double.isFinite(answer) && IntStream.range(0, all.length)
                    .allMatch(i -> IntStream.range(0, i).allMatch(j -> isApart(all[j], all[i])));
        }

        private static boolean isApart(double a, double b) {
            return Math.abs(a - b) > APART * TOLERANCE * Math.max(Math.abs(a), Math.abs(b));
        }
    }

    /** @return whether a typed number equals this one within the tolerance */
    public static boolean isNear(double typed, double value) {
        return Math.abs(typed - value) <= TOLERANCE * Math.abs(value);
    }

    private List<String> hints() {
        return page.split(END_OF_TASK)[1].lines().toList();
    }

    /**
     * @return the exercise with the student's numbers: the first ones with which no wrong answer looks like another or
     *         like the right one
     */
    public Worked worked(Draw draw) {
        Picks picks = draw.picks();
        int mistakes = hints().size() - 1;
        for (int attempt = 0; attempt < MOST_DRAWS; attempt++) {
            Worked worked = work.apply(picks);
            if (worked.mistakes.length != mistakes) {
                throw new IllegalStateException("'" + title + "' needs a hint for each mistake");
            }
            if (worked.isClear() && worked.answer >= lowest && worked.answer <= highest) {
                return worked;
            }
        }
        throw new IllegalStateException("no clear numbers among " + MOST_DRAWS + " for '" + title + "'");
    }

    @Override
    public String text(Draw draw) {
        return page.split(END_OF_TASK)[0].formatted(worked(draw).numbers.stream().map(x -> x instanceof Double d
                ? Draw.text(d) : x).toArray()) + "\nGive five significant digits; accepted within "
                + Draw.text(100 * TOLERANCE) + " %. The answer is " + (unit.isEmpty() ? "a pure number" : "in " + unit)
                + " and lies between " + Draw.text(lowest) + " and " + Draw.text(highest) + ".";
    }

    @Override
    public Mark mark(Draw draw, String answer, Function<String, byte[]> files) {
        return mark(worked(draw), answer);
    }

    /**
     * @param worked the exercise with one student's numbers
     * @param answer the answer as the student typed it
     * @return the mark
     */
    public Mark mark(Worked worked, String answer) {
        try {
            double value = AnswerText.read(answer, unit);
            return isNear(value, worked.answer) ? new Mark(true, List.of("This is right."))
                    : Mark.wrong(reason(worked, value));
        } catch (InvalidInputException e) {
            return Mark.wrong(e.getMessage());
        }
    }

    private String reason(Worked worked, double value) {
        List<String> hints = hints();
        for (int i = 1; i < hints.size(); i++) {
            if (isNear(value, worked.mistakes[i - 1])) {
                return hints.get(i);
            }
        }
        double answer = worked.answer;
        if (isNear(-value, answer)) {
            return "The size is right and the sign is not.";
        }
        for (double power : new double[] {10, 100, 1000, 0.1, 0.01, 0.001}) {
            if (isNear(value * power, answer)) {
                return "The digits are right, and the decimal point is not where it belongs: look at the units.";
            }
        }
        if (Math.abs(value - answer) < CLOSE * Math.abs(answer)) {
            return "This is close, but off by more than " + Draw.text(100 * TOLERANCE)
                    + " %: calculate with all digits and round at the very end.";
        }
        return "This is not right yet. " + hints.get(0);
    }
}
