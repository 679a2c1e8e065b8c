package benchmarks;

import deSolvers.DESolver;
import deSolvers.RK4Solver;
import deSolvers.implicit.BackwardEulerSolver;
import deSolvers.implicit.ImplicitWork;
import deSolvers.implicit.LinearisedEulerSolver;
import hunts.TaskOptions;
import java.io.PrintStream;
import java.lang.management.ManagementFactory;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.function.ToDoubleFunction;
import particles.Cloth;
import particles.ParticleSystem;
import particles.effects.springs.SpringForce;

/**
 * Compares an implicit with an explicit solver on one frame (1/60 s) of a cloth of 64 x 64 particles with ever stiffer
 * springs. RK4 has to take steps of 2.8284/omega, where omega is the fastest vibration of the cloth, found by power
 * iteration; backward Euler takes one step.
 */
final class StiffCloth {
    static final double FRAME = 1.0 / 60;
    private static final int EDGE = 64;
    private static final double MASS = 0.01;
    private static final double RK4_LIMIT = 2.8284;
    /** The number of RK4 steps that are timed; all cost the same. */
    private static final int TIMED = 40;
    /** The number of solvers whose first and further steps are timed; medians are used. */
    private static final int SOLVERS = 5;
    private static final int FURTHER = 3;
    /** The numbers of RK4 steps at which Newton's method is timed too; at 100 it does not converge. */
    private static final List<Long> NEWTON = List.of(1L, 10L);

    /**
     * The cost of a frame.
     *
     * @param stiffness  of every spring (N/m)
     * @param rk4Steps   that RK4 needs to be stable
     * @param rk4        time of these (s)
     * @param first      median time of first steps of backward Euler with one linear solve, which include the symbolic
     *                   factorisation (s)
     * @param linearised median time of further such steps (s)
     * @param newton     time of a step iterated to tolerance (s); NaN if not measured
     * @param work       the work of the linearised step
     */
    record Row(double stiffness, long rk4Steps, double rk4, double first, double linearised, double newton,
            ImplicitWork work) {
    }

    private StiffCloth() {
    }

    /** The steps that RK4 needs for a frame of a cloth with this stiffness. */
    static long rk4Steps(double stiffness) {
        return (long) StrictMath.ceil(FRAME * fastest(stiffness) / RK4_LIMIT);
    }

    /** The stiffness for which RK4 needs that many steps: omega grows with its root. */
    static double stiffnessFor(long steps) {
        double ratio = (steps - 0.01) * RK4_LIMIT / FRAME / fastest(1);
        return ratio * ratio;
    }

    /** omega of the fastest vibration (1/s): the root of the largest eigenvalue of -M^-1 dF/dx. */
    private static double fastest(double stiffness) {
        ParticleSystem cloth = Cloth.hanging(EDGE, stiffness, 0);
        int n = cloth.getStateSize();
        double[] direction = new double[n];
        double[] product = new double[n];
        for (int x = 0; x < n; x++) {
            direction[x] = x % 6 < 3 ? (x * 7919 % 101) - 50 : 0;
        }
        double eigenvalue = 0;
        for (int i = 0; i < 200; i++) {                 // converges to 1 %, enough to count steps
            double length = 0;
            for (double value : direction) {
                length += value * value;
            }
            length = Math.sqrt(length);
            for (int x = 0; x < n; x++) {
                direction[x] /= length;
            }
            cloth.getJacobianProduct(direction, product);
            eigenvalue = 0;
            for (int x = 0; x < n; x += 6) {
                for (int c = x; c < x + 3; c++) {
                    eigenvalue -= direction[c] * product[c + 3];
                    direction[c] = -product[c + 3];
                }
            }
        }
        return Math.sqrt(eigenvalue);
    }

    static ImplicitWork linearisedWork(double stiffness) {
        LinearisedEulerSolver solver = new LinearisedEulerSolver();
        solver.stepState(Cloth.hanging(EDGE, stiffness, 0), FRAME);
        return solver.getWork();
    }

    private static double seconds(DESolver solver, ParticleSystem system, double deltaT, int steps) {
        long before = ManagementFactory.getThreadMXBean().getCurrentThreadCpuTime();
        for (int i = 0; i < steps; i++) {
            solver.stepState(system, deltaT);
        }
        return (ManagementFactory.getThreadMXBean().getCurrentThreadCpuTime() - before) * 1e-9;
    }

    private static Row measure(double stiffness) {
        long steps = rk4Steps(stiffness);
        double rk4 = seconds(new RK4Solver(), Cloth.hanging(EDGE, stiffness, 0), FRAME / steps, TIMED) / TIMED * steps;
        double[] first = new double[SOLVERS];
        double[] further = new double[SOLVERS * FURTHER];
        ImplicitWork work = null;
        for (int i = 0; i < further.length; i += FURTHER) {
            LinearisedEulerSolver linearised = new LinearisedEulerSolver();
            first[i / FURTHER] = seconds(linearised, Cloth.hanging(EDGE, stiffness, 0), FRAME, 1);
            work = linearised.getWork();
            for (int j = i; j < i + FURTHER; j++) {
                further[j] = seconds(linearised, Cloth.hanging(EDGE, stiffness, 0), FRAME, 1);
            }
        }
        double newton = !NEWTON.contains(steps) ? Double.NaN
                : seconds(new BackwardEulerSolver(), Cloth.hanging(EDGE, stiffness, 0), FRAME, 1);
        return new Row(stiffness, steps, rk4, median(first), median(further), newton, work);
    }

    private static double median(double[] times) {
        Arrays.sort(times);
        return times[times.length / 2];
    }

    /** Prints the sweep, the stiffest cloth last. */
    static void print(PrintStream out, long[] rk4Steps) {
        for (int i = 0; i < 3; i++) {                   // warm-up
            measure(stiffnessFor(2));
            measure(stiffnessFor(100));
        }
        ParticleSystem cloth = Cloth.hanging(EDGE, 1, 0);
        out.printf(Locale.ROOT, "%nA frame of 1/60 s of a cloth of %d x %d particles of %s g, %d springs: CPU time%n",
                EDGE,
                EDGE, 1000 * MASS, ((SpringForce) cloth.getEffects().get(1)).springCount());
        out.println("stiffness (N/m)  rk4 steps    rk4 (s)  first step (s)  further ones (s)  Newton (s)  rk4/further"
                + " ones  CG iterations");
        List<Row> rows = new ArrayList<>();
        for (long steps : rk4Steps) {
            Row row = measure(stiffnessFor(steps));
            out.printf(Locale.ROOT, "%15.3g  %9d  %9.4f  %14.4f  %16.4f  %10s  %16.2f  %13d%n", row.stiffness,
                    row.rk4Steps,
                    row.rk4, row.first, row.linearised,
                    Double.isNaN(row.newton) ? "-" : String.format(Locale.ROOT, "%.4f", row.newton),
                    row.rk4 / row.linearised, row.work.krylovIterations());
            rows.add(row);
        }
        out.printf(Locale.ROOT, "From %d to %d steps of rk4 the time of a linearised step varies %.1f times, that of a"
                + " solver's first one %.1f times.%n", rk4Steps[0], rk4Steps[rk4Steps.length - 1],
                variation(rows, Row::linearised), variation(rows, Row::first));
    }

    private static double variation(List<Row> rows, ToDoubleFunction<Row> time) {
        return rows.stream().mapToDouble(time).max().orElseThrow() / rows.stream().mapToDouble(time).min()
                .orElseThrow();
    }

    /** @param args none; the build hands options on, and there are none */
    public static void main(String[] args) {
        try {
            new TaskOptions(args, List.of());
        } catch (IllegalArgumentException e) {
            System.err.println(e.getMessage());
            System.exit(2);
        }
        print(System.out, new long[] {1, 2, 3, 5, 6, 7, 10, 20, 50, 100, 200, 500, 1000, 2000, 5000});
    }
}
