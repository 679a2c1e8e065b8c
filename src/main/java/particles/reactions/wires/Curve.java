package particles.reactions.wires;

import particles.view.CurveView;

/**
 * A curve in space for a bead to slide along: where two smooth functions of the place are zero. Their gradients have to
 * be independent of each other on the curve. The functions are lengths or nearly so: what they say near the curve is
 * about how far off it is (m).
 */
public interface Curve extends CurveView {
    /** How many functions a curve has. */
    int ROWS = 2;

    /**
     * Evaluates both functions for a moving point.
     *
     * @param state     position (m) and velocity (m/s) of the point, in the six entries from {@code x} on
     * @param x         where they begin
     * @param values    receives the two values
     * @param gradients receives the two gradients, one after the other, 6 doubles
     * @param bends     receives, for each function, the second derivative along the velocity: v<sup>T</sup> H v with
     *                  the function's matrix H of second derivatives
     */
    void evaluate(double[] state, int x, double[] values, double[] gradients, double[] bends);
}
