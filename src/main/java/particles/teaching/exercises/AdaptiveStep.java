package particles.teaching.exercises;

import java.util.List;
import particles.teaching.marking.CommonMistake;
import particles.teaching.marking.Draw;
import particles.teaching.marking.Draw.Picks;
import particles.teaching.marking.NumericExercise;
import particles.teaching.marking.Question;

/** The exercise on adaptive steps as on the slide: two steps of deltaT, one of twice that, compare, adjust. */
final class AdaptiveStep extends NumericExercise {
    private static final int ERROR_ORDER = 5;
    private static final int RICHARDSON = 15;

    AdaptiveStep() {
        super("Adaptive steps: the next deltaT", 0.02, 0.3,
                "Calculate the difference first; then ask how it changes when deltaT becomes half as long.");
    }

    @Override
    protected Question ask(Picks picks) {
        double m = picks.of(0.4, 0.5, 0.8, 1.25, 1.6, 2, 2.5, 4);
        double k = picks.decimal(20, 90, 1);
        double x = picks.decimal(50, 150, 2);
        double v = picks.decimal(5, 15, 1);
        double h = picks.of(0.1, 0.12, 0.15, 0.2, 0.25);
        double bound = picks.of(1e-6, 2e-6, 5e-6, 1e-5, 2e-5);
        double error = difference("rk4", m, k, x, v, h);
        double factor = bound / error;
        double smallest = error < 1e-6 * x ? Double.POSITIVE_INFINITY : 0;      // roundings on the way would show
        return new Question("A particle of m = " + Draw.text(m) + " kg on a spring of k = " + Draw.text(k)
                + " N/m is at x = " + Draw.text(x) + " m with v = "
                + Draw.text(v) + " m/s. Take two steps of RK4 with deltaT = " + Draw.text(h)
                + " s, and one of 2 deltaT from the same start; the"
                + " difference of the two x is the error.\nWhich deltaT would make this error " + Draw.text(bound)
                + " m? Assume that it grows with deltaT as the error of"
                + " a single step, not of a whole run, of a method of order 4.", "s",
                FOUR_DIGITS, next(h, factor, 1.0 / ERROR_ORDER), smallest, List.of(
                new CommonMistake(next(h, factor, 1.0 / (ERROR_ORDER - 1)),
                        "The error over a given time goes with the fourth"
                                + " power; that of one step goes with the fifth."),
                new CommonMistake(next(h, 1 / factor, 1.0 / ERROR_ORDER),
                        "The fraction is the wrong way round: too large an error needs a shorter step."),
                new CommonMistake(next(h, factor, 1),
                        "The error does not go with deltaT itself but with its fifth power: take the fifth root."),
                new CommonMistake(next(h, factor, 1.0 / 2),
                        "The square root belongs to a method of order 1;"
                                + " RK4's error of one step goes with the fifth power."),
                new CommonMistake(next(h, factor, 1.0 / 3),
                        "The cube root belongs to a method of order 2; RK4's"
                                + " error of one step goes with the fifth power."),
                new CommonMistake(next(h, RICHARDSON * factor, 1.0 / ERROR_ORDER),
                        "The fifteenth of the difference is the error of the better"
                                + " result; the question asks for the difference itself."),
                new CommonMistake(2 * next(h, factor, 1.0 / ERROR_ORDER),
                        "This is 2 deltaT; the question asks for deltaT, the length of the short steps."),
                new CommonMistake(next(h, bound / difference("midpoint", m, k, x, v, h), 1.0 / ERROR_ORDER),
                        "The steps are those of the midpoint method; RK4's are wanted."),
                new CommonMistake(next(h, bound / difference("rk4", 1, k, x, v, h), 1.0 / ERROR_ORDER),
                        "The mass is missing: a = F/m = -(k/m) x.")));
    }

    private static double next(double h, double factor, double power) {
        return h * StrictMath.pow(factor, power);
    }

    private static double difference(String solver, double m, double k, double x, double v, double h) {
        return Math.abs(new Spring(m, k, 0, x, v).after(solver, 2, h).x() - new Spring(m, k, 0, x, v).after(solver, 1,
                2 * h).x());
    }
}
