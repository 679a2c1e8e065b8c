package deSolvers.extrapolation;

import static deSolvers.problems.Bounds.assertAbove;
import static deSolvers.problems.Bounds.assertBelow;
import static org.junit.jupiter.api.Assertions.assertTrue;

import deSolvers.adaptive.DormandPrinceSolver;
import deSolvers.problems.ReferenceProblem;
import deSolvers.problems.WorkCurve;
import org.hipparchus.ode.ODEState;
import org.hipparchus.ode.OrdinaryDifferentialEquation;
import org.hipparchus.ode.nonstiff.GraggBulirschStoerIntegrator;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/**
 * Evaluations for the same error at the end, against Gragg-Bulirsch-Stoer of Hipparchus (minimal step 1e-12, maximal
 * step the whole interval, the same tolerances 1e-3 ... 1e-11 in half decades), averaged over the errors that both
 * reach.
 */
class WorkAgainstHipparchusTest {

    private static WorkCurve hipparchus(ReferenceProblem problem, double duration) {
        WorkCurve curve = new WorkCurve();
        for (double exponent = 3; exponent <= 11; exponent += 0.5) {
            double tolerance = StrictMath.pow(10, -exponent);
            problem.startAt(0);
            OrdinaryDifferentialEquation equation = new OrdinaryDifferentialEquation() {
                @Override
                public int getDimension() {
                    return problem.getStateSize();
                }

                @Override
                public double[] computeDerivatives(double t, double[] y) {
                    problem.setState(y);
                    problem.incTime(t - problem.getTime());
                    double[] dSdt = new double[y.length];
                    problem.getStateDerivative(dSdt);
                    return dSdt;
                }
            };
            double[] end = new GraggBulirschStoerIntegrator(1e-12, duration, tolerance, tolerance)
                    .integrate(equation, new ODEState(0, problem.exactState(0)), duration).getPrimaryState();
            problem.setState(end);
            problem.incTime(duration - problem.getTime());
            curve.add(problem.getEvaluations(), problem.error());
        }
        return curve;
    }

    @ParameterizedTest
    @MethodSource("deSolvers.adaptive.WorkAgainstSciPyTest#problems")
    void bulirschStoerNeedsAboutAsManyEvaluations(String name, ReferenceProblem problem, double duration) {
        double ratio = WorkCurve.of(problem, duration, tol -> new BulirschStoerSolver(tol, tol), 3, 11)
                .over(hipparchus(problem, duration));
        // Measured 0.89, 1.04, 0.71, 0.61, 0.67 in the order above.
        assertTrue(ratio <= 1.25, name + ": " + ratio);
    }

    @ParameterizedTest
    @MethodSource("deSolvers.adaptive.WorkAgainstSciPyTest#problems")
    void bulirschStoerBeatsDormandPrinceAtSmallErrorsOnly(String name, ReferenceProblem problem, double duration) {
        double ratio = WorkCurve.of(problem, duration, tol -> new BulirschStoerSolver(tol, tol), 9, 12)
                .over(WorkCurve.of(problem, duration, tol -> new DormandPrinceSolver(tol, tol), 9, 12));
        double coarse = WorkCurve.of(problem, duration, tol -> new BulirschStoerSolver(tol, tol), 3, 6)
                .over(WorkCurve.of(problem, duration, tol -> new DormandPrinceSolver(tol, tol), 3, 6));
        // Measured 0.50, 0.55, 0.34, 0.57, 0.24 for tolerances 1e-9 ... 1e-12;
        // 1.67, 1.54, 1.58, 1.56, 1.34 for 1e-3 ... 1e-6.
        assertBelow(1, ratio, name);
        assertAbove(1, coarse, name);
    }
}
