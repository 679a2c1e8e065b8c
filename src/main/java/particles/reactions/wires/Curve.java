package particles.reactions.wires;

import particles.law.Vector3;
import particles.view.Scenery.CurveView;

/**
 * A wire: a curve in space along which a bead slides, defined as the common zeros of two smooth functions of position.
 * Their gradients must be linearly independent on the curve, and near it their values must be approximate distances
 * from it (m).
 */
public interface Curve extends CurveView {
    /** The number of functions of a curve. */
    int ROWS = 2;

    /** @return the value of function k, 0 or 1, at a point: about its distance from where that is 0 (m) */
    double value(int k, Vector3 x);

    /** @return its gradient */
    Vector3 gradient(int k, Vector3 x);

    /** @return its second derivative along a velocity: v<sup>T</sup> H v with the matrix H of second derivatives */
    double bend(int k, Vector3 x, Vector3 v);
}
