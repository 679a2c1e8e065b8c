package particles.teaching.marking;

import java.util.List;

/**
 * A numeric question with one student's numbers.
 *
 * @param text      the task, without the instructions that all exercises share
 * @param unit      the unit of the answer; empty for a pure number
 * @param tolerance the relative error allowed
 * @param answer    the right answer
 * @param smallest  the smallest size of an answer: below, it would be a difference of large numbers, with visible
 *                  round-off
 * @param mistakes  the typical mistakes
 */
public record Question(String text, String unit, double tolerance, double answer, double smallest,
        List<CommonMistake> mistakes) {
    /**
     * The right answer and those of mistakes differ by at least this many tolerances, so that none is taken for
     * another.
     */
    private static final double APART = 5;

    /** @return whether the right answer and all typical wrong ones can be told from each other */
    public boolean isClear() {
        if (!(Math.abs(answer) >= smallest) || !Double.isFinite(answer)) {
            return false;
        }
        for (int i = 0; i < mistakes.size(); i++) {
            if (!isApart(answer, mistakes.get(i).value())) {
                return false;
            }
            for (int j = 0; j < i; j++) {
                if (!isApart(mistakes.get(j).value(), mistakes.get(i).value())) {
                    return false;
                }
            }
        }
        return true;
    }

    private boolean isApart(double a, double b) {
        return Math.abs(a - b) > APART * tolerance * Math.max(Math.abs(a), Math.abs(b));
    }

    /** @return whether a typed number equals this one within the tolerance */
    public boolean isNear(double typed, double value) {
        return Math.abs(typed - value) <= tolerance * Math.abs(value);
    }
}
