package particles.experiments.problems;

import deSolvers.DEStateSource;
import java.util.function.Supplier;
import java.util.function.ToLongFunction;

/**
 * A problem on which work is set against precision.
 *
 * @param name         its name in options
 * @param title        what it is
 * @param duration     over which it is solved (s)
 * @param start        makes a source at its initial state
 * @param evaluations  asks such a source how often its derivative was evaluated
 * @param reference    the state at the end
 * @param origin       how that is known
 * @param onlyPositions whether errors are of positions alone, blocks of three and three (m); else of the whole state
 * @param mostWork     evaluations beyond which no run is made
 * @param smooth       whether slopes are to be the orders
 */
public record WorkProblem(String name, String title, double duration, Supplier<? extends DEStateSource> start,
                          ToLongFunction<DEStateSource> evaluations, double[] reference, String origin,
                          boolean onlyPositions, long mostWork, boolean smooth) {

    /**
     * @param source at the end of a run
     * @return the largest error of a position, or the length of the state's error
     */
    public double error(DEStateSource source) {
        double[] state = new double[reference.length];
        source.getState(state);
        double largest = 0;
        double squares = 0;
        for (int k = 0; k < state.length; k++) {
            double error = Math.abs(state[k] - reference[k]);
            squares += error * error;
            if (k % 6 < 3) {
                largest = Math.max(largest, error);
            }
        }
        return onlyPositions ? largest : Math.sqrt(squares);
    }

    /** @return what errors are, with their unit */
    public String errorLabel() {
        return onlyPositions ? "largest position error at the end (m)" : "error of the state at the end (1)";
    }
}
