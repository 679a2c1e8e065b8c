package deSolvers.implicit;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotSame;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import deSolvers.DESolver;
import deSolvers.DESolverException;
import deSolvers.JacobianStateSource.Blocks;
import deSolvers.StepTransaction;
import deSolvers.linear.ImplicitWork;
import deSolvers.problems.Law;
import deSolvers.problems.Oscillator;
import deSolvers.problems.ReferenceProblem;
import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import java.util.function.DoubleUnaryOperator;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/**
 * The equation m = s + g f(m), by blocks and entry by entry, where it has one solution, several or none that is a
 * number.
 */
class StageSolutionTest {

    /** s' = f(s) from a given state. */
    private static final class Scalar extends ReferenceProblem {
        private final DoubleUnaryOperator f;

        Scalar(double start, DoubleUnaryOperator f) {
            super(start);
            this.f = f;
        }

        @Override
        protected void rates(double t, double[] s, double[] dSdt) {
            dSdt[0] = f.applyAsDouble(s[0]);
        }
    }

    /** What is left of the step's own equations, as a part of the largest term. */
    private static double left(BlockParticles particles, double[] before, double h, boolean midpoint) {
        double[] after = particles.state();
        double[] mid = after.clone();
        for (int i = 0; midpoint && i < mid.length; i++) {
            mid[i] = (before[i] + after[i]) / 2;
        }
        double[] dSdt = new double[after.length];
        particles.setState(mid);
        particles.incTime(midpoint ? -h / 2 : 0);
        particles.getStateDerivative(dSdt);
        double worst = 0;
        double largest = 1;
        for (int i = 0; i < after.length; i++) {
            worst = Math.max(worst, Math.abs(after[i] - before[i] - h * dSdt[i]));
            largest = Math.max(largest, Math.max(Math.abs(after[i]), Math.abs(h * dSdt[i])));
        }
        return worst / largest;
    }

    /** However much of the Jacobian is known, the equation is solved to rounding; all in few evaluations. */
    @ParameterizedTest
    @CsvSource({"4, 20, EXACT", "4, 20, APPROXIMATE", "4, 20, NONE", "80, 20, EXACT", "80, 20, APPROXIMATE",
            "80, 20, NONE",
        "120, 20, NONE", "1, 0, EXACT"})
    void theStepsOwnEquationHolds(int n, double stiffness, Blocks blocks) {
        for (boolean midpoint : new boolean[] {false, true}) {
            BlockParticles particles = new BlockParticles(n, stiffness, false, blocks);
            DESolver solver = midpoint ? new ImplicitMidpointSolver() : new BackwardEulerSolver();
            double[] before = particles.state();
            solver.stepState(particles, 0.25);
            long evaluations = particles.evaluations();
            assertTrue(evaluations < 12, evaluations + " evaluations");         // measured 5 to 9
            double left = left(particles, before, 0.25, midpoint);
            assertTrue(left < 5e-15, blocks + ": " + left);                     // measured at most 1.0e-15
            assertEquals(blocks != Blocks.NONE, ImplicitStage.givesBlocks(particles));
        }
    }

    @Test
    void whatWasDoneIsTold() {
        ImplicitMidpointSolver solver = new ImplicitMidpointSolver();
        assertEquals(0, solver.getWork().newtonIterations());
        BlockParticles particles = new BlockParticles(4, 20, false, Blocks.EXACT);
        solver.stepState(particles, 0.25);
        ImplicitWork work = solver.getWork();
        assertEquals(work.jacobians(), work.factorisations(), "each of so small a matrix");
        assertEquals(0, work.products());
        assertTrue(work.newtonIterations() >= work.jacobians() && work.jacobians() > 0, work.toString());
    }

    @Test
    void onlyParticlesInSpaceGiveBlocks() {
        assertTrue(ImplicitStage.givesBlocks(new BlockParticles(2, 1, true, Blocks.APPROXIMATE)));
        assertFalse(ImplicitStage.givesBlocks(new BlockParticles(0, 1, true, Blocks.EXACT)), "there are none");
        assertFalse(ImplicitStage.givesBlocks(new Oscillator()));
    }

    /**
     * m = 1 + g (1 + a atan(m - 1)), to be followed from g = 0; below 1 there are no numbers. At the end, and at half
     * of it, Newton's steps from 1 go that way; from a quarter on they follow. Each piece begins where the last one
     * ended, and after a failure there again.
     */
    @Test
    void aSolutionIsFollowedFromTheStart() {
        double a = 2.2;
        List<Double> asked = new ArrayList<>();
        Scalar source = new Scalar(1, m -> {
            asked.add(m);
            return m < 1 ? Double.NaN : 1 + a * StrictMath.atan(m - 1);
        });
        new BackwardEulerSolver().stepState(source, 1);
        double m = source.state()[0];
        assertEquals(0, 1 - m + 1 + a * StrictMath.atan(m - 1), 1e-15);     // measured 0
        // At the start for: Newton's method, the guard's question whether it is finite there, the way down, one half, a
        // quarter.
        assertEquals(5, asked.stream().filter(at -> at == 1).count());
        // Where a quarter leads to: when it is found, for three quarters, which fail, and for a half.
        double quarter = 1.508914610868177;
        assertEquals(0, 1 - quarter + 0.25 * (1 + a * StrictMath.atan(quarter - 1)), 1e-15);
        assertEquals(3, asked.stream().filter(at -> at == quarter).count());
    }

    @Test
    void theCauseIsTold() {
        Scalar wall = new Scalar(1, s -> s > 1 ? Double.NaN : 1);
        DESolverException e = assertThrows(DESolverException.class, () -> new BackwardEulerSolver().stepState(wall,
                0.5));
        assertTrue(e.getMessage().contains("the linear solver failed at Newton's iteration 1"), e.getMessage());
        Scalar none = new Scalar(1, s -> Double.NaN);
        e = assertThrows(DESolverException.class, () -> new BackwardEulerSolver().stepState(none, 0.5));
        assertTrue(e.getMessage().contains("entry 0 of the derivative is NaN at t = 0.0"), e.getMessage());
        Scalar huge = new Scalar(1.5e308, s -> s > 1.6e308 ? Double.NaN : 1e308);
        e = assertThrows(DESolverException.class, () -> new BackwardEulerSolver().stepState(huge, 1));
        assertTrue(e.getMessage().contains("entry 0 of the state became Infinity within the step"), e.getMessage());
    }

    /** Of a small source the residual, its matrix and its rounding, by hand: s' = J s with J = (1 -2; 3 0.5). */
    @Test
    void theEquationOfASmallSource() {
        double[] j = {1, -2, 3, 0.5};
        Law linear = new Law((t, s, dSdt) -> {
            dSdt[0] = j[0] * s[0] + j[1] * s[1];
            dSdt[1] = j[2] * s[0] + j[3] * s[1];
        }, 2, -1);
        DenseProblem problem = new DenseProblem(new ImplicitWork.Counter());
        Random random = new Random(3);
        for (double g : new double[] {0.25, -0.125, 2}) {
            problem.begin(new StepTransaction(new BackwardEulerSolver()).begin(linear, 1), linear, new double[] {2, -1},
                    g);
            double[] m = random.doubles(2, -3, 3).toArray();
            double[] residual = new double[2];
            problem.evaluate(m, residual);
            double[] f = {m[0] - 2 * m[1], 3 * m[0] + 0.5 * m[1]};
            assertArrayEquals(new double[] {2 - m[0] + g * f[0], -1 - m[1] + g * f[1]}, residual, 2e-15);
            problem.linearise(m);
            double[] correction = new double[2];
            assertTrue(problem.correct(residual, correction));
            for (int i = 0; i < 2; i++) {
                double product = correction[i] - g * (j[2 * i] * correction[0] + j[2 * i + 1] * correction[1]);
                assertEquals(residual[i], product, 1e-6);       // J by differences, right to half the digits
            }
            double[] floor = new double[2];
            problem.rounding(m, floor);
            double[] terms = {2 + Math.abs(m[0]) + Math.abs(g) * (Math.abs(m[0]) + 2 * Math.abs(m[1])),
                1 + Math.abs(m[1]) + Math.abs(g) * (3 * Math.abs(m[0]) + 0.5 * Math.abs(m[1]))};
            assertArrayEquals(new double[] {2 * Math.ulp(1.0) * terms[0], 2 * Math.ulp(1.0) * terms[1]}, floor,
                    1e-6 * floor[0]);
            problem.rounding(new double[2], floor);
            assertEquals(2 * Math.ulp(1.0) * 1, floor[1], 1e-25);
        }
    }

    /** What is singular, to the bit: s' = s with g = 1. */
    @Test
    void aSingularMatrixIsRefused() {
        Scalar growth = new Scalar(0, s -> s);
        DenseProblem problem = new DenseProblem(new ImplicitWork.Counter());
        problem.begin(new StepTransaction(new BackwardEulerSolver()).begin(growth, 1), growth, new double[1], 1);
        problem.evaluate(new double[1], new double[1]);
        problem.linearise(new double[1]);
        assertFalse(problem.correct(new double[] {1}, new double[1]));
    }

    /** Of a large source no matrix is known: only the sum itself is rounded. */
    @Test
    void roundingOfALargeSource() {
        Scalar decay = new Scalar(2, s -> -3 * s);
        ImplicitWork.Counter work = new ImplicitWork.Counter();
        KrylovProblem problem = new KrylovProblem(work);
        problem.begin(new StepTransaction(new BackwardEulerSolver()).begin(decay, 1), new double[] {2}, -0.5, 1e-4);
        problem.evaluate(new double[] {-5}, new double[1]);
        double[] floor = new double[1];
        problem.rounding(new double[] {-5}, floor);
        assertEquals(2 * Math.ulp(1.0) * (2 + 5 + 0.5 * 15), floor[0], 1e-27);
        problem.linearise(new double[] {-5});
        assertEquals(1, work.jacobians);
    }

    /**
     * Full matrices for two particles, and up to a state of 600 where blocks would be no more than a preconditioner.
     */
    @ParameterizedTest
    @CsvSource({"2, EXACT, dense", "3, EXACT, blocks", "101, EXACT, blocks", "3, APPROXIMATE, dense",
            "100, APPROXIMATE, dense",
        "101, APPROXIMATE, blocks", "3, NONE, dense", "100, NONE, dense", "101, NONE, products"})
    void radausSystemsAreChosenBySize(int n, Blocks blocks, String kind) {
        RadauChoice choice = new RadauChoice(new ImplicitWork.Counter());
        BlockParticles particles = new BlockParticles(n, 1, true, blocks);
        choice.resize(6 * n);
        RadauSystems systems = choice.systemsFor(particles);
        Class<?> expected = kind.equals("dense") ? DenseRadauSystems.class
                : kind.equals("blocks") ? BlockRadauSystems.class : KrylovRadauSystems.class;
        assertEquals(expected, systems.getClass());
        assertSame(systems, choice.systemsFor(particles), "made once");
        choice.resize(6 * n);
        assertNotSame(systems, choice.systemsFor(particles));
    }
}
