package particles.teaching.figures;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static particles.Texts.assertHas;

import deSolvers.catalog.SolverCatalog;
import java.util.List;
import org.junit.jupiter.api.Test;
import particles.teaching.solvers.SolverCheck;

/** The numbers of a report are those of the theory. */
class SolverFiguresTest {
    private static SolverFigures figures(String name) {
        return SolverFigures.of(name, () -> SolverCatalog.create(name),
                SolverCheck.check(() -> SolverCatalog.create(name), SolverCatalog.create(name).getClass()
                        .getSimpleName()));
    }

    private static String value(SolverFigures figures, String property) {
        List<Object> row = figures.facts().rows().stream().filter(r -> r.get(0).toString().startsWith(property))
                .findFirst()
                .orElseThrow();
        return row.get(1) + " " + row.get(2);
    }

    private static double number(SolverFigures figures, String property) {
        return Double.parseDouble(value(figures, property).replaceFirst(" .*", ""));
    }

    @Test
    void rk4HasItsLimitsAndDamps() {
        SolverFigures rk4 = figures("rk4");
        // eight digits are shown
        assertEquals(2.785293563405282, number(rk4, "real limit"), 5e-8);
        assertEquals(2 * Math.sqrt(2), number(rk4, "imaginary limit"), 5e-8);
        assertEquals(4, number(rk4, "order"), 0.05);                                                // measured 4.013
        // |R(i)|^2 = (1 - 1/2 + 1/24)^2 + (1 - 1/6)^2 = 569/576
        assertEquals(569.0 / 576, number(rk4, "areas in state space"), 5e-9);
        assertHas(value(rk4, "areas in state space"), "not symplectic: areas shrink");
        assertTrue(value(rk4, "distance from the start").endsWith("not reversible"));
        assertTrue(rk4.region().isPresent());
    }

    @Test
    void verletKeepsAreaAndGoesBack() {
        SolverFigures verlet = figures("verlet");
        assertHas(value(verlet, "areas in state space"), "symplectic on the spring");
        assertHas(value(verlet, "distance from the start"), "reversible: it ends where it began");
        // the invariant x^2 (1 - h^2/4) + v^2 keeps the energy within h^2/4 = 0.0025
        assertEquals(0.0025, number(verlet, "largest energy error"), 5e-7);      // measured 5.7e-8
        assertEquals(2, number(verlet, "imaginary limit"), 5e-8);
        // README's limit, to the two digits that it gives
        assertEquals(SolverCatalog.info("verlet").dampedLimit(), number(verlet, "damped limit"), 0.005);
        assertTrue(verlet.region().isPresent());
    }

    @Test
    void eulerGrowsAndNoSpringIsStable() {
        SolverFigures euler = figures("euler");
        assertEquals(2, number(euler, "areas in state space"), 5e-8);           // 1 + h^2
        assertEquals(0, number(euler, "imaginary limit"));
        assertEquals(2, number(euler, "real limit"), 5e-8);
        assertEquals(1, number(euler, "evaluations"));
    }
}
