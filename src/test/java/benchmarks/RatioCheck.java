package benchmarks;

import com.sun.management.OperatingSystemMXBean;
import java.io.PrintStream;
import java.lang.management.ManagementFactory;
import java.lang.management.ThreadMXBean;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.function.LongSupplier;
import particles.ParticleSystem;
import particles.engine.ForceSum;
import particles.engine.ParallelForces;

/**
 * {@code gradle benchmark -Pcheck=true}: compares the slides' solvers with loops written by hand, {@link ByHand}, in
 * one process in which all have run, and fails if one has become slower than its figure by more than 15 %.
 */
final class RatioCheck {
    /** A ratio may exceed its figure by this factor. */
    private static final double SLACK = 1.15;
    /**
     * Time over that of the loop by hand: medians of ten runs on a server with two cores that other programs kept busy.
     * Runs differ by up to 10 %, as the compiler is luckier in some. In a chain of 100 particles, what a step costs
     * beside its evaluations counts.
     */
    private static final List<Row> ROWS = List.of(
            new Row("chain", "rk4", 1.12), new Row("chain", "midpoint", 1.31), new Row("chain", "euler", 1.32),
            new Row("chain", "symplectic-euler", 1.18),
            new Row("cloth-64", "rk4", 0.94), new Row("cloth-64", "midpoint", 0.97),
            new Row("cloth-64", "euler", 0.96), new Row("cloth-64", "symplectic-euler", 0.95));
    /** Two threads' time over one thread's, rk4 on a cloth of 64 x 64. */
    private static final double TWO_THREADS = 0.6;
    private static final int PAIRS = 60;
    /** A slow ratio is measured on: other work on the machine can slow all blocks so far, and a loss slows all. */
    private static final int MOST_PAIRS = 600;
    /** Short, so that many blocks are not interrupted (ns). */
    private static final long BLOCK = 2_000_000;
    private static final long WARM_UP = 400_000_000;
    private static final long LONGEST = 15_000_000_000L;
    /** With more than this, two threads seldom run at once, and their time says nothing (processors). */
    private static final double MOST_BUSY = 0.2;
    private static final OperatingSystemMXBean MACHINE = ManagementFactory.getPlatformMXBean(
            OperatingSystemMXBean.class);
    private static final ThreadMXBean CPU = ManagementFactory.getThreadMXBean();

    private RatioCheck() {
    }

    /** A ratio to be held. */
    private record Row(String workload, String method, double figure) {
        double limit() {
            return SLACK * figure;
        }
    }

    /** A method on a workload of its own, in blocks of solutions that take about equally long. */
    private static final class Timed {
        private final Workload workload;
        private final Method method;
        private int solutions = 1;

        Timed(String workload, String method, int steps) {
            this.workload = Workload.of(workload);
            this.method = Method.withSteps(method, this.workload, steps * this.workload.deltaT(), steps);
        }

        static Timed of(Row row, String suffix) {
            return new Timed(row.workload, row.method + suffix, row.workload.equals("chain") ? 64 : 4);
        }

        void warmUp() {
            for (long used = 0, time; used < WARM_UP; used += time) {
                time = time(CPU::getCurrentThreadCpuTime);
                solutions = (int) Math.max(1, solutions * BLOCK / Math.max(time, BLOCK / 8));
            }
        }

        long time(LongSupplier clock) {
            long start = clock.getAsLong();
            for (int n = 0; n < solutions; n++) {
                method.solve(workload);
            }
            return clock.getAsLong() - start;
        }

        double timePerSolution() {
            return time(CPU::getCurrentThreadCpuTime) / (double) solutions;
        }
    }

    /** A row's two contestants. */
    private record Pair(Row row, Timed ours, Timed byHand) {
        /** The fastest block of each, of pairs back to back: other work makes blocks slower, never faster. */
        double ratio() {
            double fastest = Double.POSITIVE_INFINITY;
            double hand = Double.POSITIVE_INFINITY;
            for (int n = 0; n < PAIRS || n < MOST_PAIRS && fastest > row.limit() * hand; n++) {
                hand = Math.min(hand, byHand.timePerSolution());
                fastest = Math.min(fastest, ours.timePerSolution());
            }
            return fastest / hand;
        }
    }

    /** @return whether all ratios are within their limits */
    static boolean run(PrintStream out) {
        List<Pair> pairs = new ArrayList<>();
        for (Row row : ROWS) {
            pairs.add(new Pair(row, Timed.of(row, ""), Timed.of(row, ByHand.SUFFIX)));
        }
        pairs.forEach(pair -> {
            pair.ours.warmUp();
            pair.byHand.warmUp();
        });
        out.println("CPU time over that of a loop by hand (limit):");
        boolean good = true;
        for (Pair pair : pairs) {
            good &= report(out, pair.row.workload + ", " + pair.row.method, pair.ratio(), pair.row.limit());
        }
        if (Runtime.getRuntime().availableProcessors() < 2) {
            out.println("two threads: not measured on one processor");
            return good;
        }
        out.println("two threads' time over one thread's (limit):");
        busyElsewhere();
        double ratio = twoThreads();
        double busy = busyElsewhere();
        if (ratio > SLACK * TWO_THREADS && busy > MOST_BUSY) {
            out.printf(Locale.ROOT, "cloth-64, rk4               %.2f, not judged: other programs kept %.1f processors"
                    + " busy%n", ratio, busy);
            return good;
        }
        return report(out, "cloth-64, rk4", ratio, SLACK * TWO_THREADS) && good;
    }

    /** How many processors other programs kept busy since the last call. */
    private static double busyElsewhere() {
        return (MACHINE.getCpuLoad() - MACHINE.getProcessCpuLoad()) * MACHINE.getAvailableProcessors();
    }

    private static boolean report(PrintStream out, String name, double ratio, double limit) {
        out.printf(Locale.ROOT, "%-27s %.2f (%.2f)%s%n", name, ratio, limit, ratio <= limit ? "" : "   too slow");
        return ratio <= limit;
    }

    /**
     * The fastest step of each, of as many as it takes to be within the limit: beside other work, two threads seldom
     * run at once.
     */
    private static double twoThreads() {
        Timed one = new Timed("cloth-64", "rk4", 1);
        Timed two = new Timed("cloth-64", "rk4", 1);
        ForceSum forces = ((ParticleSystem) two.workload.source()).getForceSum();
        long start = System.nanoTime();
        long fastest = Long.MAX_VALUE;
        long fastestOfTwo = Long.MAX_VALUE;
        for (int n = 0; n < 200 || fastestOfTwo > SLACK * TWO_THREADS * fastest; n++) {
            for (int k = 0; k < 8; k++) {
                fastest = Math.min(fastest, one.time(System::nanoTime));
            }
            ParallelForces.use(forces, 2);              // forgets delays, after which one thread works alone
            for (int k = 0; k < 8; k++) {
                fastestOfTwo = Math.min(fastestOfTwo, two.time(System::nanoTime));
            }
            if (System.nanoTime() - start > LONGEST) {
                break;
            }
        }
        return fastestOfTwo / (double) fastest;
    }
}
