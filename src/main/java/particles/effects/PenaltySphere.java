package particles.effects;

import particles.law.Particles;
import particles.law.Sphere;
import particles.spec.Values;

/**
 * A stiff sphere that pushes out particles inside it, or pushes them in if it is hollow; the formula is in {@link
 * Penalty}. At the centre of a ball, which has no normal, the force is 0.
 */
public final class PenaltySphere extends Penalty {
    private final Sphere sphere;
    private final double side;

    /**
     * @param particles the particles on which it acts
     * @param sphere    the sphere
     * @param stiffness k, the force per metre of depth (N/m), 0 or more
     * @param loss      b, the relative increase of the force per m/s of inward speed (s/m), 0 or more; 0 loses no
     *                  energy
     * @throws IllegalArgumentException if a number is out of its range
     */
    public PenaltySphere(Particles particles, Sphere sphere, double stiffness, double loss) {
        super(particles, stiffness, loss);
        this.sphere = sphere;
        side = sphere.hollow() ? -1 : 1;
    }

    @Override
    public String getName() {
        return "penaltySphere";
    }

    @Override
    public void addForces(double[] state, double time, double[] force, int from, int to) {
        double cx = sphere.centre().x();
        double cy = sphere.centre().y();
        double cz = sphere.centre().z();
        for (int x = STRIDE * from; x < STRIDE * to; x += STRIDE) {
            double rx = state[x] - cx;
            double ry = state[x + 1] - cy;
            double rz = state[x + 2] - cz;
            double length = Math.sqrt(rx * rx + ry * ry + rz * rz);
            double depth = side * (sphere.radius() - length);
            if (depth > 0 && length > 0) {
                double out = side / length;
                double speed = out * (rx * state[x + 3] + ry * state[x + 4] + rz * state[x + 5]);
                double push = out * push(depth, speed);
                force[x + 3] += push * rx;
                force[x + 4] += push * ry;
                force[x + 5] += push * rz;
            }
        }
    }

    @Override
    double depth(double[] state, int i, double[] normal) {
        double length = length(state, i);
        normal[0] = length > 0 ? side * (state[STRIDE * i] - sphere.centre().x()) / length : 0;
        normal[1] = length > 0 ? side * (state[STRIDE * i + 1] - sphere.centre().y()) / length : 0;
        normal[2] = length > 0 ? side * (state[STRIDE * i + 2] - sphere.centre().z()) / length : 0;
        return side * (sphere.radius() - length);
    }

    @Override
    double curvature(double[] state, int i) {
        double length = length(state, i);
        return length > 0 ? side / length : 0;
    }

    private double length(double[] state, int i) {
        double rx = state[STRIDE * i] - sphere.centre().x();
        double ry = state[STRIDE * i + 1] - sphere.centre().y();
        double rz = state[STRIDE * i + 2] - sphere.centre().z();
        return Math.sqrt(rx * rx + ry * ry + rz * rz);
    }

    /** Penalty spheres in scenes. */
    public static final class Keys extends EffectKind {
        /** Called once, by {@link EffectCatalog}. */
        public Keys() {
            super("penaltySphere", "A stiff ball that pushes particles out, or a hollow one that pushes them in.",
                    SharedKeys.CENTRE, SharedKeys.RADIUS, SharedKeys.HOLLOW, SharedKeys.STIFFNESS, SharedKeys.LOSS);
        }

        @Override
        public void build(Values values, EffectContext scene) {
            Sphere sphere = SharedKeys.sphere(values);
            scene.add(new PenaltySphere(scene.particles(), sphere, values.get(SharedKeys.STIFFNESS),
                    values.get(SharedKeys.LOSS)));
            scene.show(sphere);
        }

        @Override
        public boolean isRepeatable() {
            return true;
        }
    }
}
