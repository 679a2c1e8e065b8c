package particles.scene.parts;

import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import particles.law.Vector3;
import particles.scene.parts.ObjReader.Contents;
import particles.scene.parts.SpringFamily.Sort;
import particles.spec.Key;
import particles.spec.Kind.Chosen;
import particles.spec.ListType;
import particles.spec.MappingType;
import particles.spec.NumberType;
import particles.spec.TextType;
import particles.spec.Values;
import particles.spec.VectorType;
import particles.spec.messages.Place;
import particles.spec.messages.Problems;

/** A mesh in scenes: a file of another program, and how it is placed. */
final class MeshShape {
    private static final Key<String> FILE = TextType.of("the name of a file", "^[^'\"\\\\]+$").required("file",
            "A Wavefront OBJ file in the scene's folder: vertices (v), faces (f), lines (l) and groups (g, o).");
    private static final Key<Vector3> PLACE = VectorType.of("m").withDefault("place", Vector3.ZERO,
            "The position of the file's origin (m).");
    private static final Key<Vector3> TURN = VectorType.of("degrees").withDefault("turn", Vector3.ZERO,
            "Its rotation about the file's origin: about the fixed x, y and z axes, in this order (degrees);"
            + " [-90, 0, 0] if z points up in the file.");
    private static final Key<Double> SCALE = NumberType.positive("m").withDefault("scale", 1.0,
            "The length of the file's unit (m).");
    private static final Key<Double> TOTAL_MASS = NumberType.positive("kg").optional("totalMass",
            "The mass of all particles together (kg), shared by area, or evenly if there are no faces; give this"
            + " or mass.");
    private static final Key<List<String>> FIXED = ListType.oneOrMore("a fixed part", TextType.of(
            "the name of a group of the file, or the id of a particle of the shape", "\\S"))
            .withDefault("fixed", List.of(), "Its fixed particles: groups, ids, or a list of both.");
    private static final Key<Vector3> LOW = VectorType.of("m").required("low", "Its lowest coordinates (m).");
    private static final Key<Vector3> HIGH = VectorType.of("m").required("high", "Its highest coordinates (m).");
    static final Key<Values> FIXED_BOX = MappingType.of("a box", LOW, HIGH).optional("fixedBox",
            "A box in which all particles are fixed.");

    private MeshShape() {
    }

    /** @return the keys besides the shape's name */
    static List<Key<?>> keys() {
        return List.of(FILE, PLACE, TURN, SCALE, ShapeKind.MASS, TOTAL_MASS, ParticleDescription.RADIUS,
                ShapeKind.VELOCITY, FIXED, FIXED_BOX,
                Sort.STRUCTURAL.key("Springs along edges and lines."),
                Sort.SHEAR.key("Springs along the diagonals of faces."),
                Sort.BEND.key("Springs across each edge that two faces share: they resist folding."),
                ShapeKind.SURFACE);
    }

    /** @return the particles of a mesh, or empty if problems were reported */
    static Optional<ParticleLayout> layout(String id, Chosen<ShapeKind> chosen, NamedFiles files, Problems problems) {
        Values values = chosen.values();
        Optional<Contents> read = files.read(values.get(FILE), values.place(FILE), problems)
                .flatMap(file -> ObjReader.read(file, problems));
        if (read.isEmpty()) {
            return Optional.empty();
        }
        Mesh mesh = new Mesh(id, read.get(), vertex -> values.get(PLACE).plus(ShapeKind.turned(
                vertex.times(values.get(SCALE)), values.get(TURN))));
        return mesh.withoutShare().filter(line -> values.isGiven(TOTAL_MASS)).map(line ->
                problems.<ParticleLayout>add(new Place(read.get().source(), line, 1), "this vertex belongs to no face"
                + " with an area, so it has no share of totalMass; give 'mass'")).orElse(Optional.of(mesh));
    }

    /** @return whether a position is in a box of this key */
    static boolean isIn(Values box, Vector3 position) {
        return Stream.of(position.minus(box.get(LOW)), box.get(HIGH).minus(position)).allMatch(inwards ->
                Math.min(inwards.x(), Math.min(inwards.y(), inwards.z())) >= 0);
    }
}
