package particles.scene;

import static deSolvers.problems.Bounds.assertBelow;
import static deSolvers.problems.Bounds.assertBetween;
import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.sun.management.ThreadMXBean;
import java.lang.management.ManagementFactory;
import java.util.HashSet;
import java.util.Map;
import java.util.Set;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import particles.law.Particles;
import particles.law.Vector3;

class ShapesTest {
    private static final String HEAD = "title: Shapes\nteaches: counting\nsolver: rk4\ndeltaT: 0.002\nduration: 1\n";

    private static Scene build(String text) {
        return TestScenes.build(HEAD + text);
    }

    private static Scene cloth(int columns, int rows, String more) {
        return build("shapes:\n  - cloth: {corner: [-1, 0, 0], across: [2, 0, 0], down: [0, -1, 0], columns: "
                + columns + ", rows: "
                + rows + ", totalMass: 3" + more + "}\n");
    }

    private static Scene jelly(int columns, int rows, int layers, String more) {
        return build("shapes:\n  - jelly: {centre: [0, 0.6, 0], size: [1, 1.2, 0.8], columns: " + columns + ", rows: "
                + rows
                + ", layers: " + layers + ", mass: 0.1" + more + "}\n");
    }

    /**
     * A cloth of n m particles has (n-1) m + n (m-1) next neighbours, 2 (n-1)(m-1) diagonals, and (n-2) m + n (m-2)
     * neighbours but one. In a block every face of every layer has two diagonals, and every cell four more through its
     * middle.
     */
    @ParameterizedTest
    @CsvSource(textBlock = """
            2, 2, 0, 4, 2, 0
            5, 3, 0, 22, 16, 14
            2, 7, 0, 19, 12, 10
            2, 2, 2, 12, 16, 0
            4, 3, 2, 46, 82, 20
            3, 5, 4, 133, 292, 86
            """)
    void aShapeHasTheRightNumberOfSprings(int n, int m, int layers, int structural, int shear, int bend) {
        Map.of("structural", structural, "shear", shear, "bend", bend).forEach((sort, count) -> {
            String springs = ", " + sort + ": {stiffness: 1}";
            Scene scene = layers == 0 ? cloth(n, m, springs) : jelly(n, m, layers, springs);
            assertEquals(count, scene.springs().springCount(), sort);
        });
    }

    @Test
    void noPairIsConnectedTwiceAndEverySpringIsAtRest() {
        String all = ", structural: {stiffness: 1}, shear: {stiffness: 1}, bend: {stiffness: 1}";
        Scene scene = jelly(4, 3, 5, all + ", turn: [10, 20, 30]");
        Set<Set<Integer>> pairs = new HashSet<>();
        for (int s = 0; s < scene.springs().springCount(); s++) {
            assertTrue(pairs.add(Set.of(scene.springs().from(s), scene.springs().to(s))), "spring " + s);
        }
        double energy = scene.system().getEnergy(scene.system().getOwnState(), 0);
        assertBelow(8e-30, energy, "measured 8.5e-31, rounding of lengths");
    }

    @Test
    void idsHaveTheirPositions() {
        Scene scene = cloth(3, 2, ", fixed: [top-right, \"cloth[0,1]\"], velocity: [0, 0, 5]");
        Particles particles = scene.system().getParticles();
        assertArrayEquals(new String[] {"cloth[0,0]", "cloth[0,1]", "cloth[1,0]", "cloth[1,1]", "cloth[2,0]",
                "cloth[2,1]"},
                IntStream.range(0, 6).mapToObj(particles::id).toArray());
        double[] state = scene.system().getOwnState();
        assertArrayEquals(new double[] {-1, -1, 0, 0, 0, 0},
                IntStream.range(6, 12).mapToDouble(i -> state[i]).toArray());
        assertArrayEquals(new double[] {0, 0, 0, 0, 0, 5},
                IntStream.range(12, 18).mapToDouble(i -> state[i]).toArray());
        assertEquals("1 4", fixed(particles));
        assertEquals(0.5, particles.mass(3), "a sixth of 3 kg");
    }

    private static String fixed(Particles particles) {
        return IntStream.range(0, particles.count()).filter(particles::isFixed).mapToObj(Integer::toString)
                .collect(Collectors.joining(" "));
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', textBlock = """
            cloth | left    | 0 1 2
            cloth | bottom  | 2 5 8 11
            cloth | corners | 0 2 9 11
            cloth | edges   | 0 1 2 3 5 6 8 9 10 11
            jelly | top     | 6 7 8 15 16 17 24 25 26
            jelly | corners | 0 2 6 8 18 20 24 26
            """)
    void partsAreFixedByName(String shape, String part, String numbers) {
        Scene scene = shape.equals("cloth") ? cloth(4, 3, ", fixed: " + part) : jelly(3, 3, 3, ", fixed: " + part);
        assertEquals(numbers, fixed(scene.system().getParticles()));
    }

    /** Front faces out: the volume that the triangles enclose is the block's, and positive. */
    @Test
    void aBlocksSurfaceIsClosedAndFacesOutwards() {
        Scene scene = jelly(3, 4, 5, ", turn: [10, 20, 30]");
        int[] triangles = scene.scenery().surfaces().get(0).triangles();
        assertEquals(3 * 4 * (2 * 3 + 2 * 4 + 3 * 4), triangles.length);
        double volume = 0;
        for (int t = 0; t < triangles.length; t += 3) {
            volume += at(scene, triangles[t]).dot(at(scene, triangles[t + 1]).cross(at(scene, triangles[t + 2]))) / 6;
        }
        assertEquals(1 * 1.2 * 0.8, volume, 1e-14);
        assertFalse(IntStream.of(triangles).anyMatch(i -> i >= 60));
    }

    private static Vector3 at(Scene scene, int i) {
        return Vector3.at(scene.system().getOwnState(), 6 * i);
    }

    @Test
    void aClothFacesTheViewerWhoSeesItsFirstCornerTopLeft() {
        Scene scene = cloth(3, 3, "");
        int[] triangles = scene.scenery().surfaces().get(0).triangles();
        assertEquals(3 * 8, triangles.length);
        for (int t = 0; t < triangles.length; t += 3) {
            Vector3 a = at(scene, triangles[t]);
            assertTrue(at(scene, triangles[t + 1]).minus(a).cross(at(scene, triangles[t + 2]).minus(a)).z() > 0);
        }
    }

    /** Mirror images stay mirror images up to round-off (measured 2.1e-15). */
    @Test
    void aClothThatFallsFromTwoCornersStaysSymmetric() {
        Scene scene = build(
                "effects: [gravity]\nshapes:\n  - cloth: {corner: [-1, 0, -1], across: [2, 0, 0], down: [0, 0,"
                + " 2], columns: 9, rows: 9, totalMass: 0.6, fixed: [top-left, top-right],"
                + " structural: {stiffness: 60, damping: 0.05}, shear: {stiffness: 20}, bend: {stiffness: 5}}\n");
        scene.simulation().run();
        double worst = 0;
        for (int i = 0; i < 9; i++) {
            for (int j = 0; j < 9; j++) {
                Vector3 left = at(scene, 9 * i + j);
                Vector3 right = at(scene, 9 * (8 - i) + j);
                worst = Math.max(worst, right.minus(new Vector3(-left.x(), left.y(), left.z())).length());
            }
        }
        assertBelow(2e-14, worst);
        assertTrue(at(scene, 9 * 4 + 8).y() < -0.5, "it has fallen");
    }

    /** Each of 40 more rules takes 122 bytes per particle (measured); to make the name again would take over 300. */
    @Test
    void solidsCostNoObjectForEachParticle() {
        ThreadMXBean threads = (ThreadMXBean) ManagementFactory.getThreadMXBean();
        String block = "shapes:\n  - jelly: {centre: [0, 0, 0], size: [1, 1, 1], columns: 20, rows: 20, layers: 20,"
                + " mass: 0.1}\nrules:\n";
        long[] bytes = new long[2];
        for (int k = 0; k < 2; k++) {
            String text = HEAD + block + "  - ground: {height: -2}\n".repeat(1 + 40 * k);
            TestScenes.read(text);
            long before = threads.getCurrentThreadAllocatedBytes();
            TestScenes.read(text);
            bytes[k] = threads.getCurrentThreadAllocatedBytes() - before;
        }
        assertTrue(bytes[1] - bytes[0] < 40 * 8000 * 150L, bytes[1] + " bytes, and " + bytes[0] + " for one solid");
    }

    /** A block that lies on the ground is squeezed a little by its weight and comes to rest there. */
    @Test
    void aBlockOnTheGroundStaysThere() {
        Scene scene = build("effects: [gravity]\nrules: [ground: {restitution: 0, friction: {law: coulomb,"
                + " coefficient: 0.5}}]\nshapes:\n  - jelly: {centre: [0, 0.5, 0], size: [1, 1, 1], columns: 3, rows:"
                + " 3, layers: 3, mass: 0.1, structural: {stiffness: 400, damping: 2}, shear: {stiffness: 200,"
                + " damping: 1}}\n");
        scene.simulation().run();
        double[] state = scene.system().getOwnState();
        for (int n : new int[] {0, 1, 2, 9, 10, 11, 18, 19, 20}) {
            assertEquals(0, state[6 * n + 1], 1e-9, "the bottom lies on the ground");
        }
        assertBelow(4e-7, scene.system().getKineticEnergy(state), "at rest, measured 4.7e-8");
        assertEquals(0, at(scene, 13).x(), 1e-15, "measured 5e-19, rounding only");
        assertBetween(0.496, 0.499, at(scene, 13).y());
    }
}
