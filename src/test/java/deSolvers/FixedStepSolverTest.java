package deSolvers;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotSame;
import static org.junit.jupiter.api.Assertions.assertThrows;

import deSolvers.multistep.AdamsBashforthMoultonSolver;
import deSolvers.problems.ArraySpySource;
import deSolvers.problems.DragInWind;
import deSolvers.problems.Oscillator;
import deSolvers.problems.SecondOrderProblem;
import deSolvers.problems.SpySource;
import deSolvers.problems.Steps;
import deSolvers.symplectic.SymplecticEulerSolver;
import deSolvers.symplectic.VelocityVerletSolver;
import deSolvers.symplectic.Yoshida4Solver;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.Test;

/** Tests {@link FixedStepSolver}: its helpers, and the checks around a step. */
class FixedStepSolverTest {
    private static final double H = 0.25;

    /** A method given by a lambda. */
    private static final class Method extends FixedStepSolver {
        private final Body body;

        Method(Body body) {
            this.body = body;
        }

        /** One step, with the solver whose helpers it calls. */
        interface Body {
            void step(FixedStepSolver solver, DEStateSource source, double[] s, double deltaT);
        }

        @Override
        protected void step(DEStateSource source, double[] s, double deltaT) {
            body.step(this, source, s, deltaT);
        }
    }

    /** Every helper is called three times in two steps; no result is overwritten by a later one. */
    @Test
    void resultsOfHelpersNeverShareAnArray() {
        Method method = new Method((solver, source, s, deltaT) -> {
            List<double[]> results = new ArrayList<>();
            List<double[]> copies = new ArrayList<>();
            results.add(s);
            for (int round = 1; round <= 3; round++) {
                results.add(solver.derivative(s));
                results.add(solver.eulerStep(s, round));
                results.add(solver.plus(s, round, s));
                results.add(solver.copy(s));
                while (copies.size() < results.size()) {
                    copies.add(results.get(copies.size()).clone());
                }
            }
            for (int i = 0; i < results.size(); i++) {
                assertArrayEquals(copies.get(i), results.get(i), "result " + i + " was changed by a later call");
                for (int j = 0; j < i; j++) {
                    assertNotSame(results.get(j), results.get(i), "results " + j + " and " + i);
                }
            }
        });
        DragInWind source = new DragInWind(3, 2);
        method.stepState(source, H);
        method.stepState(source, H);
        method.stepState(new ArraySpySource(new DragInWind(3, 2)), H);
    }

    /**
     * A derivative that is not finite at one evaluation only, and affects no other one. The midpoint method's first
     * derivative affects the new state only through the second, and symplectic methods read accelerations only.
     */
    @Test
    void noBadDerivativeGetsLost() {
        for (DESolver solver : new DESolver[] {new EulerSolver(), new MidpointSolver(), new RK4Solver(),
                new AdamsBashforthMoultonSolver(), new SymplecticEulerSolver(), new VelocityVerletSolver(),
                new Yoshida4Solver()}) {
            for (double bad : ContractBasics.NOT_FINITE) {
                for (int entry = 0; entry < 6; entry++) {
                    SteadyRates source = new SteadyRates(entry, bad);
                    int evaluations = 1;
                    for (int step = 0; step < 5; step++) {
                        int before = source.made;
                        solver.stepState(source, H);
                        evaluations = source.made - before;
                    }
                    for (int k = 0; k < evaluations; k++) {
                        double[] start = source.getState();
                        source.badAt = source.made + k;
                        Steps.assertFails(DESolverException.class, "entry " + entry + " of the ",
                                () -> solver.stepState(source, H));
                        assertArrayEquals(start, source.getState());
                    }
                }
            }
        }
    }

    @Test
    void anIncrementThatOverflowsIsNamed() {
        SteadyRates source = new SteadyRates(2, 1e300);
        source.badAt = 0;
        Steps.assertFails(DESolverException.class, "entry 2 of the derivative times deltaT is Infinity",
                () -> new MidpointSolver().stepState(source, 1e10));
    }

    /** ds/dt = 1 in every entry and at any state, but for one entry at one evaluation. */
    private static final class SteadyRates extends SecondOrderProblem {
        private final int entry;
        private final double bad;
        private int made;
        private int badAt = -1;

        SteadyRates(int entry, double bad) {
            super(3, new double[6]);
            this.entry = entry;
            this.bad = bad;
        }

        @Override
        public void getStateDerivative(double[] dSdt) {
            Arrays.fill(dSdt, 1);
            if (made++ == badAt) {
                dSdt[entry] = bad;
            }
        }

        @Override
        public boolean accelerationDependsOnVelocity() {
            return false;
        }

        @Override
        protected void accelerate(double t, double[] s, double[] dSdt) {
            throw new AssertionError("not asked for");
        }
    }

    /** A method may also move the source itself, as the slides do; the start is put back if it then fails. */
    @Test
    void aMethodMayMoveTheSource() {
        Method slides = new Method((solver, source, s, deltaT) -> {
            source.setState(new double[] {5, 6});
            source.incTime(deltaT / 2);
            double[] dSdt = new double[2];
            source.getStateDerivative(dSdt);
            assertArrayEquals(new double[] {6, -5}, dSdt);
            throw new IllegalStateException("enough");
        });
        for (SpySource source : new SpySource[] {new SpySource(new Oscillator()),
                new ArraySpySource(new Oscillator())}) {
            assertThrows(IllegalStateException.class, () -> slides.stepState(source, H));
            assertArrayEquals(new double[] {1, 0}, source.problem().getState());
            assertEquals(0, source.getTime());
        }
    }

    /** State and derivative are finite, so deltaT is the likely cause; the start is put back. */
    @Test
    void aStateThatOverflowsWithinTheStepIsNamed() {
        Method overflow = new Method((solver, source, s, deltaT) -> {
            source.incTime(deltaT);
            s[1] = Double.POSITIVE_INFINITY;
        });
        for (SpySource source : new SpySource[] {new SpySource(new Oscillator()),
                new ArraySpySource(new Oscillator())}) {
            Steps.assertFails(DESolverException.class, "entry 1 of the state became Infinity within the step",
                    () -> overflow.stepState(source, H));
            assertArrayEquals(new double[] {1, 0}, source.problem().getState());
            assertEquals(0, source.getTime());
        }
        SteadyRates steady = new SteadyRates(0, 0);
        steady.setState(new double[] {0, 0, Double.NaN, 0, 0, 0});
        Steps.assertFails(DESolverException.class, "entry 2 of the state is NaN before the step",
                () -> new EulerSolver().stepState(steady, H));
    }

    /** For any moves of the clock within a step. Measured: 167 of 10,000 need a second move at the end. */
    @Test
    void aStepEndsExactlyAtItsEnd() {
        Random random = new Random(17);
        Method method = new Method((solver, source, s, deltaT) -> source.incTime(deltaT * random.nextDouble()));
        for (int n = 0; n < 1000; n++) {
            Oscillator source = new Oscillator();
            source.incTime(Math.scalb(random.nextDouble() - 0.5, random.nextInt(20) - 10));
            double deltaT = Math.scalb(random.nextDouble() - 0.5, random.nextInt(20) - 10);
            double end = source.getTime() + deltaT;
            method.stepState(source, deltaT);
            assertEquals(end, source.getTime(), "case " + n);
        }
    }
}
