package particles.app.student;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import deSolvers.DESolver;
import deSolvers.DEStateSource;
import deSolvers.EulerSolver;
import deSolvers.catalog.SolverCatalog;
import java.util.Arrays;
import java.util.function.IntFunction;
import java.util.function.Supplier;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;
import particles.law.Effect;
import particles.law.Particles;
import particles.teaching.GuardedRun;

/** A run that is longer than the check finds a class that counts its steps, and no other. */
class PlainRunsTest {
    /** Two-step Adams-Bashforth, begun with a step of Euler: a right method makes no larger error when begun anew. */
    public static final class AdamsBashforth extends DESolver {
        private double[] last = {};

        @Override
        public void reset() {
            last = new double[0];
        }

        @Override
        public void stepState(DEStateSource source, double deltaT) {
            double[] state = new double[source.getStateSize()];
            double[] dSdt = new double[state.length];
            source.getState(state);
            source.getStateDerivative(dSdt);
            double[] earlier = last.length == 0 ? dSdt : last;
            for (int i = 0; i < state.length; i++) {
                state[i] += deltaT * (1.5 * dSdt[i] - 0.5 * earlier[i]);
            }
            last = dSdt;
            source.setState(state);
            source.incTime(deltaT);
        }
    }

    /** Euler that is another method after so many steps. */
    private static final class Counts extends DESolver {
        private final int most;
        private int steps;

        Counts(int most) {
            this.most = most;
        }

        @Override
        public void reset() {
            steps = 0;
        }

        @Override
        public void stepState(DEStateSource source, double deltaT) {
            steps++;
            (steps > most ? SolverCatalog.create("midpoint") : new EulerSolver()).stepState(source, deltaT);
        }
    }

    private static boolean differ(IntFunction<double[]> run) {
        return new GuardedRun(20).run(() -> PlainRuns.differ(Runnable::run, run)).value().orElseThrow();
    }

    private static boolean solverDiffers(Supplier<DESolver> maker) {
        return differ(before -> PlainRuns.solver(maker, before));
    }

    @ParameterizedTest
    @MethodSource("deSolvers.catalog.SolverCatalog#names")
    void everySolverOfTheCatalogueIsTheSameLate(String name) {
        assertEquals(false, solverDiffers(() -> SolverCatalog.create(name)));
    }

    /** Begun anew, it is off by 1.5e-4 to 2.9e-4 of the motion after 200 steps; those of the catalogue by 7e-10. */
    @Test
    void aMethodThatUsesEarlierStepsIsTheSameLate() {
        assertEquals(false, solverDiffers(AdamsBashforth::new));
    }

    /** From Euler to midpoint, 200 steps change the amplitude by exp(5 * 0.01 * 2 / 2) - 1, which is 5 %. */
    @ParameterizedTest
    @ValueSource(ints = {200, 1000, 9000})
    void aCountOfStepsIsFound(int most) {
        assertTrue(solverDiffers(() -> new Counts(most)));
    }

    /** A constant force that ends after 1,000 calls, and one that does not. */
    @ParameterizedTest
    @ValueSource(ints = {1000, Integer.MAX_VALUE})
    void aCountOfCallsOfAForceIsFound(int most) {
        assertEquals(most == 1000, differ(before -> PlainRuns.effect(particles -> constant(particles, most), before)));
    }

    private static Effect constant(Particles particles, int most) {
        return new Effect() {
            private int calls;

            @Override
            public String getName() {
                return "constant";
            }

            @Override
            public void addForces(double[] state, double time, double[] force) {
                calls++;
                Arrays.setAll(force, i -> force[i] + (calls > most ? 0 : particles.count()));
            }
        };
    }
}
