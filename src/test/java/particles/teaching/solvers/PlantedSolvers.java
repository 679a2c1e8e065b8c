package particles.teaching.solvers;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import deSolvers.DESolver;
import deSolvers.DEStateSource;
import java.util.Arrays;
import java.util.List;
import java.util.function.IntToDoubleFunction;
import java.util.function.Supplier;
import particles.teaching.Finding;

/** Solvers as students write them, each with one mistake. */
public final class PlantedSolvers {
    /**
     * RK4 as the slide has it: where each stage is, how far the clock moves to it and at last, and what each counts.
     */
    public static final double[] PLACES = {0.5, 0.5, 1};
    public static final double[] MOVES = {0.5, 0, 0.5, 0};
    public static final double[] WEIGHTS = {1.0 / 6, 1.0 / 3, 1.0 / 3, 1.0 / 6};
    public static final String NEW_STATE = "; the slide says s + k1/6 + k2/3 + k3/3 + k4/6";

    private PlantedSolvers() {
    }

    /** What {@link DESolver#stepState} does. */
    public interface Step {
        void make(DEStateSource source, double deltaT);
    }

    public static DESolver solver(Step step) {
        return new DESolver() {
            @Override
            public void stepState(DEStateSource source, double deltaT) {
                step.make(source, deltaT);
            }
        };
    }

    public static double[] state(DEStateSource source) {
        double[] state = new double[source.getStateSize()];
        source.getState(state);
        return state;
    }

    public static double[] slope(DEStateSource source) {
        double[] dSdt = new double[source.getStateSize()];
        source.getStateDerivative(dSdt);
        return dSdt;
    }

    public static double[] slopeAt(DEStateSource source, double[] trial) {
        source.setState(trial);
        return slope(source);
    }

    public static double[] with(double[] state, IntToDoubleFunction increment) {
        double[] sum = state.clone();
        Arrays.setAll(sum, i -> state[i] + increment.applyAsDouble(i));
        return sum;
    }

    /** The Euler step with its increment as told. */
    public static DESolver euler(java.util.function.DoubleBinaryOperator increment) {
        return solver((source, deltaT) -> {
            double[] state = state(source);
            double[] dSdt = slope(source);
            source.setState(with(state, i -> increment.applyAsDouble(dSdt[i], deltaT)));
            source.incTime(deltaT);
        });
    }

    /** The midpoint step with numbers that may be wrong. */
    public static DESolver midpoint(double half, double firstMove, double lastMove) {
        return solver((source, deltaT) -> {
            double[] state = state(source);
            double[] dSdt = slope(source);
            source.incTime(firstMove * deltaT);
            double[] gMid = slopeAt(source, with(state, i -> half * deltaT * dSdt[i]));
            source.setState(with(state, i -> deltaT * gMid[i]));
            source.incTime(lastMove * deltaT);
        });
    }

    /**
     * RK4 with numbers that may be wrong.
     *
     * @param places  of k2, k3 and k4: 1/2, 1/2, 1
     * @param moves   of the clock before k2, k3, k4 and at the end: 1/2, 0, 1/2, 0
     * @param weights 1/6, 1/3, 1/3, 1/6
     */
    public static DESolver rk4(double[] places, double[] moves, double[] weights) {
        return solver((source, deltaT) -> {
            double[] state = state(source);
            double[][] k = new double[4][];
            k[0] = slope(source);
            for (int stage = 1; stage < 4; stage++) {
                int before = stage - 1;
                double place = places[before];
                source.incTime(moves[before] * deltaT);
                k[stage] = slopeAt(source, with(state, i -> place * deltaT * k[before][i]));
            }
            source.setState(with(state, i -> deltaT * (weights[0] * k[0][i] + weights[1] * k[1][i]
                    + weights[2] * k[2][i]
                    + weights[3] * k[3][i])));
            source.incTime(moves[3] * deltaT);
        });
    }

    /** Positions and velocities of blocks of six, as the slides' simple algorithm has them. */
    public static DESolver blocks(boolean newVelocity) {
        return solver((source, deltaT) -> {
            double[] state = state(source);
            double[] dSdt = slope(source);
            for (int block = 0; block < state.length; block += 6) {
                for (int x = block; x < block + 3; x++) {
                    double old = state[x + 3];
                    state[x + 3] += dSdt[x + 3] * deltaT;
                    state[x] += (newVelocity ? state[x + 3] : old) * deltaT;
                }
            }
            source.setState(state);
            source.incTime(deltaT);
        });
    }

    /** Takes the size from the first source that it meets. */
    public static final class CachedSize extends DESolver {
        private double[] state;
        private double[] dSdt;

        @Override
        public void stepState(DEStateSource source, double deltaT) {
            if (state == null) {
                state = new double[source.getStateSize()];
                dSdt = new double[source.getStateSize()];
            }
            source.getState(state);
            source.getStateDerivative(dSdt);
            for (int i = 0; i < state.length; i++) {
                state[i] += dSdt[i] * deltaT;
            }
            source.setState(state);
            source.incTime(deltaT);
        }
    }

    /** Asks for the state once, and goes on with its own array. */
    public static final class KeptArray extends DESolver {
        private double[] state = {};

        @Override
        public void stepState(DEStateSource source, double deltaT) {
            if (state.length != source.getStateSize()) {
                state = state(source);
            }
            double[] dSdt = slope(source);
            for (int i = 0; i < state.length; i++) {
                state[i] += dSdt[i] * deltaT;
            }
            source.setState(state);
            source.incTime(deltaT);
        }
    }

    /** Asks for the derivative once. */
    public static final class StaleDerivative extends DESolver {
        private double[] dSdt = {};

        @Override
        public void stepState(DEStateSource source, double deltaT) {
            if (dSdt.length != source.getStateSize()) {
                dSdt = slope(source);
            }
            source.setState(with(state(source), i -> dSdt[i] * deltaT));
            source.incTime(deltaT);
        }
    }

    /** Adams-Bashforth of order 2, which begins with an Euler step. */
    public static final class AdamsBashforth2 extends DESolver {
        private double[] last = {};

        @Override
        public void stepState(DEStateSource source, double deltaT) {
            double[] dSdt = slope(source);
            double[] before = last.length == dSdt.length ? last : dSdt;
            source.setState(with(state(source), i -> deltaT * (1.5 * dSdt[i] - 0.5 * before[i])));
            source.incTime(deltaT);
            last = dSdt;
        }
    }

    /** Holds a check to these beginnings of what it finds wrong, and to nothing else. */
    public static void assertFound(String name, Supplier<DESolver> maker, String... expected) {
        List<String> wrong = SolverCheck.check(maker, name).wrong().stream().map(Finding::toString).toList();
        assertEquals(expected.length, wrong.size(), wrong.toString());
        for (int k = 0; k < expected.length; k++) {
            assertTrue(wrong.get(k).startsWith(expected[k]), wrong.get(k) + " does not start with " + expected[k]);
        }
    }
}
