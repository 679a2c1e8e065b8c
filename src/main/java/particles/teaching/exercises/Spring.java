package particles.teaching.exercises;

import deSolvers.catalog.SolverCatalog;
import deSolvers.problems.SecondOrderProblem;
import particles.teaching.exercises.Draw.Picks;

/** A particle on a spring and a damper, m x'' = -k x - c x', with its exact motion and that of solvers. */
final class Spring extends SecondOrderProblem {
    private static final int FINE = 1000;

    private final double mass;
    private final double stiffness;
    private final double damping;

    /**
     * @param mass      m (kg)
     * @param stiffness k (N/m); negative pushes away
     * @param damping   c (N s/m)
     * @param x         the initial position (m)
     * @param v         the initial velocity (m/s)
     */
    Spring(double mass, double stiffness, double damping, double x, double v) {
        super(1, x, v);
        this.mass = mass;
        this.stiffness = stiffness;
        this.damping = damping;
    }

    @Override
    protected void accelerate(double t, double[] s, double[] dSdt) {
        dSdt[1] = (-stiffness * s[0] - damping * s[1]) / mass;
    }

    @Override
    public boolean accelerationDependsOnVelocity() {
        return damping != 0;
    }

    double x() {
        return getState()[0];
    }

    double v() {
        return getState()[1];
    }

    double energy() {
        double[] s = getState();
        return (mass * s[1] * s[1] + stiffness * s[0] * s[0]) / 2;
    }

    /** @return a mass for a spring (kg) */
    static double mass(Picks picks) {
        return picks.of(0.4, 0.5, 0.8, 1.25, 1.6, 2, 2.5, 4);
    }

    /** @return such a spring after a number of steps of a solver of the catalogue; this one stays */
    Spring after(String solver, int steps, double deltaT) {
        Spring moved = new Spring(mass, stiffness, damping, x(), v());
        moved.step(SolverCatalog.create(solver), steps, deltaT);
        return moved;
    }

    /** @return this spring after the true motion: RK4 with steps so short that all digits anybody types are right */
    Spring truly(double time) {
        return after("rk4", FINE, time / FINE);
    }
}
