package deSolvers.implicit;

import static org.junit.jupiter.api.Assertions.assertTrue;

import deSolvers.DESolver;
import deSolvers.FixedStepContract;
import deSolvers.StepMatrixFormula;
import deSolvers.problems.Chain;
import deSolvers.problems.Kepler;
import deSolvers.problems.Oscillator;
import deSolvers.problems.ReferenceProblem;
import deSolvers.problems.Steps;
import deSolvers.symplectic.EnergyKeeping;
import org.junit.jupiter.api.Test;

class ImplicitMidpointSolverTest extends FixedStepContract {
    ImplicitMidpointSolverTest() {
        super(ImplicitMidpointSolver::new, 2,
                h -> StepMatrixFormula.rational(h, new double[] {1, 0.5}, new double[] {1, -0.5}));
    }

    /**
     * The energy of a linear spring is kept to rounding: the bound is 0 but for the floor of 1e-10 in the check itself.
     */
    @Test
    void theEnergyOfALinearSpringIsKeptFor100000Periods() {
        EnergyKeeping.check(createSolver(), 2, 0);
    }

    @Test
    void thereAndBack() {
        for (ReferenceProblem problem : new ReferenceProblem[] {new Oscillator(), new Kepler(0.5), new Chain(5, 3)}) {
            assertTrue(errorThereAndBack(createSolver(), problem) < 1e-12, problem.getClass().getSimpleName());
        }
        assertTrue(errorThereAndBack(new BackwardEulerSolver(), new Oscillator()) > 0.1,
                "backward-euler is not reversible");
    }

    /** Measured at most 1.5e-13 (Kepler); 0.22 for backward-euler. */
    private static double errorThereAndBack(DESolver solver, ReferenceProblem problem) {
        problem.startAt(0);
        Steps.make(1000, solver, problem, 1.0 / 64);
        Steps.make(1000, solver, problem, -1.0 / 64);
        return problem.error();
    }
}
