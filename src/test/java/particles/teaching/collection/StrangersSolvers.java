package particles.teaching.collection;

import static particles.teaching.collection.Pieces.drifts;
import static particles.teaching.collection.Pieces.implicit;
import static particles.teaching.collection.Pieces.leapfrog;
import static particles.teaching.collection.Pieces.plus;
import static particles.teaching.collection.Pieces.rungeKutta;
import static particles.teaching.collection.RightSolvers.FEHLBERG;
import static particles.teaching.collection.RightSolvers.FEHLBERG4;
import static particles.teaching.collection.RightSolvers.FEHLBERG5;
import static particles.teaching.collection.RightSolvers.RK4;
import static particles.teaching.collection.RightSolvers.RK4_WEIGHTS;
import static particles.teaching.collection.RightSolvers.W;
import static particles.teaching.collection.Specimen.right;
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
import particles.teaching.solvers.PlantedSolvers;
import particles.teaching.solvers.PlantedSolvers.Step;

/** Right and wrong solvers after those of a third person, who had not seen the check either. */
final class StrangersSolvers {
    private static final String HEUN = "1";
    private static final String MEAN = "1/2 1/2";
    private static final Step MIDPOINT = rungeKutta("1/2", "0 1", "");
    private static final String NOT_CONTROLLED = "name promises step-size control";
    private static final String LEFT_OUT = "these entries stay as they were in the trial state at evaluation 2: ";

    private StrangersSolvers() {
    }

    static List<Specimen> allRight() {
        return List.of(
                right("R01HeunSolver", "Heun, numbered", rungeKutta(HEUN, MEAN, "")),
                right("A3HeunSolver", "Heun, numbered", rungeKutta(HEUN, MEAN, "")),
                right("R02RalstonSolver", "Ralston", rungeKutta("2/3", "1/4 3/4", "")),
                right("R03KuttaThirdOrderSolver", "Kutta", rungeKutta("1/2; -1 2", "1/6 2/3 1/6", "")),
                right("R05ClassicRK4", "RK4", rungeKutta(RK4, RK4_WEIGHTS, "")),
                right("R07ThreeEighthsSolver", "3/8", rungeKutta("1/3; -1/3 1; 1 -1 1", "1/8 3/8 3/8 1/8", "")),
                right("R09EulerVerfahren", "Euler", RightSolvers::euler),
                right("R12FehlbergFixedStep", "order 5", rungeKutta(FEHLBERG, FEHLBERG5, "")),
                right("R13AdamsBashforth2", "Heun start", () -> new History(2, "")),
                right("R15AdamsBashforth4", "RK4 start", () -> new History(4, "")),
                right("Solver16", "predictor and corrector", () -> new Adams(4, 4, true)),
                right("R17LeapfrogKDK", "leapfrog", (source, h) -> leapfrog(source, h)),
                right("R18LeapfrogDKD", "leapfrog", drifts(new double[] {0.5, 0.5}, new double[] {1})),
                right("R19SymplecticEuler", "kick, drift", drifts(new double[] {0, 1}, new double[] {1})),
                right("R21YoshidaSolver", "four drifts", drifts(new double[] {W / 2, (1 - W) / 2, (1 - W) / 2, W / 2},
                        new double[] {W, 1 - 2 * W, W})),
                right("R22Ruth3", "the velocity first", ruth3(2.0 / 3, -2.0 / 3, 1, -1.0 / 24)),
                right("R23ImplicitEuler", "Newton", implicit(0, 1, 1, 1, 1e-10, 50)),
                right("R24Trapezoid", "Newton", implicit(0.5, 0.5, 1, 1, 1e-10, 50)),
                right("R26BDF2", "begun by backward Euler", () -> new Bdf2(2.0 / 3)),
                right("R27AdaptiveHeunEuler", "1e-6", () -> new Adaptive(HEUN, MEAN, "1 0", 1e-6, 2, true)),
                right("R28BogackiShampine", "adaptive", () -> new SubSteps("")),
                right("AdaptifPasVariable", "Fehlberg", () -> new Adaptive(FEHLBERG, FEHLBERG4, FEHLBERG5, 1e-7, 5,
                true)),
                right("R47SubstepRK4", "ten sub-steps", (source, h) -> {
                    for (int i = 0; i < 10; i++) {
                        rungeKutta(RK4, RK4_WEIGHTS, "").make(source, h / 10);
                    }
                }),
                right("R48ImplicitEulerFixedPoint", "refuses long steps", StrangersSolvers::fixedPoint),
                refusing("R60ClassicRK4", 0, PlantedSolvers.solver(rungeKutta(RK4, RK4_WEIGHTS, ""))),
                refusing("R61LeapfrogKDK", 0, PlantedSolvers.solver((source, h) -> leapfrog(source, h))),
                refusing("R62EulerVerfahren", 0, PlantedSolvers.solver(RightSolvers::euler)),
                refusing("R63BogackiShampine", 0, new SubSteps("")),
                refusing("R64Trapezoid", 0, PlantedSolvers.solver(implicit(0.5, 0.5, 1, 1, 1e-10, 50))),
                refusing("R40ClassicRK4", Double.MIN_VALUE, PlantedSolvers.solver(rungeKutta(RK4, RK4_WEIGHTS, ""))),
                refusing("R43BogackiShampine", Double.MIN_VALUE, new SubSteps("")));
    }

    static List<Specimen> allWrong() {
        return List.of(
                wrong("W148PointMilieu", "trial loop to n - 1", LEFT_OUT + "23;", looped("1/2", 0, -1)),
                wrong("W104HeunSolver", "trial loop to n - 1", LEFT_OUT + "23;", looped(HEUN, 0, -1)),
                wrong("W127HeunSolver", "trial loop from 1", LEFT_OUT + "0;", looped(HEUN, 1, 0)),
                wrong("W143HeunSolver", "trial loop to 6", LEFT_OUT + "6, 7, 8,", looped(HEUN, 0, 6)),
                wrong("W146PointMilieu", "trial loop to 12", LEFT_OUT + "12, 13, 14,", looped("1/2", 0, 12)),
                wrong("W144HeunSolver", "trial loop to 30", "200 particles.*loop has a fixed length",
                        looped(HEUN, 0, 30)),
                wrong("W141LeapfrogKDK", "last coordinate gets no kick", ": 2, 5, 8, 11.*loop", (source, h) -> {
                    double[] s = state(source);
                    kickTwo(source, s, h / 2);
                    Pieces.drift(source, s, h);
                    kickTwo(source, s, h / 2);
                }),
                wrong("W68HeunSolver", "is midpoint", "midpoint method and not Heun", MIDPOINT),
                wrong("Task2Heun", "is midpoint", "midpoint method and not Heun", MIDPOINT),
                wrong("W60BackwardEuler", "is Euler", "Euler method, which is explicit", RightSolvers::euler),
                wrong("W63ImplicitMidpoint", "is midpoint", "midpoint method, which is explicit", MIDPOINT),
                wrong("W50SymplecticEuler", "is Euler", "old velocity", RightSolvers::euler),
                wrong("LeapfrogKDK2", "drift, kick, drift", "not velocity Verlet", drifts(new double[] {0.5, 0.5},
                        new double[] {1})),
                wrong("BackwardEulerNewton", "is the trapezoid", "trapezoidal rule and not backward Euler",
                        implicit(0.5, 0.5, 1, 1, 1e-10, 50)),
                wrong("W65AdamsBashforth2", "is Heun", "nothing of earlier steps is used", rungeKutta(HEUN, MEAN, "")),
                wrong("W66AdaptiveRK4", "fixed step", NOT_CONTROLLED, rungeKutta(RK4, RK4_WEIGHTS, "")),
                wrong("W83StepDoubling", "error always 0", NOT_CONTROLLED, rungeKutta("1/4; 0 1/2; 0 1/2 1/4",
                        "0 1/2 0 1/2", "")),
                wrong("W22AdaptiveHeunEuler", "error always 0", NOT_CONTROLLED, rungeKutta(HEUN, MEAN, "")),
                wrong("W80AdaptiveBogackiShampine", "accepts what is too far off", NOT_CONTROLLED + "|endless",
                        () -> new SubSteps("inverted")),
                wrong("W81AdaptiveBogackiShampine", "rejected state kept", "made again from the state before",
                        () -> new SubSteps("keeps")),
                wrong("W77AdaptiveBogackiShampine", "never rejects", "made again from the state before",
                        () -> new SubSteps("never")),
                wrong("W135AdaptiveBogackiShampine", "clock moves though rejected", "clock may move only when",
                        () -> new SubSteps("clock")),
                wrong("W78AdaptiveBogackiShampine", "no Math.abs", "Math.abs", () -> new SubSteps("noAbs")),
                wrong("W137AdaptiveBogackiShampine", "error of entry 0", "largest of all entries",
                        () -> new SubSteps("first")),
                wrong("W134AdaptiveBogackiShampine", "k3 at t + h/2", "k3 is evaluated at t \\+ deltaT/2",
                        () -> new SubSteps("time")),
                wrong("W132AdaptiveBogackiShampine", "a32 = 1/2", "k3 is evaluated at s \\+ k2/2",
                        () -> new SubSteps("row")),
                wrong("W133AdaptiveBogackiShampine", "b3 = 1/9", "weights add up to 2/3",
                        () -> new SubSteps("weight")),
                wrong("W138AdaptiveBogackiShampine", "trial loop to n - 1", LEFT_OUT + "23;",
                        () -> new SubSteps("loop")),
                wrong("W136AdaptiveBogackiShampine", "nothing for negative deltaT", "negative deltaT does nothing",
                        () -> new SubSteps("forward")),
                wrong("W30HeunSolver", "swallows exceptions", "do not catch it", swallowing(rungeKutta(HEUN, MEAN,
                ""))),
                wrong("W76EulerVerfahren", "swallows exceptions", "do not catch it", swallowing(RightSolvers::euler)),
                wrong("W75EulerSolver", "first source kept", "first source is kept in a field", FirstSource::new),
                wrong("W24Trapezoid", "sign of the Jacobian", "signs in the matrix", newton(0.5, 1)),
                wrong("W98BackwardEuler", "sign of the Jacobian", "signs in the matrix", newton(0, 1)),
                wrong("W96BackwardEuler", "sign of the matrix", "signs in the matrix", newton(0, -1)),
                wrong("W93ImplicitMidpoint", "h for the middle", "deltaT stand where deltaT/2 is meant",
                        (source, h) -> {
                    implicit(0, 1, 0.5, 0.25, 1e-12, 50).make(source, 2 * h);
                    source.incTime(-h);
                }),
                wrong("W124Trapezoid", "h f(new)", "deltaT stand where deltaT/2 is meant",
                        implicit(0.5, 1, 1, 1, 1e-12, 50)),
                wrong("W84AdamsBashforth3", "newest dropped", "t - 5 deltaT, t - 6 deltaT instead of",
                        () -> new History(3, "newest")),
                wrong("W85AdamsBashforth4", "old ones all the same", "derivatives at t, t - deltaT, which",
                        () -> new History(4, "direction")),
                wrong("W91AdamsBashforth2", "old one never replaced", "t - 6 deltaT instead of",
                        () -> new History(2, "frozen")),
                wrong("W88AdamsBashforth2", "no reset", "reset\\(\\) was called", () -> new History(2, "reset")),
                wrong("W56AdamsBashforth2", "deltaT not compared", "deltaT changes", () -> new History(2, "deltaT")),
                wrong("W25AdamsBashforth2", "state not compared", "as a collision does",
                        () -> new History(2, "state")),
                wrong("W89AdamsBashforth3", "stages of the start at t", "first steps.*not accurate enough",
                        () -> new History(3, "start")),
                wrong("W142AdamsBashforth2", "clock stays later", "from step 2 on the clock never moves",
                        () -> new History(2, "clock")),
                wrong("W37SymplecticEuler", "v times 0.999", "0.9990 times v", (source, h) -> damped(source, h, 0.999)),
                wrong("W70SymplecticEuler", "v times 0.99", "0.9900 times v", (source, h) -> damped(source, h, 0.99)),
                wrong("W44YoshidaSolver", "no minus", "parts of the step add up to 4.405", leapfrogs(W, 2 * W - 1, W)),
                wrong("W129YoshidaSolver", "1 - W in the middle", "parts of the step add up to", leapfrogs(W, 1 - W,
                        W)),
                wrong("W130Ruth3", "drifts 2/3, 2/3, -1/3", "a3 is evaluated at x \\+ 4/3 v",
                        ruth3(2.0 / 3, 2.0 / 3, -1.0 / 3, -1.0 / 24)),
                wrong("W57Ruth3", "+1/24", "says v \\+ 7/24 a1 deltaT \\+ 3/4 a2 deltaT - a3",
                        ruth3(2.0 / 3, -2.0 / 3, 1, 1.0 / 24)),
                wrong("W101VelocityVerlet", "(1/2) of whole numbers", "1/2 is 0 in Java", (source, h) -> {
                    double[] s = state(source);
                    double[] half = s.clone();
                    Pieces.kick(source, half, h / 2);
                    source.setState(s);
                    Pieces.drift(source, s, h);
                    for (int i = 3; i < s.length; i += i % 6 == 5 ? 4 : 1) {
                        s[i] = half[i];
                    }
                    Pieces.kick(source, s, h / 2);
                }),
                wrong("W18RK4Solver", "1/6 in float", "first seven digits", rungeKutta(RK4, "" + (double) (1f / 6) + " "
                        + (double) (2f / 6) + " " + (double) (2f / 6) + " " + (double) (1f / 6), "")),
                wrong("W72ThreeEighths", "1/3 in float", "first seven digits", rungeKutta((double) (1f / 3)
                        + "; -1/3 1; 1 -1 1", "1/8 3/8 3/8 1/8", "0 1/3 2/3 1")),
                wrong("W33RalstonSolver", "2/3 of whole numbers", "2/3 is 0 in Java", rungeKutta("0", "1/4 3/4",
                        "0 2/3")),
                wrong("W109Fehlberg", "9/50 for -9/50", "weight of k5 is 0.1800 instead of -0.1800",
                        rungeKutta(FEHLBERG, FEHLBERG5.replace("-9/50", "9/50"), "")),
                wrong("W107HeunSolver", "brackets missing", "brackets missing", (source, h) -> {
                    double[] s = state(source);
                    double[] k1 = slope(source);
                    source.incTime(h);
                    source.setState(plus(plus(s, h, k1), 0.5, slopeAt(source, plus(s, h, k1))));
                }));
    }

    private static Specimen refusing(String name, double least, DESolver solver) {
        return right(name, "refuses deltaT below " + least, () -> PlantedSolvers.solver((source, deltaT) -> {
            if (deltaT < least) {
                throw new IllegalArgumentException("deltaT is " + deltaT);
            }
            solver.reset();
            solver.stepState(source, deltaT);
        }));
    }

    private static void fixedPoint(DEStateSource source, double h) {
        double[] s = state(source);
        double[] next = s;
        source.incTime(h);
        for (int round = 0; round < 200; round++) {
            double[] better = plus(s, h, slopeAt(source, next));
            double change = Pieces.norm(plus(better, -1, next));
            next = better;
            if (change < 1e-12) {
                source.setState(next);
                return;
            }
        }
        throw new IllegalStateException("the iteration does not converge: use a shorter deltaT than " + h);
    }

    /** Heun or midpoint; the loop of the trial state begins and ends at these entries, or some before the end. */
    private static Step looped(String place, int from, int to) {
        double part = place.equals(HEUN) ? 1 : 0.5;
        return (source, h) -> {
            double[] s = state(source);
            double[] k1 = slope(source);
            double[] trial = s.clone();
            for (int i = from; i < Math.min(s.length, to <= 0 ? s.length + to : to); i++) {
                trial[i] += part * h * k1[i];
            }
            source.incTime(part * h);
            double[] k2 = slopeAt(source, trial);
            source.setState(plus(plus(s, (1 - 0.5 / part) * h, k1), 0.5 / part * h, k2));
            source.incTime((1 - part) * h);
        };
    }

    private static void kickTwo(DEStateSource source, double[] s, double h) {
        double[] kept = s.clone();
        Pieces.kick(source, s, h);
        for (int i = 5; i < s.length; i += 6) {
            s[i] = kept[i];
        }
        source.setState(s);
    }

    private static Step ruth3(double first, double second, double third, double lastKick) {
        return drifts(new double[] {0, first, second, third}, new double[] {7.0 / 24, 3.0 / 4, lastKick});
    }

    private static Step leapfrogs(double... parts) {
        return (source, h) -> Arrays.stream(parts).forEach(part -> leapfrog(source, part * h));
    }

    private static void damped(DEStateSource source, double h, double factor) {
        double[] s = state(source);
        Pieces.kick(source, s, h);
        for (int i = 3; i < s.length; i += i % 6 == 5 ? 4 : 1) {
            s[i] *= factor;
        }
        Pieces.drift(source, s, h);
    }

    private static Step swallowing(Step step) {
        return (source, h) -> {
            try {
                step.make(source, h);
            } catch (RuntimeException e) {
                source.incTime(0);                      // and goes on
            }
        };
    }

    /** One part of the equation at the start; Newton's matrix is sign times I + part deltaT J. */
    private static Step newton(double now, double sign) {
        return (source, h) -> {
            double[] s = state(source);
            double[] base = plus(s, now * h, slope(source));
            source.incTime(h);
            double part = (1 - now) * h;
            double[] y = s.clone();
            double size = 1;
            for (int round = 0; round < 50 && !(size < 1e-12); round++) {
                double[] f = slopeAt(source, y);
                double[][] matrix = new double[y.length][y.length + 1];
                for (int j = 0; j < y.length; j++) {
                    double[] moved = y.clone();
                    moved[j] += 1e-7;
                    double[] there = slopeAt(source, moved);
                    for (int i = 0; i < y.length; i++) {
                        matrix[i][j] = part * (there[i] - f[i]) / 1e-7 * (sign < 0 ? -1 : 1) + (i == j ? sign : 0);
                    }
                    matrix[j][y.length] = base[j] + part * f[j] - y[j];
                }
                double[] change = Pieces.eliminate(matrix);
                y = plus(y, 1, change);
                size = Pieces.norm(change);
            }
            source.setState(y);
        };
    }

    /** Bogacki and Shampine's pair with sub-steps, tolerance 1e-8, and a slip. */
    private static final class SubSteps extends DESolver {
        private final double[] c = {0, 0.5, 0.75, 1};
        private final double[][] a = {{}, {0.5}, {0, 0.75}, {2.0 / 9, 1.0 / 3, 4.0 / 9}};
        private final double[] b = {2.0 / 9, 1.0 / 3, 4.0 / 9, 0};
        private final double[] e = {-5.0 / 72, 1.0 / 12, 1.0 / 9, -1.0 / 8};
        private final String slip;

        SubSteps(String slip) {
            this.slip = slip;
            c[2] = slip.equals("time") ? 0.5 : 0.75;
            a[2][1] = slip.equals("row") ? 0.5 : 0.75;
            b[2] = slip.equals("weight") ? 1.0 / 9 : 4.0 / 9;
        }

        private double error(double[] off, double[] s) {
            double size = 0;
            for (int i = 0; i < (slip.equals("first") ? 1 : s.length); i++) {
                double signed = slip.equals("noAbs") ? off[i] : Math.abs(off[i]);
                size = Math.max(size, signed / (1e-8 * (1 + Math.abs(s[i]))));
            }
            return size;
        }

        @Override
        public void stepState(DEStateSource source, double deltaT) {
            double[] s = state(source);
            double t = source.getTime();
            double end = t + deltaT;
            double h = slip.equals("never") ? deltaT / 10 : deltaT;
            while (slip.equals("forward") ? t < end : (end - t) * deltaT > 0) {
                h = Math.abs(h) > Math.abs(end - t) ? end - t : h;
                double[][] k = new double[4][];
                double[] y = s;
                double[] off = new double[s.length];
                for (int j = 0; j < 4; j++) {
                    double[] trial = s;
                    for (int l = 0; l < j; l++) {
                        trial = plus(trial, h * a[j][l], k[l]);
                    }
                    if (slip.equals("loop")) {
                        trial = trial.clone();
                        trial[s.length - 1] = s[s.length - 1];
                    }
                    source.incTime(t + c[j] * h - source.getTime());
                    k[j] = slopeAt(source, trial);
                    y = plus(y, h * b[j], k[j]);
                    off = plus(off, h * e[j], k[j]);
                }
                double error = error(off, s);
                if (Double.isNaN(Arrays.stream(off).sum())) {
                    throw new ArithmeticException("NaN");
                }
                boolean good = (slip.equals("inverted") ? error > 1 : error <= 1) || slip.equals("never");
                s = good || slip.equals("keeps") ? y : s;
                t = !good && !slip.equals("clock") ? t : h == end - t ? end : t + h;
                h *= Math.min(5, Math.max(0.2, 0.9 * Math.pow(Math.max(error, 1e-9), -1.0 / 3)));
            }
            source.setState(s);
            source.incTime(end - source.getTime());
        }
    }

    /** Adams-Bashforth begun by RK4, with a slip. */
    private static final class History extends DESolver {
        private static final double[][] WEIGHTS = {{}, {}, {1.5, -0.5}, {23.0 / 12, -16.0 / 12, 5.0 / 12},
            {55.0 / 24, -59.0 / 24, 37.0 / 24, -9.0 / 24}};
        private final int order;
        private final String slip;
        private final double[][] old;
        private int known;
        private DEStateSource last;
        private double[] left = {};
        private double time;
        private double length;

        History(int order, String slip) {
            this.order = order;
            this.slip = slip;
            old = new double[order - 1][];
        }

        @Override
        public void stepState(DEStateSource source, double deltaT) {
            double[] s = state(source);
            boolean goesOn = source == last && (slip.equals("time") || time == source.getTime())
                    && (slip.equals("deltaT") || length == deltaT) && (slip.equals("state") || Arrays.equals(s, left));
            known = goesOn ? known : 0;
            double[] f = slope(source);
            boolean full = known >= order - 1;
            if (full) {
                double[] next = plus(s, deltaT * WEIGHTS[order][0], f);
                for (int j = 1; j < order; j++) {
                    next = plus(next, deltaT * WEIGHTS[order][j], old[j - 1]);
                }
                source.setState(next);
                source.incTime(slip.equals("clock") ? 0 : deltaT);
            } else {
                rungeKutta(RK4, RK4_WEIGHTS, slip.equals("start") ? "0 0 0 1" : "").make(source, deltaT);
            }
            if (!full || !slip.equals("newest") && !slip.equals("frozen")) {
                keep(f);
            }
            known++;
            last = source;
            left = state(source);
            time = source.getTime();
            length = deltaT;
        }

        private void keep(double[] f) {
            if (slip.equals("direction") && known >= order - 1) {
                Arrays.fill(old, f);
                return;
            }
            for (int j = order - 2; j > 0; j--) {
                old[j] = old[j - 1];
            }
            old[0] = f;
        }

        @Override
        public void reset() {
            known = slip.equals("reset") ? known : 0;
        }
    }

    /** Euler that steps the first source that it was given. */
    private static final class FirstSource extends DESolver {
        private DEStateSource source;

        @Override
        public void stepState(DEStateSource given, double deltaT) {
            source = source == null ? given : source;
            RightSolvers.euler(source, deltaT);
        }
    }
}
