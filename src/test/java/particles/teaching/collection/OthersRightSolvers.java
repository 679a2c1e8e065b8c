package particles.teaching.collection;

import static particles.teaching.collection.Pieces.drifts;
import static particles.teaching.collection.Pieces.implicit;
import static particles.teaching.collection.Pieces.iterated;
import static particles.teaching.collection.Pieces.newton;
import static particles.teaching.collection.Pieces.plus;
import static particles.teaching.collection.Pieces.rungeKutta;
import static particles.teaching.collection.RightSolvers.DOPRI;
import static particles.teaching.collection.RightSolvers.DOPRI4;
import static particles.teaching.collection.RightSolvers.DOPRI5;
import static particles.teaching.collection.RightSolvers.FEHLBERG;
import static particles.teaching.collection.RightSolvers.FEHLBERG5;
import static particles.teaching.collection.RightSolvers.RK4;
import static particles.teaching.collection.RightSolvers.RK4_WEIGHTS;
import static particles.teaching.collection.RightSolvers.W;
import static particles.teaching.collection.Specimen.right;
import static particles.teaching.solvers.PlantedSolvers.slope;
import static particles.teaching.solvers.PlantedSolvers.slopeAt;
import static particles.teaching.solvers.PlantedSolvers.state;

import deSolvers.DESolver;
import deSolvers.DEStateSource;
import deSolvers.FixedStepSolver;
import deSolvers.SecondOrderStateSource;
import java.util.Arrays;
import java.util.List;
import particles.teaching.collection.Pieces.Adaptive;
import particles.teaching.collection.RightSolvers.Adams;
import particles.teaching.solvers.PlantedSolvers.Step;

/** Right solvers, chosen by somebody who had not seen the check. */
final class OthersRightSolvers {
    private OthersRightSolvers() {
    }

    static List<Specimen> all() {
        return List.of(
                right("EulerMethod", "as on the slide", RightSolvers::euler),
                right("MidPoint", "arrays in fields", rungeKutta("1/2", "0 1", "")),
                right("HeunSolver", "on FixedStepSolver", HeunOnFixedStep::new),
                right("Ralston", "with helpers", rungeKutta("2/3", "1/4 3/4", "")),
                right("RichardsonEuler", "2 H - B", rungeKutta("1/2", "0 1", "")),
                right("RungeKutta4", "written out", rungeKutta(RK4, RK4_WEIGHTS, "")),
                right("MySolver", "3/8 rule", rungeKutta("1/3; -1/3 1; 1 -1 1", "1/8 3/8 3/8 1/8", "")),
                right("SSPRK3", "clock set back within the step", rungeKutta("1; 1/4 1/4", "1/6 1/6 2/3", "")),
                right("Solver2", "Butcher's order 5", rungeKutta("1/4; 1/8 1/8; 0 -1/2 1; 3/16 0 0 9/16;"
                        + " -3/7 2/7 12/7 -12/7 8/7", "7/90 0 32/90 12/90 32/90 7/90", "")),
                right("Fehlberg45", "order 5, clock set back", rungeKutta(FEHLBERG, FEHLBERG5, "")),
                right("DormandPrinceAdaptive", "1e-9", () -> new Adaptive(DOPRI, DOPRI5, DOPRI4, 1e-9, 5, true)),
                right("BogackiShampineSolver", "fixed steps", rungeKutta("1/2; 0 3/4", "2/9 1/3 4/9", "")),
                right("TaylorTwo", "second derivative by a difference", OthersRightSolvers::taylor),
                right("AdamsBashforth4", "RK4 at first", () -> new Adams(4, 4, false)),
                right("PredictorCorrector", "RK4 at first", () -> new Adams(4, 4, true)),
                right("SymplecticEuler", "kick, drift; throws for other sources", (source, h) -> {
                    if (!(source instanceof SecondOrderStateSource)) {
                        throw new IllegalArgumentException("positions and velocities are needed");
                    }
                    double[] s = state(source);
                    Pieces.kick(source, s, h);
                    Pieces.drift(source, s, h);
                }),
                right("SemiImplicitEuler", "drift, kick; a cast that may fail", (source, h) -> {
                    ((SecondOrderStateSource) source).getDimension();
                    drifts(new double[] {1, 0}, new double[] {1}).make(source, h);
                }),
                right("Leapfrog", "closing kick iterated", (source, h) -> closingKick(source, h, 1e-14)),
                right("BestSolver", "drift, kick, drift", drifts(new double[] {0.5, 0.5}, new double[] {1})),
                right("VelocityVerlet", "force at the predicted velocity", OthersRightSolvers::predicted),
                right("Yoshida", "three leapfrogs, iterated", (source, h) -> {
                    for (double w : new double[] {W, 1 - 2 * W, W}) {
                        closingKick(source, w * h, 1e-14);
                    }
                }),
                right("Ruth3", "kick first", ruth()),
                right("PEFRL", "Omelyan", drifts(new double[] {0.1786178958448091, -0.06626458266981849,
                    1 - 2 * (0.1786178958448091 - 0.06626458266981849), -0.06626458266981849, 0.1786178958448091},
                        new double[] {(1 + 2 * 0.2123418310626054) / 2, -0.2123418310626054, -0.2123418310626054,
                            (1 + 2 * 0.2123418310626054) / 2})),
                right("BackwardEulerNewton", "full Newton", implicit(0, 1, 1, 1, 1e-12, 50)),
                right("CrankNicolson", "Newton", implicit(0.5, 0.5, 1, 1, 1e-12, 50)),
                right("ImplicitMidpoint", "simple iteration", iterated(0, 1, 0.5, 0.5, 1e-13, 500)),
                right("GaussLegendre4", "two stages", OthersRightSolvers::gauss),
                right("SDIRK2", "two stages", OthersRightSolvers::sdirk),
                right("Rosenbrock", "ROS2", (source, h) -> ros2(source, h, 1)),
                right("BDF2", "backward Euler at first", () -> new Bdf2(2.0 / 3)));
    }

    /** Kick, drift, and a kick that is repeated until the velocity stands still, for the sake of drag. */
    static void closingKick(DEStateSource source, double h, double tolerance) {
        double[] s = state(source);
        Pieces.kick(source, s, h / 2);
        Pieces.drift(source, s, h);
        double[] half = s.clone();
        double change = 1;
        for (int round = 0; round < 100 && change > tolerance; round++) {
            double[] before = s;
            s = half.clone();
            Pieces.kick(source, s, h / 2);
            change = Pieces.norm(plus(s, -1, before));
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

    /** Ruth's coefficients the other way round: kicks 7/24, 3/4, -1/24, drifts 2/3, -2/3, 1. */
    private static Step ruth() {
        double[] kicks = {7.0 / 24, 3.0 / 4, -1.0 / 24};
        double[] drifts = {2.0 / 3, -2.0 / 3, 1};
        return (source, h) -> {
            double[] s = state(source);
            for (int i = 0; i < 3; i++) {
                Pieces.kick(source, s, kicks[i] * h);
                Pieces.drift(source, s, drifts[i] * h);
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
        source.incTime(t - e - source.getTime());
        double[] behind = slopeAt(source, plus(s, -e, f));
        double[] second = plus(ahead, -1, behind);
        source.setState(plus(plus(s, h, f), h * h / 2 / (2 * e), second));
        source.incTime(t + h - source.getTime());
    }

    private static void gauss(DEStateSource source, double h) {
        double r = Math.sqrt(3) / 6;
        double t = source.getTime();
        double[] s = state(source);
        int n = s.length;
        double[] k = newton(u -> {
            double[] k1 = Arrays.copyOf(u, n);
            double[] k2 = Arrays.copyOfRange(u, n, 2 * n);
            source.incTime(t + (0.5 - r) * h - source.getTime());
            double[] f1 = slopeAt(source, plus(plus(s, h / 4, k1), h * (0.25 - r), k2));
            source.incTime(t + (0.5 + r) * h - source.getTime());
            double[] f2 = slopeAt(source, plus(plus(s, h * (0.25 + r), k1), h / 4, k2));
            double[] off = Arrays.copyOf(plus(k1, -1, f1), 2 * n);
            System.arraycopy(plus(k2, -1, f2), 0, off, n, n);
            return off;
        }, new double[2 * n], 1e-11, 60);
        source.setState(plus(plus(s, h / 2, Arrays.copyOf(k, n)), h / 2, Arrays.copyOfRange(k, n, 2 * n)));
        source.incTime(t + h - source.getTime());
    }

    /** The unknowns are the stages' states, and the last one is the result. */
    private static void sdirk(DEStateSource source, double deltaT) {
        double gamma = 1 - 1 / Math.sqrt(2);
        double t = source.getTime();
        double[] s = state(source);
        source.incTime(gamma * deltaT);
        double[] one = newton(x -> plus(plus(x, -1, s), -gamma * deltaT, slopeAt(source, x)), s, 1e-12, 40);
        double[] base = plus(s, (1 - gamma) * deltaT, slopeAt(source, one));
        source.incTime(t + deltaT - source.getTime());
        source.setState(newton(x -> plus(plus(x, -1, base), -gamma * deltaT, slopeAt(source, x)), one, 1e-12, 40));
    }

    /** Verwer's ROS2: (I - g h J) k1 = f + g h f_t, (I - g h J) k2 = f(end) - 2 k1 - g h f_t. */
    static void ros2(DEStateSource source, double h, double sign) {
        double g = 1 + 1 / Math.sqrt(2);
        double t = source.getTime();
        double[] s = state(source);
        int n = s.length;
        double[] f = slope(source);
        double[][] w = new double[n][n + 1];
        for (int j = 0; j < n; j++) {
            double[] moved = s.clone();
            moved[j] += 1e-7;
            double[] there = slopeAt(source, moved);
            for (int i = 0; i < n; i++) {
                w[i][j] = (i == j ? 1 : 0) - sign * g * h * (there[i] - f[i]) / 1e-7;
            }
        }
        double dt = 1e-4 * h;
        source.incTime(dt);
        double[] later = slopeAt(source, s);
        double[] ft = new double[n];
        for (int i = 0; i < n; i++) {
            ft[i] = dt == 0 ? 0 : (later[i] - f[i]) / dt;
        }
        double[] k1 = solved(w, plus(f, g * h, ft));
        source.incTime(t + h - source.getTime());
        double[] k2 = solved(w, plus(plus(slopeAt(source, plus(s, h, k1)), -2, k1), -g * h, ft));
        source.setState(plus(plus(s, 1.5 * h, k1), 0.5 * h, k2));
    }

    private static double[] solved(double[][] w, double[] right) {
        double[][] m = new double[w.length][];
        for (int i = 0; i < m.length; i++) {
            m[i] = w[i].clone();
            m[i][m.length] = right[i];
        }
        return Pieces.eliminate(m);
    }

    /** The letters of the base class. */
    private static final class HeunOnFixedStep extends FixedStepSolver {
        @Override
        protected void step(DEStateSource source, double[] s, double deltaT) {
            double[] k1 = eulerStep(s, deltaT);
            source.incTime(deltaT);
            double[] k2 = eulerStep(plus(s, 1, k1), deltaT);
            for (int i = 0; i < s.length; i++) {
                s[i] += (k1[i] + k2[i]) / 2;
            }
        }
    }

    /** Begun, and begun again after any change, by backward Euler. */
    static final class Bdf2 extends DESolver {
        private final double factor;
        private DEStateSource last;
        private double time;
        private double length;
        private double[] before = {};
        private double[] now = {};

        Bdf2(double factor) {
            this.factor = factor;
        }

        @Override
        public void stepState(DEStateSource source, double deltaT) {
            double[] s = state(source);
            boolean goesOn = source == last && source.getTime() == time && length == deltaT && Arrays.equals(s, now);
            double[] base = s.clone();
            for (int i = 0; goesOn && i < s.length; i++) {
                base[i] = (4 * s[i] - before[i]) / 3;
            }
            double b = goesOn ? factor * deltaT : deltaT;
            source.incTime(deltaT);
            double[] next = newton(x -> plus(plus(x, -1, base), -b, slopeAt(source, x)), s, 1e-12, 100);
            source.setState(next);
            last = source;
            time = source.getTime();
            length = deltaT;
            before = s;
            now = next.clone();
        }

        @Override
        public void reset() {
            last = null;
        }
    }
}
