package particles.teaching.collection;

import static particles.teaching.collection.Pieces.implicit;
import static particles.teaching.collection.Pieces.plus;
import static particles.teaching.collection.Pieces.rungeKutta;
import static particles.teaching.collection.RightSolvers.DOPRI;
import static particles.teaching.collection.RightSolvers.DOPRI4;
import static particles.teaching.collection.RightSolvers.DOPRI5;
import static particles.teaching.collection.RightSolvers.RK4;
import static particles.teaching.collection.RightSolvers.RK4_WEIGHTS;
import static particles.teaching.collection.Specimen.wrong;
import static particles.teaching.solvers.PlantedSolvers.slope;
import static particles.teaching.solvers.PlantedSolvers.slopeAt;
import static particles.teaching.solvers.PlantedSolvers.state;

import deSolvers.DESolver;
import deSolvers.DEStateSource;
import java.util.Arrays;
import java.util.List;
import particles.teaching.collection.OthersRightSolvers.Bdf2;
import particles.teaching.collection.Pieces.Adaptive;
import particles.teaching.collection.RightSolvers.Adams;

/** Wrong solvers with one mistake each, chosen by somebody who had not seen the check. */
final class OthersWrongSolvers {

    private OthersWrongSolvers() {
    }

    static List<Specimen> all() {
        return List.of(
                wrong("RK4Mine", "weights of k3 and k4 swapped", "weight of k3", rungeKutta(RK4,
                        "1/6 1/3 1/6 1/3", "")),
                wrong("MidpointSolver", "clock at t", "gMid is evaluated at t;", rungeKutta("1/2", "0 1", "0 0")),
                wrong("Euler", "clock never moved", "never moves", (source, h)
                        -> source.setState(plus(state(source), h, slope(source)))),
                wrong("EulerTwo", "clock moved twice", "2 deltaT", (source, h) -> {
                    RightSolvers.euler(source, h);
                    source.incTime(h);
                }),
                wrong("HalfStep", "clock moved by half", "deltaT/2", (source, h) -> {
                    rungeKutta("1/2", "0 1", "").make(source, h);
                    source.incTime(-h / 2);
                }),
                wrong("Heun", "predicted state never set", "setState is missing", (source, h) -> {
                    double[] s = state(source);
                    double[] k1 = slope(source);
                    source.incTime(h);
                    source.setState(plus(plus(s, h / 2, k1), h / 2, slope(source)));
                }),
                wrong("RungeKutta", "tmp = s", "makes no copy", rungeKutta("1/2; 1/2 1/2; 1/2 1/2 1", "2/3 5/6 4/3 1/6",
                        "0 1/2 1/2 1")),
                wrong("SimpleEuler", "setState in the loop", "setState belongs behind the loop", (source, h) -> {
                    double[] s = state(source);
                    for (int i = 0; i < s.length; i++) {
                        s[i] += h * slope(source)[i];
                        source.setState(s);
                    }
                    source.incTime(h);
                }),
                wrong("TwoStep", "+ 1/2 of the old derivative", "weights of a step", () -> new Adams(2, 4, false) {
                    @Override
                    double[] weights(double[] all) {
                        return new double[] {1.5, 0.5};
                    }
                }),
                wrong("SymplecticEulerSolver", "is Euler", "old velocity", RightSolvers::euler),
                wrong("Yoshida4Solver", "two digits swapped", "new velocity is v .*the method says v \\+ 0.6756 a1",
                        (source, h) -> {
                    double w = 1.3152071919596783;
                    for (double part : new double[] {w, 1 - 2 * w, w}) {
                        OthersRightSolvers.closingKick(source, part * h, 1e-15);
                    }
                }),
                wrong("ImprovedEuler", "1 / 2 of whole numbers", "is 0 in Java", rungeKutta("1", "0 0", "")),
                wrong("MidpointMethod", "the step is taken from the middle", "go back to the start",
                        rungeKutta("1/2", "1/2 1", "")),
                wrong("FastRK4", "float", "float", OthersWrongSolvers::inFloat),
                wrong("AdamsBashforth2", "the old derivative is static", "static", Shared::new),
                wrong("VerletSolver", "acceleration kept", "kept from the step before", Kept::new),
                wrong("BackwardEuler", "Newton to 1e-3", "iteration ends too early", implicit(0, 1, 1, 1, 1e-1, 100)),
                wrong("ImplicitEuler", "one round of the iteration", "iteration for the new state ends too early",
                        rungeKutta("1", "0 1", "")),
                wrong("BackwardEulerSolver", "clock at t", "at the clock t;", implicit(0, 1, 1, 0, 1e-12, 100)),
                wrong("EulerLoop", "one entry left out", ": 23;", (source, h) -> {
                    double[] s = state(source);
                    double[] moved = plus(s, h, slope(source));
                    moved[s.length - 1] = s[s.length - 1];
                    source.setState(moved);
                    source.incTime(h);
                }),
                wrong("HeunForSprings", "arrays of 4", "array of 4", (source, h) -> {
                    double[] s = new double[4];
                    source.getState(s);
                    double[] k1 = new double[4];
                    source.getStateDerivative(k1);
                    source.setState(plus(s, h, k1));
                    source.incTime(h);
                    double[] k2 = new double[4];
                    source.getStateDerivative(k2);
                    source.setState(plus(plus(s, h / 2, k1), h / 2, k2));
                }),
                wrong("GameSolver", "0.01 for deltaT", "hard-coded", (source, h) -> {
                    double end = source.getTime() + h;
                    rungeKutta("1/2", "0 1", "0 0").make(source, 0.01);
                    source.incTime(end - source.getTime());
                }),
                wrong("AdaptiveRK", "last sub-step not cut", "last sub-step has to be cut", OthersWrongSolvers::uncut),
                wrong("BogackiShampine", "Math.abs(deltaT)", "sign of deltaT is lost", (source, h)
                        -> rungeKutta("1/2; 0 3/4", "2/9 1/3 4/9", "").make(source, Math.abs(h))),
                wrong("DormandPrince", "sign of the exponent", "endless loop", () -> new Adaptive(DOPRI, DOPRI5, DOPRI4,
                        1e-9, -5, true)),
                wrong("AB4", "begun with copies of the first derivative", "Begin with a method",
                        () -> new Adams(4, 1, false)),
                wrong("HeunsMethod", "is midpoint", "not Heun's method", rungeKutta("1/2", "0 1", "")),
                wrong("TenSubSteps", "an eleventh by rounding", "made once too often", (source, h) -> {
                    double end = source.getTime() + h;
                    for (double t = 0; Math.abs(t) < Math.abs(h); t += h / 10) {
                        rungeKutta("1/2", "0 1", "").make(source, h / 10);
                    }
                    source.incTime(end - source.getTime());
                }),
                wrong("RK4Solver", "k3 from k1", "k3 is evaluated at s \\+ k1/2", rungeKutta("1/2; 1/2 0; 0 0 1",
                        RK4_WEIGHTS, "")),
                wrong("RungeKutta4th", "k4 at t + deltaT/2", "k4 is evaluated at t \\+ deltaT/2",
                        rungeKutta(RK4, RK4_WEIGHTS, "0 1/2 1/2 1/2")),
                wrong("ClassicRK", "deltaT twice", "multiplied by deltaT twice", (source, h) -> {
                    double t = source.getTime();
                    double[] s = state(source);
                    double[] k = slope(source);
                    double[] sum = plus(s, h / 6, k);
                    for (double place : new double[] {0.5, 0.5, 1}) {
                        source.incTime(t + place * h - source.getTime());
                        k = slopeAt(source, plus(s, place * h * h, k));
                        sum = plus(sum, h * (place == 1 ? 1.0 / 6 : 1.0 / 3), k);
                    }
                    source.setState(sum);
                }),
                wrong("LeapfrogSolver", "old acceleration in the second kick", "at the new position is missing",
                        (source, h) -> {
                    double[] s = state(source);
                    double[] a = slope(source);
                    for (int i = 0; i < s.length; i += i % 6 == 2 ? 4 : 1) {
                        s[i + 3] += h / 2 * a[i + 3];
                        s[i] += h * s[i + 3];
                        s[i + 3] += h / 2 * a[i + 3];
                    }
                    source.setState(s);
                    source.incTime(h);
                }),
                wrong("SemiImplicit", "all positions, then all velocities", "\\(x1, v1, x2, v2", (source, h) -> {
                    double[] s = state(source);
                    double[] f = slope(source);
                    int half = s.length / 2;
                    for (int i = 0; i < half; i++) {
                        s[half + i] += h * f[half + i];
                        s[i] += h * s[half + i];
                    }
                    source.setState(s);
                    source.incTime(h);
                }),
                wrong("Trapezoid", "both at t + deltaT", "at the start of the step is taken at the clock t \\+ deltaT",
                        (source, h) -> {
                    source.incTime(h);
                    implicit(0.5, 0.5, 1, 0, 1e-12, 50).make(source, h);
                    source.incTime(-h);
                }),
                wrong("Bdf2Solver", "2/3 missing", "formula of order 2", () -> new Bdf2(1)),
                wrong("Ros2", "sign of the Jacobian", "signs in the matrix", (source, h)
                        -> OthersRightSolvers.ros2(source, h, -1)),
                wrong("VelocityVerletSolver", "half missing", "half is missing", (source, h) -> {
                    double[] s = state(source);
                    double[] a = slope(source);
                    for (int i = 0; i < s.length; i += i % 6 == 2 ? 4 : 1) {
                        s[i] += h * s[i + 3] + h * h * a[i + 3];
                    }
                    source.incTime(h);
                    double[] end = slopeAt(source, s);
                    for (int i = 3; i < s.length; i += i % 6 == 5 ? 4 : 1) {
                        s[i] += h / 2 * (a[i] + end[i]);
                    }
                    source.setState(s);
                }),
                wrong("DoPri5", "two digits swapped", "k5 is evaluated at", rungeKutta(DOPRI.replace("19372", "19327"),
                        DOPRI5, "0 1/5 3/10 4/5 8/9 1 1")),
                wrong("SolverA", "size cached", "size is cached", Cached::new),
                wrong("Multistep", "goes on when deltaT changes", "deltaT changes", () -> new Adams(3, 4, false) {
                    @Override
                    boolean goesOn(DEStateSource source, double deltaT) {
                        return goesOnWithAnyDeltaT(source);
                    }
                }));
    }

    private static void inFloat(DEStateSource source, double h) {
        double[] s = rounded(state(source));
        double[] k1 = rounded(slope(source));
        source.incTime(h / 2);
        double[] k2 = rounded(slopeAt(source, plus(s, h / 2, k1)));
        double[] k3 = rounded(slopeAt(source, plus(s, h / 2, k2)));
        source.incTime(h / 2);
        double[] k4 = rounded(slopeAt(source, plus(s, h, k3)));
        source.setState(plus(plus(plus(plus(s, h / 6, k1), h / 3, k2), h / 3, k3), h / 6, k4));
    }

    private static double[] rounded(double[] x) {
        return Arrays.stream(x).map(number -> (float) number).toArray();
    }

    /** Step doubling that goes on until it is past the end. */
    private static void uncut(DEStateSource source, double deltaT) {
        double start = source.getTime();
        double[] s = state(source);
        double done = 0;
        double h = deltaT;
        while (Math.signum(deltaT) * (deltaT - done) > 0) {
            double[] one = rk4(source, s, start + done, h);
            double[] two = rk4(source, rk4(source, s, start + done, h / 2), start + done + h / 2, h / 2);
            double error = Pieces.norm(plus(one, -1, two));
            if (Double.isNaN(error)) {
                throw new IllegalStateException("no step is small enough");
            }
            if (error <= 1e-8) {
                s = two;
                done += h;
            }
            h *= Math.min(4, Math.max(0.2, 0.9 * Math.pow(1e-8 / Math.max(error, 1e-300), 0.2)));
        }
        source.setState(s);
        source.incTime(start + done - source.getTime());
    }

    private static double[] rk4(DEStateSource source, double[] s, double t, double h) {
        source.setState(s);
        source.incTime(t - source.getTime());
        rungeKutta(RK4, RK4_WEIGHTS, "").make(source, h);
        return state(source);
    }

    /** Adams-Bashforth 2 that begins by Heun; one field is static. */
    private static final class Shared extends DESolver {
        private static double[] previous = {};
        private DEStateSource last;
        private double time;
        private double length;
        private double[] left = {};

        @Override
        public void stepState(DEStateSource source, double h) {
            double[] s = state(source);
            double[] f = slope(source);
            if (source == last && source.getTime() == time && h == length && Arrays.equals(s, left)) {
                left = plus(plus(s, 1.5 * h, f), -0.5 * h, previous);
                source.incTime(h);
            } else {
                source.incTime(h);
                left = plus(plus(s, h / 2, f), h / 2, slopeAt(source, plus(s, h, f)));
            }
            source.setState(left);
            previous = f;
            last = source;
            time = source.getTime();
            length = h;
        }

        @Override
        public void reset() {
            last = null;
        }
    }

    /** Leapfrog that takes the acceleration of its last step while the source is the same object. */
    private static final class Kept extends DESolver {
        private DEStateSource last;
        private double[] a = {};

        @Override
        public void stepState(DEStateSource source, double h) {
            double[] s = state(source);
            a = source == last ? a : slope(source);
            last = source;
            for (int i = 0; i < s.length; i += i % 6 == 2 ? 4 : 1) {
                s[i + 3] += h / 2 * a[i + 3];
                s[i] += h * s[i + 3];
            }
            source.incTime(h);
            a = slopeAt(source, s);
            for (int i = 3; i < s.length; i += i % 6 == 5 ? 4 : 1) {
                s[i] += h / 2 * a[i];
            }
            source.setState(s);
        }

        @Override
        public void reset() {
            last = null;
        }
    }

    /** Midpoint with arrays of the first source's length. */
    private static final class Cached extends DESolver {
        private double[] s;
        private double[] k;

        @Override
        public void stepState(DEStateSource source, double h) {
            if (s == null) {
                s = new double[source.getStateSize()];
                k = new double[s.length];
            }
            source.getState(s);
            source.getStateDerivative(k);
            source.setState(plus(s, h / 2, k));
            source.incTime(h / 2);
            source.getStateDerivative(k);
            source.setState(plus(s, h, k));
            source.incTime(h / 2);
        }
    }
}
