package particles.scene.format;

import deSolvers.adaptive.AdaptiveSolver;

/**
 * The tolerances of an adaptive solver.
 *
 * @param relative error in a sub-step, relative to the size of the state
 * @param absolute error allowed in addition (m, m/s)
 */
public record Tolerances(double relative, double absolute) {

    /** One tolerance for both.
     *
     * @param tolerance the absolute one; also the relative one, as far as solvers accept it
     * @return both
     */
    public static Tolerances both(double tolerance) {
        return new Tolerances(Math.min(tolerance, AdaptiveSolver.LOOSEST_TOLERANCE), tolerance);
    }
}
