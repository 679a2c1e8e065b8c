package particles.teaching.exercises;

import java.util.List;
import particles.teaching.marking.CommonMistake;
import particles.teaching.marking.Draw;
import particles.teaching.marking.Draw.Picks;
import particles.teaching.marking.NumericExercise;
import particles.teaching.marking.Question;

/** The exercise on backward Euler for a spring that is much too stiff for Euler. */
final class StiffSpring extends NumericExercise {

    StiffSpring() {
        super("A stiff spring and backward Euler", -30, 6,
                "Write down both equations with x and v at the end of"
                        + " the step as unknowns, and put one into the other.");
    }

    @Override
    protected Question ask(Picks picks) {
        double m = picks.of(0.4, 0.5, 0.8, 1.25, 1.6, 2, 2.5, 4);
        double k = 10 * picks.whole(20, 120);
        double c = picks.decimal(20, 120, 1);
        double x = picks.decimal(50, 150, 2);
        double v = picks.decimal(20, 90, 1);
        double h = picks.of(0.05, 0.06, 0.08, 0.1, 0.12);
        double answer = new Spring(m, k, c, x, v).after("backward-euler", 1, h).v();
        double late = (v - h * k / m * x) / (1 + h * c / m);
        double undampedLater = (v * (1 - h * c / m) - h * k / m * x) / (1 + h * h * k / m);
        return new Question("A particle of m = " + Draw.text(m) + " kg on a stiff spring of k = " + Draw.text(k)
                + " N/m with a damper of c = " + Draw.text(c)
                + " N s/m is at x = " + Draw.text(x) + " m and has v = " + Draw.text(v)
                + " m/s.\nWhat is its velocity after one step of backward Euler with deltaT = "
                + Draw.text(h) + " s, where force and velocity are those at the end of the step?", "m/s", FOUR_DIGITS,
                        answer, 0.1 * v, List.of(
                new CommonMistake(new Spring(m, k, c, x, v).after("euler", 1, h).v(),
                        "This is the Euler method: the forces are those at the start of the step."),
                new CommonMistake(late, "The spring's force has to be that at the end of the step too: k (x + deltaT "
                        + "v), with the new v."),
                new CommonMistake(undampedLater, "The damper's force has to be that at the end of the step too: c "
                        + "times the new v."),
                new CommonMistake(new Spring(m, k, c, x, v).after("implicit-midpoint", 1, h).v(),
                        "This is the implicit midpoint method: half way, not at the end."),
                new CommonMistake(new Spring(m, k, 0, x, v).after("backward-euler", 1, h).v(),
                        "The damper is missing."),
                new CommonMistake(new Spring(1, k, c, x, v).after("backward-euler", 1, h).v(),
                        "The mass is missing: a = F/m."),
                new CommonMistake(new Spring(m, k, c, x, v).after("backward-euler", 1, h).x(),
                        "This is the position; the question asks for the velocity."),
                new CommonMistake(new Spring(m, k, c, x, v).after("backward-euler", 2, h).v(),
                        "These are two steps; one is wanted."),
                new CommonMistake(new Spring(m, k, c, x, v).truly(h).v(),
                        "This is the exact motion; the question asks for backward Euler's result.")));
    }
}
