package particles.teaching.collection;

import static particles.teaching.collection.Pieces.drifts;
import static particles.teaching.collection.Pieces.plus;
import static particles.teaching.collection.Pieces.rungeKutta;
import static particles.teaching.collection.RightSolvers.CASH_KARP;
import static particles.teaching.collection.RightSolvers.CASH_KARP5;
import static particles.teaching.collection.RightSolvers.DOPRI;
import static particles.teaching.collection.RightSolvers.DOPRI4;
import static particles.teaching.collection.RightSolvers.DOPRI5;
import static particles.teaching.collection.RightSolvers.FEHLBERG;
import static particles.teaching.collection.RightSolvers.FEHLBERG4;
import static particles.teaching.collection.RightSolvers.RK4;
import static particles.teaching.collection.RightSolvers.RK4_WEIGHTS;
import static particles.teaching.collection.RightSolvers.W;
import static particles.teaching.collection.Specimen.wrong;
import static particles.teaching.solvers.PlantedSolvers.slope;
import static particles.teaching.solvers.PlantedSolvers.slopeAt;
import static particles.teaching.solvers.PlantedSolvers.state;

import deSolvers.DEStateSource;
import java.util.Arrays;
import java.util.List;
import particles.teaching.collection.Pieces.Adaptive;
import particles.teaching.solvers.PlantedSolvers;

/** Wrong solvers whose coefficients, stage times or use of deltaT are wrong. */
final class WrongFormulas {
    private static final String CLOCK_LATE = "(evaluated|taken) at (time )?t[ ;,:].*clock|at the clock t|evaluated at "
            + "t;";

    private WrongFormulas() {
    }

    static List<Specimen> all() {
        return List.of(
                wrong("EulerSolver", "half the step", "half|halved|1/2|k1/2|deltaS/2", rungeKutta("", "1/2", "")),
                wrong("EulerSolver", "sign", "sign", rungeKutta("", "-1", "")),
                wrong("MidpointSolver", "half missing", "half is missing", rungeKutta("1", "0 1", "0 1/2")),
                wrong("MidpointSolver", "clock at t", CLOCK_LATE, rungeKutta("1/2", "0 1", "0 0")),
                wrong("MidpointSolver", "clock at t + deltaT", "gMid is evaluated at t \\+ deltaT",
                        rungeKutta("1/2", "0 1", "0 1")),
                wrong("Middle", "1/2 of whole numbers", "1/2 is 0", rungeKutta("0", "0 1", "0 1/2")),
                wrong("HeunSolver", "half missing", "half is missing|add up to", rungeKutta("1", "1 1", "")),
                wrong("HeunSolver", "midpoint instead", "midpoint", rungeKutta("1/2", "0 1", "")),
                wrong("HeunSolver", "weights swapped for Ralston's", "weight", rungeKutta("1", "1/4 3/4", "")),
                wrong("RalstonSolver", "weights the other way round", "weight|other way round|swapped",
                        rungeKutta("2/3", "3/4 1/4", "")),
                wrong("RK3Solver", "k3 without -k1", "k3 is evaluated at", rungeKutta("1/2; 0 2", "1/6 2/3 1/6",
                        "0 1/2 1")),
                wrong("RungeKutta3Solver", "weights add up to 7/6", "weight|add up",
                        rungeKutta("1/2; -1 2", "1/6 2/3 1/3", "")),
                wrong("SSPRK3Solver", "last weight", "weight|add up", rungeKutta("1; 1/4 1/4", "1/6 1/6 1/3", "")),
                wrong("RK4Solver", "weight", "weight of k3", rungeKutta(RK4, "1/6 1/3 1/6 1/6", "")),
                wrong("RK4Solver", "weights in disorder", "weight", rungeKutta(RK4, "1/3 1/6 1/6 1/3", "")),
                wrong("RK4Solver", "all weights 1/4", "weight", rungeKutta(RK4, "1/4 1/4 1/4 1/4", "")),
                wrong("RK4Solver", "not divided by 6", "6 times", rungeKutta(RK4, "1 2 2 1", "")),
                wrong("RK4Solver", "whole numbers divided", "1/6 is 0", rungeKutta(RK4, "0 0 0 0", "")),
                wrong("Rk", "k4 at s + k3/2", "k4 is evaluated at", rungeKutta("1/2; 0 1/2; 0 0 1/2", RK4_WEIGHTS,
                "0 1/2 1/2 1")),
                wrong("RK4Solver", "k3 from k1", "k3 is evaluated at s \\+ k1/2",
                        rungeKutta("1/2; 1/2 0; 0 0 1", RK4_WEIGHTS, "")),
                wrong("RK4Solver", "k3 without the half", "k3 is evaluated at s \\+ k2[;:].*half is missing",
                        rungeKutta("1/2; 0 1; 0 0 1", RK4_WEIGHTS, "0 1/2 1/2 1")),
                wrong("RK4Solver", "clock at t", CLOCK_LATE, rungeKutta(RK4, RK4_WEIGHTS, "0 0 0 0")),
                wrong("RungeKutta", "k2 at t", "k2 is evaluated at t;", rungeKutta(RK4, RK4_WEIGHTS, "0 0 1/2 1")),
                wrong("RungeKuttaSolver", "clock moved at once", "t \\+ deltaT", rungeKutta(RK4, RK4_WEIGHTS,
                "0 1 1 1")),
                wrong("Rk4Mine", "trial state never taken back", "go back to the start|one array",
                        rungeKutta("1/2; 1/2 1/2; 1/2 1/2 1", "2/3 5/6 4/3 1/6", "0 1/2 1/2 1")),
                wrong("RK4Solver", "one array for all slopes", "one array", WrongFormulas::oneSlopeArray),
                wrong("RK4Solver", "trial = s without clone", "one array|clone|copy", WrongFormulas::aliasedTrial),
                wrong("RungeKutta38Solver", "weights of RK4", "weight",
                        rungeKutta("1/3; -1/3 1; 1 -1 1", RK4_WEIGHTS, "")),
                wrong("RK38", "sign of a coefficient", "k3 is evaluated at",
                        rungeKutta("1/3; 1/3 1; 1 -1 1", "1/8 3/8 3/8 1/8", "0 1/3 2/3 1")),
                wrong("DormandPrinceSolver", "coefficient of row 4", "k4 is evaluated|order",
                        rungeKutta(DOPRI.replace("-56/15", "-55/15"), DOPRI5, "0 1/5 3/10 4/5 8/9 1 1")),
                wrong("DormandPrinceSolver", "weight", "weight|add up|order", rungeKutta(DOPRI,
                        DOPRI5.replace("125/192",
                        "125/129"), "")),
                wrong("DormandPrince", "adaptive, wrong row", "k3 is evaluated|order",
                        () -> new Adaptive(DOPRI.replace("3/40 9/40", "3/40 9/20"), DOPRI5, DOPRI4, 1e-6, 5, true)),
                wrong("FehlbergSolver", "sign in row 5", "k5 is evaluated|order",
                        rungeKutta(FEHLBERG.replace("439/216 -8", "439/216 8"), FEHLBERG4, "0 1/4 3/8 12/13 1 1/2")),
                wrong("CashKarpSolver", "weight forgotten", "weight|add up|order",
                        rungeKutta(CASH_KARP, CASH_KARP5.replace("250/621", "0"), "")),
                wrong("SymplecticEulerSolver", "old velocity", "old velocity|Euler method", rungeKutta("", "1", "")),
                wrong("EulerSolver", "new velocity", "new velocity", drifts(new double[] {0, 1}, new double[] {1})),
                wrong("LeapfrogSolver", "two whole kicks", "velocity|twice|half", WrongFormulas::wholeKicks),
                wrong("VerletSolver", "old acceleration only", "acceleration", WrongFormulas::oldAcceleration),
                wrong("VelocityVerlet", "half of a missing in x", "half is missing", (source, h) -> verlet(source, h, 1,
                0.5)),
                wrong("VelocityVerlet", "accelerations not halved", "new velocity|half",
                        (source, h) -> verlet(source, h, 0.5, 1)),
                wrong("YoshidaSolver", "coefficient rounded to 1.3", "13/10 a1 deltaT.*the method says v \\+ 1.351 a1",
                        drifts(new double[] {0.65, -0.15, -0.15, 0.65},
                        new double[] {1.3, -1.6, 1.3})),
                wrong("Yoshida4Solver", "kicks in disorder", "order|velocity|position|kick", drifts(new double[] {W / 2,
                        (1 - W) / 2, (1 - W) / 2,
                        W / 2}, new double[] {1 - 2 * W, W, W})),
                wrong("Ruth3", "sign of a drift", "parts of the step.*signs", drifts(new double[] {1, 2.0 / 3,
                        2.0 / 3},
                        new double[] {-1.0 / 24, 3.0 / 4, 7.0 / 24})),
                wrong("EulerSolver", "deltaT ignored", "deltaT is ignored", PlantedSolvers.euler((f, h) -> f)),
                wrong("EulerSolver", "deltaT hard-coded", "hard-coded", PlantedSolvers.euler((f, h) -> 0.01 * f)),
                wrong("EulerSolver", "deltaT squared", "multiplied by deltaT twice", PlantedSolvers.euler((f, h)
                -> h * h * f)),
                wrong("EulerSolver", "divided by deltaT", "divided by deltaT", PlantedSolvers.euler((f, h) -> f / h)),
                wrong("EulerSolver", "|deltaT|", "sign of deltaT", PlantedSolvers.euler((f, h) -> Math.abs(h) * f)),
                wrong("EulerSolver", "no increment", "no derivative is in it",
                        PlantedSolvers.euler((f, h) -> 0 * f)));
    }

    private static void oneSlopeArray(DEStateSource source, double h) {
        double[] s = state(source);
        double[] k = new double[s.length];
        double[] k1 = derivative(source, s, k);
        source.incTime(h / 2);
        double[] k2 = derivative(source, plus(s, h / 2, k1), k);
        double[] k3 = derivative(source, plus(s, h / 2, k2), k);
        source.incTime(h / 2);
        double[] k4 = derivative(source, plus(s, h, k3), k);
        double[] next = s.clone();
        Arrays.setAll(next, i -> s[i] + h * (k1[i] + 2 * k2[i] + 2 * k3[i] + k4[i]) / 6);
        source.setState(next);
    }

    private static double[] derivative(DEStateSource source, double[] at, double[] k) {
        source.setState(at);
        source.getStateDerivative(k);
        return k;
    }

    private static void aliasedTrial(DEStateSource source, double h) {
        double[] s = state(source);
        double[] trial = s;
        double[] k1 = slope(source);
        source.incTime(h / 2);
        add(trial, s, h / 2, k1);
        double[] k2 = slopeAt(source, trial);
        add(trial, s, h / 2, k2);
        double[] k3 = slopeAt(source, trial);
        source.incTime(h / 2);
        add(trial, s, h, k3);
        double[] k4 = slopeAt(source, trial);
        double[] next = s.clone();
        Arrays.setAll(next, i -> s[i] + h * (k1[i] + 2 * k2[i] + 2 * k3[i] + k4[i]) / 6);
        source.setState(next);
    }

    private static void add(double[] sum, double[] s, double h, double[] k) {
        for (int i = 0; i < s.length; i++) {
            sum[i] = s[i] + h * k[i];
        }
    }

    private static void wholeKicks(DEStateSource source, double h) {
        double[] s = state(source);
        Pieces.kick(source, s, h);
        Pieces.drift(source, s, h);
        Pieces.kick(source, s, h);
    }

    private static void oldAcceleration(DEStateSource source, double h) {
        double[] s = state(source);
        double[] a = slope(source);
        for (int i = 0; i < s.length; i += i % 6 == 2 ? 4 : 1) {
            s[i] += h * s[i + 3] + h * h / 2 * a[i + 3];
            s[i + 3] += h * a[i + 3];
        }
        source.setState(s);
        source.incTime(h);
    }

    private static void verlet(DEStateSource source, double h, double x, double v) {
        double[] s = state(source);
        double[] old = slope(source);
        for (int i = 0; i < s.length; i += i % 6 == 2 ? 4 : 1) {
            s[i] += h * s[i + 3] + x * h * h * old[i + 3];
        }
        source.incTime(h);
        double[] now = slopeAt(source, s);
        for (int i = 3; i < s.length; i += i % 6 == 5 ? 4 : 1) {
            s[i] += v * h * (old[i] + now[i]);
        }
        source.setState(s);
    }
}
