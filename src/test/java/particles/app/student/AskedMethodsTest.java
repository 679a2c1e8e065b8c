package particles.app.student;

import static org.junit.jupiter.api.Assertions.assertEquals;

import deSolvers.catalog.SolverCatalog;
import java.util.List;
import java.util.stream.Collectors;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import particles.teaching.Finding;

/**
 * A right solver passes as its own method, and as the kind that it is of: rk2, rk3, rk5 and rk45 are all that have the
 * order, or a higher one, without earlier steps.
 */
class AskedMethodsTest {
    @Tag("slow")
    @ParameterizedTest
    @CsvSource(textBlock = """
            euler, euler
            midpoint, midpoint rk2
            rk4, rk2 rk3 rk4 rk45
            symplectic-euler, symplectic-euler
            verlet, rk2 verlet
            yoshida4, rk2 rk3 rk45 yoshida4
            backward-euler, backward-euler
            implicit-midpoint, implicit-midpoint rk2
            adams, multistep
            dormand-prince, adaptive rk2 rk3 rk45 rk5
            linearised-euler, ''
            """)
    void eachSolverPassesOnlyAsWhatItIs(String solver, String expected) {
        assertEquals(expected, AskedMethods.NAMES.stream().filter(method -> !method.equals(AskedMethods.ANY)
                && AskedMethods.check(() -> SolverCatalog.create(solver), "X", method).wrong().isEmpty())
                .collect(Collectors.joining(" ")));
        assertEquals(List.of(), AskedMethods.check(() -> SolverCatalog.create(solver), "X", AskedMethods.ANY).findings()
                .stream().filter(Finding::isWrong).toList());
    }
}
