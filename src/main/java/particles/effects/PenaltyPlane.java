package particles.effects;

import particles.law.Particles;
import particles.law.Plane;
import particles.law.Vector3;
import particles.spec.Key;
import particles.spec.NumberType;
import particles.spec.Values;
import particles.spec.VectorType;

/**
 * A stiff plane that pushes back particles below it, the slides' "penalty force"; the formula is in {@link Penalty}.
 * Without loss, a particle of mass m is inside for pi sqrt(m/k) and leaves as fast as it came.
 */
public final class PenaltyPlane extends Penalty {
    private final Plane plane;

    /**
     * @param particles the particles on which it acts
     * @param plane     the plane
     * @param stiffness k, the force per metre of depth (N/m), 0 or more
     * @param loss      b, the relative increase of the force per m/s of inward speed (s/m), 0 or more; 0 loses no
     *                  energy
     * @throws IllegalArgumentException if a number is out of its range
     */
    public PenaltyPlane(Particles particles, Plane plane, double stiffness, double loss) {
        super(particles, stiffness, loss);
        this.plane = plane;
    }

    @Override
    public String getName() {
        return "penaltyPlane";
    }

    @Override
    public void addForces(double[] state, double time, double[] force, int from, int to) {
        double nx = plane.normal().x();
        double ny = plane.normal().y();
        double nz = plane.normal().z();
        for (int x = STRIDE * from; x < STRIDE * to; x += STRIDE) {
            double depth = -plane.distance(state[x], state[x + 1], state[x + 2]);
            if (depth > 0) {
                double push = push(depth, nx * state[x + 3] + ny * state[x + 4] + nz * state[x + 5]);
                force[x + 3] += push * nx;
                force[x + 4] += push * ny;
                force[x + 5] += push * nz;
            }
        }
    }

    @Override
    double depth(double[] state, int i, double[] normal) {
        normal[0] = plane.normal().x();
        normal[1] = plane.normal().y();
        normal[2] = plane.normal().z();
        return -plane.distance(state[STRIDE * i], state[STRIDE * i + 1], state[STRIDE * i + 2]);
    }

    @Override
    double curvature(double[] state, int i) {
        return 0;
    }

    /** Penalty planes in scenes. */
    public static final class Keys extends EffectKind {
        private static final Key<Vector3> POINT = Key.withDefault("point", VectorType.of("m"), Vector3.ZERO,
                "Any point of the plane (m).");
        private static final Key<Vector3> NORMAL = Key.withDefault("normal", VectorType.notZero(""),
                new Vector3(0, 1, 0), "A vector that points out of the solid; its length does not matter.");

        private static final Key<Double> BALL_RADIUS = Key.withDefault("ballRadius", NumberType.notNegative("m"), 0.0,
                "The distance at which the plane begins to push (m): 0 for points, the radius for balls.");

        /** Called once, by {@link EffectCatalog}. */
        public Keys() {
            super("penaltyPlane", "A stiff plane that pushes back particles below it.", SharedKeys.STIFFNESS,
                    SharedKeys.LOSS, POINT, NORMAL, BALL_RADIUS);
        }

        @Override
        public void build(Values values, EffectContext scene) {
            Plane plane = new Plane(values.get(POINT), values.get(NORMAL));
            Vector3 lifted = plane.point().plus(plane.normal().times(values.get(BALL_RADIUS)));
            scene.add(new PenaltyPlane(scene.particles(), new Plane(lifted, plane.normal()),
                    values.get(SharedKeys.STIFFNESS), values.get(SharedKeys.LOSS)));
            scene.show(plane);
        }

        @Override
        public boolean isRepeatable() {
            return true;
        }
    }
}
