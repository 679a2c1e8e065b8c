package particles.reactions.wires;

import particles.law.Vector3;

/** A straight wire: two components of x - point, across the line, are 0. */
public final class StraightWire implements Curve {
    private final Vector3[] across;
    private final Vector3 point;
    private final Vector3 direction;

    /**
     * @param point     any point of the line (m)
     * @param direction the direction of the line; of any length but zero
     */
    public StraightWire(Vector3 point, Vector3 direction) {
        this.point = point;
        this.direction = direction.normalized();
        Frame frame = Frame.around(direction);
        across = new Vector3[] {frame.first(), frame.second()};
    }

    @Override
    public Vector3 at(double u) {
        return point.plus(direction.times(u));
    }

    @Override
    public double length() {
        return Double.POSITIVE_INFINITY;
    }

    @Override
    public double value(int k, Vector3 x) {
        return across[k].dot(x) - across[k].dot(point);
    }

    @Override
    public Vector3 gradient(int k, Vector3 x) {
        return across[k];
    }

    @Override
    public double bend(int k, Vector3 x, Vector3 v) {
        return 0;
    }
}
