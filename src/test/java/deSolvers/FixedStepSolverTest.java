package deSolvers;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotSame;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import deSolvers.problems.ArraySpySource;
import deSolvers.problems.DragInWind;
import deSolvers.problems.Oscillator;
import deSolvers.problems.ReferenceProblem;
import deSolvers.problems.SpySource;
import java.util.ArrayList;
import java.util.List;
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
            void step(Method solver, DEStateSource source, double[] s, double deltaT);
        }

        @Override
        protected void step(DEStateSource source, double[] s, double deltaT) {
            body.step(this, source, s, deltaT);
        }

        double[] derivativeAt(double[] s) {
            return derivative(s);
        }

        double[] eulerStepFrom(double[] s, double deltaT) {
            return eulerStep(s, deltaT);
        }

        double[] sum(double[] s, double factor, double[] k) {
            return plus(s, factor, k);
        }

        double[] copyOf(double[] a) {
            return copy(a);
        }

        boolean continues() {
            return continuesLastStep();
        }
    }

    /** Every helper is called three times in two steps, and no result is overwritten by a later one. */
    @Test
    void resultsOfHelpersNeverShareAnArray() {
        Method method = new Method((solver, source, s, deltaT) -> {
            List<double[]> results = new ArrayList<>();
            List<double[]> copies = new ArrayList<>();
            results.add(s);
            for (int round = 1; round <= 3; round++) {
                results.add(solver.derivativeAt(s));
                results.add(solver.eulerStepFrom(s, round));
                results.add(solver.sum(s, round, s));
                results.add(solver.copyOf(s));
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

    @Test
    void helpersComputeTheSlidesFormulas() {
        new Method((solver, source, s, deltaT) -> {
            assertArrayEquals(new double[] {1, 0}, s);
            assertArrayEquals(new double[] {0, -1}, solver.derivativeAt(s));
            assertArrayEquals(new double[] {3, -1}, solver.derivativeAt(new double[] {1, 3}));
            assertArrayEquals(new double[] {0, -4}, solver.eulerStepFrom(s, 4));
            assertArrayEquals(new double[] {1.5, 3}, solver.sum(s, 0.5, new double[] {1, 6}));
            assertArrayEquals(s, solver.copyOf(s));
        }).stepState(new Oscillator(), H);
    }

    /**
     * The midpoint method's first derivative affects the new state only through the second, which may be finite again.
     */
    @Test
    void anInfiniteDerivativeIsReportedEvenIfTheNewStateIsFinite() {
        for (DESolver solver : new DESolver[] {new EulerSolver(), new MidpointSolver(), new RK4Solver()}) {
            ReferenceProblem hyperbola = new ReferenceProblem(1) {
                @Override
                public double[] exactState(double t) {
                    return new double[] {Math.sqrt(2 * t)};
                }

                @Override
                protected void rates(double t, double[] s, double[] dSdt) {
                    dSdt[0] = 1 / s[0];
                }
            };
            hyperbola.setState(new double[] {0});
            DESolverException e = assertThrows(DESolverException.class, () -> solver.stepState(hyperbola, H));
            assertTrue(e.getMessage().contains("entry 0 of the derivative is Infinity at t = 0.0"), e.getMessage());
            assertArrayEquals(new double[] {0}, hyperbola.state());
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
            assertArrayEquals(new double[] {1, 0}, source.problem().state());
            assertEquals(0, source.getTime());
        }
    }

    @Test
    void aStepOfZeroDoesNotCallTheMethod() {
        Oscillator source = new Oscillator();
        new Method((solver, s, state, deltaT) -> {
            throw new AssertionError("called");
        }).stepState(source, 0);
        assertEquals(0, source.evaluations());
        assertArrayEquals(new double[] {1, 0}, source.state());
    }

    @Test
    void aMethodIsToldWhetherTheStepContinuesTheLastOne() {
        boolean[] continued = new boolean[1];
        Method method = new Method((solver, source, s, deltaT) -> {
            continued[0] = solver.continues();
            s[0] += deltaT;
        });
        for (boolean arrays : new boolean[] {false, true}) {
            SpySource source = arrays ? new ArraySpySource(new Oscillator()) : new SpySource(new Oscillator());
            method.stepState(source, H);
            assertFalse(continued[0], "the first step");
            method.stepState(source, H);
            assertTrue(continued[0], "the next one");
            method.stepState(source, 0);
            method.stepState(source, H);
            assertTrue(continued[0], "a step of no time changes nothing");
            source.setState(new double[] {9, 9});
            method.stepState(source, H);
            assertFalse(continued[0], "somebody moved the source");
            method.reset();
            method.stepState(source, H);
            assertFalse(continued[0], "after reset()");
        }
    }
}
