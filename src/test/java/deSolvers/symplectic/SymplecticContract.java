package deSolvers.symplectic;

import static deSolvers.problems.Bounds.assertAbove;
import static deSolvers.problems.Bounds.assertBelow;
import static org.junit.jupiter.api.Assertions.assertEquals;

import deSolvers.DESolver;
import deSolvers.FixedStepContract;
import deSolvers.problems.Chain;
import deSolvers.problems.Kepler;
import deSolvers.problems.Oscillator;
import deSolvers.problems.ReferenceProblem;
import deSolvers.problems.Steps;
import java.util.function.DoubleFunction;
import java.util.function.Supplier;
import org.junit.jupiter.api.Test;

/** What a method promises that keeps phase-space volume: an energy error that stays bounded. */
public abstract class SymplecticContract extends FixedStepContract {
    private static final double H = 0.25;

    SymplecticContract(Supplier<DESolver> maker, int order, DoubleFunction<double[]> oscillatorStep) {
        super(maker, order, oscillatorStep);
    }

    @Override
    protected boolean needsSecondOrder() {
        return true;
    }

    /** @return whether a step back undoes a step */
    protected boolean isReversible() {
        return true;
    }

    /**
     * @param h a step
     * @return the largest energy error on x'' = -x from (1, 0) in theory, relative to the energy
     */
    abstract double energyBound(double h);

    @Test
    void theEnergyErrorStaysBoundedFor100000Periods() {
        double first = EnergyKeeping.check(createSolver(), H, energyBound(H));
        // The bound is reached, up to how close the steps come to the worst phase.
        assertAbove(0.99 * energyBound(H), first);
    }

    @Test
    void thereAndBack() {
        for (ReferenceProblem problem : new ReferenceProblem[] {new Oscillator(), new Kepler(0.5), new Chain(5, 3)}) {
            var solver = createSolver();
            Steps.make(1000, solver, problem, 1.0 / 64);
            Steps.make(1000, solver, problem, -1.0 / 64);
            assertEquals(0, problem.getTime());
            // Measured at most 7.0e-13 (verlet, Kepler) and at least 1.3e-3 (symplectic-euler, oscillator).
            if (isReversible()) {
                assertBelow(5e-12, problem.error(), problem.getClass().getSimpleName());
            } else {
                assertAbove(1e-3, problem.error(), problem.getClass().getSimpleName());
            }
        }
    }
}
