package benchmarks;

import java.io.PrintStream;
import java.lang.management.ManagementFactory;
import java.lang.management.ThreadMXBean;
import java.util.ArrayList;
import java.util.Arrays;
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
     * Time over that of the loop by hand: measured in three runs on a server with two cores, where they differ by up to
     * a tenth. A chain of 100 particles is short enough that what a step costs beside its evaluations counts.
     */
    private static final List<Row> ROWS = List.of(
            new Row("chain", "rk4", 1.28), new Row("chain", "midpoint", 1.46), new Row("chain", "euler", 1.48),
            new Row("chain", "symplectic-euler", 1.27),
            new Row("cloth-64", "rk4", 1.05), new Row("cloth-64", "midpoint", 1.05),
            new Row("cloth-64", "euler", 1.05), new Row("cloth-64", "symplectic-euler", 1.05));
    /** Two threads' time over one thread's, rk4 on a cloth of 64 x 64. */
    private static final double TWO_THREADS = 0.65;
    private static final int PAIRS = 15;
    /** A slow ratio is measured again: other work on the machine makes it slower at times, and a loss always. */
    private static final int TRIES = 3;
    private static final long BLOCK = 15_000_000;               // ns
    private static final long WARM_UP = 400_000_000;
    private static final long LONGEST = 15_000_000_000L;
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
        /** The median of pairs of blocks, back to back. */
        double ratio() {
            double[] ratios = new double[PAIRS];
            for (int n = 0; n < PAIRS; n++) {
                double hand = byHand.timePerSolution();
                ratios[n] = ours.timePerSolution() / hand;
            }
            Arrays.sort(ratios);
            return ratios[PAIRS / 2];
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
            double ratio = pair.ratio();
            for (int n = 1; n < TRIES && ratio > pair.row.limit(); n++) {
                ratio = Math.min(ratio, pair.ratio());
            }
            good &= report(out, pair.row.workload + ", " + pair.row.method, ratio, pair.row.limit());
        }
        if (Runtime.getRuntime().availableProcessors() < 2) {
            out.println("two threads: not measured on one processor");
            return good;
        }
        out.println("two threads' time over one thread's (limit):");
        return report(out, "cloth-64, rk4", twoThreads(), SLACK * TWO_THREADS) && good;
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
