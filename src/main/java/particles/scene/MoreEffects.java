package particles.scene;

import java.util.List;
import java.util.Optional;
import particles.Plane;
import particles.Sphere;
import particles.Vector3;
import particles.effects.Cohesion;
import particles.effects.PenaltyPlane;
import particles.effects.PenaltySphere;
import particles.effects.PointAttraction;
import particles.effects.QuadraticDrag;
import particles.effects.TurbulentWind;
import particles.spec.FlagType;
import particles.spec.Key;
import particles.spec.NumberType;
import particles.spec.Values;
import particles.spec.VectorType;
import particles.spec.WholeNumberType;

/** The effects beyond those of the first scenes; {@link EffectKind#ALL} lists them. */
final class MoreEffects {
    private MoreEffects() {
    }

    static final Key<Integer> SEED = Key.withDefault("seed", new WholeNumberType(0, 1_000_000_000), 1,
            "Which of all random sequences; the same seed gives the same run on every machine.");

    private static final Key<Double> STRENGTH = Key.required("strength", NumberType.notNegative("m/s"),
            "The root mean square of the eddies' speed (m/s).");
    private static final Key<Double> EDDY_SIZE = Key.withDefault("eddySize", NumberType.positive("m"), 1.0,
            "How large the largest eddies are (m); the smallest are an eighth of that.");
    private static final Key<Vector3> STEADY = Key.withDefault("mean", VectorType.of("m/s"), Vector3.ZERO,
            "The steady wind that carries the eddies along (m/s).");

    static final EffectKind TURBULENCE = new EffectKind("turbulence", "The air moves in eddies of many sizes, and drag carries"
            + " particles with it.", STRENGTH, EDDY_SIZE, STEADY, SEED) {
        @Override
        void build(Values values, SceneAssembly assembly) {
            assembly.blow(new TurbulentWind(values.get(STEADY), values.get(STRENGTH), values.get(EDDY_SIZE), values.get(SEED)));
            assembly.noteSpeed(values.get(STEADY).length() + values.get(STRENGTH));
        }

        @Override
        List<EffectKind> needs() {
            return drags();
        }

        @Override
        Optional<EffectKind> excludes() {
            return Optional.of(WIND);
        }
    };

    private static final Key<Double> QUADRATIC = Key.required("coefficient", NumberType.notNegative("kg/m"),
            "c, the force on a particle over the square of its speed through the air: half the air's density times cross-section"
            + " times drag coefficient (kg/m).");

    static final EffectKind QUADRATIC_DRAG = new EffectKind("quadraticDrag", "Air resists every particle in proportion to the"
            + " square of its speed through the air.", QUADRATIC) {
        @Override
        void build(Values values, SceneAssembly assembly) {
            assembly.add(new QuadraticDrag(assembly.particles(), values.get(QUADRATIC), assembly.wind()));
        }
    };

    private static final Key<Vector3> CENTRE = Key.withDefault("centre", VectorType.of("m"), Vector3.ZERO,
            "The point that attracts (m).");
    private static final Key<Double> MU = Key.required("strength", NumberType.any("m^3/s^2"),
            "mu, the acceleration at 1 m (m^3/s^2); negative repels.");
    private static final Key<Double> SOFTENING = Key.withDefault("softening", NumberType.notNegative("m"), 0.0,
            "s: the force is that of a point at the distance sqrt(r^2 + s^2), and particles may pass through the point (m).");

    static final EffectKind ATTRACTION = new EffectKind("attraction", "A point attracts every particle as the sun does.", MU,
            CENTRE, SOFTENING) {
        @Override
        void build(Values values, SceneAssembly assembly) {
            assembly.add(new PointAttraction(assembly.particles(), values.get(CENTRE), values.get(MU), values.get(SOFTENING)));
        }

        @Override
        boolean isRepeatable() {
            return true;
        }
    };

    private static final Key<Double> RANGE = Key.required("range", NumberType.positive("m"),
            "The distance beyond which two particles do not feel each other (m).");
    private static final Key<Double> BALANCE = Key.withDefault("balance", NumberType.between(0.05, 0.95, ""), 0.6,
            "At which part of the range two particles neither attract nor repel each other.");
    private static final Key<Double> DEPTH = Key.required("depth", NumberType.positive("J"),
            "The energy that it takes to separate two particles (J).");
    private static final Key<Double> DAMPING = Key.withDefault("damping", NumberType.notNegative("N s/m"), 0.0,
            "What slows two near particles that approach each other or part (N s/m).");

    static final EffectKind COHESION = new EffectKind("cohesion", "Near particles repel and less near ones attract each other, so"
            + " that many hold together like a drop.", RANGE, BALANCE, DEPTH, DAMPING) {
        @Override
        void build(Values values, SceneAssembly assembly) {
            double range = values.get(RANGE);
            assembly.add(new Cohesion(assembly.particles(), range, range * values.get(BALANCE), values.get(DEPTH),
                    values.get(DAMPING)));
        }
    };

    private static final Key<Double> STIFFNESS = Key.required("stiffness", NumberType.notNegative("N/m"),
            "k, the push for each metre of depth (N/m).");
    private static final Key<Double> LOSS = Key.withDefault("loss", NumberType.notNegative("s/m"), 0.0,
            "By what part the push is larger for each m/s of speed inwards, and smaller outwards (s/m); 0 loses no energy.");
    private static final Key<Vector3> POINT = Key.withDefault("point", VectorType.of("m"), Vector3.ZERO,
            "Any point of the plane (m).");
    private static final Key<Vector3> NORMAL = Key.withDefault("normal", VectorType.notZero(""), new Vector3(0, 1, 0),
            "N, the direction out of the solid; of any length.");

    static final EffectKind PENALTY_PLANE = new EffectKind("penaltyPlane", "A stiff plane pushes particles back that are below"
            + " it.", STIFFNESS, LOSS, POINT, NORMAL) {
        @Override
        void build(Values values, SceneAssembly assembly) {
            Plane plane = new Plane(values.get(POINT), values.get(NORMAL));
            assembly.add(new PenaltyPlane(assembly.particles(), plane, values.get(STIFFNESS), values.get(LOSS)));
            assembly.show(plane);
        }

        @Override
        boolean isRepeatable() {
            return true;
        }
    };

    static final Key<Vector3> SPHERE_CENTRE = Key.required("centre", VectorType.of("m"), "Where its middle is (m).");
    static final Key<Double> RADIUS = Key.required("radius", NumberType.positive("m"), "Its radius (m).");
    static final Key<Boolean> HOLLOW = Key.withDefault("hollow", FlagType.FLAG, false,
            "Whether particles belong inside it, as in a bowl or a bubble, and not outside.");

    static Sphere sphere(Values values) {
        return new Sphere(values.get(SPHERE_CENTRE), values.get(RADIUS), values.get(HOLLOW));
    }

    static final EffectKind PENALTY_SPHERE = new EffectKind("penaltySphere", "A stiff ball pushes particles out, or a hollow one"
            + " pushes them in.", SPHERE_CENTRE, RADIUS, HOLLOW, STIFFNESS, LOSS) {
        @Override
        void build(Values values, SceneAssembly assembly) {
            assembly.add(new PenaltySphere(assembly.particles(), sphere(values), values.get(STIFFNESS), values.get(LOSS)));
            assembly.show(sphere(values));
        }

        @Override
        boolean isRepeatable() {
            return true;
        }
    };
}
