package deSolvers.rungeKutta;

import deSolvers.StepTransaction;
import java.util.Arrays;

/** The loop over the stages of any explicit Runge-Kutta method, with its work arrays. */
public final class RungeKuttaStages {
    private final ButcherTableau tableau;
    private final double[][] k;
    private double[] trial = {};

    /** @param tableau the method */
    public RungeKuttaStages(ButcherTableau tableau) {
        this.tableau = tableau;
        this.k = new double[tableau.getStages()][0];
    }

    /** @param n the state's size from now on */
    public void resize(int n) {
        trial = new double[n];
        for (int i = 0; i < k.length; i++) {
            k[i] = new double[n];
        }
    }

    /**
     * Evaluates all stages but the first, whose slope is known.
     *
     * @param source the step's source; left at the last stage
     * @param state  the state at the beginning
     * @param slope  the derivative there
     * @param offset time from the beginning of the step to that of the sub-step (s)
     * @param h      the sub-step (s)
     */
    public void evaluate(StepTransaction source, double[] state, double[] slope, double offset, double h) {
        System.arraycopy(slope, 0, k[0], 0, slope.length);
        for (int stage = 1; stage < k.length; stage++) {
            combine(tableau.row(stage), h, trial);
            for (int i = 0; i < trial.length; i++) {
                trial[i] += state[i];
            }
            source.setState(trial);
            source.setOffset(offset + tableau.node(stage) * h);
            source.getStateDerivative(k[stage]);        // at (s + h sum a k, t + c h)
        }
    }

    /**
     * Computes a weighted sum of the slopes.
     *
     * @param weights the weights of the first stages
     * @param h       a factor for all (s)
     * @param result  receives h sum w k
     */
    public void combine(double[] weights, double h, double[] result) {
        Arrays.fill(result, 0);
        for (int j = 0; j < weights.length; j++) {
            double weight = weights[j];
            for (int i = 0; weight != 0 && i < result.length; i++) {
                result[i] += weight * k[j][i];
            }
        }
        for (int i = 0; i < result.length; i++) {
            result[i] *= h;
        }
    }

    /** @return the state of the last stage evaluated; to be read only */
    public double[] getLastState() {
        return trial;
    }

    /**
     * @param stage 0 to stages - 1
     * @return its slope; to be read only
     */
    public double[] slope(int stage) {
        return k[stage];
    }
}
