package particles.scene.parts;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import particles.effects.SharedKeys;
import particles.law.Scales;
import particles.law.Vector3;
import particles.scene.parts.SpringFamily.Sort;
import particles.spec.FlagType;
import particles.spec.Key;
import particles.spec.Kind;
import particles.spec.ListType;
import particles.spec.MappingType;
import particles.spec.NameType;
import particles.spec.NumberType;
import particles.spec.TextType;
import particles.spec.Values;
import particles.spec.VectorType;
import particles.spec.messages.Problems;

/** A kind of shape that a scene can name, with its keys and particle positions; {@link #ALL} lists them. */
public final class ShapeKind extends Kind {
    private static final TextType OWN_ID = TextType.of(
            "the id of a particle of the shape, such as ID[0] in a rope, ID[3,4] in a cloth",
            "^[^\\s\\[\\],\"'\\x00-\\x1f\\x7f]{1,60}\\[[0-9]+(,[0-9]+)*\\]$");
    private static final NumberType.Whole COUNT = new NumberType.Whole(2, 1_000_000);

    static final Key<Double> MASS = NumberType.positive("kg").optional("mass",
            "The mass of each particle (kg); give this or totalMass.");
    static final Key<Double> TOTAL_MASS = NumberType.positive("kg").optional("totalMass",
            "The mass of all particles together, shared evenly (kg); give this or mass.");
    static final Key<Vector3> VELOCITY = VectorType.of("m/s").withDefault("velocity", Vector3.ZERO,
            "The velocity of all free particles at the start (m/s).");
    private static final Key<Double> FORWARD = NumberType.positive("").required("forward",
            "Factor of the friction on a particle that slides along the body towards the head.");
    private static final Key<Double> BACKWARD = NumberType.positive("").required("backward",
            "Factor of the friction on a particle that slides along the body towards the tail.");
    private static final Key<Double> ASIDE = NumberType.positive("").required("across",
            "Factor of the friction on a particle that slides sideways.");
    /** Friction that depends on the direction. */
    public static final Key<Values> SCALES = MappingType.of("'scales'", FORWARD, BACKWARD, ASIDE).optional("scales",
            "Scales of a snake or bristles of a worm: friction depends on the direction of sliding. The head is the"
            + " end of the rope, or the right end of a cloth or a block.");

    static final Key<Boolean> SURFACE = FlagType.FLAG.withDefault("surface", true,
            "Whether to draw it as a shaded surface.");

    /** Reads the fixed particles of any shape. */
    static final Key<List<String>> FIXED = fixed(List.of());

    /** Makes the particles of a shape. */
    @FunctionalInterface
    interface Maker {
        /** @return the particles of the shape with this name, or empty if problems were reported */
        Optional<ParticleLayout> make(String id, Chosen<ShapeKind> chosen, NamedFiles files, Problems problems);
    }

    /** Makes a lattice from its name, the names of its sides and its values. */
    @FunctionalInterface
    private interface LatticeMaker {
        Lattice make(String id, List<List<String>> sides, Values values);
    }

    private final Maker maker;

    /** A shape with these keys besides its name. */
    ShapeKind(String name, String sentence, Maker maker, List<Key<?>> keys) {
        super(name, sentence, Stream.concat(Stream.of(id(name)), keys.stream()).toList(), List.of(MASS, TOTAL_MASS));
        this.maker = maker;
    }

    /**
     * @param sides   the names of the two ends along each direction
     * @param parts   other names of parts that can be fixed
     * @param lattice makes the particles
     * @param own     the keys for the positions of the particles
     */
    private static ShapeKind lattice(String name, String sentence, List<List<String>> sides, List<String> parts,
            LatticeMaker lattice, Key<?>... own) {
        return new ShapeKind(name, sentence, (id, chosen, files, problems) -> {
            Lattice made = lattice.make(id, sides, chosen.values());
            return made.flatness() > 1e-9 ? Optional.of(made)
                    : problems.add(chosen.place(), "'" + name + "' has no extent in one direction: its particles"
                            + " would lie on top of each other");
        }, keys(sides, parts, own));
    }

    private static List<Key<?>> keys(List<List<String>> sides, List<String> parts, Key<?>... own) {
        boolean squares = sides.size() > 1;             // without them there are neither shear springs nor a surface
        List<Key<?>> all = new ArrayList<>(List.of(own));
        all.addAll(List.of(MASS, TOTAL_MASS, ParticleDescription.RADIUS, VELOCITY, SCALES,
                fixed(Stream.concat(sides.stream().flatMap(List::stream), parts.stream()).toList())));
        Stream.of(Sort.values()).filter(sort -> squares || sort != Sort.SHEAR).forEach(sort -> all.add(sort.key()));
        if (squares) {
            all.add(SURFACE);
        }
        return all;
    }

    /** @return the scales of a particle whose body goes from one particle to the next */
    static Scales scales(Values values, int tail, int head) {
        return new Scales(tail, head, values.get(FORWARD), values.get(BACKWARD), values.get(ASIDE));
    }

    private static Key<String> id(String name) {
        return ParticleDescription.NEW_ID.withDefault("id", name,
                "The shape's name; its particles' ids begin with it.");
    }

    private static Key<List<String>> fixed(List<String> parts) {
        return ListType.oneOrMore("a fixed part", NameType.or("part", parts, OWN_ID)).withDefault("fixed", List.of(),
                "Its fixed particles: names of parts, ids of its particles, or a list of both.");
    }

    /** @return the particles of a shape of this kind, or empty if problems were reported */
    Optional<ParticleLayout> layout(Chosen<ShapeKind> chosen, NamedFiles files, Problems problems) {
        return maker.make(chosen.values().get(getId()), chosen, files, problems);
    }

    /** @return the key of the shape's name */
    public Key<String> getId() {
        return id(getName());
    }

    private static final Key<Vector3> START = VectorType.of("m").required("start",
            "The position of its first particle (m).");
    private static final Key<Vector3> END = VectorType.of("m").required("end",
            "The position of its last particle (m).");
    private static final Key<Integer> PARTICLES = COUNT.required("particles", "The number of particles.");

    private static final ShapeKind ROPE = lattice("rope",
            "Particles rope[0], rope[1] ... at equal distances along a line.",
            List.of(List.of("start", "end")), List.of(), (id, sides, values) -> new Lattice(id,
            List.of(values.get(PARTICLES)), values.get(START), List.of(values.get(END).minus(values.get(START))),
            sides), START, END, PARTICLES);

    private static final Key<Vector3> TOP_LEFT = VectorType.of("m").required("corner",
            "The position of the top-left particle (m).");
    private static final Key<Vector3> ACROSS = VectorType.notZero("m").required("across",
            "The vector from the top-left to the top-right particle (m).");
    private static final Key<Vector3> DOWN = VectorType.notZero("m").required("down",
            "The vector from the top-left to the bottom-left particle (m).");
    private static final Key<Integer> COLUMNS = COUNT.required("columns", "The number of particles across.");
    private static final Key<Integer> ROWS = COUNT.required("rows", "The number of particles from top to bottom.");

    private static final ShapeKind CLOTH = lattice("cloth",
            "Particles cloth[column,row] in a rectangle or parallelogram; cloth[0,0] is the top-left particle.",
            List.of(List.of("left", "right"), List.of("top", "bottom")),
            List.of("top-left", "top-right", "bottom-left", "bottom-right", "corners", "edges"),
            (id, sides, values) -> new Lattice(id, List.of(values.get(COLUMNS), values.get(ROWS)), values.get(TOP_LEFT),
            List.of(values.get(ACROSS), values.get(DOWN)), sides), TOP_LEFT, ACROSS, DOWN, COLUMNS, ROWS);

    private static final Key<Vector3> SIZE = VectorType.positive("m").required("size",
            "Its width, height and depth before it is turned (m).");
    private static final Key<Vector3> TURN = VectorType.of("degrees").withDefault("turn", Vector3.ZERO,
            "Its rotation about its centre: about the fixed x, y and z axes, in this order (degrees).");
    private static final Key<Integer> LAYERS = COUNT.required("layers", "The number of particles from back to front.");
    private static final Key<Integer> JELLY_ROWS = COUNT.required("rows",
            "The number of particles from bottom to top.");

    private static final ShapeKind JELLY = lattice("jelly",
            "Particles jelly[column,row,layer] in a block; jelly[0,0,0] is at the left, bottom and back.",
            List.of(List.of("left", "right"), List.of("bottom", "top"), List.of("back", "front")), List.of("corners"),
            ShapeKind::block, SharedKeys.CENTRE, SIZE, TURN, COLUMNS, JELLY_ROWS, LAYERS);

    private static Lattice block(String id, List<List<String>> sides, Values values) {
        Vector3 size = values.get(SIZE);
        List<Vector3> edges = Stream.of(new Vector3(size.x(), 0, 0), new Vector3(0, size.y(), 0),
                new Vector3(0, 0, size.z())).map(edge -> turned(edge, values.get(TURN))).toList();
        Vector3 diagonal = edges.get(0).plus(edges.get(1)).plus(edges.get(2));
        return new Lattice(id, List.of(values.get(COLUMNS), values.get(JELLY_ROWS), values.get(LAYERS)),
                values.get(SharedKeys.CENTRE).minus(diagonal.times(0.5)), edges, sides);
    }

    /** @return a vector that was rotated about the fixed x, y and z axes, in this order */
    static Vector3 turned(Vector3 v, Vector3 degrees) {
        double[] r = {v.x(), v.y(), v.z()};
        double[] angles = {degrees.x(), degrees.y(), degrees.z()};
        for (int axis = 0, i = 1, j = 2; axis < 3; i = j, j = axis, axis++) {
            double sin = StrictMath.sin(StrictMath.toRadians(angles[axis]));
            double cos = StrictMath.cos(StrictMath.toRadians(angles[axis]));
            double before = r[i];
            r[i] = cos * before - sin * r[j];
            r[j] = sin * before + cos * r[j];
        }
        return Vector3.at(r, 0);
    }

    private static final ShapeKind MESH = new ShapeKind("mesh",
            "Particles mesh[0], mesh[1] ... at the vertices of a mesh that another program made.", MeshShape::layout,
            MeshShape.keys());

    /** All shapes. */
    public static final List<ShapeKind> ALL = List.of(ROPE, CLOTH, JELLY, MESH);
}
