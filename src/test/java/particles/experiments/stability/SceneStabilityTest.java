package particles.experiments.stability;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;

import deSolvers.text.Digits;
import java.util.List;
import java.util.function.IntFunction;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import particles.experiments.runs.SolverChoice;
import particles.experiments.stability.SceneStability.Limit;
import particles.scene.TestScenes;
import particles.scene.format.SceneDescription;
import particles.view.Panel;
import particles.view.Series;

/** On chains of n unit masses between two walls, whose largest omega is 2 sin(n pi / (2 (n + 1))). */
class SceneStabilityTest {
    private static SceneDescription chain(int n, String damping) {
        return TestScenes.read("title: chain\nteaches: stability\nsolver: rk4\ndeltaT: 0.1\nduration: 1\nparticles:\n"
                + lines(n + 2, i -> "id: p" + i + ", position: [" + i + ", 0, 0], fixed: " + (i % (n + 1) == 0))
                + "springs:\n" + lines(n + 1, i -> "from: p" + i + ", to: p" + (i + 1) + ", stiffness: 1, restLength: 1"
                + damping));
    }

    private static String lines(int count, IntFunction<String> keys) {
        return IntStream.range(0, count).mapToObj(i -> "  - {" + keys.apply(i) + "}\n").collect(Collectors.joining());
    }

    private static List<Limit> limits(SceneDescription scene, String solvers) {
        Spectrum spectrum = SceneStability.spectrum(scene);
        return SceneStability.limits(spectrum, scene.deltaT(), SolverChoice.list(solvers), (part, what) -> { });
    }

    /** Nine digits of the spectrum, as many as the slides' value has: measured 2e-9. */
    @ParameterizedTest
    @CsvSource(textBlock = """
            1, 1.414213562, 2
            2, 1.154700538, 1.632993162
            10, 1.010283227, 1.428756241
            100, 1.000120951, 1.414384613
            """)
    void limitsOfChainsAreThoseOfTheirFastestMode(int n, double leapfrog, double rk4) {
        for (Limit limit : limits(chain(n, ""), "verlet, symplectic-euler, rk4")) {
            double exact = limit.solver().name().equals("rk4") ? rk4 : leapfrog;
            assertEquals(1, limit.deltaT() / exact, 5e-9, limit.toString());
        }
    }

    /** Euler's (1 + (h omega)^2)^(1/2), midpoint's (1 + (h omega)^4/4)^(1/2) at deltaT = 0.1. */
    @ParameterizedTest
    @CsvSource({"euler, 1.940662e-02", "midpoint, 1.919622e-04"})
    void whatAlwaysGrowsSaysByHowMuch(String solver, double growth) {
        Limit limit = limits(chain(10, ""), solver).get(0);
        assertEquals(0, limit.deltaT());
        assertEquals(1, limit.growth() / growth, 1e-5, limit.toString());
        assertEquals("always grows: " + Digits.few(growth) + " per step",
                SceneStability.table(List.of(limit), 0.1).rows().get(0).get(1));
    }

    /**
     * Springs damped by c = 0.3 k: in every mode -2 Re lambda = 0.3 omega^2,
     * and |1 + h lambda| = 1 at h = 0.3 for all of them.
     */
    @Test
    void dampingGivesEulerALimit() {
        SceneDescription scene = chain(10, ", damping: 0.3");
        Limit limit = limits(scene, "euler").get(0);
        assertEquals(0.3, limit.deltaT(), 3e-6, limit.toString());
    }

    /** omega^2 - (c/2)^2 under the root: all eigenvalues of the damped chain, from the undamped chain's. */
    @Test
    void arnoldiFindsEveryDampedMode() {
        int n = 10;
        Spectrum spectrum = SceneStability.spectrum(chain(n, ", damping: 0.3"));
        assertEquals(n, spectrum.modes().size());
        for (int k = 0; k < n; k++) {
            double omega = 2 * Math.sin((n - k) * Math.PI / (2 * (n + 1)));
            double half = 0.15 * omega * omega;
            assertEquals(omega, spectrum.modes().get(k).size(), 1e-9);
            assertEquals(-half, spectrum.modes().get(k).re(), 1e-9);
            assertEquals(Math.sqrt(omega * omega - half * half), spectrum.modes().get(k).im(), 1e-9);
        }
    }

    @Test
    void unlimitedSolversSaySo() {
        List<Limit> limits = limits(chain(2, ""), "backward-euler, implicit-midpoint, radau, dormand-prince");
        List<List<Object>> rows = SceneStability.table(limits, 0.1).rows();
        for (List<Object> row : rows.subList(0, 3)) {
            assertEquals(List.of("unbounded", Double.NaN, ""), row.subList(1, 4));
        }
        assertEquals("sub-steps of", rows.get(3).get(1).toString().substring(0, 12));
        assertEquals(List.of("-", Double.NaN, ""), SceneStability.table(limits(chain(2, ""), "bulirsch-stoer"), 0.1)
                .rows().get(0).subList(1, 4));
    }

    /**
     * A mass in the middle of a compressed spring pair snaps out by itself: no solver is blamed, and no limit comes
     * from it.
     */
    @Test
    void growthOfTheMotionItselfIsPhysics() {
        SceneDescription scene = TestScenes.read("""
                title: snap
                teaches: growth that is physics
                solver: rk4
                deltaT: 0.01
                duration: 1
                particles:
                  - {id: a, position: [-1, 0, 0], mass: 1, fixed: true}
                  - {id: m, position: [0, 0, 0], mass: 1}
                  - {id: b, position: [1, 0, 0], mass: 1, fixed: true}
                springs:
                  - {from: a, to: m, stiffness: 100, restLength: 1.01}
                  - {from: m, to: b, stiffness: 100, restLength: 1.01}
                """);
        Spectrum spectrum = SceneStability.spectrum(scene);
        // transverse: 2 k (restLength - 1)/m = 2 grows as e^(sqrt 2 t)
        assertEquals(Math.sqrt(2), spectrum.modes().stream().mapToDouble(Spectrum.Mode::re).max().orElseThrow(), 1e-9);
        Limit limit = limits(scene, "verlet").get(0);
        assertEquals(2 / Math.sqrt(200), limit.deltaT(), 1e-8);
    }

    /** A skydiver at rest feels no drag that is quadratic: its derivative, by differences, is 1e-9 /s. */
    @Test
    void modesTooSlowToSeeAreNone() {
        assertEquals(List.of(), SceneStability.spectrum(TestScenes.named("22")).modes());
    }

    private static Panel plane(double deltaT, String... solvers) {
        return SceneStability.plane("A chain", SceneStability.spectrum(chain(1, "")), deltaT,
                Stream.of(solvers).map(SolverChoice::of).toList());
    }

    /** At deltaT = 1000, modes reach to 1414, rk4's region to 2.83 and radau's unstable one to 12. */
    @Test
    void outlinesThatWouldBeTooSmallToBeSeenAreLeftOut() {
        assertEquals(List.of("modes of the scene", "imaginary axis"), plane(1000, "rk4", "radau").charts().get(0)
                .series().stream().map(Series::name).toList());
        Panel near = plane(1, "rk4", "radau");
        assertEquals("A chain: eigenvalues times deltaT = 1 s", near.title());
        assertEquals(List.of("rk4", "radau", "modes of the scene", "imaginary axis"),
                near.charts().get(0).series().stream().map(Series::name).toList());
        assertArrayEquals(new double[] {Math.sqrt(2), -Math.sqrt(2)}, near.charts().get(0).series().get(2).y(), 1e-9);
    }

    /**
     * A step of symplectic Euler on x'' = -k x - c x' has the trace 2 - h^2 k - h c and the determinant 1 - h c: one
     * eigenvalue is -1 at h^2 k + 2 h c = 4. Here k = 2 and c = 4, with two real eigenvalues; verlet's iteration at the
     * end of a step diverges from h c = 2 on.
     */
    @Test
    void anOverdampedSpringIsOneSpringForSymplecticSolvers() {
        List<Limit> limits = limits(chain(1, ", damping: 2"), "symplectic-euler, backward-euler");
        assertEquals(Math.sqrt(6) - 2, limits.get(0).deltaT(), 1e-8);
        assertEquals(Double.POSITIVE_INFINITY, limits.get(1).deltaT());
    }

    /** Drag alone, c = 3: 1 - h c reaches -1 at h = 2/3, with symplectic Euler as with Euler. */
    @Test
    void dragIsASpringWithoutStiffness() {
        SceneDescription scene = TestScenes.read("""
                title: drag
                teaches: decay
                solver: rk4
                deltaT: 0.01
                duration: 1
                particles: [{id: a, position: [0, 0, 0], velocity: [1, 0, 0], mass: 2}]
                effects: [drag: {coefficient: 6}]
                """);
        for (Limit limit : limits(scene, "euler, symplectic-euler")) {
            assertEquals(2.0 / 3, limit.deltaT(), 1e-8, limit.toString());
        }
    }

    /** A class of one's own is measured on its own code, as the catalogue's solvers are. */
    @Test
    void aClassOfOnesOwnHasItsLimit() {
        Limit own = limits(chain(2, ""), "deSolvers.RK4Solver").get(0);
        assertEquals(2 * Math.sqrt(2) / Math.sqrt(3), own.deltaT(), 1e-8);
    }

    /** In the fastest mode of three, the amplitudes are 1, -sqrt(2) and 1. */
    @Test
    void theModeThatSetsALimitIsNamedByTheParticleThatMovesMost() {
        Limit limit = limits(chain(3, ""), "verlet").get(0);
        List<Object> row = SceneStability.table(List.of(limit), 0.1).rows().get(0);
        assertEquals(2 * Math.sin(3 * Math.PI / 8), (Double) row.get(2), 1e-8);
        assertEquals("p2", row.get(3));
    }
}
