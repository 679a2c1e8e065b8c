package particles.view;

import particles.law.Vector3;

/** What a picture needs to know of a curve in space. */
public interface CurveView {
    /**
     * @param u how far along the curve, measured on the curve or along a straight line beside it (m); any number
     * @return the place (m)
     */
    Vector3 at(double u);

    /** @return the u at which the curve is back where it began (m); infinite where it never is */
    double length();
}
