package particles.teaching.solvers;

import static org.junit.jupiter.api.Assertions.assertEquals;

import deSolvers.catalog.SolverCatalog;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import particles.teaching.declared.Method;

/** The built-in solvers are right, and recognised. */
class CatalogueSolversPassTest {
    private static final Map<String, Method> METHODS = Map.of("euler", Method.EULER, "midpoint", Method.MIDPOINT, "rk4",
            Method.RK4, "symplectic-euler", Method.SYMPLECTIC_EULER, "verlet", Method.VERLET, "yoshida4",
            Method.YOSHIDA4, "backward-euler", Method.BACKWARD_EULER, "implicit-midpoint", Method.IMPLICIT_MIDPOINT);

    static List<String> names() {
        return SolverCatalog.names();
    }

    @ParameterizedTest
    @MethodSource("names")
    void everyCatalogueSolverPassesWithNoComplaintAndIsRecognised(String name) {
        SolverVerdict verdict = SolverCheck.check(() -> SolverCatalog.create(name),
                SolverCatalog.create(name).getClass().getSimpleName());
        assertEquals(List.of(), verdict.findings());
        assertEquals(Optional.ofNullable(METHODS.get(name)), verdict.method());
    }
}
