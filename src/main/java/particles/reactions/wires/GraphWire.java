package particles.reactions.wires;

import java.util.function.DoubleUnaryOperator;
import particles.law.Require;
import particles.law.Vector3;

/** A wire in the shape of a graph, y = f(x), in a plane with an origin and two orthogonal directions for x and y. */
public final class GraphWire implements Curve {

    /**
     * A smooth function of one variable.
     *
     * @param value f(x) (m)
     * @param slope f'(x)
     * @param bend  f''(x) (1/m)
     */
    public record Profile(DoubleUnaryOperator value, DoubleUnaryOperator slope, DoubleUnaryOperator bend) {
    }

    private final Vector3 origin;
    private final Vector3 along;
    private final Vector3 up;
    private final Vector3 across;
    private final Profile profile;

    /**
     * @param origin  the point x = y = 0 (m)
     * @param along   the direction of x; of any length but zero
     * @param up      the direction of y; its component along x is removed
     * @param profile f
     * @throws IllegalArgumentException if the directions are parallel
     */
    public GraphWire(Vector3 origin, Vector3 along, Vector3 up, Profile profile) {
        this.origin = origin;
        this.along = along.normalized();
        Vector3 rest = up.minus(this.along.times(up.dot(this.along)));
        if (!(rest.length() > 1e-9 * up.length())) {
            throw new IllegalArgumentException("the directions " + along + " and " + up + " of a wire are parallel");
        }
        this.up = rest.normalized();
        this.across = this.along.cross(this.up);
        this.profile = profile;
    }

    /**
     * @param curvature f'' (1/m); positive for a valley
     * @return f(x) = f'' x&sup2; / 2
     */
    public static Profile parabola(double curvature) {
        return new Profile(x -> curvature * x * x / 2, x -> curvature * x, x -> curvature);
    }

    /**
     * @param amplitude  A (m)
     * @param wavelength lambda (m), not zero
     * @return f(x) = A sin(2 pi x / lambda)
     * @throws IllegalArgumentException if the wavelength is zero or a number not finite
     */
    public static Profile sine(double amplitude, double wavelength) {
        Require.notNegative("the size of a sine's amplitude", Math.abs(amplitude));
        Require.positive("the size of its wavelength", Math.abs(wavelength));
        double k = 2 * Math.PI / wavelength;
        return new Profile(x -> amplitude * StrictMath.sin(k * x), x -> amplitude * k * StrictMath.cos(k * x),
                x -> -amplitude * k * k * StrictMath.sin(k * x));
    }

    /** {@inheritDoc} Here u is x. */
    @Override
    public Vector3 at(double u) {
        return origin.plus(along.times(u)).plus(up.times(profile.value.applyAsDouble(u)));
    }

    @Override
    public double length() {
        return Double.POSITIVE_INFINITY;
    }

    @Override
    public double value(int k, Vector3 x) {
        Vector3 d = x.minus(origin);
        return k == 0 ? d.dot(across) : d.dot(up) - profile.value.applyAsDouble(d.dot(along));
    }

    @Override
    public Vector3 gradient(int k, Vector3 x) {
        return k == 0 ? across : up.minus(along.times(profile.slope.applyAsDouble(x.minus(origin).dot(along))));
    }

    @Override
    public double bend(int k, Vector3 x, Vector3 v) {
        double speed = v.dot(along);
        return k == 0 ? 0 : -profile.bend.applyAsDouble(x.minus(origin).dot(along)) * speed * speed;
    }
}
