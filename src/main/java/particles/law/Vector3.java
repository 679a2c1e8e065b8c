package particles.law;

/**
 * A vector in space. The inner loops over springs and pairs of particles work on flat arrays instead.
 *
 * @param x to the right
 * @param y up
 * @param z towards the viewer of the default camera
 */
public record Vector3(double x, double y, double z) {
    /** The origin. */
    public static final Vector3 ZERO = new Vector3(0, 0, 0);

    /** @return the vector in three entries of an array, from an index on */
    public static Vector3 at(double[] values, int place) {
        return new Vector3(values[place], values[place + 1], values[place + 2]);
    }

    /** Writes the vector to three entries of an array, from an index on. */
    public void put(double[] values, int place) {
        values[place] = x;
        values[place + 1] = y;
        values[place + 2] = z;
    }

    /** @return the 1-norm, the sum of the absolute values of its components */
    public double norm1() {
        return Math.abs(x) + Math.abs(y) + Math.abs(z);
    }

    /** @return this + b */
    public Vector3 plus(Vector3 b) {
        return new Vector3(x + b.x, y + b.y, z + b.z);
    }

    /** @return this - b */
    public Vector3 minus(Vector3 b) {
        return new Vector3(x - b.x, y - b.y, z - b.z);
    }

    /** @return this times the number */
    public Vector3 times(double factor) {
        return new Vector3(factor * x, factor * y, factor * z);
    }

    /** @return this divided by the number */
    public Vector3 over(double divisor) {
        return new Vector3(x / divisor, y / divisor, z / divisor);
    }

    /** @return the scalar product */
    public double dot(Vector3 b) {
        return x * b.x + y * b.y + z * b.z;
    }

    /** @return the vector product, this x b */
    public Vector3 cross(Vector3 b) {
        return new Vector3(y * b.z - z * b.y, z * b.x - x * b.z, x * b.y - y * b.x);
    }

    /** @return whether all components are 0 or -0 */
    public boolean isZero() {
        return x == 0 && y == 0 && z == 0;
    }

    /** @return the length, without overflow or underflow on the way */
    public double length() {
        double largest = Math.max(Math.abs(x), Math.max(Math.abs(y), Math.abs(z)));
        if (largest == 0 || !Double.isFinite(largest)) {
            return largest;
        }
        double a = x / largest;
        double b = y / largest;
        double c = z / largest;
        return largest * Math.sqrt(a * a + b * b + c * c);
    }

    /**
     * @return the vector of length 1 in this direction
     * @throws IllegalArgumentException if this vector has no direction
     */
    public Vector3 normalized() {
        double length = length();
        if (!(length > 0) || !Double.isFinite(length)) {
            throw new IllegalArgumentException(this + " has no direction");
        }
        return over(length);
    }

    /**
     * @param name the name of the vector in the message
     * @return this vector
     * @throws IllegalArgumentException if one of the three is not a finite number
     */
    public Vector3 requireFinite(String name) {
        if (!isFinite()) {
            throw new IllegalArgumentException(name + " has to be finite, not " + this);
        }
        return this;
    }

    /** @return true if all three are finite numbers */
    public boolean isFinite() {
        return Double.isFinite(x) && Double.isFinite(y) && Double.isFinite(z);
    }
}
