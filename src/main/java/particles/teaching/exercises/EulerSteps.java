package particles.teaching.exercises;

import java.util.List;
import particles.teaching.marking.CommonMistake;
import particles.teaching.marking.Draw;
import particles.teaching.marking.Draw.Picks;
import particles.teaching.marking.NumericExercise;
import particles.teaching.marking.Question;

/** The exercise on three steps of the Euler method by hand. */
final class EulerSteps extends NumericExercise {
    private static final int STEPS = 3;

    EulerSteps() {
        super("Three steps of the Euler method", -4, 2,
                "Write down x, v and a for the start, make one step, and go on from there; compute a anew each step.");
    }

    @Override
    protected Question ask(Picks picks) {
        double m = picks.of(0.4, 0.5, 0.8, 1.25, 1.6, 2, 2.5, 4);
        double k = picks.decimal(20, 90, 1);
        double x = picks.decimal(50, 150, 2);
        double v = picks.decimal(5, 15, 1);
        double h = picks.of(0.1, 0.15, 0.2, 0.25);
        double answer = new Spring(m, k, 0, x, v).after("euler", STEPS, h).x();
        return new Question("A particle of m = " + Draw.text(m) + " kg slides on a spring of k = " + Draw.text(k)
                + " N/m, without gravity or friction: x'' = -(k/m) x. It is at x = "
                + Draw.text(x) + " m and moves with v = " + Draw.text(v)
                + " m/s.\nWhere is it after three Euler steps of deltaT = "
                + Draw.text(h) + " s?", "m", FOUR_DIGITS, answer, 0.1 * x, List.of(
                new CommonMistake(new Spring(m, k, 0, x, v).after("symplectic-euler", STEPS, h).x(),
                        "The position was moved with the new velocity: that is the simple algorithm (symplectic "
                                + "Euler). Euler uses the"
                                + " derivative at the start of the step for both."),
                new CommonMistake(new Spring(m, k, 0, x, v).after("euler", STEPS - 1, h).x(),
                        "These are two steps; three are wanted."),
                new CommonMistake(new Spring(m, k, 0, x, v).after("euler", STEPS + 1, h).x(),
                        "These are four steps; three are wanted."),
                new CommonMistake(new Spring(m, k, 0, x, v).after("euler", 1, STEPS * h).x(),
                        "This is one step of three times deltaT; the"
                                + " derivative has to be evaluated anew after each step."),
                new CommonMistake(new Spring(m, k, 0, x, v).after("euler", STEPS, h).v(),
                        "This is the velocity; the question asks for the place."),
                new CommonMistake(new Spring(1, k, 0, x, v).after("euler", STEPS, h).x(),
                        "The mass is missing: a = F/m = -(k/m) x."),
                new CommonMistake(new Spring(m, -k, 0, x, v).after("euler", STEPS, h).x(),
                        "The spring pulls back: the sign of its force is minus."),
                new CommonMistake(new Spring(m, k, 0, x, v).after("midpoint", STEPS, h).x(),
                        "This is the midpoint method; Euler evaluates the derivative once, at the start of the step."),
                new CommonMistake(new Spring(m, k, 0, x, v).truly(STEPS * h).x(),
                        "This is the exact motion; the question asks for Euler's result.")));
    }
}
