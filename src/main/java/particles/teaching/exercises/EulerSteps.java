package particles.teaching.exercises;

import java.util.List;
import particles.teaching.marking.Draw.Picks;
import particles.teaching.marking.NumericExercise;
import particles.teaching.marking.Question;

/** The exercise on three steps of the Euler method by hand. */
final class EulerSteps extends NumericExercise {
    private static final int STEPS = 3;

    EulerSteps() {
        super("Three steps of the Euler method", "m", -9, 8, """
                A particle of m = %s kg slides on a spring of k = %s N/m, without gravity or friction: x'' = -(k/m) \
                x. It is at x = %s m and moves with v = %s m/s.
                Where is it after three Euler steps of deltaT = %s s?
                ---
                Write down x, v and a for the start, make one step, and go on from there; compute a anew each step.
                The position was moved with the new velocity: that is the simple algorithm (symplectic Euler). Euler \
                uses the derivative at the start of the step for both.
                These are two steps; three are wanted.
                These are four steps; three are wanted.
                This is one step of three times deltaT; the derivative has to be evaluated anew after each step.
                This is the velocity; the question asks for the place.
                The mass is missing: a = F/m = -(k/m) x.
                The spring pulls back: the sign of its force is minus.
                This is the midpoint method; Euler evaluates the derivative once, at the start of the step.
                This is the exact motion; the question asks for Euler's result.
                """);
    }

    @Override
    protected Question ask(Picks picks) {
        double m = Spring.mass(picks);
        double k = picks.decimal(20, 90, 1);
        double x = picks.decimal(50, 300, 2);
        double v = picks.decimal(5, 60, 1);
        double h = picks.of(0.1, 0.15, 0.2, 0.25);
        Spring spring = new Spring(m, k, 0, x, v);
        Spring right = spring.after("euler", STEPS, h);
        return question(right.x(), 0.1 * x, List.of(m, k, x, v, h), spring.after("symplectic-euler", STEPS, h).x(),
                spring.after("euler", STEPS - 1, h).x(), spring.after("euler", STEPS + 1, h).x(),
                spring.after("euler", 1, STEPS * h).x(), right.v(),
                new Spring(1, k, 0, x, v).after("euler", STEPS, h).x(),
                new Spring(m, -k, 0, x, v).after("euler", STEPS, h).x(),
                spring.after("midpoint", STEPS, h).x(), spring.truly(STEPS * h).x());
    }
}
