package particles.rules;

import particles.law.AnchorMotion;
import particles.law.Require;
import particles.law.Vector3;

/** Uniform motion of an anchor on a circle, as of a crank: counter-clockwise when the axis points at the viewer. */
public final class CircleMotion implements AnchorMotion {
    private final Vector3 centre;
    private final Vector3 cosine;
    private final Vector3 sine;
    private final double omega;

    /**
     * @param start  the position at t = 0 (m)
     * @param centre any point of the axis (m)
     * @param axis   its direction
     * @param period the time of one turn (s), not 0; a negative one turns the other way
     * @throws IllegalArgumentException if the axis has no direction, the period is 0 or a number not finite
     */
    public CircleMotion(Vector3 start, Vector3 centre, Vector3 axis, double period) {
        Vector3 unit = axis.normalized();
        Vector3 radius = start.minus(centre).requireFinite("the radius of a circle");
        Vector3 along = unit.times(radius.dot(unit));
        this.centre = centre.plus(along);
        cosine = radius.minus(along);
        sine = unit.cross(cosine);
        omega = 2 * Math.PI / (Math.signum(period) * Require.positive("the length of a period", Math.abs(period)));
    }

    @Override
    public void at(double time, double[] values) {
        double sin = StrictMath.sin(omega * time);
        double cos = StrictMath.cos(omega * time);
        Vector3 from = cosine.times(cos).plus(sine.times(sin));
        from.plus(centre).put(values, 0);
        sine.times(cos).minus(cosine.times(sin)).times(omega).put(values, 3);
        from.times(-omega * omega).put(values, 6);
    }
}
