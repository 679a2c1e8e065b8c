package particles.scene.parts;

import java.util.List;
import particles.law.Vector3;
import particles.reactions.wires.CircularWire;
import particles.reactions.wires.Curve;
import particles.reactions.wires.GraphWire;
import particles.reactions.wires.StraightWire;
import particles.spec.Key;
import particles.spec.Kind;
import particles.spec.NumberType;
import particles.spec.Values;
import particles.spec.VectorType;

/** A kind of wire along which a bead can slide, with its keys and its curve; {@link #ALL} lists them. */
public abstract class WireKind extends Kind {
    public static final Key<String> BEAD = Key.required("bead", SpringDescription.ANY_ID, "The particle on the wire.");

    WireKind(String name, String sentence, Key<?>... keys) {
        super(name, sentence, keys);
    }

    /** @return the curve, for a bead that begins at this place */
    public abstract Curve curve(Values values, Vector3 start);

    private static final Key<Vector3> DIRECTION = Key.required("direction", VectorType.notZero(""),
            "The direction of the wire; the vector's length does not matter.");

    private static final WireKind LINE = new WireKind("line", "A straight wire through the bead's initial"
            + " position.", BEAD,
            DIRECTION) {
        @Override
        public Curve curve(Values values, Vector3 start) {
            return new StraightWire(start, values.get(DIRECTION));
        }
    };

    private static final Key<Vector3> CENTRE = Key.required("centre", VectorType.of("m"),
            "The centre of the ring (m).");
    private static final Key<Vector3> AXIS = Key.withDefault("axis", VectorType.notZero(""), new Vector3(0, 0, 1),
            "A vector perpendicular to the ring; its length does not matter.");
    private static final Key<Double> RADIUS = Key.required("radius", NumberType.positive("m"),
            "The ring's radius (m).");

    private static final WireKind CIRCLE = new WireKind("circle", "A circular wire.", BEAD, CENTRE, AXIS, RADIUS) {
        @Override
        public Curve curve(Values values, Vector3 start) {
            return new CircularWire(values.get(CENTRE), values.get(AXIS), values.get(RADIUS));
        }
    };

    private static final Key<Vector3> ORIGIN = Key.withDefault("origin", VectorType.of("m"), Vector3.ZERO,
            "The point of the wire from which x and y are measured (m).");
    private static final Key<Double> CURVATURE = Key.required("curvature", NumberType.any("1/m"),
            "f'' (1/m); the wire is y = f'' x^2 / 2.");
    private static final Key<Double> AMPLITUDE = Key.required("amplitude", NumberType.any("m"),
            "A (m); the wire is y = A sin(2 pi x / wavelength).");
    private static final Key<Double> WAVELENGTH = Key.required("wavelength", NumberType.positive("m"),
            "The distance from crest to crest (m).");

    private static final WireKind PARABOLA = new WireKind("parabola",
            "A parabola in the x-y plane; a hill if the curvature is negative.", BEAD, ORIGIN, CURVATURE) {
        @Override
        public Curve curve(Values values, Vector3 start) {
            return graph(values, GraphWire.parabola(values.get(CURVATURE)));
        }
    };

    private static final WireKind SINE = new WireKind("sine", "A sine wave in the x-y plane.", BEAD,
            ORIGIN, AMPLITUDE, WAVELENGTH) {
        @Override
        public Curve curve(Values values, Vector3 start) {
            return graph(values, GraphWire.sine(values.get(AMPLITUDE), values.get(WAVELENGTH)));
        }
    };

    private static Curve graph(Values values, GraphWire.Profile profile) {
        return new GraphWire(values.get(ORIGIN), new Vector3(1, 0, 0), new Vector3(0, 1, 0), profile);
    }

    /** All wires. */
    public static final List<WireKind> ALL = List.of(LINE, CIRCLE, PARABOLA, SINE);
}
