package particles.teaching.collection;

import static particles.teaching.collection.Methods.drift;
import static particles.teaching.collection.Methods.kick;
import static particles.teaching.collection.Methods.plus;
import static particles.teaching.collection.Specimen.right;
import static particles.teaching.collection.Specimen.wrong;
import static particles.teaching.solvers.PlantedSolvers.slope;
import static particles.teaching.solvers.PlantedSolvers.slopeAt;
import static particles.teaching.solvers.PlantedSolvers.state;

import deSolvers.DESolver;
import deSolvers.DEStateSource;
import deSolvers.FixedStepSolver;
import deSolvers.SecondOrderStateSource;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Random;
import java.util.function.DoubleBinaryOperator;
import java.util.function.ToDoubleFunction;
import particles.teaching.solvers.PlantedSolvers;
import particles.teaching.solvers.PlantedSolvers.Step;

/** Right and wrong solvers that no table makes: their arrays, loops, fields and habits. */
final class HandwrittenSolvers {
    private static final double W = 1 / (2 - Math.cbrt(2));

    private static final String KEPT = "^state: deltaT changes from one step to the next, and the step is not the one"
            + " that a new solver makes with it: deltaT of an earlier step is kept";

    private static final String ONE_BY_ONE = "^state: with a source of 7 numbers, stepState ends in .*: go through the"
            + " entries one by one, to source.getStateSize";

    private HandwrittenSolvers() {
    }

    static List<Specimen> allRight() {
        return List.of(
                right("Solver1", "Euler in plain loops", HandwrittenSolvers::euler),
                right("HeunSolver", "on FixedStepSolver", () -> new HeunOnFixedStep(0.5)),
                right("StepDoubling", "midpoint against two half steps", stepDoubling(Methods.rungeKutta(
                        new double[][] {{}, {0.5}}, new double[] {0, 1}, new double[0], (stage, old, next) -> next),
                        1e-7)),
                right("AdaptiveStrang", "not symmetric", stepDoubling(Methods.turns(new double[] {0, 1, 0},
                        new double[] {0.5, 0.5}), 1e-5)),
                right("Mine", "Strang splitting of the entries", PlantedSolvers::splitting),
                right("Mine", "Strang splitting of even and odd entries", PlantedSolvers::evenAndOdd),
                right("TaylorTwo", "second derivative by a difference", HandwrittenSolvers::taylor),
                right("RosenbrockEuler", "one Newton step", rosenbrock(1)),
                right("Rosenbrock", "ROS2", (source, h) -> ros2(source, h, 1)),
                right("FsalSolver", "Bogacki-Shampine that keeps a derivative", () -> new Fsal("")),
                right("Leapfrog", "refuses other sources", (source, h) -> {
                    if (!(source instanceof SecondOrderStateSource)) {
                        throw new UnsupportedOperationException("positions and velocities are needed");
                    }
                    closingKick(source, h);
                }),
                right("SemiImplicitEuler", "a cast that may fail", (source, h) -> {
                    ((SecondOrderStateSource) source).getDimension();
                    Methods.turns(new double[] {1, 0}, new double[] {1}).make(source, h);
                }),
                right("VelocityVerlet", "force at the predicted velocity", HandwrittenSolvers::predicted),
                right("Yoshida", "three leapfrogs, iterated", (source, h) -> {
                    for (double w : new double[] {W, 1 - 2 * W, W}) {
                        closingKick(source, w * h);
                    }
                }),
                right("R48ImplicitEulerFixedPoint", "refuses long steps", (source, h) -> fixedPoint(source, h,
                        Methods::norm)));
    }

    static List<Specimen> allWrong() {
        Random random = new Random(4);
        double[] array = new double[600];
        int[] entries = {0};
        return List.of(
                increment("deltaT ignored",
                        "^method: the new state is s . 5 k1, which does not follow deltaT: deltaT is"
                        + " ignored", (f, h) -> f),
                increment("deltaT hard-coded",
                        "^method: the new state is s . k1/20, which does not follow deltaT: a time step"
                        + " of 0.01000 s is hard-coded, and deltaT is ignored", (f, h) -> 0.01 * f),
                increment("deltaT squared", "multiplied by deltaT twice", (f, h) -> h * h * f),
                increment("divided by deltaT",
                        "^method: the new state is s . 25 k1, which does not follow deltaT: the"
                        + " derivative is divided by deltaT; it has to be multiplied by deltaT", (f, h) -> f / h),
                increment("|deltaT|", "sign of deltaT", (f, h) -> Math.abs(h) * f),
                increment("no increment", "no derivative is in it", (f, h) -> 0 * f),
                increment("derivative rounded", "^state: digits get lost", (f, h) -> h * Math.round(f * 1000) / 1000.0),
                increment("small ones forgotten", "numbers up to 0.0001000", (f, h) -> Math.abs(f) < 1e-3 ? 0 : h * f),
                increment("deltaT in float", "float arithmetic", (f, h) -> (float) h * f),
                increment("derivative cut off",
                        "^method: with numbers up to 1000 the step is not the one that it makes"
                        + " with numbers up to 1: something is cut off", (f, h) -> h * Math.max(-5, Math.min(5, f))),
                increment("random",
                        "^method: two new solvers make different steps from the same place: something is random,"
                        + " or static", (f, h) -> h * f * (1 + 0.01 * random.nextDouble())),
                increment("half steps after forty entries",
                        "^method: two new solvers make different steps from the same place", (f, h) ->
                        ++entries[0] > 40 ? h / 2 * f : h * f),
                increment("gravity of its own", "something is added", (f, h) -> h * (f - 9.81)),
                increment("NaN taken for 0", "the new state has no NaN", (f, h) -> Double.isNaN(f) ? 0 : h * f),
                wrong("Mine", "clock stays with the state", "where state and derivative are 0, the clock ends at t",
                        (source, h) -> {
                            double[] s = state(source);
                            euler(source, h);
                            source.incTime(Arrays.equals(s, state(source)) ? -h : 0);
                        }),
                wrong("Mine", "clock put back", "^time: the clock ends at t after", (source, h) -> {
                    euler(source, h);
                    source.incTime(-h);
                }),
                increment("NaN", "^state: the new state is NaN", (f, h) -> Math.sqrt(-1 - f * f)),
                wrong("HeunSolver", "1/2 of whole numbers", "no derivative is in it.*1/2 is 0", () ->
                        new HeunOnFixedStep(0)),
                wrong("Mine", "stops when the first entry is still", "has to reach all entries", (source, h) ->
                        fixedPoint(source, h, change -> Math.abs(change[0]))),
                wrong("Mine", "sub-steps of 0.001 s, and the rest is lost", "leaves the state where it was",
                        (source, h) -> {
                    double end = source.getTime() + h;
                    for (int k = (int) (Math.abs(h) / 0.001); k > 0; k--) {
                        euler(source, Math.copySign(0.001, h));
                    }
                    Methods.clock(source, end);
                }),
                wrong("ClassicRK", "deltaT twice", "multiplied by deltaT twice", (source, h) -> {
                    double[] s = state(source);
                    double[] k1 = slope(source);
                    source.incTime(h / 2);
                    double[] k2 = slopeAt(source, plus(s, h * h / 2, k1));
                    source.setState(plus(s, h, k2));
                    source.incTime(h / 2);
                }),
                wrong("W107HeunSolver", "brackets missing", "brackets missing", (source, h) -> {
                    double[] s = state(source);
                    double[] k1 = slope(source);
                    source.incTime(h);
                    source.setState(plus(plus(s, h, k1), 0.5, slopeAt(source, plus(s, h, k1))));
                }),
                wrong("W141LeapfrogKDK", "last coordinate gets no kick", ": 5, 11, 17.*loop", (source, h) -> {
                    double[] s = state(source);
                    kickTwo(source, s, h / 2);
                    drift(source, s, h);
                    kickTwo(source, s, h / 2);
                }),
                wrong("LeapfrogSolver", "all positions, then all velocities", "\\(x1, v1, x2, v2",
                        HandwrittenSolvers::halves),
                wrong("Mine", "three coordinates", "on a line, 10 numbers, stepState ends in .*getDimension", () ->
                        PlantedSolvers.blocks()),
                wrong("EulerSolver", "entries in pairs", ONE_BY_ONE, (source, h) -> blocks(source, h, 2, false)),
                wrong("EulerSolver", "blocks of six", ONE_BY_ONE, (source, h) -> blocks(source, h, 6, false)),
                wrong("EulerSolver", "whole blocks only", "7 numbers, entry 6 of .* alike: go through", (source, h)
                        -> blocks(source, h, 3, true)),
                wrong("Mine", "velocity of the particle before", "entry 6 of the new state changes with entry 3",
                        HandwrittenSolvers::neighbour),
                wrong("Mine", "the time for deltaT", "length is the time, source.getTime.., and", (source, h) -> {
                    source.setState(plus(state(source), source.getTime(), slope(source)));
                    source.incTime(h);
                }),
                wrong("Mine", "old velocity, for particles only", "updated with the old velocity", (source, h) -> {
                    if (!(source instanceof SecondOrderStateSource)) {
                        throw new IllegalArgumentException("particles are needed");
                    }
                    euler(source, h);
                }),
                wrong("SimpleEuler", "setState in the loop", "setState belongs behind the loop", (source, h) -> {
                    double[] s = state(source);
                    for (int i = 0; i < s.length; i++) {
                        s[i] += h * slope(source)[i];
                        source.setState(s);
                    }
                    source.incTime(h);
                }),
                wrong("EulerSolver", "array of fixed size", "array of 12", (source, h) -> {
                    double[] s = new double[12];
                    source.getState(s);
                    double[] f = new double[12];
                    source.getStateDerivative(f);
                    source.setState(plus(s, h, f));
                    source.incTime(h);
                }),
                wrong("EulerSolver", "a static array of 600", "200 particles", (source, h) -> {
                    double[] s = state(source);
                    System.arraycopy(s, 0, array, 0, s.length);
                    source.setState(plus(Arrays.copyOf(array, s.length), h, slope(source)));
                    source.incTime(h);
                }),
                wrong("EulerSolver", "size cached",
                        "^state: the solver stepped a source of 18 numbers and then one of 36, and"
                        + ".*size is cached", PlantedSolvers.CachedSize::new),
                wrong("EulerSolver", "state kept",
                        "^state: the state was set from outside, as a collision does, and the step"
                        + " afterwards does not start there: an array is kept", PlantedSolvers.KeptArray::new),
                wrong("EulerSolver", "derivative asked once",
                        "^state: the derivative is stale: getStateDerivative is called in the"
                        + " first step only",
                        PlantedSolvers.StaleDerivative::new),
                wrong("AdamsBashforth2", "never begins again",
                        "^state: the state was set from outside, as a collision does, and the"
                        + " step afterwards still uses the steps before it",
                        PlantedSolvers.AdamsBashforth2::new),
                wrong("BogackiShampine", "derivative of the step before", "derivative|kept", () -> new Fsal("always")),
                wrong("VerletSolver", "acceleration kept without a test", "kept|derivative", KeptAcceleration::new),
                wrong("Mine", "deltaT of the first call", KEPT, () -> new OtherDeltaT(true)),
                wrong("Mine", "deltaT of the call before", KEPT, () -> new OtherDeltaT(false)),
                wrong("W75EulerSolver", "first source kept", "first one is still used, which is kept",
                        FirstSource::new),
                wrong("EulerSolver", "exception", "^failure: stepState ends in an exception: java.lang."
                        + "ArrayIndexOutOfBoundsException: Index 12 out of bounds for length 12, in ",
                        (source, h) -> state(source)[source.getStateSize()]++),
                wrong("W98BackwardEuler", "sign of the Jacobian", "signs in the matrix", rosenbrock(-1)),
                wrong("Mine", "30 deltaT in the matrix", "signs in the matrix", rosenbrock(30)),
                wrong("RosenbrockEuler", "a matrix for 12 numbers", "fixed length", (source, h) -> {
                    double[] next = plus(state(source), h, slope(source));
                    rosenbrock(1).make(source, h);
                    System.arraycopy(state(source), 0, next, 0, Math.min(12, next.length));
                    source.setState(next);
                }),
                wrong("Mine", "the first matrix is kept", "something is kept from the step", () -> {
                    List<double[][]> kept = new ArrayList<>();
                    return PlantedSolvers.solver((source, h) -> {
                        double[] s = state(source);
                        double[] f = slope(source);
                        kept.add(matrix(source, s, f, h));
                        source.setState(plus(s, h, Methods.solve(kept.get(0), f)));
                        source.incTime(h);
                    });
                }),
                wrong("Mine", "the first direction is kept", "^state: after steps forward", () -> {
                    double[] kept = {0};
                    return PlantedSolvers.euler((f, h) -> f * Math.abs(h) * (kept[0] = kept[0] == 0 ? Math.signum(h)
                            : kept[0]));
                }),
                wrong("CrankNicolson", "I - deltaT J", "^method: a matrix solves a linear law in one go",
                        rosenbrock(1)),
                wrong("Leapfrog", "three closing kicks with drag", "^method: where the acceleration depends",
                        HandwrittenSolvers::closingKicks),
                wrong("Mine", "three closing kicks, adaptive", "^method: where the acceleration depends", stepDoubling(
                        HandwrittenSolvers::closingKicks, 1e-6)),
                wrong("Ros2", "sign of the Jacobian", "signs in the matrix", (source, h) -> ros2(source, h, -1)));
    }

    private static Specimen increment(String about, String cause, DoubleBinaryOperator increment) {
        return wrong("EulerSolver", about, cause, () -> PlantedSolvers.euler(increment));
    }

    static void euler(DEStateSource source, double deltaT) {
        int n = source.getStateSize();
        double[] state = new double[n];
        double[] dSdt = new double[n];
        source.getState(state);
        source.getStateDerivative(dSdt);
        for (int i = 0; i < n; i++) {
            state[i] += deltaT * dSdt[i];
        }
        source.setState(state);
        source.incTime(deltaT);
    }

    /** The Euler method, whose loops go from block to block. */
    private static void blocks(DEStateSource source, double h, int size, boolean whole) {
        double[] s = state(source);
        double[] f = slope(source);
        for (int i = 0; i < s.length - (whole ? size - 1 : 0); i += size) {
            for (int j = i; j < i + size; j++) {
                s[j] += h * f[j];
            }
        }
        source.setState(s);
        source.incTime(h);
    }

    private static Step stepDoubling(Step step, double tolerance) {
        return (source, deltaT) -> {
            double end = source.getTime() + deltaT;
            double h = deltaT;
            while ((end - source.getTime()) * deltaT > 0) {
                double t = source.getTime();
                h = Math.abs(h) > Math.abs(end - t) ? end - t : h;
                double[] s = state(source);
                step.make(source, h);
                double[] once = state(source);
                source.setState(s);
                Methods.clock(source, t);
                step.make(source, h / 2);
                step.make(source, h / 2);
                double error = Methods.norm(plus(state(source), -1, once));
                if (Double.isNaN(error)) {
                    throw new IllegalStateException("the state is NaN");
                }
                if (error > tolerance) {
                    source.setState(s);
                    Methods.clock(source, t);
                    h /= 2;
                } else {
                    Methods.clock(source, h == end - t ? end : t + h);
                    h *= 1.5;
                }
            }
        };
    }

    private static void taylor(DEStateSource source, double h) {
        double e = 1e-5;
        double t = source.getTime();
        double[] s = state(source);
        double[] f = slope(source);
        source.incTime(e);
        double[] ahead = slopeAt(source, plus(s, e, f));
        Methods.clock(source, t - e);
        double[] second = plus(ahead, -1, slopeAt(source, plus(s, -e, f)));
        source.setState(plus(plus(s, h, f), h * h / 2 / (2 * e), second));
        Methods.clock(source, t + h);
    }

    private static double[][] matrix(DEStateSource source, double[] s, double[] f, double factor) {
        double[][] m = Methods.jacobian(at -> slopeAt(source, at), s, f);
        for (int i = 0; i < s.length; i++) {
            for (int j = 0; j < s.length; j++) {
                m[i][j] = (i == j ? 1 : 0) - factor * m[i][j];
            }
        }
        return m;
    }

    private static Step rosenbrock(double sign) {
        return (source, h) -> {
            double[] s = state(source);
            double[] f = slope(source);
            source.setState(plus(s, h, Methods.solve(matrix(source, s, f, sign * h), f)));
            source.incTime(h);
        };
    }

    /** Verwer's ROS2: (I - g h J) k1 = f + g h f_t, (I - g h J) k2 = f(end) - 2 k1 - g h f_t. */
    private static void ros2(DEStateSource source, double h, double sign) {
        double g = 1 + 1 / Math.sqrt(2);
        double t = source.getTime();
        double[] s = state(source);
        double[] f = slope(source);
        double[][] w = matrix(source, s, f, sign * g * h);
        double dt = 1e-4 * h;
        source.incTime(dt);
        double[] ft = dt == 0 ? new double[s.length] : plus(new double[s.length], 1 / dt, plus(slopeAt(source, s), -1,
                f));
        double[] k1 = Methods.solve(w, plus(f, g * h, ft));
        Methods.clock(source, t + h);
        double[] k2 = Methods.solve(w, plus(plus(slopeAt(source, plus(s, h, k1)), -2, k1), -g * h, ft));
        source.setState(plus(plus(s, 1.5 * h, k1), 0.5 * h, k2));
    }

    /** Kick, drift, and a kick that is repeated until the velocity stands still, for the sake of drag. */
    private static void closingKick(DEStateSource source, double h) {
        double[] s = state(source);
        kick(source, s, h / 2);
        drift(source, s, h);
        double[] half = s.clone();
        double change = 1;
        for (int round = 0; round < 100 && change > 1e-14; round++) {
            double[] before = s;
            s = half.clone();
            kick(source, s, h / 2);
            change = Methods.norm(plus(s, -1, before));
        }
    }

    /** Each kick goes on from the one before. */
    private static void closingKicks(DEStateSource source, double h) {
        double[] s = state(source);
        kick(source, s, h / 2);
        drift(source, s, h);
        int rounds = ((SecondOrderStateSource) source).accelerationDependsOnVelocity() ? 3 : 1;
        for (int round = 0; round < rounds; round++) {
            kick(source, s, h / 2);
        }
    }

    /** The end's force is taken at v + h a. */
    private static void predicted(DEStateSource source, double h) {
        int d = ((SecondOrderStateSource) source).getDimension();
        double[] s = state(source);
        double[] a = slope(source);
        double[] x = s.clone();
        for (int i = 0; i < s.length; i++) {
            x[i] += i / d % 2 == 0 ? h * s[i + d] + h * h / 2 * a[i + d] : h * a[i];
        }
        source.incTime(h);
        double[] end = slopeAt(source, x);
        for (int i = 0; i < s.length; i++) {
            x[i] = i / d % 2 == 0 ? x[i] : s[i] + h / 2 * (a[i] + end[i]);
        }
        source.setState(x);
    }

    private static void fixedPoint(DEStateSource source, double h, ToDoubleFunction<double[]> size) {
        double[] s = state(source);
        double[] next = s;
        source.incTime(h);
        for (int round = 0; round < 200; round++) {
            double[] better = plus(s, h, slopeAt(source, next));
            double change = size.applyAsDouble(plus(better, -1, next));
            next = better;
            if (change < 1e-12) {
                source.setState(next);
                return;
            }
        }
        throw new IllegalStateException("the iteration does not converge: use a shorter deltaT than " + h);
    }

    private static void kickTwo(DEStateSource source, double[] s, double h) {
        double[] kept = s.clone();
        kick(source, s, h);
        for (int i = 5; i < s.length; i += 6) {
            s[i] = kept[i];
        }
        source.setState(s);
    }

    private static void halves(DEStateSource source, double h) {
        double[] s = state(source);
        double[] f = slope(source);
        int half = s.length / 2;
        for (int i = 0; i < half; i++) {
            s[i + half] += h * f[i + half];
            s[i] += h * s[i + half];
        }
        source.setState(s);
        source.incTime(h);
    }

    private static void neighbour(DEStateSource source, double h) {
        double[] s = state(source);
        double[] next = plus(s, h, slope(source));
        for (int x = 6; x < s.length; x += x % 6 == 2 ? 4 : 1) {
            next[x] = s[x] + h * s[x - 3];
        }
        source.setState(next);
        source.incTime(h);
    }

    private static final class HeunOnFixedStep extends FixedStepSolver {
        private final double weight;

        HeunOnFixedStep(double weight) {
            this.weight = weight;
        }

        @Override
        protected void step(DEStateSource source, double[] s, double deltaT) {
            double[] k1 = eulerStep(s, deltaT);
            source.incTime(deltaT);
            double[] k2 = eulerStep(plus(s, 1, k1), deltaT);
            for (int i = 0; i < s.length; i++) {
                s[i] += weight * (k1[i] + k2[i]);
            }
        }
    }

    /** Bogacki and Shampine's method, whose last derivative is the first of the next step, if it goes on from there. */
    private static final class Fsal extends DESolver {
        private final String slip;
        private DEStateSource last;
        private double[] left = {};
        private double[] kept = {};
        private double time;

        Fsal(String slip) {
            this.slip = slip;
        }

        @Override
        public void stepState(DEStateSource source, double h) {
            double[] s = state(source);
            boolean mine = source == last && time == source.getTime() && Arrays.equals(s, left)
                    || slip.equals("always") && left.length == s.length;
            double[] k1 = mine ? kept : slope(source);
            source.incTime(h / 2);
            double[] k2 = slopeAt(source, plus(s, h / 2, k1));
            source.incTime(h / 4);
            double[] k3 = slopeAt(source, plus(s, 3 * h / 4, k2));
            source.incTime(h / 4);
            left = plus(plus(plus(s, 2 * h / 9, k1), h / 3, k2), 4 * h / 9, k3);
            kept = slopeAt(source, left);
            last = source;
            time = source.getTime();
        }

        @Override
        public void reset() {
            last = null;
        }
    }

    /** Leapfrog that takes the acceleration of its last step while the source is the same object. */
    private static final class KeptAcceleration extends DESolver {
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

    private static final class OtherDeltaT extends DESolver {
        private final boolean first;
        private double h;

        OtherDeltaT(boolean first) {
            this.first = first;
        }

        @Override
        public void stepState(DEStateSource source, double deltaT) {
            h = h == 0 ? deltaT : h;
            source.setState(plus(state(source), h, slope(source)));
            source.incTime(deltaT);
            h = first ? h : deltaT;
        }
    }

    /** Euler that asks the first source that it was given for the derivative. */
    private static final class FirstSource extends DESolver {
        private DEStateSource source;

        @Override
        public void stepState(DEStateSource given, double deltaT) {
            source = source == null ? given : source;
            source.setState(state(given));
            source.incTime(given.getTime() - source.getTime());
            given.setState(plus(state(given), deltaT, slope(source)));
            given.incTime(deltaT);
        }
    }
}
