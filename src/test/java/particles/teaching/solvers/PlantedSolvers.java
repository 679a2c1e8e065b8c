package particles.teaching.solvers;

import deSolvers.DESolver;
import deSolvers.DEStateSource;
import java.util.Arrays;
import java.util.function.IntToDoubleFunction;
import particles.teaching.declared.Step;

/** Solvers as students write them, each with one mistake. */
public final class PlantedSolvers {
    private PlantedSolvers() {
    }

    /** @return a solver that makes these steps */
    public static DESolver solver(Step step) {
        return step.solver();
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

    /** @return s with multiples of others added: a number, then an array, and so on */
    static double[] plus(double[] s, Object... others) {
        double[] sum = s.clone();
        for (int j = 0; j < others.length; j += 2) {
            double factor = ((Number) others[j]).doubleValue();
            double[] other = (double[]) others[j + 1];
            Arrays.setAll(sum, i -> sum[i] + factor * other[i]);
        }
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

    /** Positions and velocities of blocks of six, as the slides' simple algorithm has them. */
    public static DESolver blocks() {
        return solver((source, deltaT) -> {
            double[] state = state(source);
            double[] dSdt = slope(source);
            for (int block = 0; block < state.length; block += 6) {
                for (int x = block; x < block + 3; x++) {
                    state[x + 3] += dSdt[x + 3] * deltaT;
                    state[x] += state[x + 3] * deltaT;
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
}
