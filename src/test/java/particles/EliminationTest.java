package particles;

import static deSolvers.problems.Bounds.assertBelow;
import static deSolvers.problems.Bounds.assertBetween;
import static org.junit.jupiter.api.Assertions.assertEquals;

import deSolvers.implicit.LinearisedEulerSolver;
import deSolvers.linear.SolverWork;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Implicit solvers use elimination instead of iterations when that takes less work. */
class EliminationTest {
    private static final double FRAME = 1.0 / 60;

    private static SolverWork work(ParticleSystem system) {
        LinearisedEulerSolver solver = new LinearisedEulerSolver();
        solver.stepState(system, FRAME);
        return solver.getWork();
    }

    /** At the stiffness where elimination takes over, both ways take about the same work. */
    @ParameterizedTest
    @ValueSource(ints = {20, 24})
    void aClothIsEliminatedOnceIterationsTakeMoreWork(int edge) {
        SolverWork softer = work(Cloth.hanging(edge, 100, 0));
        assertEquals(0, softer.factorisations);
        int changes = 0;
        for (double stiffness = 110; stiffness < 20_000; stiffness *= changes == 0 ? 1.1 : 2) {
            SolverWork stiffer = work(Cloth.hanging(edge, stiffness, 0));
            if (stiffer.factorisations != softer.factorisations) {
                changes++;
                double ratio = (double) stiffer.blockOperations / softer.blockOperations;
                // Measured 0.97 and 1.00 of the work of 47 and 57 iterations.
                assertBetween(0.93, 1.07, ratio, stiffness);
            }
            softer = stiffer;
        }
        assertEquals(1, changes);
        assertEquals(1, softer.factorisations);
    }

    /** A chain of 200 particles that hangs from the first, slightly crumpled. */
    private static ParticleSystem chain(double stiffness) {
        ParticleSystem chain = Cloth.chain(200, 0.01, 0.05, stiffness, 0);
        for (int i = 0; i < 200; i++) {
            chain.getOwnState()[6 * i + 2] = 0.01 * (7 * i % 5);
        }
        return chain;
    }

    /** A chain has no fill-in, so elimination is far cheaper as soon as iterations are many. */
    @Test
    void aChainIsEliminatedAsSoonAsIterationsAreMany() {
        SolverWork soft = work(chain(200));
        SolverWork stiff = work(chain(2000));
        assertEquals(0, soft.factorisations);
        assertBelow(16, soft.iterations);              // measured 13
        assertEquals(1, stiff.iterations);
        assertEquals(1, stiff.factorisations);
        // Measured 4,071 products after 11,172.
        assertBelow(soft.blockOperations / 2, stiff.blockOperations);
    }
}
