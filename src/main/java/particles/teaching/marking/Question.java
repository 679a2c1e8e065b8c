package particles.teaching.marking;

import java.util.List;
import java.util.stream.DoubleStream;
import java.util.stream.IntStream;

/**
 * A numeric question with one student's numbers.
 *
 * @param text      the task, without the instructions that all exercises share
 * @param unit      the unit of the answer; empty for a pure number
 * @param answer    the right answer
 * @param smallest  the smallest size of an answer: below, it would be a difference of large numbers, with visible
 *                  round-off
 * @param mistakes  the typical mistakes
 */
public record Question(String text, String unit, double answer, double smallest, List<CommonMistake> mistakes) {
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

    /** @return whether the right answer and all typical wrong ones can be told from each other */
    public boolean isClear() {
        double[] all = DoubleStream.concat(DoubleStream.of(answer), mistakes.stream().mapToDouble(CommonMistake::value))
                .toArray();
        return Math.abs(answer) >= smallest && Double.isFinite(answer) && IntStream.range(0, all.length).allMatch(i ->
                IntStream.range(0, i).allMatch(j -> isApart(all[j], all[i])));
    }

    private static boolean isApart(double a, double b) {
        return Math.abs(a - b) > APART * TOLERANCE * Math.max(Math.abs(a), Math.abs(b));
    }

    /** @return whether a typed number equals this one within the tolerance */
    public boolean isNear(double typed, double value) {
        return Math.abs(typed - value) <= TOLERANCE * Math.abs(value);
    }
}
