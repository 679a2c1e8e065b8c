package particles.effects;

import deSolvers.ForceDerivatives;
import java.util.Optional;
import java.util.Set;
import particles.law.BriefForce;
import particles.law.CentralForce;
import particles.law.DifferentiableEffect;
import particles.law.Particles;
import particles.law.Passage;
import particles.law.PerParticleEffect;
import particles.law.Plane;
import particles.law.Require;
import particles.law.Sphere;
import particles.law.Vector3;
import particles.spec.Key;
import particles.spec.NumberType;
import particles.spec.Values;
import particles.spec.VectorType;

/**
 * The slides' "penalty force" of a stiff plane or sphere: a particle at depth d inside is pushed out along the surface
 * normal N,
 * <pre>
 *   F = k d max(0, 1 - b v_n) N        for d &gt; 0
 * </pre>
 * v_n = N . v, k stiffness, b bounce loss. The force is continuous, never pulls, and stores k d&sup2;/2. It does not
 * stop particles at the surface: they enter the solid a little. Without loss, a particle of mass m is inside a plane
 * for pi sqrt(m/k) and leaves as fast as it came. The centre of a ball has no normal: scenes and births with a particle
 * there are refused. One that passes through it is not pushed there.
 *
 * <p>Source of the damping: K. Hunt, F. Crossley, "Coefficient of restitution interpreted as damping in vibroimpact"
 * (1975).
 */
public final class Penalty implements PerParticleEffect, DifferentiableEffect, BriefForce, CentralForce {
    private static final int STRIDE = Particles.STRIDE;

    private final Particles particles;
    private final boolean round;
    private final double radius;
    private final double side;
    private final double[] origin = new double[3];      // a ball's centre, or a point of a plane
    private final double[] facing = new double[3];      // a plane's normal; 0 for a ball
    private final double stiffness;
    private final double loss;
    private final double[] normal = new double[3];
    private final double[] turning = new double[3];
    private final double[] dFdX = new double[9];
    private final double[] dFdV = new double[9];
    private final Passage passage = new Passage() {
        @Override
        protected double depth(double[] s) {
            return Penalty.this.depth(s, 0, length(s, 0));
        }

        @Override
        protected double sinking(double[] s) {
            return -normalSpeed(s, 0);
        }
    };

    /**
     * @param particles the particles on which it acts
     * @param solid     the solid
     * @param stiffness k, the force per metre of depth (N/m), 0 or more
     * @param loss      b, the relative increase of the force per m/s of inward speed (s/m), 0 or more; 0 loses no
     *                  energy
     * @throws IllegalArgumentException if a number is out of its range
     */
    public Penalty(Particles particles, Plane solid, double stiffness, double loss) {
        this(particles, solid.point(), solid.normal(), 0, stiffness, loss);
    }

    /**
     * @param particles the particles on which it acts
     * @param solid     the solid
     * @param stiffness k (N/m), 0 or more
     * @param loss      b (s/m), 0 or more
     * @throws IllegalArgumentException if a number is out of its range
     */
    public Penalty(Particles particles, Sphere solid, double stiffness, double loss) {
        this(particles, solid.centre(), Vector3.ZERO, solid.hollow() ? -solid.radius() : solid.radius(), stiffness,
                loss);
    }

    /** @param radius 0 for a plane, negative for a hollow sphere (m) */
    private Penalty(Particles particles, Vector3 origin, Vector3 facing, double radius, double stiffness, double loss) {
        this.particles = particles;
        round = radius != 0;
        this.radius = Math.abs(radius);
        side = radius < 0 ? -1 : 1;
        origin.put(this.origin, 0);
        facing.put(this.facing, 0);
        this.stiffness = Require.notNegative("a penalty's stiffness", stiffness);
        this.loss = Require.notNegative("a penalty's loss", loss);
    }

    @Override
    public String getName() {
        return round ? "penaltySphere" : "penaltyPlane";
    }

    @Override
    public void addForces(double[] state, double time, double[] force, int from, int to) {
        for (int x = STRIDE * from; x < STRIDE * to; x += STRIDE) {
            double length = length(state, x);
            double depth = depth(state, x, length);
            if (depth > 0 && length > 0) {
                double rx = r(state, x, 0);
                double ry = r(state, x, 1);
                double rz = r(state, x, 2);
                double out = side / length;
                double speed = out * (rx * state[x + 3] + ry * state[x + 4] + rz * state[x + 5]);
                double push = out * push(depth, speed);
                force[x + 3] += push * rx;
                force[x + 4] += push * ry;
                force[x + 5] += push * rz;
            }
        }
    }

    /** A component of r, the vector from a ball's centre, or a plane's normal: N = side r / |r|. */
    private double r(double[] state, int x, int c) {
        return round ? state[x + c] - origin[c] : facing[c];
    }

    /** |r|; a particle's state begins at x. */
    private double length(double[] state, int x) {
        double rx = r(state, x, 0);
        double ry = r(state, x, 1);
        double rz = r(state, x, 2);
        return round ? Math.sqrt(rx * rx + ry * ry + rz * rz) : 1;
    }

    private double depth(double[] state, int x, double length) {
        return round ? side * (radius - length) : (origin[0] - state[x]) * facing[0]
                + (origin[1] - state[x + 1]) * facing[1] + (origin[2] - state[x + 2]) * facing[2];
    }

    /** The push along the normal (N) for d > 0. */
    private double push(double depth, double normalSpeed) {
        return stiffness * depth * Math.max(0, 1 - loss * normalSpeed);
    }

    /** The depth of a free particle, at most 0 outside. */
    private double depth(double[] state, int i) {
        int x = STRIDE * i;
        return particles.isFixed(i) ? 0 : depth(state, x, length(state, x));
    }

    /** {@inheritDoc} A solid ball is passed no sooner than at its far side; a plane or a hollow ball never. */
    @Override
    public double getShortestTime(double[] state, double time) {
        double shortest = Double.POSITIVE_INFINITY;
        for (int i = 0; round && side > 0 && i < particles.count(); i++) {
            int x = STRIDE * i;
            double square = state[x + 3] * state[x + 3] + state[x + 4] * state[x + 4] + state[x + 5] * state[x + 5];
            if (square > 0 && !particles.isFixed(i)) {
                shortest = Math.min(shortest, (length(state, x) + radius) / Math.sqrt(square));
            }
        }
        return shortest;
    }

    @Override
    public double findPassage(double[] from, double[] to, double duration) {
        return passage.find(particles, from, to, duration);
    }

    @Override
    public Optional<String> findUndirected(double[] state, int first) {
        for (int i = first; round && side > 0 && i < particles.count(); i++) {
            if (depth(state, i) > 0 && length(state, STRIDE * i) == 0) {
                return Optional.of("'" + particles.id(i) + "' is at the centre of " + getName()
                        + ", where it has no direction in which to push");
            }
        }
        return Optional.empty();
    }

    @Override
    public Set<Trait> getTraits() {
        return Set.of(loss > 0 ? Trait.DISSIPATIVE : Trait.CONSERVATIVE);
    }

    @Override
    public boolean dependsOnVelocity() {
        return loss > 0;
    }

    @Override
    public double getPotentialEnergy(double[] state, double time) {
        double energy = 0;
        for (int i = 0; i < particles.count(); i++) {
            double depth = Math.max(0, depth(state, i));
            energy += stiffness * depth * depth / 2;
        }
        return energy;
    }

    /** {@inheritDoc} The rate at which the potential falls minus the power on the particle. */
    @Override
    public double getDissipatedPower(double[] state, double time) {
        double power = 0;
        for (int i = 0; loss > 0 && i < particles.count(); i++) {
            double depth = depth(state, i);
            if (depth > 0) {
                double speed = normalSpeed(state, i);
                power += speed * (stiffness * depth - push(depth, speed));
            }
        }
        return power;
    }

    /** The speed outwards; also sets the normal. */
    private double normalSpeed(double[] state, int i) {
        int x = STRIDE * i;
        double length = length(state, x);
        for (int c = 0; c < 3; c++) {
            normal[c] = length > 0 ? side * r(state, x, c) / length : 0;
        }
        return normal[0] * state[x + 3] + normal[1] * state[x + 4] + normal[2] * state[x + 5];
    }

    @Override
    public void addForceDerivatives(double[] state, double time, ForceDerivatives derivatives) {
        for (int i = 0; i < particles.count(); i++) {
            double depth = depth(state, i);
            if (!(depth > 0)) {
                continue;
            }
            double speed = normalSpeed(state, i);
            double push = push(depth, speed);
            double bySpeed = push > 0 ? -stiffness * depth * loss : 0;
            int x = STRIDE * i;
            double length = length(state, x);
            double curvature = round && length > 0 ? side / length : 0;
            for (int c = 0; c < 3; c++) {               // d(push)/dx = -dpush/dd N + ...
                turning[c] = -push / depth * normal[c]
                        + bySpeed * curvature * (state[x + 3 + c] - speed * normal[c]);
            }
            for (int e = 0; e < 9; e++) {
                dFdX[e] = normal[e / 3] * turning[e % 3]
                        + push * curvature * ((e % 4 == 0 ? 1 : 0) - normal[e / 3] * normal[e % 3]);
                dFdV[e] = bySpeed * normal[e / 3] * normal[e % 3];
            }
            derivatives.add(i, i, dFdX, dFdV);
        }
    }

    /** Penalty planes in scenes. */
    public static final class PlaneKeys extends EffectKind {
        // not private: to check the access from another class, Java would load the law itself
        static final Key<Double> STIFFNESS = NumberType.notNegative("N/m").required("stiffness",
                "k, the push per metre of depth (N/m).");
        static final Key<Double> LOSS = NumberType.notNegative("s/m").withDefault("loss", 0.0,
                "b (s/m): at depth d and inward speed v the push is k d (1 + b v), and never negative;"
                + " 0 loses no energy.");
        private static final Key<Vector3> POINT = VectorType.of("m").withDefault("point", Vector3.ZERO,
                "Any point of the plane (m).");
        private static final Key<Vector3> NORMAL = VectorType.notZero("").withDefault("normal", new Vector3(0, 1, 0),
                "A vector that points out of the solid; its length does not matter.");

        private static final Key<Double> BALL_RADIUS = NumberType.notNegative("m").withDefault("ballRadius", 0.0,
                "The distance at which the plane begins to push (m): 0 for points, the radius for balls.");

        /** Called once, by {@link EffectCatalog}. */
        public PlaneKeys() {
            super("penaltyPlane", "A stiff plane that pushes back particles below it.", STIFFNESS, LOSS, POINT,
                    NORMAL, BALL_RADIUS);
        }

        @Override
        public void build(Values values, EffectContext scene) {
            Plane plane = new Plane(values.get(POINT), values.get(NORMAL));
            Vector3 lifted = plane.point().plus(plane.normal().times(values.get(BALL_RADIUS)));
            scene.add(new Penalty(scene.particles(), new Plane(lifted, plane.normal()), values.get(STIFFNESS),
                    values.get(LOSS)));
            scene.show(plane);
        }

        @Override
        public boolean isRepeatable() {
            return true;
        }
    }

    /** Penalty spheres in scenes; the keys of the force are those of planes. */
    public static final class SphereKeys extends EffectKind {
        /** Called once, by {@link EffectCatalog}. */
        public SphereKeys() {
            super("penaltySphere", "A stiff ball that pushes particles out, or a hollow one that pushes them in.",
                    SharedKeys.CENTRE, SharedKeys.RADIUS, SharedKeys.HOLLOW, PlaneKeys.STIFFNESS, PlaneKeys.LOSS);
        }

        @Override
        public void build(Values values, EffectContext scene) {
            Sphere sphere = SharedKeys.sphere(values);
            scene.add(new Penalty(scene.particles(), sphere, values.get(PlaneKeys.STIFFNESS),
                    values.get(PlaneKeys.LOSS)));
            scene.show(sphere);
        }

        @Override
        public boolean isRepeatable() {
            return true;
        }
    }
}
