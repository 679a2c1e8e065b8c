package particles.scene.parts;

import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.function.BiConsumer;
import java.util.function.BiFunction;
import java.util.function.Function;
import java.util.function.ToDoubleBiFunction;
import java.util.stream.Stream;
import particles.effects.SharedKeys;
import particles.law.AnchorMotion;
import particles.law.AnchorMotion.CircleMotion;
import particles.law.AnchorMotion.GlideMotion;
import particles.law.AnchorMotion.SineMotion;
import particles.law.Obstacle;
import particles.law.Plane;
import particles.law.Vector3;
import particles.reactions.ContactSurface;
import particles.reactions.ContactSurface.Bounce;
import particles.reactions.ContactSurface.Friction;
import particles.rules.Collisions;
import particles.spec.FlagType;
import particles.spec.Key;
import particles.spec.Kind;
import particles.spec.Kind.Chosen;
import particles.spec.MappingType;
import particles.spec.NameType;
import particles.spec.NumberType;
import particles.spec.TextType;
import particles.spec.Values;
import particles.spec.VectorType;

/** A kind of rule that a scene can name, with its keys; {@link RuleCatalog} lists them. */
public class RuleKind extends Kind {
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

    private static final Key<Boolean> IN_IMPACTS = FlagType.FLAG.withDefault("impacts", true,
            "Whether Coulomb friction acts at impacts too; with false they keep the velocity along the surface, as"
            + " on the slides.");

    static final Key<Double> RESTITUTION = NumberType.between(0, 1, "").withDefault("restitution", 0.5,
            "r: a bounce turns the normal velocity v into -r v. With 0 nothing bounces; with 1 no energy is lost.");
    /** Of the rules for solids. */
    public static final Key<Values> FRICTION = MappingType.of("'friction'", LAW, COEFFICIENT, STATIC, THRESHOLD,
            IN_IMPACTS)
            .optional("friction", "Friction on particles in contact with the surface; no friction if left out.");
    static final Key<Double> REST_SPEED = NumberType.notNegative("m/s").withDefault("restSpeed", 0.01,
            "A particle that would bounce off more slowly than this stays in contact (m/s); with restitution 1, none.");

    /** The anchor that a prescribed motion moves; other rules have no key of this name. */
    public static final Key<String> ANCHOR = TextType.of("the id of a fixed particle", "\\S").required("particle",
            "The particle to move, starting from its position. It must be fixed.");

    private final BiConsumer<Values, SceneAssembly> builder;

    /** With a function that builds the rule and adds it to the scene. */
    RuleKind(String name, String sentence, BiConsumer<Values, SceneAssembly> builder, Key<?>... keys) {
        super(name, sentence, keys);
        this.builder = builder;
    }

    /** Builds the rule and adds it to the scene. */
    public final void build(Values values, SceneAssembly assembly) {
        builder.accept(values, assembly);
    }

    /** @return the rule's solid, in which no particle may begin, if it has one */
    public Optional<Obstacle> obstacle(Values values) {
        return Optional.empty();
    }

    /** @return the velocity that the rule gives at the start to the fixed particle that it moves (m/s) */
    public Vector3 startVelocity(Values values, ParticleIndex index) {
        return Vector3.ZERO;
    }

    /** @return the key with the prefix of new particles' ids, if the rule makes any */
    public final Optional<Key<String>> newIds() {
        return Stream.of(BirthAndDeath.ID, BirthAndDeath.SAMPLE_ID).filter(getKeys()::contains).findFirst();
    }

    /**
     * Returns the largest number of a rule's own particles that are alive at a time.
     *
     * @param deltaT   the time step (s)
     * @param duration the duration of the run (s)
     */
    public static double alive(Values rule, double deltaT, double duration) {
        // deaths come at the end of a step, after all births of that step
        return rule.find(BirthAndDeath.RATE).orElse(0.0)
                * Math.min(duration, rule.find(BirthAndDeath.LIFETIME).orElse(duration) + deltaT);
    }

    /** @return whether a rule makes particles bounce lower and lower, without end */
    public static boolean bouncesForEver(Chosen<RuleKind> rule) {
        return rule.values().find(REST_SPEED).filter(speed -> speed == 0).isPresent()
                && rule.values().get(RESTITUTION) > 0 && rule.values().get(RESTITUTION) < 1;
    }

    /** @return whether this rule of a scene makes hard balls of particles */
    public static boolean hasBalls(Chosen<RuleKind> rule) {
        return rule.kind() == COLLISIONS;
    }

    /** A rule for particles that meet a solid. */
    private static RuleKind ofSolid(String name, String sentence, Function<Values, Obstacle> solid, Key<?>... keys) {
        return new RuleKind(name, sentence, (values, assembly) -> assembly.add(new ContactSurface(name,
                solid.apply(values), new Bounce(values.get(RESTITUTION),
                values.find(FRICTION).map(RuleKind::ofImpacts).orElse(0.0), values.get(REST_SPEED)),
                values.find(FRICTION).map(RuleKind::friction).orElse(Friction.NONE), assembly.particles()::radius)),
                keys) {
            @Override
            public Optional<Obstacle> obstacle(Values values) {
                return Optional.of(solid.apply(values));
            }
        };
    }

    /** A motion of an anchor, by functions of the values and the start: the motion, and its largest speed (m/s). */
    private static RuleKind motion(String name, String sentence, BiFunction<Values, Vector3, AnchorMotion> motion,
            ToDoubleBiFunction<Values, Vector3> speed, Key<?>... keys) {
        return new RuleKind(name, sentence, (values, assembly) -> {
            Vector3 start = assembly.positionOf(values.get(ANCHOR));
            assembly.move(values.get(ANCHOR), motion.apply(values, start));
            assembly.noteSpeed(speed.applyAsDouble(values, start));
        }, keys) {
            @Override
            public Vector3 startVelocity(Values values, ParticleIndex index) {
                double[] at = new double[9];
                motion.apply(values, index.position(values.get(ANCHOR))).at(0, at);
                return Vector3.at(at, 3);
            }
        };
    }

    private static Friction friction(Values values) {
        Friction.Law law = Friction.Law.valueOf(values.get(LAW).toUpperCase(Locale.ROOT));
        double holding = values.find(STATIC).orElse(law == Friction.Law.COULOMB ? values.get(COEFFICIENT) : 0.0);
        return new Friction(law, values.get(COEFFICIENT), holding, values.get(THRESHOLD));
    }

    private static double ofImpacts(Values friction) {
        return friction.get(IN_IMPACTS) ? friction(friction).ofCoulomb(1) : 0;
    }

    private static final Key<Double> HEIGHT = NumberType.any("m").withDefault("height", 0.0, "Its height (m).");

    static final RuleKind GROUND = ofSolid("ground",
            "Level ground: particles bounce off it, rest on it and slide along it.",
            values -> Plane.ground(values.get(HEIGHT)), HEIGHT, RESTITUTION, FRICTION, REST_SPEED);

    private static final Key<Vector3> POINT = VectorType.of("m").withDefault("point", Vector3.ZERO,
            "Any point of the plane (m).");
    private static final Key<Vector3> NORMAL = VectorType.notZero("").required("normal",
            "A vector that points out of the solid, to the side of the particles; its length does not matter.");

    static final RuleKind PLANE = ofSolid("plane",
            "A ramp or a wall: particles bounce off it, rest on it and slide along it.",
            values -> new Plane(values.get(POINT), values.get(NORMAL)),
            POINT, NORMAL, RESTITUTION, FRICTION, REST_SPEED);

    static final RuleKind SPHERE = ofSolid("sphere",
            "A ball, or the inside of a hollow one: particles bounce off it, rest on it and slide along it.",
            SharedKeys::sphere, SharedKeys.CENTRE, SharedKeys.RADIUS, SharedKeys.HOLLOW, RESTITUTION, FRICTION,
            REST_SPEED);

    private static final Key<Double> IMPACT_FRICTION = NumberType.notNegative("").withDefault("friction", 0.0,
            "mu: an impact changes the velocity along the surfaces by at most mu times that across them.");

    static final RuleKind COLLISIONS = new RuleKind("collisions",
            "Particles are hard balls that bounce off each other, and touch solids with their surface.",
            (values, assembly) -> {
                double radius = values.get(SharedKeys.BALL_RADIUS);
                for (int i = 0; i < assembly.particles().count(); i++) {
                    assembly.particles().setRadius(i, assembly.ownRadius(i).orElse(radius));
                }
                assembly.set(new Collisions.Balls(radius, new Bounce(values.get(RESTITUTION),
                        values.get(IMPACT_FRICTION), values.get(REST_SPEED))));
            }, SharedKeys.BALL_RADIUS, RESTITUTION, IMPACT_FRICTION, REST_SPEED);

    private static final Key<Double> PERIOD = NumberType.positive("s").required("period",
            "The period of the motion (s).");
    private static final Key<Vector3> AMPLITUDE = VectorType.notZero("m").required("amplitude",
            "The largest displacement to one side, as a vector (m).");

    static final RuleKind SHAKE = motion("shake",
            "Moves a particle to and fro: its displacement is amplitude sin(2 pi t / period).",
            (values, start) -> new SineMotion(start, values.get(AMPLITUDE), values.get(PERIOD)),
            (values, start) -> 2 * Math.PI * values.get(AMPLITUDE).length() / values.get(PERIOD),
            ANCHOR, AMPLITUDE, PERIOD);

    private static final Key<Vector3> CENTRE = VectorType.of("m").required("centre", "Any point of the axis (m).");
    private static final Key<Vector3> AXIS = VectorType.notZero("").withDefault("axis", new Vector3(0, 0, 1),
            "The axis of rotation; the motion is counter-clockwise if the axis points at you. Its length"
            + " does not matter.");

    static final RuleKind CIRCLE = motion("circle", "Moves a particle round an axis, like a crank.",
            (values, start) -> new CircleMotion(start, values.get(CENTRE), values.get(AXIS), values.get(PERIOD)),
            (values, start) -> 2 * Math.PI * start.minus(values.get(CENTRE)).length() / values.get(PERIOD),
            ANCHOR, CENTRE, AXIS, PERIOD);

    private static final Key<Vector3> TO = VectorType.of("m").required("to", "The point where it stops (m).");
    private static final Key<Double> DURATION = NumberType.positive("s").required("duration",
            "The duration of the motion (s).");

    static final RuleKind GLIDE = motion("glide",
            "Moves a particle straight to another place, starting and stopping smoothly.",
            (values, start) -> new GlideMotion(start, values.get(TO), values.get(DURATION)),
            (values, start) -> 1.875 * values.get(TO).minus(start).length() / values.get(DURATION),
            ANCHOR, TO, DURATION);
}
