package particles.scene;

import java.util.List;
import java.util.Optional;
import particles.Vector3;
import particles.effects.Gravity;
import particles.effects.GustyWind;
import particles.effects.LinearDrag;
import particles.spec.Key;
import particles.spec.Kind;
import particles.spec.MappingType;
import particles.spec.NumberType;
import particles.spec.Values;
import particles.spec.VectorType;

/** The effects that a scene can name: each is one entry of {@link #ALL}, with its keys and what it builds. */
public abstract class EffectKind implements Kind {
    private final String name;
    private final String sentence;
    private final MappingType keys;

    EffectKind(String name, String sentence, Key<?>... keys) {
        this.name = name;
        this.sentence = sentence;
        this.keys = MappingType.of("'" + name + "'", keys);
    }

    /** Builds what a scene names. */
    abstract void build(Values values, SceneAssembly assembly);

    /** @return effects of which a scene has to name one too, because without any this one does nothing; empty if it does */
    List<EffectKind> needs() {
        return List.of();
    }

    /** @return the effect that a scene cannot name too, if there is one */
    Optional<EffectKind> excludes() {
        return Optional.empty();
    }

    /** @return whether a scene may name it more than once */
    boolean isRepeatable() {
        return false;
    }

    @Override
    public String name() {
        return name;
    }

    @Override
    public String sentence() {
        return sentence;
    }

    @Override
    public MappingType keys() {
        return keys;
    }

    private static final Key<Vector3> ACCELERATION = Key.withDefault("acceleration", VectorType.of("m/s^2"),
            new Vector3(0, -9.81, 0), "g, the acceleration of free fall (m/s^2).");

    private static final EffectKind GRAVITY = new EffectKind("gravity", "The same acceleration for every particle.",
            ACCELERATION) {
        @Override
        void build(Values values, SceneAssembly assembly) {
            Vector3 g = values.get(ACCELERATION);
            assembly.add(new Gravity(assembly.particles(), g));
            assembly.noteAcceleration(g);
        }
    };

    private static final Key<Double> COEFFICIENT = Key.required("coefficient", NumberType.notNegative("N s/m"),
            "c, the force on a particle for each m/s of its motion through the air (N s/m).");

    private static final EffectKind DRAG = new EffectKind("drag", "Air resists every particle in proportion to its velocity"
            + " through the air.", COEFFICIENT) {
        @Override
        void build(Values values, SceneAssembly assembly) {
            assembly.add(new LinearDrag(assembly.particles(), values.get(COEFFICIENT), assembly.wind()));
        }
    };

    static final Key<Vector3> MEAN = Key.required("mean", VectorType.of("m/s"), "The wind's steady part (m/s).");
    private static final Key<Vector3> GUST = Key.withDefault("gust", VectorType.of("m/s"), Vector3.ZERO,
            "The amplitude of its varying part, gust sin(2 pi t / period) (m/s).");
    private static final Key<Double> PERIOD = Key.withDefault("period", NumberType.positive("s"), 1.0,
            "From gust to gust (s).");

    static final EffectKind WIND = new EffectKind("wind", "The air moves, and drag carries particles with it.",
            MEAN, GUST, PERIOD) {
        @Override
        void build(Values values, SceneAssembly assembly) {
            assembly.blow(new GustyWind(values.get(MEAN), values.get(GUST), values.get(PERIOD)));
            assembly.noteSpeed(values.get(MEAN).length() + values.get(GUST).length());
        }

        @Override
        List<EffectKind> needs() {
            return drags();
        }
    };

    /** What wind acts through. */
    static List<EffectKind> drags() {
        return List.of(DRAG, MoreEffects.QUADRATIC_DRAG);
    }

    /** All effects, in the order in which they are built: what others ask comes first. */
    static final List<EffectKind> ALL = List.of(GRAVITY, WIND, MoreEffects.TURBULENCE, DRAG, MoreEffects.QUADRATIC_DRAG,
            MoreEffects.ATTRACTION, MoreEffects.COHESION, MoreEffects.PENALTY_PLANE, MoreEffects.PENALTY_SPHERE);
}
