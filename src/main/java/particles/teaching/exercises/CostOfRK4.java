package particles.teaching.exercises;

import java.util.List;
import particles.teaching.marking.Draw.Picks;
import particles.teaching.marking.NumericExercise;
import particles.teaching.marking.Question;

/**
 * The exercise that the lecture calls UDOO: the cost of RK4 against midpoint for similar accuracy, with the student's
 * own duration and accuracy.
 */
final class CostOfRK4 extends NumericExercise {
    private static final int FEWEST_STEPS = 16;
    private static final double HUNDRED = 100;

    CostOfRK4() {
        super("What midpoint costs against RK4", "", 6, 150, """
                x'' = -omega^2 x with omega = %s 1/s begins at x = 1 m, v = 0, and is followed for %s s. The error \
                at the end, |(x - x exact, (v - v exact)/omega)|, may be %s m.
                How many times as many evaluations of the derivative does the midpoint method need as RK4, each with \
                the fewest steps of equal length that are good enough?
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
        double error = picks.size(3e-7, 0.01);
        double midpoint = steps("midpoint", 2, omega, duration, error);
        double rk4 = steps("rk4", 4, omega, duration, error);
        double ratio = 2 * midpoint / (4 * rk4);
        return question(ratio, 0, List.of(omega, duration, error), 2 * ratio, 4 * ratio, 1 / ratio, 0.5,
                StrictMath.pow(HUNDRED, 0.25) * ratio, StrictMath.pow(error, -0.25));
    }

    /** The fewest steps that are accurate enough; a guess by the order of the method is at most a few steps off. */
    private static int steps(String solver, int order, double omega, double duration, double error) {
        int steps = FEWEST_STEPS;
        double found = error(solver, omega, duration, steps);
        while (found > error) {
            steps = (int) Math.ceil(steps * Math.min(8, StrictMath.pow(found / error, 1.0 / order)));
            found = error(solver, omega, duration, steps);
        }
        while (error(solver, omega, duration, steps - 1) <= error) {
            steps--;
        }
        return steps;
    }

    private static double error(String name, double omega, double duration, int steps) {
        Spring spring = new Spring(1, omega * omega, 0, 1, 0).after(name, steps, duration / steps);
        double dx = spring.x() - StrictMath.cos(omega * duration);
        double dv = spring.v() / omega + StrictMath.sin(omega * duration);
        return Math.sqrt(dx * dx + dv * dv);
    }
}
