package particles.app.student;

import static org.junit.jupiter.api.Assertions.assertEquals;

import deSolvers.catalog.SolverCatalog;
import java.util.List;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;

/** A right solver passes as its own method and as no other one. */
class AskedMethodsTest {
    @Tag("slow")
    @Test
    void eachSolverPassesOnlyAsItsOwnMethod() {
        for (String solver : List.of("euler", "midpoint", "rk4", "symplectic-euler", "verlet", "yoshida4",
                "backward-euler", "implicit-midpoint")) {
            passes(solver, List.of(solver, AskedMethods.ANY));
        }
        passes("adams", List.of("multistep", AskedMethods.ANY));
        for (String solver : List.of("dormand-prince", "linearised-euler")) {
            passes(solver, List.of(AskedMethods.ANY));
        }
    }

    private static void passes(String solver, List<String> expected) {
        assertEquals(expected.stream().sorted().toList(), AskedMethods.NAMES.stream().filter(method -> AskedMethods
                .check(() -> SolverCatalog.create(solver), "X", method).wrong().isEmpty()).sorted().toList(), solver);
    }
}
