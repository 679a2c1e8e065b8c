package particles.teaching.collection;

import static particles.teaching.collection.Pieces.implicit;
import static particles.teaching.collection.Pieces.iterated;
import static particles.teaching.collection.Pieces.leapfrog;
import static particles.teaching.collection.Pieces.plus;
import static particles.teaching.collection.Pieces.rungeKutta;
import static particles.teaching.collection.RightSolvers.RK4;
import static particles.teaching.collection.RightSolvers.RK4_WEIGHTS;
import static particles.teaching.collection.RightSolvers.euler;
import static particles.teaching.collection.Specimen.wrong;
import static particles.teaching.solvers.PlantedSolvers.slope;
import static particles.teaching.solvers.PlantedSolvers.slopeAt;
import static particles.teaching.solvers.PlantedSolvers.state;

import deSolvers.DESolver;
import deSolvers.DEStateSource;
import java.util.Arrays;
import java.util.List;
import java.util.Random;
import particles.teaching.collection.RightSolvers.Adams;
import particles.teaching.solvers.PlantedSolvers;
import particles.teaching.solvers.PlantedSolvers.Step;

/** Wrong solvers whose formula is right: clocks, state, memory, iterations and arrays. */
final class WrongHabits {
    private static final Step RIGHT = rungeKutta(RK4, RK4_WEIGHTS, "");

    private WrongHabits() {
    }

    static List<Specimen> all() {
        Random random = new Random(4);
        double[][] arrays = {new double[64], new double[64]};
        double[][] many = {new double[600], new double[600]};
        return List.of(
                wrong("EulerSolver", "clock never moved", "never moves", still(RightSolvers::euler)),
                wrong("RK4Solver", "clock never moved", "never moves", still(RIGHT)),
                wrong("EulerSolver", "clock moved twice", "2 deltaT", after(RightSolvers::euler, (source, h)
                -> source.incTime(h))),
                wrong("EulerSolver", "clock moved by 0.01", "hard-coded", after(still(RightSolvers::euler),
                        (source, h) -> source.incTime(0.01))),
                wrong("EulerSolver", "clock moved to the new time", "how far the clock moves",
                        after(still(RightSolvers::euler),
                        (source, h) -> source.incTime(source.getTime() + h))),
                wrong("RK4Solver", "clock in float", "clock", after(still(RIGHT), (source, h)
                        -> source.incTime((float) h))),
                wrong("Euler", "clock 1e-9 too far", "1\\.000000001|0\\.[0-9]*00001|2\\.5e-10|1e-9",
                        after(still(RightSolvers::euler), (source, h) -> source.incTime(h * (1 + 1e-9)))),
                wrong("MidpointSolver", "clock half a step late", "3/2 deltaT", after(rungeKutta("1/2", "0 1", ""),
                        (source, h) -> source.incTime(h / 2))),
                wrong("EulerSolver", "never sets the state", "setState", (source, h) -> {
                    slope(source);
                    source.incTime(h);
                }),
                wrong("RK4Solver", "left at the last trial state", "setState|trial", (source, h) -> {
                    double[] s = state(source);
                    double[] k1 = slope(source);
                    source.incTime(h / 2);
                    slopeAt(source, plus(s, h / 2, k1));
                    source.incTime(h / 2);
                }),
                wrong("MidpointSolver", "setState forgotten before gMid", "setState is missing", (source, h) -> {
                    double[] s = state(source);
                    slope(source);
                    source.incTime(h / 2);
                    source.setState(plus(s, h, slope(source)));
                    source.incTime(h / 2);
                }),
                wrong("EulerSolver", "the old state is lost", "old state is lost", (source, h) -> {
                    double[] f = slope(source);
                    source.setState(plus(new double[f.length], h, f));
                    source.incTime(h);
                }),
                wrong("MidpointSolver", "from the trial state", "go back to the start", (source, h) -> {
                    double[] s = state(source);
                    double[] trial = plus(s, h / 2, slope(source));
                    source.incTime(h / 2);
                    source.setState(plus(trial, h, slopeAt(source, trial)));
                    source.incTime(h / 2);
                }),
                wrong("EulerSolver", "loop ends too early", ": 23;|loop", (source, h) -> {
                    double[] s = state(source);
                    double[] f = slope(source);
                    for (int i = 0; i < s.length - 1; i++) {
                        s[i] += h * f[i];
                    }
                    source.setState(s);
                    source.incTime(h);
                }),
                wrong("EulerSolver", "positions only", "entr|loop|stay", (source, h) -> {
                    double[] s = state(source);
                    double[] f = slope(source);
                    for (int i = 0; i < s.length; i++) {
                        s[i] += i % 6 < 3 ? h * f[i] : 0;
                    }
                    source.setState(s);
                    source.incTime(h);
                }),
                wrong("EulerSolver", "float", "float|digits", (source, h) -> {
                    double[] s = state(source);
                    double[] f = slope(source);
                    for (int i = 0; i < s.length; i++) {
                        s[i] = (float) (s[i] + h * f[i]);
                    }
                    source.setState(s);
                    source.incTime(h);
                }),
                wrong("EulerSolver", "derivative cut off", "cut off", PlantedSolvers.euler((f, h) -> h * Math.max(-5,
                        Math.min(5, f)))),
                wrong("EulerSolver", "random", "random|static", (source, h) -> euler(source, h * (1 + 0.01
                        * random.nextDouble()))),
                wrong("EulerSolver", "NaN", "NaN", PlantedSolvers.euler((f, h) -> Math.sqrt(-1 - f * f))),
                wrong("EulerSolver", "array of fixed size", "array of 12", (source, h) -> {
                    double[] s = new double[12];
                    source.getState(s);
                    double[] f = new double[12];
                    source.getStateDerivative(f);
                    source.setState(plus(s, h, f));
                    source.incTime(h);
                }),
                wrong("EulerSolver", "static arrays of 64", "200 particles|64|size", (source, h) -> fixed(source, h,
                arrays)),
                wrong("EulerSolver", "static arrays of 600", "200 particles|600|size", (source, h) -> fixed(source, h,
                many)),
                wrong("EulerSolver", "size cached", "size is cached", PlantedSolvers.CachedSize::new),
                wrong("EulerSolver", "state kept", "array is kept|getState", PlantedSolvers.KeptArray::new),
                wrong("EulerSolver", "derivative asked once", "stale|first step only",
                PlantedSolvers.StaleDerivative::new),
                wrong("HeunSolver", "derivative of the step before", "derivative", KeptSlope::new),
                wrong("VerletSolver", "acceleration kept without a test", "kept|derivative", KeptAcceleration::new),
                wrong("AdamsBashforth2", "never begins again", "FORGET|set from outside|earlier steps",
                        PlantedSolvers.AdamsBashforth2::new),
                wrong("AdamsBashforth4Solver", "never begins again", "set from outside|earlier steps", ()
                        -> forgetful(4, 4)),
                wrong("AB3", "begins again only at reset()", "set from outside|earlier steps", () -> forgetful(3, 4)),
                wrong("AdamsBashforth4", "Euler at first", "begin|first steps|start", () -> new Adams(4, 1, false)),
                wrong("AdamsBashforth3", "Euler at first", "begin|first steps|start", () -> new Adams(3, 1, false)),
                wrong("AdamsMoulton", "Euler at first", "begin|first steps|start", () -> new Adams(4, 1, true)),
                wrong("AdamsBashforth2", "weights the wrong way round", "weight", () -> weighted(2, -0.5, 1.5)),
                wrong("AdamsBashforth2", "sum of the weights is 2", "weight", () -> weighted(2, 1.5, 0.5)),
                wrong("AdamsBashforth3", "a wrong weight", "weight", () -> weighted(3, 23.0 / 12, -16.0 / 12,
                4.0 / 12)),
                wrong("BackwardEulerSolver", "clock at t", "clock|at t", implicit(0, 1, 1, 0, 1e-10, 50)),
                wrong("ImplicitMidpointSolver", "clock at t + deltaT", "clock|t \\+ deltaT", implicit(0, 1, 0.5, 1,
                1e-10, 50)),
                wrong("ImplicitMidpoint", "clock at t", "clock|at t", implicit(0, 1, 0.5, 0, 1e-10, 50)),
                wrong("TrapezoidSolver", "clock at t", "clock|at t", implicit(0.5, 0.5, 1, 0, 1e-10, 50)),
                wrong("TrapezoidalSolver", "weights 1/2 and 1", "order|weight|error does not", implicit(0.5, 1, 1, 1,
                1e-10, 50)),
                wrong("BackwardEulerSolver", "tolerance of 1e-2", "iteration|equation|converge",
                        iterated(0, 1, 1, 1, 1e-2, 50)),
                wrong("ImplicitMidpointSolver", "one iteration", "iteration|equation|converge",
                        iterated(0, 1, 0.5, 0.5, 1e-2, 1)),
                wrong("CrankNicolson", "Newton with a tolerance of 0.3", "iteration|equation|converge",
                        implicit(0.5, 0.5, 1, 1, 0.3, 50)),
                wrong("BackwardEuler", "is implicit midpoint", "midpoint|order", implicit(0, 1, 0.5, 0.5, 1e-10, 50)),
                wrong("DeltaTOfFirst", "deltaT of the first call", "deltaT", FirstDeltaT::new),
                wrong("EulerSolver", "two steps", "two Euler steps|2 deltaT", (source, h) -> {
                    euler(source, h);
                    euler(source, h);
                }),
                wrong("LeapfrogSolver", "all positions, then all velocities", "\\(x1, v1, x2, v2|in turn|loop|Euler",
                (source, h) -> {
                    double[] s = state(source);
                    double[] f = slope(source);
                    int half = s.length / 2;
                    for (int i = 0; i < half; i++) {
                        s[i + half] += h * f[i + half];
                        s[i] += h * s[i + half];
                    }
                    source.setState(s);
                    source.incTime(h);
                }),
                wrong("EulerSolver", "endless for negative steps is silent", "negative|backward|sign", (source, h) -> {
                    if (h > 0) {
                        euler(source, h);
                    }
                }),
                wrong("VerletSolver", "clock at t at the closing kick", "evaluated at t[; ]|clock", (source, h) -> {
                    leapfrog(new StoppedClock(source), h);
                    source.incTime(h);
                }),
                wrong("EulerSolver", "exception", "exception", (source, h) -> state(source)[source.getStateSize()]++));
    }

    private static void fixed(DEStateSource source, double h, double[][] arrays) {
        int n = source.getStateSize();
        double[] s = state(source);
        double[] f = slope(source);
        for (int i = 0; i < n; i++) {
            arrays[0][i] = s[i];
            arrays[1][i] = f[i];
        }
        double[] next = new double[n];
        for (int i = 0; i < n; i++) {
            next[i] = arrays[0][i] + h * arrays[1][i];
        }
        source.setState(next);
        source.incTime(h);
    }

    private static Step still(Step step) {
        return (source, h) -> step.make(new StoppedClock(source), h);
    }

    private static Step after(Step step, Step more) {
        return (source, h) -> {
            step.make(source, h);
            more.make(source, h);
        };
    }

    private static DESolver forgetful(int steps, int begins) {
        return new Adams(steps, begins, false) {
            private boolean begun;

            @Override
            boolean goesOn(DEStateSource source, double deltaT) {
                boolean before = begun;
                begun = true;
                return before;
            }

            @Override
            public void reset() {
                begun = false;
            }
        };
    }

    private static DESolver weighted(int steps, double... weights) {
        return new Adams(steps, 4, false) {
            @Override
            double[] weights(double[] all) {
                return weights;
            }
        };
    }

    /** A source whose clock shows what it should and stays. */
    private record StoppedClock(DEStateSource source) implements DEStateSource {
        @Override
        public int getStateSize() {
            return source.getStateSize();
        }

        @Override
        public void getState(double[] state) {
            source.getState(state);
        }

        @Override
        public void setState(double[] state) {
            source.setState(state);
        }

        @Override
        public void getStateDerivative(double[] dSdt) {
            source.getStateDerivative(dSdt);
        }

        @Override
        public double getTime() {
            return source.getTime();
        }

        @Override
        public void incTime(double deltaT) {        // the mistake
        }
    }

    private static final class KeptSlope extends DESolver {
        private double[] kept = {};

        @Override
        public void stepState(DEStateSource source, double h) {
            double[] s = state(source);
            double[] k1 = kept.length == s.length ? kept : slope(source);
            source.incTime(h);
            double[] k2 = slopeAt(source, plus(s, h, k1));
            double[] next = plus(plus(s, h / 2, k1), h / 2, k2);
            kept = slopeAt(source, next);
        }
    }

    private static final class KeptAcceleration extends DESolver {
        private double[] a = {};

        @Override
        public void stepState(DEStateSource source, double h) {
            double[] s = state(source);
            if (a.length != s.length) {
                a = slope(source);
            }
            for (int i = 0; i < s.length; i += i % 6 == 2 ? 4 : 1) {
                s[i] += h * s[i + 3] + h * h / 2 * a[i + 3];
            }
            source.incTime(h);
            double[] now = slopeAt(source, s);
            for (int i = 3; i < s.length; i += i % 6 == 5 ? 4 : 1) {
                s[i] += h / 2 * (a[i] + now[i]);
            }
            source.setState(s);
            a = now;
        }
    }

    private static final class FirstDeltaT extends DESolver {
        private double h;

        @Override
        public void stepState(DEStateSource source, double deltaT) {
            h = h == 0 ? deltaT : h;
            double[] s = Arrays.copyOf(state(source), source.getStateSize());
            source.setState(plus(s, h, slope(source)));
            source.incTime(deltaT);
        }
    }
}
