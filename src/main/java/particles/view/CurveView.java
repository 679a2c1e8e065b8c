package particles.view;

import particles.law.Vector3;

/** A curve in space, as needed for drawing. */
public interface CurveView {
    /**
     * @param u the curve's parameter, a length along the curve or along a straight line beside it (m); any number
     * @return the point (m)
     */
    Vector3 at(double u);

    /** @return the u at which a closed curve is back at its beginning (m); infinity for an open one */
    double length();
}
