package particles.reactions;

import java.util.function.DoubleUnaryOperator;
import particles.law.Require;
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

    /** {@inheritDoc} Infinite unless the curve is closed. */
    @Override
    default double length() {
        return Double.POSITIVE_INFINITY;
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

    /** A straight wire: two components of x - point, across the line, are 0. */
    final class StraightWire implements Curve {
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
            across = Curve.across(this.direction);
        }

        @Override
        public Vector3 at(double u) {
            return point.plus(direction.times(u));
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

    /**
     * A circular wire: in a plane, (x - c) . n = 0, and at distance r from the centre, (|x - c|&sup2; - r&sup2;) / (2
     * r) = 0.
     */
    final class CircularWire implements Curve {
        private final Vector3 centre;
        private final Vector3 axis;
        private final double radius;
        /** Two directions in the plane, for drawing. */
        private final Vector3[] across;

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
            this.across = Curve.across(this.axis);
        }

        @Override
        public Vector3 at(double u) {
            return centre.plus(across[0].times(radius * StrictMath.cos(u / radius)))
                    .plus(across[1].times(radius * StrictMath.sin(u / radius)));
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

    /**
     * A wire in the shape of a graph, y = f(x), in a plane with an origin and two orthogonal directions for x and y.
     */
    final class GraphWire implements Curve {
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
                throw new IllegalArgumentException("the directions " + along + " and " + up
                        + " of a wire are parallel");
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
}
