package deSolvers.catalog;

import static deSolvers.problems.Bounds.assertBelow;
import static deSolvers.problems.KnownSolutions.growthInSeason;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertNotSame;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import deSolvers.DESolver;
import deSolvers.DEStateSource;
import deSolvers.adaptive.AdaptiveSolver;
import deSolvers.adaptive.DormandPrinceSolver;
import deSolvers.problems.ForcedOscillator;
import deSolvers.problems.Steps;
import java.util.List;
import java.util.NoSuchElementException;
import org.junit.jupiter.api.Test;

class SolverCatalogTest {

    /** A student's own solver. */
    public static final class Own extends DESolver {
        @Override
        public void stepState(DEStateSource source, double deltaT) {
            source.incTime(deltaT);
        }
    }

    /** A solver that cannot be created: it has no constructor without parameters. */
    public static final class Unmakeable extends DESolver {
        public Unmakeable(int unused) {
        }

        @Override
        public void stepState(DEStateSource source, double deltaT) {
        }
    }

    /** A solver whose constructor fails. */
    public static final class Failing extends DESolver {
        public Failing() {
            throw new IllegalStateException("no luck");
        }

        @Override
        public void stepState(DEStateSource source, double deltaT) {
        }
    }

    /** A solver whose static initialiser fails. */
    public static final class Unloadable extends DESolver {
        static final int[] WEIGHTS = {1, 2};
        static final int SUM = WEIGHTS[0] + WEIGHTS[1] + WEIGHTS[2];

        @Override
        public void stepState(DEStateSource source, double deltaT) {
        }
    }

    @Test
    void everyEntryCreatesItsSolver() {
        assertEquals("euler", SolverCatalog.names().get(0));
        assertEquals(SolverCatalog.names(), SolverCatalog.all().stream().map(SolverInfo::name).toList());
        for (SolverInfo info : SolverCatalog.all()) {
            DESolver solver = SolverCatalog.create(info.name());
            assertEquals(info.adaptive(), solver instanceof AdaptiveSolver, info.name());
            assertNotSame(solver, SolverCatalog.create(info.name()), "each call makes a new one");
            assertEquals(info, SolverCatalog.info(info.name()));
            assertTrue(info.order() >= 1, info.name());
            assertTrue(info.sentence().endsWith("."), info.name());
        }
    }

    @Test
    void onlySecondOrderSolversRefuseFirstOrderSources() {
        for (SolverInfo info : SolverCatalog.all()) {
            SolverCatalog.create(info.name()).stepState(new ForcedOscillator(), 0.125);
            DESolver solver = SolverCatalog.create(info.name());
            if (info.secondOrder()) {
                assertThrows(IllegalArgumentException.class, () -> solver.stepState(growthInSeason(), 0.125),
                        info.name());
            } else {
                solver.stepState(growthInSeason(), 0.125);
            }
        }
    }

    @Test
    void theErrorForAnUnknownNameListsTheKnownOnes() {
        for (String name : List.of("rk5", "", "no.such.Solver")) {
            NoSuchElementException e = Steps.assertFails(NoSuchElementException.class, "'" + name + "'",
                    () -> SolverCatalog.create(name));
            assertTrue(e.getMessage().contains("euler, midpoint, rk4"), e.getMessage());
        }
    }

    @Test
    void onlyAdaptiveSolversTakeTolerances() {
        for (SolverInfo info : SolverCatalog.all()) {
            if (info.adaptive()) {
                double coarse = errorOf(SolverCatalog.create(info.name(), 1e-3, 1e-3));
                double fine = errorOf(SolverCatalog.create(info.name(), 1e-9, 1e-9));
                assertBelow(coarse / 1000, fine, info.name());
            } else {
                IllegalArgumentException e = Steps.assertFails(IllegalArgumentException.class, "'" + info.name() + "'",
                        () -> SolverCatalog.create(info.name(), 1e-3, 1e-3));
                assertTrue(e.getMessage().contains("dormand-prince"), e.getMessage());
            }
        }
        assertThrows(NoSuchElementException.class, () -> SolverCatalog.create("rk5", 1e-3, 1e-3));
        assertInstanceOf(DormandPrinceSolver.class, SolverCatalog.create(DormandPrinceSolver.class.getName(), 1e-3,
                1e-3));
        assertThrows(IllegalArgumentException.class, () -> SolverCatalog.create(Own.class.getName(), 1e-3, 1e-3));
        assertThrows(IllegalArgumentException.class, () -> SolverCatalog.create("dormand-prince", -1.0, 1e-3));
    }

    private static double errorOf(DESolver solver) {
        ForcedOscillator problem = new ForcedOscillator();
        solver.stepState(problem, 10);
        return problem.error();
    }

    @Test
    void aClassNameCreatesAStudentsSolver() {
        assertInstanceOf(Own.class, SolverCatalog.create(Own.class.getName()));
    }

    @Test
    void anUnusableClassIsRefusedWithTheReason() {
        assertRefused("java.lang.String", "has to extend deSolvers.DESolver");
        assertRefused(Unmakeable.class.getName(), "constructor without parameters");
        assertRefused("deSolvers.DESolver", "not abstract");
        assertRefused(Failing.class.getName(), "no luck");
    }

    @Test
    void aClassThatCannotBeLoadedIsRefusedTheSecondTimeToo() {
        String name = Unloadable.class.getName();
        assertRefused(name,
                "cannot be loaded: java.lang.ArrayIndexOutOfBoundsException: Index 2 out of bounds for length 2");
        assertRefused(name, "cannot be loaded: ");
    }

    private static void assertRefused(String name, String reason) {
        IllegalArgumentException e = Steps.assertFails(IllegalArgumentException.class, name,
                () -> SolverCatalog.create(name));
        assertTrue(e.getMessage().contains(reason), e.getMessage());
    }
}
