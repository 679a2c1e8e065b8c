package particles.scene.parts;

import java.util.Optional;
import particles.law.AnchorMotion;
import particles.law.Vector3;
import particles.rules.CircleMotion;
import particles.rules.GlideMotion;
import particles.rules.SineMotion;
import particles.spec.Key;
import particles.spec.NumberType;
import particles.spec.TextType;
import particles.spec.Values;
import particles.spec.VectorType;

/** The prescribed motions of moving anchors; {@link RuleKind#ALL} lists them. */
abstract class MotionKinds extends RuleKind {
    private static final Key<String> PARTICLE = TextType.of( "the id of a fixed particle", "\\S").required("particle",
            "The particle to move, starting from its position. It must be fixed.");
    private static final Key<Double> PERIOD = NumberType.positive("s").required("period",
            "The period of the motion (s).");

    private MotionKinds(String name, String sentence, Key<?>... keys) {
        super(name, sentence, keys);
    }

    abstract AnchorMotion motion(Values values, Vector3 start);

    /** The largest speed (m/s). */
    abstract double speed(Values values, Vector3 start);

    @Override
    public void build(Values values, SceneAssembly assembly) {
        Vector3 start = assembly.positionOf(values.get(PARTICLE));
        assembly.move(values.get(PARTICLE), motion(values, start));
        assembly.noteSpeed(speed(values, start));
    }

    @Override
    public Vector3 startVelocity(Values values, ParticleIndex index) {
        double[] at = new double[9];
        motion(values, index.position(values.get(PARTICLE))).at(0, at);
        return Vector3.at(at, 3);
    }

    @Override
    public Optional<Key<String>> anchor() {
        return Optional.of(PARTICLE);
    }

    private static final Key<Vector3> AMPLITUDE = VectorType.notZero("m").required("amplitude",
            "The largest displacement to one side, as a vector (m).");

    static final RuleKind SHAKE = new MotionKinds("shake",
            "Moves a particle to and fro: its displacement is amplitude sin(2 pi t / period).",
            PARTICLE, AMPLITUDE, PERIOD) {
        @Override
        AnchorMotion motion(Values values, Vector3 start) {
            return new SineMotion(start, values.get(AMPLITUDE), values.get(PERIOD));
        }

        @Override
        double speed(Values values, Vector3 start) {
            return 2 * Math.PI * values.get(AMPLITUDE).length() / values.get(PERIOD);
        }
    };

    private static final Key<Vector3> CENTRE = VectorType.of("m").required("centre", "Any point of the axis (m).");
    private static final Key<Vector3> AXIS = VectorType.notZero("").withDefault("axis", new Vector3(0, 0, 1),
            "The axis of rotation; the motion is counter-clockwise if the axis points at you. Its length"
            + " does not matter.");

    static final RuleKind CIRCLE = new MotionKinds("circle", "Moves a particle round an axis, like a crank.", PARTICLE,
            CENTRE,
            AXIS, PERIOD) {
        @Override
        AnchorMotion motion(Values values, Vector3 start) {
            return new CircleMotion(start, values.get(CENTRE), values.get(AXIS), values.get(PERIOD));
        }

        @Override
        double speed(Values values, Vector3 start) {
            return 2 * Math.PI * start.minus(values.get(CENTRE)).length() / values.get(PERIOD);
        }
    };

    private static final Key<Vector3> TO = VectorType.of("m").required("to", "The point where it stops (m).");
    private static final Key<Double> DURATION = NumberType.positive("s").required("duration",
            "The duration of the motion (s).");

    static final RuleKind GLIDE = new MotionKinds("glide",
            "Moves a particle straight to another place, starting and stopping smoothly.", PARTICLE, TO, DURATION) {
        @Override
        AnchorMotion motion(Values values, Vector3 start) {
            return new GlideMotion(start, values.get(TO), values.get(DURATION));
        }

        @Override
        double speed(Values values, Vector3 start) {
            return 1.875 * values.get(TO).minus(start).length() / values.get(DURATION);
        }
    };
}
