package particles.reactions.wires;

import particles.view.CurveView;

/**
 * A wire: a curve in space along which a bead slides, defined as the common zeros of two smooth functions of position.
 * Their gradients must be linearly independent on the curve, and near it their values must be approximate distances
 * from it (m).
 */
public interface Curve extends CurveView {
    /** The number of functions of a curve. */
    int ROWS = 2;

    /**
     * Evaluates both functions for a moving point.
     *
     * @param state     position (m) and velocity (m/s) of the point, in the six entries from {@code x} on
     * @param x         index of the first of these entries
     * @param values    receives the two values
     * @param gradients receives the two gradients, one after the other, 6 doubles
     * @param bends     receives, for each function, the second derivative along the velocity: v<sup>T</sup> H v with
     *                  the function's matrix H of second derivatives
     */
    void evaluate(double[] state, int x, double[] values, double[] gradients, double[] bends);
}
