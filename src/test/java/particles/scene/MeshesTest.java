package particles.scene;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Set;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;
import particles.law.Particles;
import particles.law.Vector3;
import particles.scene.format.SceneDescription;
import particles.spec.ClassNames;
import particles.spec.messages.InvalidInputException;
import particles.view.SpringView;

/** The shape 'mesh': Wavefront OBJ files as several programs write them, and as people break them. */
class MeshesTest {
    private static final String HEAD = "title: Mesh\nteaches: reading\nsolver: rk4\ndeltaT: 0.01\nduration: 0.1\n";
    private static final String CORNERS = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 1\nv 1 0 1\nv 1 1 1\nv 0 1 1\n";

    private static String mesh(String keys) {
        return HEAD + "shapes:\n  - mesh: {file: m.obj, " + keys + "}\n";
    }

    private static SceneDescription read(String yaml, String obj) {
        return TestScenes.read(yaml + "files:\n  m.obj: |2\n" + obj.indent(4));
    }

    private static Scene build(String keys, String obj) {
        return SceneBuilder.build(read(mesh(keys), obj));
    }

    private static Set<Set<Integer>> pairs(SpringView springs) {
        return IntStream.range(0, springs.springCount()).mapToObj(s -> Set.of(springs.from(s), springs.to(s)))
                .collect(Collectors.toSet());
    }

    /** One cube, in the manner of several programs; none has springs along the diagonals of its squares. */
    static Stream<Arguments> cubes() {
        String quads = "f 1 4 3 2\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n";
        String slashed = quads.replaceAll("(\\d)(?=[ \n])", "$1/$1/1");
        return Stream.of(
                Arguments.of("plain", CORNERS + quads),
                Arguments.of("as Blender writes it", "# Blender 3.6.5\n# www.blender.org\nmtllib cube.mtl\no Cube\n"
                        + CORNERS.replaceAll("([01])(?=[ \n])", "$1.000000") + "vn -0.0000 1.0000 -0.0000\n"
                        + "vt 0.625000 0.500000\n".repeat(8) + "s off\nusemtl Material\n" + slashed),
                Arguments.of("with Windows line ends", ("\n" + CORNERS + "s 1\n" + quads).replace("\n", "\r\n")),
                Arguments.of("with tabs, colours, normals only and a comment behind", CORNERS.replace(" ", "\t")
                        .replace("\n", "\t0.5 0.5 0.5\n") + quads.replaceAll("(\\d)(?=[ \n])", "$1//3")
                        .replace("\n", " # a face\n")),
                Arguments.of("with negative numbers", CORNERS + quads.lines().map(line -> Arrays.stream(line.split(" "))
                        .map(word -> word.equals("f") ? word : String.valueOf(Integer.parseInt(word) - 9))
                        .collect(Collectors.joining(" ", "", "\n"))).collect(Collectors.joining())),
                Arguments.of("with groups between faces, and a line that goes on", CORNERS + "g a b\ns 1\n"
                        + quads.replace("f 5", "g c\nf 5").replace("6 7 8", "6 \\\n  7 8")),
                Arguments.of("with all edges as lines", CORNERS
                        + "l 1 2 3 4 1\nl 5 6 7 8 5\nl 1/1 5/1\nl 2 6\nl 3 7\nl 4 8"));
    }

    @ParameterizedTest(name = "{0}")
    @MethodSource("cubes")
    void everyProgramsCubeHasEightCornersAndTwelveEdges(String name, String obj) {
        Scene scene = build("mass: 1, structural: {stiffness: 1}, shear: {stiffness: 1}", obj);
        assertEquals(8, scene.system().getParticles().count());
        SpringView springs = scene.springs();
        long edges = IntStream.range(0, springs.springCount()).filter(s -> springs.restLength(s) == 1).count();
        assertEquals(12, edges);
        assertEquals(name.endsWith("lines") ? 12 : 24, springs.springCount(), "two diagonals in each of six squares");
        assertEquals(name.endsWith("lines") ? List.of() : List.of(36), scene.scenery().surfaces().stream()
                .map(surface -> surface.triangles().length).toList());
    }

    /** A cloth as a mesh of squares has the same springs as the shape 'cloth', of all three sorts. */
    @ParameterizedTest
    @ValueSource(strings = {"structural", "shear", "bend"})
    void aMeshOfSquaresIsACloth(String sort) {
        Scene cloth = TestScenes.build(HEAD + "shapes:\n  - cloth: {corner: [0, 0, 0], across: [4, 0, 0], "
                + "down: [0, -3, 0], columns: 5, rows: 4, mass: 1, " + sort + ": {stiffness: 2}}\n");
        Scene mesh = build("mass: 1, " + sort + ": {stiffness: 2}", grid(5, 4));
        assertEquals(pairs(cloth.springs()), pairs(mesh.springs()));
        assertEquals(cloth.springs().springCount(), mesh.springs().springCount(), "each once");
        assertArrayEquals(cloth.system().getOwnState(), mesh.system().getOwnState());
    }

    private static String grid(int columns, int rows) {
        StringBuilder obj = new StringBuilder();
        for (int n = 0; n < columns * rows; n++) {
            obj.append("v ").append(n / rows).append(' ').append(-(n % rows)).append(" 0\n");
        }
        for (int c = 1; c < columns; c++) {
            for (int r = 1; r < rows; r++) {
                int n = (c - 1) * rows + r;
                obj.append("f ").append(n).append(' ').append(n + 1).append(' ').append(n + 1 + rows).append(' ')
                        .append(n + rows).append('\n');
            }
        }
        return obj.toString();
    }

    /** Each square of 6 has a sixth of the mass, and a quarter of that for each corner. */
    @Test
    void theMassIsSharedByArea() {
        Particles particles = build("totalMass: 24", grid(4, 3)).system().getParticles();
        assertEquals(1, particles.mass(0), 1e-15);
        assertEquals(2, particles.mass(1), 1e-15);
        assertEquals(4, particles.mass(4), 1e-15);
        assertEquals(24, particles.freeMass(), 1e-14);
        Particles lines = build("totalMass: 24", "v 0 0 0\nv 1 0 0\nv 5 0 0\nl 1 2 3\n").system().getParticles();
        assertEquals(8, lines.mass(2), 1e-15);
    }

    /** A pentagon that is not convex: a square of 2 by 2 with a notch of area 1; its centre is a corner. */
    @Test
    void aFaceMayHaveAnyNumberOfCornersAndNeedNotBeConvex() {
        Scene scene = build("totalMass: 15, structural: {stiffness: 1}",
                "v 0 0 0\nv 2 0 0\nv 2 2 0\nv 1 1 0\nv 0 2 0\nv 5 0 0\nv 7 0 0\nv 7 3 0\nf 1 2 3 4 5\nf 6 7 8\n");
        assertEquals(8, scene.springs().springCount());
        assertEquals(15 * 3 / 6.0 / 5, scene.system().getParticles().mass(3), 1e-14);     // areas 3 and 3
        assertEquals(12, scene.scenery().surfaces().get(0).triangles().length);
        assertTrue(!scene.scenery().surfaces().get(0).ofSprings(), "a triangle inside a pentagon is not torn");
    }

    @Test
    void aMeshIsScaledTurnedAndPlaced() {
        Scene scene = build("mass: 1, scale: 2, turn: [-90, 0, 0], place: [10, 0, 0]", "v 1 2 3\nv 0 0 0\nl 1 2\n");
        assertEquals(0, Vector3.at(scene.system().getOwnState(), 0).minus(new Vector3(12, 6, -4)).length(), 1e-14);
        assertEquals(new Vector3(10, 0, 0), Vector3.at(scene.system().getOwnState(), 6));
    }

    @ParameterizedTest
    @ValueSource(strings = {"fixed: rim", "fixed: [\"mesh[1]\", \"mesh[2]\"]",
        "fixedBox: {low: [0.5, -1, -1], high: [1.5, 2, 0]}", "fixed: [rim, \"mesh[2]\"]"})
    void particlesAreFixedByGroupIdAndBox(String fixed) {
        Particles particles = build("mass: 1, " + fixed, CORNERS + "f 1 2 3\ng rim\nl 2 3\n").system().getParticles();
        assertEquals(List.of(1, 2), IntStream.range(0, 8).filter(particles::isFixed).boxed().toList());
    }

    /** What is odd, but possible: two vertices at one place, one in no face, and a face turned round. */
    @Test
    void oddPartsOfAMeshAreNamedWithTheirLines() {
        assertEquals(List.of(), read(mesh("mass: 1"), CORNERS + "f 1 4 3 2\nf 5 6 7 8\n").remarks());
        assertEquals(List.of("m.obj:9: this vertex is at the place of another, and 1 more like it",
                "m.obj:7: this vertex belongs to no face or line, and 2 more like it",
                "m.obj:12: this face and a neighbour are turned to opposite sides"),
                read(mesh("mass: 1"), CORNERS + "v 0 0 0\nv 1 1 1\nf 1 2 3\nf 2 3 4\nl 5 6 9 5\n").remarks());
    }

    private static void assertRefused(String line, String message) {
        assertEquals("m.obj:4:1: '" + line + "' " + message, message("mass: 1",
                "v 0 0 0\nv 1 0 0\nv 1 1 0\n" + line + "\nv 5 5 5\n"));
    }

    @ParameterizedTest
    @ValueSource(strings = {"v 0 0", "v 0 1,5 0", "v nan 0 0", "v 0 1f 0"})
    void aVertexHasThreeNumbers(String line) {
        assertRefused(line, "is not a vertex; it needs three coordinates, such as 'v 0 0.5 -1'");
    }

    /** Positive numbers are of all the file's vertices, negative ones of those before the line. */
    @ParameterizedTest
    @ValueSource(strings = {"f 1 2 5", "f 0 1 2", "l -1 -4", "f 1 2 x", "f 1 2d 2"})
    void aFaceOrLineNamesVerticesThatAreThere(String line) {
        assertRefused(line, "names a vertex that is not there; the file has 1 to 4, and -1 is the last one before");
    }

    @ParameterizedTest
    @ValueSource(strings = {"f 1 2", "f 1/1 2/2 1/3", "l 1"})
    void aFaceOrLineHasItsCorners(String line) {
        assertRefused(line, "needs at least " + (line.startsWith("f") ? 3 : 2) + " corners, all different");
    }

    @Test
    void aFileOfAnotherKindIsNotTakenForAMesh() {
        assertEquals("m.obj: no line begins with 'v', so there are no vertices; is this a Wavefront OBJ file?",
                message("mass: 1", "solid cube\n"));
    }

    @Test
    void mistakesInTheKeysOfAMeshAreReported() {
        String square = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 3 3 3\ng a\nf 1 2 3\n";
        assertEquals("m.obj:4:1: this vertex belongs to no face with an area, so it has no share of totalMass; give"
                + " 'mass'", message("totalMass: 1", square));
        assertEquals("x.yaml:7:41: unknown particle 'rim' in 'fixed'; known: mesh[0] to mesh[3], a",
                message("mass: 1, fixed: rim", square));
        assertEquals("x.yaml:7:44: no particle begins in 'fixedBox'",
                message("mass: 1, fixedBox: {low: [5, 5, 5], high: [6, 6, 6]}", square));
        assertEquals("x.yaml:7:18: no other file can be read here; put its text under 'files'",
                assertThrows(InvalidInputException.class, () -> TestScenes.build(mesh("mass: 1"))).getMessage());
        assertEquals("x.yaml:7:18: the file 'm.obj' is not in 'files', which has n.obj",
                assertThrows(InvalidInputException.class, () -> TestScenes.build(mesh("mass: 1")
                        + "files: {n.obj: v}\n")).getMessage());
    }

    private static String message(String keys, String obj) {
        return assertThrows(InvalidInputException.class, () -> build(keys, obj)).getMessage();
    }

    /** The file is in the scene's folder, or in the scene itself after {@link SceneReader#withFiles}. */
    @Test
    void aSceneAndItsFileBecomeOneText(@TempDir Path folder) throws IOException {
        Path scene = Files.writeString(folder.resolve("x.yaml"), mesh("mass: 1, structural: {stiffness: 3}"));
        assertTrue(assertThrows(InvalidInputException.class, () -> SceneReader.read(scene)).getMessage()
                .endsWith("m.obj: there is no such file"));
        Files.writeString(folder.resolve("m.obj"), "\n  # a comment\r\n" + CORNERS + "f 1 4 3 2\r\n");
        Scene beside = SceneBuilder.build(SceneReader.read(scene));
        Scene within = TestScenes.build(SceneReader.withFiles(scene, ClassNames.none(), List.of()));
        assertArrayEquals(beside.system().getOwnState(), within.system().getOwnState());
        assertEquals(pairs(beside.springs()), pairs(within.springs()));
        Files.writeString(scene, HEAD + "particles: [{id: a, position: [0, 0, 0]}]\n");
        assertEquals(Files.readString(scene), SceneReader.withFiles(scene, ClassNames.none(), List.of()),
                "it names no file");
    }

    /** 160,000 vertices are 480,000 numbers, more than a scene file may have. */
    @Test
    void aMeshMayHaveMoreValuesThanASceneFile(@TempDir Path folder) throws IOException {
        Path scene = Files.writeString(folder.resolve("x.yaml"), mesh("mass: 1"));
        Files.writeString(folder.resolve("m.obj"), grid(400, 400));
        assertEquals(160_000, SceneReader.read(scene).particles().count());
    }
}
