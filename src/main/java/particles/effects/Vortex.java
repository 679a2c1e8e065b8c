package particles.effects;

import java.util.List;
import particles.law.Particles;
import particles.law.Require;
import particles.law.Vector3;
import particles.spec.Key;
import particles.spec.NumberType;
import particles.spec.Values;
import particles.spec.VectorType;

/**
 * A vortex: air that turns about an axis, in addition to other wind. At the distance r from the axis its speed is
 * <pre>
 *   u(r) = 2 U (r/R) / (1 + (r/R)^2)
 * </pre>
 * It turns like a solid body near the axis, has its largest speed U at r = R, and falls off as 1/r far away, where the
 * flow has no rotation. The field is smooth and has no divergence.
 *
 * <p>Source: W. Kaufmann (1962), M. Scully (1975).
 */
public final class Vortex implements Wind {

    private final Wind others;
    private final Vector3 point;
    private final Vector3 axis;
    private final double speed;
    private final double radius;

    /**
     * @param others the wind to which it is added
     * @param point  any point of the axis (m)
     * @param axis   the direction of the axis: the air turns counter-clockwise if it points at the viewer; not 0
     * @param speed  U (m/s); negative turns the other way
     * @param radius R (m), positive
     * @throws IllegalArgumentException if a number is out of its range
     */
    public Vortex(Wind others, Vector3 point, Vector3 axis, double speed, double radius) {
        this.others = others;
        this.point = point.requireFinite("the axis of a vortex");
        this.axis = axis.normalized();
        this.speed = speed;
        this.radius = Require.positive("the radius of a vortex", radius);
    }

    @Override
    public void getVelocities(double[] state, double time, double[] wind, int from, int to) {
        others.getVelocities(state, time, wind, from, to);
        for (int x = Particles.STRIDE * from; x < Particles.STRIDE * to; x += Particles.STRIDE) {
            Vector3 around = axis.cross(Vector3.at(state, x).minus(point));
            Vector3.at(wind, x + 3).plus(around.times(turn(around))).put(wind, x + 3);
        }
    }

    /** w = 2 U R / (R&sup2; + r&sup2;), so that u = w a x r, with the unit vector a along the axis. */
    private double turn(Vector3 around) {
        return 2 * speed * radius / (radius * radius + around.dot(around));
    }

    /**
     * {@inheritDoc} With the vector r from the axis, the derivative of u with respect to coordinate b is
     * w (a x e<sub>b</sub> - 2 r<sub>b</sub> / (R&sup2; + r&sup2;) a x r).
     */
    @Override
    public void getGradient(double[] state, double time, int i, double[] gradient) {
        others.getGradient(state, time, i, gradient);
        Vector3 around = axis.cross(Vector3.at(state, Particles.STRIDE * i).minus(point));
        Vector3 out = around.cross(axis);
        double turn = turn(around);
        for (int b = 0; b < 3; b++) {
            Vector3 unit = new Vector3(b == 0 ? 1 : 0, b == 1 ? 1 : 0, b == 2 ? 1 : 0);
            double square = radius * radius + around.dot(around);
            Vector3 column = axis.cross(unit).minus(around.times(2 * out.dot(unit) / square)).times(turn);
            gradient[b] += column.x();
            gradient[3 + b] += column.y();
            gradient[6 + b] += column.z();
        }
    }

    /** A vortex in scenes. */
    public static final class Keys extends EffectKind {
        private static final Key<Vector3> POINT = VectorType.of("m").withDefault("point", Vector3.ZERO,
                "Any point of its axis (m).");
        private static final Key<Vector3> AXIS = VectorType.notZero("").withDefault("axis", new Vector3(0, 1, 0),
                "The direction of its axis; the air turns counter-clockwise if it points at you.");
        private static final Key<Double> SPEED = NumberType.any("m/s").required("speed",
                "U (m/s): at the distance r from the axis the speed is 2 U (r/R) / (1 + (r/R)^2).");
        private static final Key<Double> RADIUS = NumberType.positive("m").withDefault("radius", 1.0,
                "R (m), the distance from the axis at which the air is fastest.");

        /** Called once, by {@link EffectCatalog}. */
        public Keys() {
            super("vortex", "Turns the air about an axis, in addition to other wind; felt only through drag.", POINT,
                    AXIS, SPEED, RADIUS);
        }

        @Override
        public void build(Values values, EffectContext scene) {
            scene.setWind(new Vortex(scene.wind(), values.get(POINT), values.get(AXIS), values.get(SPEED),
                    values.get(RADIUS)));
            scene.noteSpeed(Math.abs(values.get(SPEED)));
        }

        @Override
        public List<String> needs() {
            return List.of("drag", "quadraticDrag");
        }

        @Override
        public boolean isRepeatable() {
            return true;
        }
    }
}
