package particles.experiments.work;

import deSolvers.DEStateSource;
import deSolvers.SecondOrderStateSource;
import java.util.Map;
import java.util.Optional;
import java.util.function.Supplier;
import java.util.function.ToLongFunction;

/**
 * A problem on which work is set against precision.
 *
 * @param name          its name in options
 * @param title         what it is
 * @param duration      over which it is solved (s)
 * @param start         makes a source at its initial state
 * @param evaluations   asks such a source how often its derivative was evaluated
 * @param reference     the state at the end
 * @param origin        how that is known
 * @param onlyPositions whether errors are of positions alone (m); else of the whole state
 * @param floor         errors below this may be those of rounding, or of the reference
 * @param budget        how much is to be spent on it
 * @param stiff         what is to be expected where it is stiff, if it is
 */
public record WorkProblem(String name, String title, double duration, Supplier<? extends DEStateSource> start,
                          ToLongFunction<DEStateSource> evaluations, double[] reference, String origin,
                          boolean onlyPositions, double floor, Budget budget, Optional<Stiff> stiff) {

    /**
     * How much a solver may do.
     *
     * @param explicit          evaluations beyond which an explicit solver makes no further run
     * @param implicit          the same for an implicit one, which does more for each
     * @param tightestTolerance of adaptive implicit solvers; others go down to 1e-11
     */
    public record Budget(long explicit, long implicit, double tightestTolerance) {
    }

    /**
     * Where a problem is stiff: there implicit solvers are judged, at equal steps also the adaptive ones.
     *
     * @param deltaT  the shortest step that is still long for the stiff springs (s)
     * @param reduced what theory says of the order there, for the solvers that lose some
     */
    public record Stiff(double deltaT, Map<String, Double> reduced) {
    }

    /**
     * @param source at the end of a run
     * @return the largest error of a position, or the length of the state's error
     */
    public double error(DEStateSource source) {
        double[] state = new double[reference.length];
        source.getState(state);
        int d = source instanceof SecondOrderStateSource motion ? motion.getDimension() : state.length;
        double largest = 0;
        double squares = 0;
        for (int k = 0; k < state.length; k++) {
            double error = Math.abs(state[k] - reference[k]);
            squares += error * error;
            if (k % (2 * d) < d) {
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
