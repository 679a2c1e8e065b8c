package particles.teaching.marking;

import java.util.List;

/**
 * A numeric question with one student's numbers.
 *
 * @param text      the task, without what is said of every answer's form
 * @param unit      of the answer; empty for a pure number
 * @param tolerance by which part of the right answer another may be off
 * @param answer    the right answer
 * @param smallest  below this size the answer would be a small difference of large numbers, in which roundings show
 * @param mistakes     typical mistakes
 */
public record Question(String text, String unit, double tolerance, double answer, double smallest,
        List<CommonMistake> mistakes) {
    /** Between any two answers with a meaning lie this many tolerances, so that none is taken for another. */
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

    /** @return whether a typed number is meant to be this one */
    public boolean isNear(double typed, double value) {
        return Math.abs(typed - value) <= tolerance * Math.abs(value);
    }
}
