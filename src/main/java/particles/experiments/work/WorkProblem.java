package particles.experiments.work;

import deSolvers.DEStateSource;
import deSolvers.SecondOrderStateSource;
import deSolvers.problems.ReferenceProblem;
import java.util.Map;
import java.util.Optional;
import java.util.function.Supplier;
import particles.ParticleSystem;

/**
 * A test problem of the work-precision experiment.
 *
 * @param name          its name in options
 * @param title         a short description
 * @param duration      the time over which it is solved (s)
 * @param start         creates a source in its initial state
 * @param reference     the state at the end
 * @param origin        the origin of the reference, in words
 * @param onlyPositions whether errors are of positions alone (m); else of the whole state
 * @param floor         errors below this may be round-off, or errors of the reference
 * @param budget        the limits of work
 * @param stiff         the range of steps in which it is stiff, if it is
 */
public record WorkProblem(String name, String title, double duration, Supplier<? extends DEStateSource> start,
                          double[] reference, String origin, boolean onlyPositions, double floor, Budget budget,
                          Optional<Stiff> stiff) {

    /**
     * The limits of a solver's work.
     *
     * @param explicit          evaluations beyond which an explicit solver makes no further run
     * @param implicit          the same for an implicit one, which does more for each
     * @param tightestTolerance the tightest tolerance of adaptive implicit solvers; others go down to 1e-11
     */
    public record Budget(long explicit, long implicit, double tightestTolerance) {
    }

    /**
     * The range of steps in which a problem is stiff. Implicit solvers are compared there, at equal steps also the
     * adaptive ones.
     *
     * @param deltaT  the shortest step that is still long for the stiff springs (s)
     * @param reduced the theoretical order in this range, for the solvers with order reduction
     */
    public record Stiff(double deltaT, Map<String, Double> reduced) {
    }

    /**
     * @param source a source at the end of a run
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

    /** @return the number of evaluations of a problem's source */
    static long evaluations(DEStateSource source) {
        return source instanceof ParticleSystem system ? system.getEvaluations()
                : ((ReferenceProblem) source).getEvaluations();
    }

    /** @return the kind of error, with its unit */
    public String errorLabel() {
        return onlyPositions ? "largest position error at the end (m)" : "error of the state at the end (1)";
    }
}
