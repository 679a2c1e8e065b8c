package particles.scene.parts;

import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.function.Function;
import particles.effects.SharedKeys;
import particles.law.Obstacle;
import particles.law.Plane;
import particles.law.Vector3;
import particles.reactions.contact.ContactSurface;
import particles.reactions.contact.Friction;
import particles.rules.Collisions;
import particles.spec.Chosen;
import particles.spec.Key;
import particles.spec.Kind;
import particles.spec.MappingType;
import particles.spec.NameType;
import particles.spec.NumberType;
import particles.spec.Values;
import particles.spec.VectorType;

/** A kind of rule that a scene can name, with its keys; {@link #ALL} lists them. */
public abstract class RuleKind extends Kind {
    private static final Key<String> LAW = NameType.of("friction law", List.of("slide", "coulomb"))
            .required("law",
            "slide: F = k_f N v, the formula of the lecture's slides; coulomb: F = mu N. N is the normal force.");
    private static final Key<Double> COEFFICIENT = NumberType.notNegative("").required("coefficient",
            "k_f for slide (s/m), or mu for coulomb (a pure number).");
    private static final Key<Double> STATIC = NumberType.notNegative("").optional("static",
            "The largest force that holds a particle at rest, as a multiple of the normal force; by default mu for"
            + " coulomb and 0 for slide.");
    private static final Key<Double> THRESHOLD = NumberType.notNegative("m/s").withDefault("threshold", 0.01,
            "Below this speed a sliding particle comes to rest if static friction can hold it (m/s).");

    static final Key<Double> RESTITUTION = NumberType.between(0, 1, "").withDefault("restitution", 0.5,
            "r: a bounce turns the normal velocity v into -r v. With 0 nothing bounces; with 1 no energy is lost.");
    static final Key<Values> FRICTION = MappingType.of("'friction'", LAW, COEFFICIENT, STATIC, THRESHOLD)
            .optional("friction", "Friction on particles in contact with the surface; no friction if left out.");
    static final Key<Double> REST_SPEED = NumberType.notNegative("m/s").withDefault("restSpeed", 0.01,
            "A particle that would bounce off more slowly than this stays in contact (m/s).");

    RuleKind(String name, String sentence, Key<?>... keys) {
        super(name, sentence, keys);
    }

    /** Builds the rule and adds it to the scene. */
    public abstract void build(Values values, SceneAssembly assembly);

    /** @return the rule's solid, in which no particle may begin, if it has one */
    public Optional<Obstacle> obstacle(Values values) {
        return Optional.empty();
    }

    /** @return the key that names the fixed particle moved by the rule, if there is one */
    public Optional<Key<String>> anchor() {
        return Optional.empty();
    }

    /** @return the velocity that the rule gives at the start to the fixed particle that it moves (m/s) */
    public Vector3 startVelocity(Values values, ParticleIndex index) {
        return Vector3.ZERO;
    }

    /** @return the key with the prefix of new particles' ids, if the rule makes any */
    public Optional<Key<String>> newIds() {
        return Optional.empty();
    }

    /**
     * Returns the largest number of the rule's own particles that are alive at a time.
     *
     * @param deltaT   the time step (s)
     * @param duration the duration of the run (s)
     */
    public double alive(Values values, double deltaT, double duration) {
        return 0;
    }

    /** @return the radius of balls that meet each other unless they have their own (m); 0 if the rule makes none */
    public double ballRadius(Values values) {
        return 0;
    }

    /** @return whether this rule of a scene makes hard balls of particles */
    public static boolean hasBalls(Chosen<RuleKind> rule) {
        return rule.kind() == COLLISIONS;
    }

    /** @return whether it removes particles of any origin */
    public boolean removes() {
        return false;
    }

    /** @return whether it acts on springs only */
    public boolean needsSprings() {
        return false;
    }

    /** A rule for particles that meet a solid. */
    private static final class OfSolid extends RuleKind {
        private final Function<Values, Obstacle> solid;

        OfSolid(String name, String sentence, Function<Values, Obstacle> solid, Key<?>... keys) {
            super(name, sentence, keys);
            this.solid = solid;
        }

        @Override
        public Optional<Obstacle> obstacle(Values values) {
            return Optional.of(solid.apply(values));
        }

        @Override
        public void build(Values values, SceneAssembly assembly) {
            assembly.add(new ContactSurface(getName(), solid.apply(values), values.get(RESTITUTION),
                    values.find(FRICTION).map(RuleKind::friction).orElse(Friction.NONE), values.get(REST_SPEED),
                    assembly::radius));
        }
    }

    private static Friction friction(Values values) {
        Friction.Law law = Friction.Law.valueOf(values.get(LAW).toUpperCase(Locale.ROOT));
        double holding = values.find(STATIC).orElse(law == Friction.Law.COULOMB ? values.get(COEFFICIENT) : 0.0);
        return new Friction(law, values.get(COEFFICIENT), holding, values.get(THRESHOLD));
    }

    private static final Key<Double> HEIGHT = NumberType.any("m").withDefault("height", 0.0, "Its height (m).");

    private static final RuleKind GROUND = new OfSolid("ground",
            "Level ground: particles bounce off it, rest on it and slide along it.",
            values -> Plane.ground(values.get(HEIGHT)), HEIGHT, RESTITUTION, FRICTION, REST_SPEED);

    private static final Key<Vector3> POINT = VectorType.of("m").withDefault("point", Vector3.ZERO,
            "Any point of the plane (m).");
    private static final Key<Vector3> NORMAL = VectorType.notZero("").required("normal",
            "A vector that points out of the solid, to the side of the particles; its length does not matter.");

    private static final RuleKind PLANE = new OfSolid("plane",
            "A ramp or a wall: particles bounce off it, rest on it and slide along it.",
            values -> new Plane(values.get(POINT), values.get(NORMAL)),
            POINT, NORMAL, RESTITUTION, FRICTION, REST_SPEED);

    private static final RuleKind SPHERE = new OfSolid("sphere",
            "A ball, or the inside of a hollow one: particles bounce off it, rest on it and slide along it.",
            SharedKeys::sphere, SharedKeys.CENTRE, SharedKeys.RADIUS, SharedKeys.HOLLOW, RESTITUTION, FRICTION,
            REST_SPEED);

    private static final Key<Double> IMPACT_FRICTION = NumberType.notNegative("").withDefault("friction", 0.0,
            "mu: an impact changes the velocity along the surfaces by at most mu times that across them.");

    private static final RuleKind COLLISIONS = new RuleKind("collisions",
            "Particles are hard balls that bounce off each other, and touch solids with their surface.",
            SharedKeys.BALL_RADIUS, RESTITUTION, IMPACT_FRICTION, REST_SPEED) {
        @Override
        public double ballRadius(Values values) {
            return values.get(SharedKeys.BALL_RADIUS);
        }

        @Override
        public void build(Values values, SceneAssembly assembly) {
            double[] radii = new double[assembly.particles().count()];
            Arrays.setAll(radii, i -> assembly.ownRadius(i).orElse(ballRadius(values)));
            assembly.set(new Collisions.Balls(radii, values.get(RESTITUTION), values.get(IMPACT_FRICTION),
                    values.get(REST_SPEED)));
        }
    };

    /** All rules. */
    public static final List<RuleKind> ALL = List.of(GROUND, PLANE, SPHERE, COLLISIONS, BirthAndDeath.TEAR,
            MotionKinds.SHAKE, MotionKinds.CIRCLE, MotionKinds.GLIDE, BirthAndDeath.EMITTER, BirthAndDeath.KILL,
            BirthAndDeath.SAMPLES);
}
