package particles.reactions.wires;

import particles.law.Vector3;

/** A straight wire: two components of x - point, across the line, are 0. */
public final class StraightWire implements Curve {
    private final double[] across = new double[6];
    private final double[] offset = new double[2];
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
        frame.first().put(across, 0);
        frame.second().put(across, 3);
        offset[0] = frame.first().dot(point);
        offset[1] = frame.second().dot(point);
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
    public void evaluate(double[] state, int x, double[] values, double[] gradients, double[] bends) {
        System.arraycopy(across, 0, gradients, 0, 6);
        for (int r = 0, g = 0; r < ROWS; r++, g += 3) {
            values[r] = across[g] * state[x] + across[g + 1] * state[x + 1] + across[g + 2] * state[x + 2] - offset[r];
            bends[r] = 0;
        }
    }
}
