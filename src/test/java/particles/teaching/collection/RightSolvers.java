package particles.teaching.collection;

import static particles.teaching.collection.Pieces.drifts;
import static particles.teaching.collection.Pieces.implicit;
import static particles.teaching.collection.Pieces.iterated;
import static particles.teaching.collection.Pieces.leapfrog;
import static particles.teaching.collection.Pieces.newton;
import static particles.teaching.collection.Pieces.plus;
import static particles.teaching.collection.Pieces.rungeKutta;
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

/** Right solvers in the styles that students write. */
final class RightSolvers {
    static final String DOPRI = "1/5; 3/40 9/40; 44/45 -56/15 32/9; 19372/6561 -25360/2187 64448/6561 -212/729;"
            + " 9017/3168 -355/33 46732/5247 49/176 -5103/18656; 35/384 0 500/1113 125/192 -2187/6784 11/84";
    static final String DOPRI5 = "35/384 0 500/1113 125/192 -2187/6784 11/84 0";
    static final String DOPRI4 = "5179/57600 0 7571/16695 393/640 -92097/339200 187/2100 1/40";
    static final String FEHLBERG = "1/4; 3/32 9/32; 1932/2197 -7200/2197 7296/2197; 439/216 -8 3680/513 -845/4104;"
            + " -8/27 2 -3544/2565 1859/4104 -11/40";
    static final String FEHLBERG5 = "16/135 0 6656/12825 28561/56430 -9/50 2/55";
    static final String FEHLBERG4 = "25/216 0 1408/2565 2197/4104 -1/5 0";
    static final String CASH_KARP = "1/5; 3/40 9/40; 3/10 -9/10 6/5; -11/54 5/2 -70/27 35/27;"
            + " 1631/55296 175/512 575/13824 44275/110592 253/4096";
    static final String CASH_KARP5 = "37/378 0 250/621 125/594 0 512/1771";
    static final String CASH_KARP4 = "2825/27648 0 18575/48384 13525/55296 277/14336 1/4";
    static final String RK4 = "1/2; 0 1/2; 0 0 1";
    static final String RK4_WEIGHTS = "1/6 1/3 1/3 1/6";
    static final double W = 1 / (2 - Math.cbrt(2));

    private RightSolvers() {
    }

    static List<Specimen> all() {
        return List.of(
                right("EulerSolver", "Euler", rungeKutta("", "1", "")),
                right("Solver1", "Euler in plain loops", RightSolvers::euler),
                right("MidpointSolver", "midpoint", rungeKutta("1/2", "0 1", "")),
                right("RK2Solver", "midpoint as RK2", rungeKutta("1/2", "0 1", "")),
                right("RungeKutta2Solver", "Heun as order 2", rungeKutta("1", "1/2 1/2", "")),
                right("HeunSolver", "Heun", rungeKutta("1", "1/2 1/2", "")),
                right("ModifiedEulerSolver", "Heun by another name", rungeKutta("1", "1/2 1/2", "")),
                right("ImprovedEuler", "midpoint by another name", rungeKutta("1/2", "0 1", "")),
                right("ExplicitTrapezoid", "Heun by a third name", rungeKutta("1", "1/2 1/2", "")),
                right("RalstonSolver", "Ralston", rungeKutta("2/3", "1/4 3/4", "")),
                right("RungeKutta3Solver", "Heun's method of order 3", rungeKutta("1/3; 0 2/3", "1/4 0 3/4", "")),
                right("RK3Solver", "Ralston of order 3", rungeKutta("1/2; 0 3/4", "2/9 1/3 4/9", "")),
                right("MySolver", "Kutta of order 3", rungeKutta("1/2; -1 2", "1/6 2/3 1/6", "")),
                right("SSPRK3Solver", "Shu and Osher", rungeKutta("1; 1/4 1/4", "1/6 1/6 2/3", "")),
                right("SSPRK2", "Shu and Osher, two stages", rungeKutta("1", "1/2 1/2", "")),
                right("ShuOsher", "Shu and Osher as mixtures", RightSolvers::shuOsher),
                right("RK4Solver", "RK4", rungeKutta(RK4, RK4_WEIGHTS, "")),
                right("RungeKuttaSolver", "RK4 on FixedStepSolver", OnFixedStep::new),
                right("Kutta", "RK4 with work arrays", WorkArrays::new),
                right("RungeKutta38Solver", "the 3/8 rule", rungeKutta("1/3; -1/3 1; 1 -1 1", "1/8 3/8 3/8 1/8", "")),
                right("RungeKutta4", "the 3/8 rule as order 4", rungeKutta("1/3; -1/3 1; 1 -1 1", "1/8 3/8 3/8 1/8",
                "")),
                right("GillSolver", "Gill", rungeKutta("1/2; " + (Math.sqrt(0.5) - 0.5) + " " + (1 - Math.sqrt(0.5))
                + "; 0 "
                        + -Math.sqrt(0.5) + " " + (1 + Math.sqrt(0.5)),
                        "1/6 " + (2 - Math.sqrt(2)) / 6 + " " + (2 + Math.sqrt(2)) / 6 + " 1/6", "")),
                right("RungeKuttaFehlbergSolver", "order 5", rungeKutta(FEHLBERG, FEHLBERG5, "")),
                right("RKF45Solver", "order 4", rungeKutta(FEHLBERG, FEHLBERG4, "")),
                right("DormandPrinceSolver", "fixed steps", rungeKutta(DOPRI, DOPRI5, "")),
                right("CashKarpSolver", "fixed steps", rungeKutta(CASH_KARP, CASH_KARP5, "")),
                right("BogackiShampine", "fixed steps", rungeKutta("1/2; 0 3/4; 2/9 1/3 4/9", "2/9 1/3 4/9 0", "")),
                right("SmallEuler", "ten Euler steps", (source, deltaT) -> {
                    for (int i = 0; i < 10; i++) {
                        euler(source, deltaT / 10);
                    }
                }),
                right("RichardsonEuler", "extrapolated Euler", RightSolvers::richardson),
                right("GraggSolver", "extrapolated midpoint", RightSolvers::gragg),
                right("DopriAdaptive", "1e-6", () -> new Adaptive(DOPRI, DOPRI5, DOPRI4, 1e-6, 5, true)),
                right("DormandPrince45", "1e-3, loops at NaN", () -> new Adaptive(DOPRI, DOPRI5, DOPRI4, 1e-3, 5,
                false)),
                right("AdaptiveFehlberg", "1e-8", () -> new Adaptive(FEHLBERG, FEHLBERG4, FEHLBERG5, 1e-8, 5, true)),
                right("CashKarp", "1e-5, loops at NaN", () -> new Adaptive(CASH_KARP, CASH_KARP5, CASH_KARP4, 1e-5, 5,
                false)),
                right("HeunEuler", "pair of orders 2 and 1", () -> new Adaptive("1", "1/2 1/2", "1 0", 1e-4, 2, true)),
                right("StepDoubling", "RK4 against two half steps", RightSolvers::stepDoubling),
                right("SymplecticEulerSolver", "kick, drift", (source, deltaT) -> {
                    double[] s = state(source);
                    Pieces.kick(source, s, deltaT);
                    Pieces.drift(source, s, deltaT);
                }),
                right("SemiImplicitEuler", "drift, kick", drifts(new double[] {1, 0}, new double[] {1})),
                right("EulerCromer", "from the derivative's halves", RightSolvers::cromer),
                right("VelocityVerletSolver", "kick, drift, kick", (source, deltaT) -> leapfrog(source, deltaT)),
                right("LeapfrogSolver", "drift, kick, drift", drifts(new double[] {0.5, 0.5}, new double[] {1})),
                right("VerletSolver", "x first, then both accelerations", RightSolvers::verlet),
                right("StoermerVerlet", "drift, kick, drift", drifts(new double[] {0.5, 0.5}, new double[] {1})),
                right("Yoshida4Solver", "three leapfrogs", RightSolvers::threeLeapfrogs),
                right("Yoshida", "four drifts", drifts(new double[] {W / 2, (1 - W) / 2, (1 - W) / 2, W / 2},
                        new double[] {W, 1 - 2 * W, W})),
                right("ForestRuth", "three leapfrogs", RightSolvers::threeLeapfrogs),
                right("Ruth3Solver", "Ruth of order 3", drifts(new double[] {1, -2.0 / 3, 2.0 / 3},
                        new double[] {-1.0 / 24, 3.0 / 4, 7.0 / 24})),
                right("Pefrl", "Omelyan, order 4", RightSolvers::pefrl),
                right("NystromSolver", "Nystrom of order 4", RightSolvers::nystrom),
                right("BackwardEulerSolver", "Newton", implicit(0, 1, 1, 1, 1e-10, 50)),
                right("ImplicitEuler", "simple iteration", iterated(0, 1, 1, 1, 1e-12, 500)),
                right("ImplicitMidpointSolver", "Newton", implicit(0, 1, 0.5, 0.5, 1e-10, 50)),
                right("TrapezoidalRule", "Newton", implicit(0.5, 0.5, 1, 1, 1e-9, 50)),
                right("CrankNicolson", "simple iteration", iterated(0.5, 0.5, 1, 1, 1e-12, 500)),
                right("ThetaMethod", "0.6 at the end", implicit(0.4, 0.6, 1, 1, 1e-10, 50)),
                right("RadauSolver", "Radau IIA of order 3", RightSolvers::radau3),
                right("SDIRK2", "two stages", RightSolvers::sdirk),
                right("RosenbrockEuler", "one Newton step", RightSolvers::rosenbrock),
                right("AdamsBashforth2", "Euler at first", () -> new Adams(2, 1, false)),
                right("AB3Solver", "RK4 at first", () -> new Adams(3, 4, false)),
                right("AdamsBashforth4Solver", "RK4 at first", () -> new Adams(4, 4, false)),
                right("PredictorCorrector", "Adams-Moulton, RK4 at first", () -> new Adams(4, 4, true)),
                right("CarefulRK4", "refuses negative steps", (source, deltaT) -> {
                    if (deltaT < 0) {
                        throw new IllegalArgumentException("deltaT must not be negative: " + deltaT);
                    }
                    rungeKutta(RK4, RK4_WEIGHTS, "").make(source, deltaT);
                }),
                right("OwnException", "refuses NaN", (source, deltaT) -> {
                    for (double x : slope(source)) {
                        if (Double.isNaN(x)) {
                            throw new IllegalStateException("blow-up");
                        }
                    }
                    euler(source, deltaT);
                }),
                right("ParticleVerlet", "second order only", (source, deltaT) -> {
                    SecondOrderStateSource particles = (SecondOrderStateSource) source;
                    if (particles.getDimension() < 1) {
                        throw new IllegalArgumentException("no positions");
                    }
                    leapfrog(source, deltaT);
                }),
                right("Leapfrog", "refuses other sources", (source, deltaT) -> {
                    if (!(source instanceof SecondOrderStateSource)) {
                        throw new UnsupportedOperationException("positions and velocities are needed");
                    }
                    leapfrog(source, deltaT);
                }),
                right("LowStorage", "Williamson's two arrays", RightSolvers::williamson),
                right("FsalSolver", "Bogacki-Shampine that keeps a derivative", Fsal::new));
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

    private static void shuOsher(DEStateSource source, double h) {
        double[] s = state(source);
        double[] one = plus(s, h, slope(source));
        source.incTime(h);
        double[] two = plus(one, h, slopeAt(source, one));
        source.incTime(-h / 2);
        double[] middle = with(0.75, s, 0.25, two);
        double[] three = plus(middle, h, slopeAt(source, middle));
        source.setState(with(1.0 / 3, s, 2.0 / 3, three));
        source.incTime(h / 2);
    }

    private static double[] with(double a, double[] x, double b, double[] y) {
        double[] sum = new double[x.length];
        Arrays.setAll(sum, i -> a * x[i] + b * y[i]);
        return sum;
    }

    private static void richardson(DEStateSource source, double h) {
        double[] s = state(source);
        double[] k = slope(source);
        double[] long1 = plus(s, h, k);
        source.incTime(h / 2);
        double[] half = plus(s, h / 2, k);
        double[] short2 = plus(half, h / 2, slopeAt(source, half));
        source.setState(with(2, short2, -1, long1));
        source.incTime(h / 2);
    }

    private static double[] modifiedMidpoint(DEStateSource source, double[] s, double t, double h, int n) {
        double step = h / n;
        source.incTime(t - source.getTime());
        double[] before = s;
        double[] now = plus(s, step, slopeAt(source, s));
        for (int i = 1; i < n; i++) {
            source.incTime(t + i * step - source.getTime());
            double[] next = plus(before, 2 * step, slopeAt(source, now));
            before = now;
            now = next;
        }
        source.incTime(t + h - source.getTime());
        return with(0.5, plus(before, step, slopeAt(source, now)), 0.5, now);
    }

    private static void gragg(DEStateSource source, double h) {
        double t = source.getTime();
        double[] s = state(source);
        double[] two = modifiedMidpoint(source, s, t, h, 2);
        double[] four = modifiedMidpoint(source, s, t, h, 4);
        source.setState(with(4.0 / 3, four, -1.0 / 3, two));
    }

    private static void stepDoubling(DEStateSource source, double deltaT) {
        double end = source.getTime() + deltaT;
        double done = 0;
        double h = deltaT;
        while (Math.abs(done) < Math.abs(deltaT)) {
            double t = source.getTime();
            double[] s = state(source);
            rungeKutta(RK4, RK4_WEIGHTS, "").make(source, h);
            double[] once = state(source);
            source.setState(s);
            source.incTime(t - source.getTime());
            rungeKutta(RK4, RK4_WEIGHTS, "").make(source, h / 2);
            rungeKutta(RK4, RK4_WEIGHTS, "").make(source, h / 2);
            double error = Pieces.norm(plus(state(source), -1, once));
            if (error > 1e-7) {
                source.setState(s);
                source.incTime(t - source.getTime());
            } else {
                if (Double.isNaN(state(source)[0])) {
                    throw new IllegalStateException("the state is NaN");
                }
                done += h;
            }
            h = (error > 1e-7 ? 0.5 : 1) * h;
            h = Math.abs(h) > Math.abs(deltaT - done) ? deltaT - done : h;
        }
        source.incTime(end - source.getTime());
    }

    private static void cromer(DEStateSource source, double deltaT) {
        double[] s = state(source);
        double[] dSdt = slope(source);
        for (int i = 0; i < s.length; i++) {
            s[i] += i % 6 > 2 ? dSdt[i] * deltaT : 0;
        }
        for (int i = 0; i < s.length; i++) {
            s[i] += i % 6 < 3 ? s[i + 3] * deltaT : 0;
        }
        source.setState(s);
        source.incTime(deltaT);
    }

    private static void verlet(DEStateSource source, double h) {
        double[] s = state(source);
        double[] old = slope(source);
        for (int i = 0; i < s.length; i += i % 6 == 2 ? 4 : 1) {
            s[i] += h * s[i + 3] + h * h / 2 * old[i + 3];
        }
        source.incTime(h);
        double[] now = slopeAt(source, s);
        for (int i = 3; i < s.length; i += i % 6 == 5 ? 4 : 1) {
            s[i] += h / 2 * (old[i] + now[i]);
        }
        source.setState(s);
    }

    private static void threeLeapfrogs(DEStateSource source, double h) {
        leapfrog(source, W * h);
        leapfrog(source, (1 - 2 * W) * h);
        leapfrog(source, W * h);
    }

    private static void pefrl(DEStateSource source, double h) {
        double xi = 0.1786178958448091;
        double lambda = -0.2123418310626054;
        double chi = -0.6626458266981849e-1;
        drifts(new double[] {xi, chi, 1 - 2 * (chi + xi), chi, xi},
                new double[] {(1 - 2 * lambda) / 2, lambda, lambda, (1 - 2 * lambda) / 2}).make(source, h);
    }

    private static void nystrom(DEStateSource source, double h) {
        double t = source.getTime();
        double[] s = state(source);
        double[] k1 = slope(source);
        double[] middle = s.clone();
        double[] end = s.clone();
        double[] next = s.clone();
        for (int i = 0; i < s.length; i += i % 6 == 2 ? 4 : 1) {
            middle[i] += h / 2 * s[i + 3] + h * h / 8 * k1[i + 3];
        }
        source.incTime(h / 2);
        double[] k2 = slopeAt(source, middle);
        for (int i = 0; i < s.length; i += i % 6 == 2 ? 4 : 1) {
            end[i] += h * s[i + 3] + h * h / 2 * k2[i + 3];
        }
        source.incTime(h / 2);
        double[] k3 = slopeAt(source, end);
        for (int i = 0; i < s.length; i += i % 6 == 2 ? 4 : 1) {
            next[i] += h * s[i + 3] + h * h / 6 * (k1[i + 3] + 2 * k2[i + 3]);
            next[i + 3] += h / 6 * (k1[i + 3] + 4 * k2[i + 3] + k3[i + 3]);
        }
        source.setState(next);
        source.incTime(t + h - source.getTime());
    }

    private static void radau3(DEStateSource source, double h) {
        double t = source.getTime();
        double[] s = state(source);
        int n = s.length;
        double[] both = newton(u -> {
            double[] one = Arrays.copyOf(u, n);
            double[] two = Arrays.copyOfRange(u, n, 2 * n);
            source.incTime(t + h / 3 - source.getTime());
            double[] f1 = slopeAt(source, one);
            source.incTime(t + h - source.getTime());
            double[] f2 = slopeAt(source, two);
            double[] r = new double[2 * n];
            for (int i = 0; i < n; i++) {
                r[i] = one[i] - s[i] - h * (5.0 / 12 * f1[i] - 1.0 / 12 * f2[i]);
                r[n + i] = two[i] - s[i] - h * (3.0 / 4 * f1[i] + 1.0 / 4 * f2[i]);
            }
            return r;
        }, twice(s), 1e-10, 50);
        source.setState(Arrays.copyOfRange(both, n, 2 * n));
        source.incTime(t + h - source.getTime());
    }

    private static double[] twice(double[] s) {
        double[] both = Arrays.copyOf(s, 2 * s.length);
        System.arraycopy(s, 0, both, s.length, s.length);
        return both;
    }

    private static void sdirk(DEStateSource source, double h) {
        double gamma = 1 - Math.sqrt(0.5);
        double t = source.getTime();
        double[] s = state(source);
        source.incTime(gamma * h);
        double[] k1 = newton(k -> plus(k, -1, slopeAt(source, plus(s, gamma * h, k))), new double[s.length], 1e-11, 50);
        double[] second = plus(s, (1 - gamma) * h, k1);
        source.incTime(t + h - source.getTime());
        double[] k2 = newton(k -> plus(k, -1, slopeAt(source, plus(second, gamma * h, k))), k1, 1e-11, 50);
        source.setState(plus(second, gamma * h, k2));
    }

    private static void rosenbrock(DEStateSource source, double h) {
        double[] s = state(source);
        double[] f = slope(source);
        double[][] m = new double[s.length][s.length + 1];
        for (int j = 0; j < s.length; j++) {
            double[] moved = s.clone();
            moved[j] += 1e-6;
            double[] there = slopeAt(source, moved);
            for (int i = 0; i < s.length; i++) {
                m[i][j] = (i == j ? 1 : 0) - h * (there[i] - f[i]) / 1e-6;
            }
        }
        for (int i = 0; i < s.length; i++) {
            m[i][s.length] = h * f[i];
        }
        source.setState(plus(s, 1, Pieces.eliminate(m)));
        source.incTime(h);
    }

    private static void williamson(DEStateSource source, double h) {
        double[] a = {0, -5.0 / 9, -153.0 / 128};
        double[] b = {1.0 / 3, 15.0 / 16, 8.0 / 15};
        double[] c = {1.0 / 3, 3.0 / 4, 1};
        double t = source.getTime();
        double[] s = state(source);
        double[] q = new double[s.length];
        for (int i = 0; i < 3; i++) {
            double[] f = slope(source);
            for (int j = 0; j < s.length; j++) {
                q[j] = a[i] * q[j] + h * f[j];
                s[j] += b[i] * q[j];
            }
            source.setState(s);
            source.incTime(t + c[i] * h - source.getTime());
        }
    }

    private static final class OnFixedStep extends FixedStepSolver {
        @Override
        protected void step(DEStateSource source, double[] s, double deltaT) {
            double[] k1 = eulerStep(s, deltaT);
            source.incTime(deltaT / 2);
            double[] k2 = eulerStep(plus(s, 0.5, k1), deltaT);
            double[] k3 = eulerStep(plus(s, 0.5, k2), deltaT);
            source.incTime(deltaT / 2);
            double[] k4 = eulerStep(plus(s, 1, k3), deltaT);
            for (int i = 0; i < s.length; i++) {
                s[i] += (k1[i] + 2 * k2[i] + 2 * k3[i] + k4[i]) / 6;
            }
        }
    }

    private static final class WorkArrays extends DESolver {
        private double[] s = {};
        private double[] trial = {};
        private double[] k = {};
        private double[] sum = {};

        @Override
        public void stepState(DEStateSource source, double h) {
            if (s.length != source.getStateSize()) {
                s = new double[source.getStateSize()];
                trial = new double[s.length];
                k = new double[s.length];
                sum = new double[s.length];
            }
            source.getState(s);
            Arrays.fill(sum, 0);
            stage(source, 0, h / 6);
            source.incTime(h / 2);
            stage(source, h / 2, h / 3);
            stage(source, h / 2, h / 3);
            source.incTime(h / 2);
            stage(source, h, h / 6);
            for (int i = 0; i < s.length; i++) {
                s[i] += sum[i];
            }
            source.setState(s);
        }

        private void stage(DEStateSource source, double place, double weight) {
            for (int i = 0; i < s.length; i++) {
                trial[i] = place == 0 ? s[i] : s[i] + place * k[i];
            }
            source.setState(trial);
            source.getStateDerivative(k);
            for (int i = 0; i < s.length; i++) {
                sum[i] += weight * k[i];
            }
        }
    }

    /** Adams-Bashforth, alone or as predictor, which begins again whenever it does not go on from its own last step. */
    static class Adams extends DESolver {
        private static final double[][] BASHFORTH = {{1}, {1.5, -0.5}, {23.0 / 12, -16.0 / 12, 5.0 / 12},
            {55.0 / 24, -59.0 / 24, 37.0 / 24, -9.0 / 24}};
        private static final double[] MOULTON = {9.0 / 24, 19.0 / 24, -5.0 / 24, 1.0 / 24};
        private final int steps;
        private final int begins;
        private final boolean corrects;
        private DEStateSource last;
        private double[] left = {};
        private double[][] before = new double[4][];
        private double time;
        private double length;
        private int known;

        Adams(int steps, int begins, boolean corrects) {
            this.steps = steps;
            this.begins = begins;
            this.corrects = corrects;
        }

        boolean goesOn(DEStateSource source, double deltaT) {
            return length == deltaT && goesOnWithAnyDeltaT(source);
        }

        final boolean goesOnWithAnyDeltaT(DEStateSource source) {
            return source == last && time == source.getTime() && Arrays.equals(left, state(source));
        }

        double[] weights(double[] all) {
            return all;
        }

        @Override
        public void stepState(DEStateSource source, double deltaT) {
            if (!goesOn(source, deltaT)) {
                known = 0;
            }
            double[] s = state(source);
            before[3] = before[2];
            before[2] = before[1];
            before[1] = before[0];
            before[0] = slope(source);
            known = Math.min(steps, known + 1);
            if (known < steps) {
                if (begins == 1) {
                    euler(source, deltaT);
                } else {
                    rungeKutta(RK4, RK4_WEIGHTS, "").make(source, deltaT);
                }
            } else {
                double[] weights = weights(BASHFORTH[steps - 1]);
                double[] next = s;
                for (int j = 0; j < steps; j++) {
                    next = plus(next, deltaT * weights[j], before[j]);
                }
                source.setState(next);
                source.incTime(deltaT);
                if (corrects) {
                    next = plus(s, deltaT * MOULTON[0], slope(source));
                    for (int j = 1; j < steps; j++) {
                        next = plus(next, deltaT * MOULTON[j], before[j - 1]);
                    }
                    source.setState(next);
                }
            }
            last = source;
            left = state(source);
            time = source.getTime();
            length = deltaT;
        }

        @Override
        public void reset() {
            last = null;
        }
    }

    private static final class Fsal extends DESolver {
        private DEStateSource last;
        private double[] left = {};
        private double[] kept = {};
        private double time;

        @Override
        public void stepState(DEStateSource source, double h) {
            double[] s = state(source);
            boolean mine = source == last && time == source.getTime() && Arrays.equals(s, left);
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
}
