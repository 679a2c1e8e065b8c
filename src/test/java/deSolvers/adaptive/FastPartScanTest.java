package deSolvers.adaptive;

import static deSolvers.problems.Bounds.assertBelow;
import static deSolvers.problems.KnownSolutions.decay;
import static deSolvers.problems.KnownSolutions.slowAndFastSpring;
import static deSolvers.problems.KnownSolutions.stiffPair;

import deSolvers.DESolver;
import deSolvers.adaptive.AdaptiveContract.Maker;
import deSolvers.extrapolation.BulirschStoerSolver;
import deSolvers.problems.ReferenceProblem;
import java.util.function.Consumer;
import java.util.function.ToDoubleFunction;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;

/**
 * Scans decayed parts of a solution that are too fast for an explicit method, over many rates and step lengths. The
 * sub-steps grow until the fast part grows again, and only the error estimate can detect that, so it must not vanish at
 * any rate.
 */
class FastPartScanTest {
    private static final double[][] TOLERANCES = {{1e-6, 1e-9}, {1e-3, 1e-6}};

    /**
     * The bounds in units of the tolerance, for decay, damped spring and stiff pair. Measured, with the tolerances
     * 1e-6/1e-9 and 1e-3/1e-6: step-doubling 46, 150, 48; bulirsch-stoer 14, 25, 2.5; dormand-prince 2.4, 19,
     * 1.3. Without their second estimates step-doubling reached 2.7e252 and
     * bulirsch-stoer infinity, over a finer scan.
     */
    static Stream<Arguments> solvers() {
        return Stream.of(
                Arguments.of("step-doubling", 150, 450, 150, (Maker) StepDoublingSolver::new),
                Arguments.of("bulirsch-stoer", 50, 75, 10, (Maker) BulirschStoerSolver::new),
                Arguments.of("dormand-prince", 8, 60, 4, (Maker) DormandPrinceSolver::new));
    }

    /** s' = -lambda s: in units of the tolerance, worst of all steps of 3 s. */
    @ParameterizedTest(name = "{0}")
    @MethodSource("solvers")
    void aDecayedPartDoesNotReturn(String name, double bound, double spring, double pair, Maker maker) {
        scan(maker, name, bound, scan -> {
            for (double lambda = 20; lambda < 400; lambda *= 1.06) {
                for (double deltaT : new double[] {0.1, 0.25, 1}) {
                    scan.run(decay(lambda), deltaT, scan::largestError, "lambda " + lambda);
                }
            }
        });
    }

    /** x'' = -omega^2 x - 0.1 omega x' beside a slow oscillator: the velocity, from omega/2 to begin with. */
    @ParameterizedTest(name = "{0}")
    @MethodSource("solvers")
    void aDampedVibrationDoesNotReturn(String name, double decay, double bound, double pair, Maker maker) {
        scan(maker, name, bound, scan -> {
            for (double omega = 30; omega < 500; omega *= 1.1) {
                double fast = omega;
                for (double deltaT : new double[] {1.0 / 60, 0.1, 0.5}) {
                    scan.run(slowAndFastSpring(omega, 0.05 * omega), deltaT, s -> scan.overEnvelope(s, fast),
                            "omega " + omega);
                }
            }
        });
    }

    /** Slow and fast parts in every entry. */
    @Tag("slow")
    @ParameterizedTest(name = "{0}")
    @MethodSource("solvers")
    void aFastPartBesideASlowOneDoesNotReturn(String name, double decay, double spring, double bound, Maker maker) {
        scan(maker, name, bound, scan -> {
            for (double deltaT = 0.004; deltaT < 0.05; deltaT *= 1.04) {
                scan.run(stiffPair(), deltaT, scan::largestError, "the pair");
            }
        });
    }

    private static void scan(Maker maker, String solver, double bound, Consumer<Scan> runs) {
        for (double[] tolerance : TOLERANCES) {
            Scan scan = new Scan(maker, tolerance);
            runs.accept(scan);
            assertBelow(bound, scan.worst, solver + ", tolerances " + tolerance[0] + " and " + tolerance[1] + ", "
                    + scan.where);
        }
    }

    /** The worst result of runs with the same tolerances. */
    private static final class Scan {
        private final Maker maker;
        private final double[] tolerance;
        private double worst;
        private String where = "";

        Scan(Maker maker, double[] tolerance) {
            this.maker = maker;
            this.tolerance = tolerance;
        }

        /** Runs 3 s and records the worst error after each step. */
        void run(ReferenceProblem problem, double deltaT, ToDoubleFunction<ReferenceProblem> unitsOff, String what) {
            DESolver solver = maker.create(tolerance[0], tolerance[1]);
            problem.startAt(0);
            while (problem.getTime() < 3) {
                solver.stepState(problem, deltaT);
                double units = unitsOff.applyAsDouble(problem);
                if (!(units <= worst)) {
                    worst = Double.isNaN(units) ? Double.POSITIVE_INFINITY : units;         // stays the worst
                    where = what + ", deltaT " + deltaT;
                }
            }
        }

        /** The largest error of an entry relative to its tolerance. */
        double largestError(ReferenceProblem problem) {
            double[] exact = problem.exactState(problem.getTime());
            double[] state = problem.getState();
            return IntStream.range(0, exact.length).mapToDouble(i -> Math.abs(state[i] - exact[i])
                    / (tolerance[1] + tolerance[0] * Math.abs(exact[i]))).max().orElseThrow();
        }

        /** The excess of the fast velocity over 1.2 times its envelope, in units of the absolute tolerance. */
        double overEnvelope(ReferenceProblem problem, double omega) {
            double envelope = 0.5 * omega * StrictMath.exp(-0.05 * omega * problem.getTime());
            double[] state = problem.getState();
            return Math.max(0, Math.hypot(state[2], state[3]) - 1.2 * envelope) / tolerance[1];
        }
    }
}
