package particles.experiments.stability;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static particles.Texts.assertStarts;

import deSolvers.DEStateSource;
import deSolvers.FixedStepSolver;
import deSolvers.catalog.SolverCatalog;
import deSolvers.catalog.SolverInfo;
import deSolvers.catalog.SolverInfo.Family;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import particles.experiments.runs.SolverChoice;
import particles.experiments.stability.Spectrum.Mode;
import particles.view.DataTable;

/**
 * The limits that the catalogue states are measured on the solvers' real code, whose steps {@code StepMatrixFormula}
 * compares with theory.
 */
class StabilityLimitsTest {
    private static SolverStability measured(String solver) {
        return SolverStability.of(SolverChoice.of(solver));
    }

    private static void assertLimit(double theory, StabilityLimit measured, String what) {
        if (!Double.isNaN(theory)) {
            // the catalogue gives four digits; an unbounded limit is met exactly
            assertEquals(theory, measured.value(), theory == 0 ? 0 : 6e-5, what);
        }
    }

    @Test
    void everyLimitThatTheCatalogueStatesIsMeasured() {
        for (SolverInfo info : SolverCatalog.all()) {
            SolverStability measured = measured(info.name());
            assertLimit(info.realLimit(), measured.damped(), info.name() + ", real");
            assertLimit(info.imaginaryLimit(), measured.undamped(), info.name() + ", imaginary");
        }
    }

    /** At h omega = 10, Euler's implicit method leaves 1/sqrt(101) of an undamped vibration, and the midpoint all. */
    @Test
    void solversThatAreCalledDampingDampWhatIsTooFast() {
        for (SolverInfo info : SolverCatalog.all()) {
            if (info.unlimited() && !info.adaptive()) {
                assertEquals(info.damping() ? 1 / Math.sqrt(101) : 1, Amplification.of(info).at(0, 10), 1e-12,
                        info.name());
            }
            assertTrue(!info.damping() || info.unlimited(), info.name());
        }
    }

    /** Of verlet and yoshida4 it depends on the iteration's tolerance: what is stated is no more than was measured. */
    @Test
    void limitsUnderDampingAreMeasured() {
        for (String name : List.of("symplectic-euler", "verlet", "yoshida4")) {
            SolverInfo info = SolverCatalog.info(name);
            double measured = measured(name).damped().value();
            assertEquals(info.dampedLimit(), measured, 5e-4, name);     // measured 3e-4, of verlet
            assertTrue(info.dampedLimit() <= measured, name);
        }
        // symplectic Euler, critically damped: 4 - h^2 - 4 h = 0
        assertEquals(2 * (Math.sqrt(2) - 1), SolverCatalog.info("symplectic-euler").dampedLimit(), 5.1e-5);
    }

    /** Both eigenvalues of a critically damped spring are -omega, where the limit is the real one. */
    @Test
    void aCriticallyDampedSpringHasTheRealLimitOfMethodsThatStepTheWholeState() {
        for (SolverInfo info : SolverCatalog.all()) {
            if (!info.secondOrder() && info.family() != Family.MULTISTEP) {
                Amplification onSprings = new Amplification(Amplification.of(info).maker(), true, false, 0);
                assertLimit(info.dampedLimit(), StabilityLimit.measure(h -> onSprings.of(new Mode(-1, 0, 1, 2, ""), h)),
                        info.name());
            }
        }
    }

    /** (1 + h^2)^(1/2) - 1, (1 + h^4/4)^(1/2) - 1, and reference-values.md's 1.6e-7, at h = 0.1. */
    @ParameterizedTest
    @CsvSource({"euler, 4.987562e-3, 1e-9", "midpoint, 1.249992e-5, 1e-10", "adams, 1.6e-7, 2e-9"})
    void whatAlwaysGrowsSaysByHowMuch(String solver, double growth, double digits) {
        StabilityLimit limit = measured(solver).undamped();
        assertEquals(growth, limit.growth(), digits);
        assertStarts(limit.text(), "always grows: ");
    }

    /**
     * With h^8: too little to see at 0.1, 9.3e-14, and not stable for all that. No threshold may turn it into a limit.
     */
    @Test
    void theGrowthOfBulirschStoerIsTinyAndNotNone() {
        SolverInfo info = SolverCatalog.info("bulirsch-stoer");
        assertEquals(0, measured(info.name()).undamped().value());
        Amplification amplification = Amplification.of(info);
        assertEquals(256, (amplification.at(0, 0.4) - 1) / (amplification.at(0, 0.2) - 1), 10);     // measured 250
    }

    /** Heun's method, as a student writes it: R is that of the midpoint method. */
    public static final class Heun extends FixedStepSolver {
        @Override
        protected void step(DEStateSource source, double[] s, double deltaT) {
            double[] k1 = eulerStep(s, deltaT);
            source.incTime(deltaT);
            double[] k2 = eulerStep(plus(s, 1, k1), deltaT);
            for (int i = 0; i < s.length; i++) {
                s[i] += (k1[i] + k2[i]) / 2;
            }
        }
    }

    /** R = 1 - h + h^2/2 exceeds 1 beyond h = 2, and is over 1 by h^4/8 on the imaginary axis. */
    @Test
    void theTableHasAClassOfYourOwnOnSprings() {
        assertEquals(List.of("StabilityLimitsTest$Heun", "-", "always grows: 1.25e-5 per step", "-", "2.0000"),
                SolverStability.table(List.of(measured(Heun.class.getName()))).rows().get(0));
    }

    @Test
    void theTableHasEverySolverAndSaysUnbounded() {
        DataTable table = SolverStability.table(SolverChoice.list("all").stream().map(SolverStability::of).toList());
        assertEquals(SolverCatalog.names(), table.rows().stream().map(row -> row.get(0)).toList());
        assertEquals(table.columns().size(), table.columns().stream().map(DataTable.Column::name).distinct().count());
        List<Object> verlet = table.rows().get(SolverCatalog.names().indexOf("verlet"));
        assertEquals("0.7400", verlet.get(3));
        assertEquals(0.74, Double.parseDouble((String) verlet.get(4)), 0.005);
        List<Object> bulirschStoer = table.rows().get(SolverCatalog.names().indexOf("bulirsch-stoer"));
        assertEquals("no growth above 1e-12 per step", bulirschStoer.get(2));
        List<Object> implicit = table.rows().get(SolverCatalog.names().indexOf("backward-euler"));
        assertEquals(List.of("unbounded", "unbounded", "unbounded", "unbounded"), implicit.subList(1, 5));
    }

    /** Radau's growing solutions no longer grow from 12 on: (1 + 2z/5 + z^2/20)/(1 - 3z/5 + 3z^2/20 - z^3/60) = -1. */
    @Test
    void aSquareShowsAllLimits() {
        assertEquals(1.3 * 2.8284, measured("rk4").reach(), 1e-4);
        assertEquals(1.3 * 2, measured("backward-euler").reach(), 1e-7);
        assertEquals(1.3 * 3.2, measured("implicit-midpoint").reach());
        double z = measured("radau").reach() / 1.3;
        assertEquals(-1, (1 + 2 * z / 5 + z * z / 20) / (1 - 3 * z / 5 + 3 * z * z / 20 - z * z * z / 60), 1e-6);
    }
}
