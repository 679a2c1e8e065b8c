package particles.teaching.exercises;

import deSolvers.catalog.SolverCatalog;
import deSolvers.problems.ReferenceProblem;
import deSolvers.rungeKutta.ButcherTableau;
import java.util.stream.IntStream;
import particles.teaching.exercises.Draw.Picks;

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
        startAt(0);
        step(SolverCatalog.create(solver), steps, deltaT);
        return getState()[0];
    }

    /**
     * Steps with a method in which a mistake was made.
     *
     * @param method a printed Butcher tableau
     * @param right  what stands there
     * @param wrong  what was written in its place
     * @param steps  the number of steps
     * @param deltaT the time step (s)
     * @return v after these steps (m/s)
     */
    double afterMistake(String method, String right, String wrong, int steps, double deltaT) {
        ButcherTableau tableau = ButcherTableau.parse(method.replace(right, wrong));
        double v = exactState(0)[0];
        for (int n = 0; n < steps; n++) {
            double[] k = new double[tableau.getStages()];
            for (int i = 0; i < k.length; i++) {
                k[i] = deltaT * slope(v + sum(tableau.row(i), k), (n + tableau.node(i)) * deltaT);
            }
            v += sum(tableau.weights(0), k);
        }
        return v;
    }

    private static double sum(double[] weights, double[] k) {
        return IntStream.range(0, weights.length).mapToDouble(j -> weights[j] * k[j]).sum();
    }

    private double slope(double velocity, double t) {
        return -rate * (velocity - freshening * t);
    }

    @Override
    protected void rates(double t, double[] s, double[] dSdt) {
        dSdt[0] = slope(s[0], t);
    }
}
