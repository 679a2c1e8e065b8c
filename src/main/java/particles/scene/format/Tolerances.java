package particles.scene.format;

/**
 * The tolerances of an adaptive solver.
 *
 * @param relative error in a sub-step, relative to the size of the state
 * @param absolute error besides (m, m/s)
 */
public record Tolerances(double relative, double absolute) {
}
