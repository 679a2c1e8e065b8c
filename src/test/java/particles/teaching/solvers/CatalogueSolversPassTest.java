package particles.teaching.solvers;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import deSolvers.catalog.SolverCatalog;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/** Whoever does it right hears no complaint. */
class CatalogueSolversPassTest {
    private static final Map<String, String> IDENTITIES = Map.of("euler", "This is the Euler method.", "midpoint",
            "This is the midpoint method.",
            "rk4", "This is RK4, the classical Runge-Kutta method.", "symplectic-euler",
            "This is symplectic Euler, the slides' simple particle system algorithm.", "verlet",
            "This is velocity Verlet (leapfrog: kick, drift, kick).", "yoshida4",
            "This is Yoshida's method of order 4.", "adams",
            "This is a method that uses earlier steps (a multistep method).", "backward-euler",
            "This is backward Euler.",
            "implicit-midpoint", "This is the implicit midpoint method.");

    static List<String> names() {
        return SolverCatalog.names();
    }

    @ParameterizedTest
    @MethodSource("names")
    void everyCatalogueSolverPassesWithNoComplaintAndIsRecognised(String name) {
        SolverVerdict verdict = SolverCheck.check(() -> SolverCatalog.create(name),
                SolverCatalog.create(name).getClass().getSimpleName());
        assertEquals(List.of(), verdict.wrong());
        boolean refuses = List.of("symplectic-euler", "verlet", "yoshida4").contains(name);
        assertEquals(refuses ? 1 : 0, verdict.findings().size(), verdict.findings().toString());
        assertTrue(verdict.findings().stream().allMatch(note -> note.text().startsWith(
                "it works on systems of positions and velocities only, such as particles, and refuses others")),
                verdict.findings().toString());
        assertEquals(IDENTITIES.getOrDefault(name, "This is a method without fixed"
                + " coefficients, adaptive or implicit."),
                verdict.identity());
    }
}
