package particles.scene.parts;

import java.util.List;
import java.util.function.BiFunction;
import particles.law.Vector3;
import particles.reactions.Curve;
import particles.reactions.Curve.Profile;
import particles.spec.Key;
import particles.spec.Kind;
import particles.spec.NumberType;
import particles.spec.Values;
import particles.spec.VectorType;

/** A kind of wire along which a bead can slide, with its keys and its curve; {@link #ALL} lists them. */
public final class WireKind extends Kind {
    public static final Key<String> BEAD = SpringDescription.ANY_ID.required("bead", "The particle on the wire.");

    private final BiFunction<Values, Vector3, Curve> curve;

    private WireKind(String name, String sentence, BiFunction<Values, Vector3, Curve> curve, Key<?>... keys) {
        super(name, sentence, keys);
        this.curve = curve;
    }

    /** @return the curve, for a bead that begins at this place */
    public Curve curve(Values values, Vector3 start) {
        return curve.apply(values, start);
    }

    private static final Key<Vector3> DIRECTION = VectorType.notZero("").required("direction",
            "The direction of the wire; the vector's length does not matter.");

    private static final WireKind LINE = new WireKind("line", "A straight wire through the bead's initial position.",
            (values, start) -> Curve.line(start, values.get(DIRECTION)), BEAD, DIRECTION);

    private static final Key<Vector3> CENTRE = VectorType.of("m").required("centre", "The centre of the ring (m).");
    private static final Key<Vector3> AXIS = VectorType.notZero("").withDefault("axis", new Vector3(0, 0, 1),
            "A vector perpendicular to the ring; its length does not matter.");
    private static final Key<Double> RADIUS = NumberType.positive("m").required("radius", "The ring's radius (m).");

    private static final WireKind CIRCLE = new WireKind("circle", "A circular wire.",
            (values, start) -> Curve.circle(values.get(CENTRE), values.get(AXIS), values.get(RADIUS)),
            BEAD, CENTRE, AXIS, RADIUS);

    private static final Key<Vector3> ORIGIN = VectorType.of("m").withDefault("origin", Vector3.ZERO,
            "The point of the wire from which x and y are measured (m).");
    private static final Key<Double> CURVATURE = NumberType.any("1/m").required("curvature",
            "f'' (1/m); the wire is y = f'' x^2 / 2.");
    private static final Key<Double> AMPLITUDE = NumberType.any("m").required("amplitude",
            "A (m); the wire is y = A sin(2 pi x / wavelength).");
    private static final Key<Double> WAVELENGTH = NumberType.positive("m").required("wavelength",
            "The distance from crest to crest (m).");

    private static final WireKind PARABOLA = new WireKind("parabola",
            "A parabola in the x-y plane; a hill if the curvature is negative.",
            (values, start) -> Curve.graph(values.get(ORIGIN), Profile.parabola(values.get(CURVATURE))),
            BEAD, ORIGIN, CURVATURE);

    private static final WireKind SINE = new WireKind("sine", "A sine wave in the x-y plane.",
            (values, start) -> Curve.graph(values.get(ORIGIN),
                    Profile.sine(values.get(AMPLITUDE), values.get(WAVELENGTH))),
            BEAD, ORIGIN, AMPLITUDE, WAVELENGTH);

    /** All wires. */
    public static final List<WireKind> ALL = List.of(LINE, CIRCLE, PARABOLA, SINE);
}
