package particles.scene.parts;

import java.util.function.BiFunction;
import java.util.function.ToDoubleBiFunction;
import particles.law.AnchorMotion;
import particles.law.AnchorMotion.Circle;
import particles.law.AnchorMotion.Glide;
import particles.law.AnchorMotion.Sine;
import particles.law.Vector3;
import particles.spec.Key;
import particles.spec.NumberType;
import particles.spec.Values;
import particles.spec.VectorType;

/** A prescribed motion of a moving anchor; {@link RuleKind#ALL} lists them. */
final class MotionKind extends RuleKind {
    private final BiFunction<Values, Vector3, AnchorMotion> motion;

    /** With functions of the values and the start: the motion, and its largest speed (m/s). */
    private MotionKind(String name, String sentence, BiFunction<Values, Vector3, AnchorMotion> motion,
            ToDoubleBiFunction<Values, Vector3> speed, Key<?>... keys) {
        super(name, sentence, (values, assembly) -> {
            Vector3 start = assembly.positionOf(values.get(ANCHOR));
            assembly.move(values.get(ANCHOR), motion.apply(values, start));
            assembly.noteSpeed(speed.applyAsDouble(values, start));
        }, keys);
        this.motion = motion;
    }

    @Override
    public Vector3 startVelocity(Values values, ParticleIndex index) {
        double[] at = new double[9];
        motion.apply(values, index.position(values.get(ANCHOR))).at(0, at);
        return Vector3.at(at, 3);
    }

    private static final Key<Double> PERIOD = NumberType.positive("s").required("period",
            "The period of the motion (s).");
    private static final Key<Vector3> AMPLITUDE = VectorType.notZero("m").required("amplitude",
            "The largest displacement to one side, as a vector (m).");

    static final RuleKind SHAKE = new MotionKind("shake",
            "Moves a particle to and fro: its displacement is amplitude sin(2 pi t / period).",
            (values, start) -> new Sine(start, values.get(AMPLITUDE), values.get(PERIOD)),
            (values, start) -> 2 * Math.PI * values.get(AMPLITUDE).length() / values.get(PERIOD),
            ANCHOR, AMPLITUDE, PERIOD);

    private static final Key<Vector3> CENTRE = VectorType.of("m").required("centre", "Any point of the axis (m).");
    private static final Key<Vector3> AXIS = VectorType.notZero("").withDefault("axis", new Vector3(0, 0, 1),
            "The axis of rotation; the motion is counter-clockwise if the axis points at you. Its length"
            + " does not matter.");

    static final RuleKind CIRCLE = new MotionKind("circle", "Moves a particle round an axis, like a crank.",
            (values, start) -> new Circle(start, values.get(CENTRE), values.get(AXIS), values.get(PERIOD)),
            (values, start) -> 2 * Math.PI * start.minus(values.get(CENTRE)).length() / values.get(PERIOD),
            ANCHOR, CENTRE, AXIS, PERIOD);

    private static final Key<Vector3> TO = VectorType.of("m").required("to", "The point where it stops (m).");
    private static final Key<Double> DURATION = NumberType.positive("s").required("duration",
            "The duration of the motion (s).");

    static final RuleKind GLIDE = new MotionKind("glide",
            "Moves a particle straight to another place, starting and stopping smoothly.",
            (values, start) -> new Glide(start, values.get(TO), values.get(DURATION)),
            (values, start) -> 1.875 * values.get(TO).minus(start).length() / values.get(DURATION),
            ANCHOR, TO, DURATION);
}
