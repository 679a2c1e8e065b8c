package particles.reactions;

import java.util.List;
import java.util.function.DoubleFunction;
import java.util.function.DoubleUnaryOperator;
import particles.law.Require;
import particles.law.Vector3;
import particles.view.Scenery.CurveView;

/**
 * A wire: a curve in space along which a bead slides, where two surfaces meet.
 *
 * @param surfaces the two surfaces, with linearly independent gradients on the curve
 * @param path     the points of the curve, for drawing
 * @param length   the length of a closed curve (m), infinite for an open one
 */
public record Curve(List<Surface> surfaces, DoubleFunction<Vector3> path, double length) implements CurveView {

    /** A surface, given as the zeros of a smooth function of position. */
    public interface Surface {
        /** @return the function at a point: near the surface about the distance from it (m) */
        double value(Vector3 x);

        /** @return its gradient */
        Vector3 gradient(Vector3 x);

        /** @return its second derivative along a velocity: v<sup>T</sup> H v with the matrix H of second derivatives */
        double bend(Vector3 x, Vector3 v);
    }

    /** A plane, (x - point) . N = 0. */
    private record Flat(Vector3 point, Vector3 normal) implements Surface {
        @Override
        public double value(Vector3 x) {
            return x.minus(point).dot(normal);
        }

        @Override
        public Vector3 gradient(Vector3 x) {
            return normal;
        }

        @Override
        public double bend(Vector3 x, Vector3 v) {
            return 0;
        }
    }

    /** A sphere, (|x - c|&sup2; - r&sup2;) / (2 r) = 0. */
    private record Round(Vector3 centre, double radius) implements Surface {
        @Override
        public double value(Vector3 x) {
            Vector3 d = x.minus(centre);
            return (d.dot(d) - radius * radius) / (2 * radius);
        }

        @Override
        public Vector3 gradient(Vector3 x) {
            return x.minus(centre).over(radius);
        }

        @Override
        public double bend(Vector3 x, Vector3 v) {
            return v.dot(v) / radius;
        }
    }

    /** A graph's y - f(x) = 0, measured from an origin. */
    private record Graph(Vector3 origin, Profile profile) implements Surface {
        @Override
        public double value(Vector3 at) {
            Vector3 d = at.minus(origin);
            return d.y() - profile.value.applyAsDouble(d.x());
        }

        @Override
        public Vector3 gradient(Vector3 at) {
            return new Vector3(-profile.slope.applyAsDouble(at.x() - origin.x()), 1, 0);
        }

        @Override
        public double bend(Vector3 at, Vector3 v) {
            return -profile.bend.applyAsDouble(at.x() - origin.x()) * v.x() * v.x();
        }
    }

    /**
     * A smooth function of one variable.
     *
     * @param value f(x) (m)
     * @param slope f'(x)
     * @param bend  f''(x) (1/m)
     */
    public record Profile(DoubleUnaryOperator value, DoubleUnaryOperator slope, DoubleUnaryOperator bend) {
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
    }

    /**
     * A straight wire.
     *
     * @param point     any of its points (m)
     * @param direction of any length but zero
     */
    public static Curve line(Vector3 point, Vector3 direction) {
        Vector3 along = direction.normalized();
        Vector3[] across = across(along);
        return new Curve(List.of(new Flat(point, across[0]), new Flat(point, across[1])),
                u -> point.plus(along.times(u)), Double.POSITIVE_INFINITY);
    }

    /**
     * A circular wire, in a plane and on a sphere.
     *
     * @param centre c (m)
     * @param axis   across the circle's plane; of any length but zero
     * @param radius r (m), positive
     * @throws IllegalArgumentException if the radius is not positive
     */
    public static Curve circle(Vector3 centre, Vector3 axis, double radius) {
        Vector3 normal = axis.normalized();
        Vector3[] across = across(normal);
        return new Curve(List.of(new Flat(centre, normal),
                new Round(centre, Require.positive("the radius of a wire", radius))),
                u -> centre.plus(across[0].times(radius * StrictMath.cos(u / radius)))
                        .plus(across[1].times(radius * StrictMath.sin(u / radius))), 2 * Math.PI * radius);
    }

    /**
     * A wire in the shape of a graph, y = f(x), in a plane of constant z.
     *
     * @param origin  the point x = y = 0 (m)
     * @param profile f
     */
    public static Curve graph(Vector3 origin, Profile profile) {
        return new Curve(List.of(new Flat(origin, new Vector3(0, 0, 1)), new Graph(origin, profile)),
                x -> origin.plus(new Vector3(x, profile.value.applyAsDouble(x), 0)), Double.POSITIVE_INFINITY);
    }

    /** Two orthogonal unit vectors across one, from the coordinate axis that is farthest from it. */
    private static Vector3[] across(Vector3 axis) {
        double x = Math.abs(axis.x());
        double y = Math.abs(axis.y());
        double z = Math.abs(axis.z());
        Vector3 far = x <= y && x <= z ? new Vector3(1, 0, 0) : y <= z ? new Vector3(0, 1, 0) : new Vector3(0, 0, 1);
        Vector3 first = axis.cross(far).normalized();
        return new Vector3[] {first, axis.cross(first)};
    }

    @Override
    public Vector3 at(double u) {
        return path.apply(u);
    }
}
