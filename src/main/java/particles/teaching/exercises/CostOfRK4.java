package particles.teaching.exercises;

import deSolvers.DESolver;
import deSolvers.catalog.SolverCatalog;
import java.math.BigDecimal;
import java.math.MathContext;
import java.util.List;
import particles.teaching.marking.Draw.Picks;
import particles.teaching.marking.NumericExercise;
import particles.teaching.marking.Question;

/**
 * The exercise that the lecture calls UDOO: the cost of RK4 against midpoint for similar accuracy, with the student's
 * own duration and accuracy.
 */
final class CostOfRK4 extends NumericExercise {
    /** The fewest steps are found by trial; the leading terms of the errors alone may be wrong by a percent. */
    private static final double HALF_A_PERCENT = 0.005;
    private static final int FEWEST_STEPS = 16;
    private static final double HUNDRED = 100;

    CostOfRK4() {
        super("What midpoint costs against RK4", "", 6, 45, """
                x'' = -omega^2 x with omega = %s 1/s begins at x = 1 m, v = 0, and is followed for %s s. The error \
                at the end, |(x - x exact, (v - v exact)/omega)|, may be %s m.
                How many times as many evaluations of the derivative does the midpoint method need as RK4, each with \
                the longest deltaT that is good enough?
                ---
                For each method, write down how the error at the end goes with the number of steps; the frequency \
                and the duration count too.
                This is the ratio of the steps; a step of midpoint has two evaluations and one of RK4 four.
                The weights are the wrong way round: midpoint has two evaluations per step, RK4 four.
                This is RK4's cost over midpoint's; the question asks for midpoint's over RK4's.
                This compares one step with one step; for the same accuracy RK4 may take far longer ones.
                This is about the ratio for a hundredth of the error: check the power of ten.
                The orders alone do not do it: the errors' constants and the duration count too.
                """);
    }

    @Override
    protected Question ask(Picks picks) {
        double duration = picks.whole(30, 60);
        double omega = picks.decimal(100, 150, 2);
        double error = twoDigits(StrictMath.pow(10, -2 - picks.decimal(0, 300, 2)));
        double midpoint = steps("midpoint", omega, duration, error);
        double rk4 = steps("rk4", omega, duration, error);
        double ratio = 2 * midpoint / (4 * rk4);
        return question(ratio, 0, List.of(omega, duration, error), 2 * ratio, 4 * ratio, 1 / ratio, 0.5,
                StrictMath.pow(HUNDRED, 0.25) * ratio, StrictMath.pow(error, -0.25));
    }

    @Override
    protected double tolerance() {
        return HALF_A_PERCENT;
    }

    private static double twoDigits(double x) {
        return new BigDecimal(x).round(new MathContext(2)).doubleValue();
    }

    /** The fewest steps that are accurate enough. */
    private static int steps(String solver, double omega, double duration, double error) {
        int few = FEWEST_STEPS;
        int enough = 2 * few;
        while (!(error(solver, omega, duration, enough) <= error)) {
            few = enough;
            enough *= 2;
        }
        while (enough - few > 1) {
            int middle = (few + enough) / 2;
            if (error(solver, omega, duration, middle) <= error) {
                enough = middle;
            } else {
                few = middle;
            }
        }
        return enough;
    }

    private static double error(String name, double omega, double duration, int steps) {
        DESolver solver = SolverCatalog.create(name);
        Spring spring = new Spring(1, omega * omega, 0, 1, 0);
        for (int n = 0; n < steps; n++) {
            solver.stepState(spring, duration / steps);
        }
        double dx = spring.x() - StrictMath.cos(omega * duration);
        double dv = spring.v() / omega + StrictMath.sin(omega * duration);
        return Math.sqrt(dx * dx + dv * dv);
    }
}
