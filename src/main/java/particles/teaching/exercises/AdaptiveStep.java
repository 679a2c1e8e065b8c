package particles.teaching.exercises;

import java.util.List;
import particles.teaching.marking.Draw.Picks;
import particles.teaching.marking.NumericExercise;
import particles.teaching.marking.Question;

/** The exercise on adaptive steps as on the slide: two steps of deltaT, one of twice that, compare, adjust. */
final class AdaptiveStep extends NumericExercise {
    private static final int ERROR_ORDER = 5;
    private static final int RICHARDSON = 15;

    AdaptiveStep() {
        super("Adaptive steps: the next deltaT", "s", 0.01, 0.4, """
                A particle of m = %s kg on a spring of k = %s N/m is at x = %s m with v = %s m/s. Take two steps of \
                RK4 with deltaT = %s s, and one of 2 deltaT from the same start; the difference of the two x is the \
                error.
                Which deltaT would make this error %s m? Assume that it grows with deltaT as the error of a single \
                step, not of a whole run, of a method of order 4.
                ---
                Calculate the difference first; then ask how it changes when deltaT becomes half as long.
                The error over a given time goes with the fourth power; that of one step goes with the fifth.
                The fraction is the wrong way round: too large an error needs a shorter step.
                The error does not go with deltaT itself but with its fifth power: take the fifth root.
                The square root belongs to a method of order 1; RK4's error of one step goes with the fifth power.
                The cube root belongs to a method of order 2; RK4's error of one step goes with the fifth power.
                The fifteenth of the difference is the error of the better result; the question asks for the \
                difference itself.
                This is 2 deltaT; the question asks for deltaT, the length of the short steps.
                The steps are those of the midpoint method; RK4's are wanted.
                The mass is missing: a = F/m = -(k/m) x.
                """);
    }

    @Override
    protected Question ask(Picks picks) {
        double m = Spring.mass(picks);
        double k = picks.size(1, 30);
        double x = picks.decimal(50, 150, 2);
        double v = picks.decimal(5, 15, 1);
        double h = picks.of(0.1, 0.12, 0.15, 0.2, 0.25);
        double bound = picks.of(1e-7, 3e-7, 1e-6, 3e-6, 1e-5, 3e-5, 1e-4);
        Spring spring = new Spring(m, k, 0, x, v);
        double error = difference("rk4", spring, h);
        double factor = bound / error;
        double smallest = error < 1e-6 * x ? Double.POSITIVE_INFINITY : 0;      // roundings on the way would show
        double next = next(h, factor, ERROR_ORDER);
        return question(next, smallest, List.of(m, k, x, v, h, bound), next(h, factor, ERROR_ORDER - 1),
                next(h, 1 / factor, ERROR_ORDER), next(h, factor, 1), next(h, factor, 2), next(h, factor, 3),
                next(h, RICHARDSON * factor, ERROR_ORDER), 2 * next,
                next(h, bound / difference("midpoint", spring, h), ERROR_ORDER),
                next(h, bound / difference("rk4", new Spring(1, k, 0, x, v), h), ERROR_ORDER));
    }

    private static double next(double h, double factor, double root) {
        return h * StrictMath.pow(factor, 1 / root);
    }

    private static double difference(String solver, Spring spring, double h) {
        return Math.abs(spring.after(solver, 2, h).x() - spring.after(solver, 1, 2 * h).x());
    }
}
