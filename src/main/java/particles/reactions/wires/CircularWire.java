package particles.reactions.wires;

import particles.law.Require;
import particles.law.Vector3;

/**
 * A circular wire: in a plane, (x - c) . n = 0, and at distance r from the centre, (|x - c|&sup2; - r&sup2;) / (2 r) =
 * 0.
 */
public final class CircularWire implements Curve {
    private final Vector3 centre;
    private final Vector3 axis;
    private final double radius;
    /** The axis and two directions across it, for drawing. */
    private final Frame frame;

    /**
     * @param centre c (m)
     * @param axis   n, across the circle's plane; of any length but zero
     * @param radius r (m), positive
     * @throws IllegalArgumentException if the radius is not positive
     */
    public CircularWire(Vector3 centre, Vector3 axis, double radius) {
        this.centre = centre;
        this.axis = axis.normalized();
        this.radius = Require.positive("the radius of a wire", radius);
        this.frame = Frame.around(axis);
    }

    @Override
    public Vector3 at(double u) {
        return centre.plus(frame.first().times(radius * StrictMath.cos(u / radius)))
                .plus(frame.second().times(radius * StrictMath.sin(u / radius)));
    }

    @Override
    public double length() {
        return 2 * Math.PI * radius;
    }

    @Override
    public double value(int k, Vector3 x) {
        Vector3 d = x.minus(centre);
        return k == 0 ? d.dot(axis) : (d.dot(d) - radius * radius) / (2 * radius);
    }

    @Override
    public Vector3 gradient(int k, Vector3 x) {
        Vector3 d = x.minus(centre);
        return k == 0 ? axis : d.over(radius);
    }

    @Override
    public double bend(int k, Vector3 x, Vector3 v) {
        return k == 0 ? 0 : v.dot(v) / radius;
    }
}
