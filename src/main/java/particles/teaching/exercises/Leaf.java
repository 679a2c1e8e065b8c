package particles.teaching.exercises;

import deSolvers.DESolver;
import deSolvers.catalog.SolverCatalog;
import deSolvers.problems.ReferenceProblem;

/**
 * A leaf that the wind carries along, and the wind freshens: v' = -(c/m)(v - b t). The state is the one number v; since
 * its
 * derivative depends on time, a clock that is wrong within a step shows.
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

    /** @return v after so many steps of a solver of the catalogue (m/s) */
    double after(String solver, int steps, double deltaT) {
        DESolver made = SolverCatalog.create(solver);
        for (int n = 0; n < steps; n++) {
            made.stepState(this, deltaT);
        }
        return state()[0];
    }

    /**
     * A Runge-Kutta method that someone got wrong.
     *
     * @param steps  how many
     * @param deltaT the time step (s)
     * @param times  at which part of a step each stage evaluates
     * @param stages how much of each earlier stage is in the state of each stage
     * @param weight how much of each stage makes the step
     * @return v after these steps (m/s)
     */
    double afterMistake(int steps, double deltaT, double[] times, double[][] stages, double[] weight) {
        double v = state()[0];
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
