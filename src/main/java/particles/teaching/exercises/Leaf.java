package particles.teaching.exercises;

import deSolvers.DESolver;
import deSolvers.catalog.SolverCatalog;
import deSolvers.problems.ReferenceProblem;
import particles.teaching.marking.Draw.Picks;

/**
 * A leaf carried by a wind that freshens: v' = -(c/m)(v - b t). The state is the one number v. Its derivative depends
 * on time, so a clock that is wrong within a step shows.
 */
final class Leaf extends ReferenceProblem {
    private final double rate;
    private final double freshening;

    /**
     * @param rate       c/m (1/s)
     * @param freshening b (m/s^2)
     * @param v          the velocity at t = 0 (m/s)
     */
    Leaf(double rate, double freshening, double v) {
        super(v);
        this.rate = rate;
        this.freshening = freshening;
    }

    /** @return a mass for a leaf (kg) */
    static double mass(Picks picks) {
        return picks.of(0.2, 0.4, 0.5, 0.8, 1.25, 1.6);
    }

    /** @return v after a number of steps of a solver of the catalogue from the start (m/s) */
    double after(String solver, int steps, double deltaT) {
        DESolver made = SolverCatalog.create(solver);
        startAt(0);
        for (int n = 0; n < steps; n++) {
            made.stepState(this, deltaT);
        }
        return getState()[0];
    }

    /**
     * Steps with a wrong Runge-Kutta method.
     *
     * @param steps  the number of steps
     * @param deltaT the time step (s)
     * @param times  the time of each stage, as a fraction of the step
     * @param stages the weights of earlier stages in the state of each stage
     * @param weight the weight of each stage in the step
     * @return v after these steps (m/s)
     */
    double afterMistake(int steps, double deltaT, double[] times, double[][] stages, double[] weight) {
        double v = exactState(0)[0];
        double time = 0;
        for (int n = 0; n < steps; n++) {
            double[] k = new double[times.length];
            double next = v;
            for (int i = 0; i < k.length; i++) {
                double trial = v;
                for (int j = 0; j < stages[i].length; j++) {
                    trial += stages[i][j] * k[j];
                }
                k[i] = deltaT * slope(trial, time + times[i] * deltaT);
                next += weight[i] * k[i];
            }
            v = next;
            time += deltaT;
        }
        return v;
    }

    private double slope(double velocity, double t) {
        return -rate * (velocity - freshening * t);
    }

    @Override
    protected void rates(double t, double[] s, double[] dSdt) {
        dSdt[0] = slope(s[0], t);
    }
}
