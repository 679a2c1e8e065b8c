package deSolvers.symplectic;

import static org.junit.jupiter.api.Assertions.assertEquals;

import deSolvers.DEStateSource;
import deSolvers.problems.SecondOrderProblem;
import java.util.Random;
import java.util.function.Consumer;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Kicks and drifts of blocks of d positions and d velocities. */
class SymplecticSolverTest {
    private static final double H = 0.25;
    private static final int BLOCKS = 3;

    private final Random random = new Random(14);

    private double[] random(int d) {
        return random.doubles(2L * d * BLOCKS, -1, 1).toArray();
    }

    /** Runs kicks and drifts within a step of a source with blocks of d. */
    private static void inAStep(int d, Consumer<SymplecticSolver> moves) {
        new SymplecticSolver() {
            @Override
            void kickAndDrift(DEStateSource source, double[] s, double deltaT) {
                moves.accept(this);
            }
        }.stepState(new SecondOrderProblem(d, new double[2 * d * BLOCKS]) {
            @Override
            protected void accelerate(double t, double[] s, double[] dSdt) {
                throw new AssertionError("no move asks for it");
            }
        }, H);
    }

    @ParameterizedTest
    @ValueSource(ints = {1, 2, 3, 4})
    void aKickChangesVelocitiesOnlyAndADriftPositions(int d) {
        double[] state = random(d);
        double[] a = random(d);
        double[] kicked = state.clone();
        double[] drifted = state.clone();
        inAStep(d, solver -> solver.kick(kicked, a, H));
        inAStep(d, solver -> solver.drift(drifted, H));
        for (int e = 0; e < state.length; e++) {
            boolean velocity = e % (2 * d) >= d;
            assertEquals(velocity ? state[e] + H * a[e] : state[e], kicked[e], "entry " + e);
            assertEquals(velocity ? state[e] : state[e] + H * state[e + d], drifted[e], "entry " + e);
        }
    }
}
