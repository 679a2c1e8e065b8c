package particles.teaching.exercises;

import java.util.List;
import particles.teaching.marking.Draw.Picks;
import particles.teaching.marking.NumericExercise;
import particles.teaching.marking.Question;

/** The exercise on backward Euler for a spring that is much too stiff for Euler. */
final class StiffSpring extends NumericExercise {

    StiffSpring() {
        super("A stiff spring and backward Euler", "m/s", -30, 12, """
                A particle of m = %s kg on a stiff spring of k = %s N/m with a damper of c = %s N s/m is at x = %s m \
                and has v = %s m/s.
                What is its velocity after one step of backward Euler with deltaT = %s s, where force and velocity \
                are those at the end of the step?
                ---
                Write down both equations with x and v at the end of the step as unknowns, and put one into the \
                other.
                This is the Euler method: the forces are those at the start of the step.
                The spring's force has to be that at the end of the step too: k (x + deltaT v), with the new v.
                The damper's force has to be that at the end of the step too: c times the new v.
                This is the implicit midpoint method: half way, not at the end.
                The damper is missing.
                The mass is missing: a = F/m.
                This is the position; the question asks for the velocity.
                These are two steps; one is wanted.
                This is the exact motion; the question asks for backward Euler's result.
                """);
    }

    @Override
    protected Question ask(Picks picks) {
        double m = Spring.mass(picks);
        double k = 10 * picks.whole(20, 120);
        double c = picks.decimal(20, 120, 1);
        double x = picks.decimal(50, 150, 2);
        double v = picks.decimal(20, 200, 1);
        double h = picks.of(0.05, 0.06, 0.08, 0.1, 0.12);
        Spring spring = new Spring(m, k, c, x, v);
        Spring right = spring.after("backward-euler", 1, h);
        double pull = v - h * k / m * x;
        return question(right.v(), 0.1 * v, List.of(m, k, c, x, v, h), spring.after("euler", 1, h).v(),
                pull / (1 + h * c / m), (pull - v * h * c / m) / (1 + h * h * k / m),
                spring.after("implicit-midpoint", 1, h).v(),
                new Spring(m, k, 0, x, v).after("backward-euler", 1, h).v(),
                new Spring(1, k, c, x, v).after("backward-euler", 1, h).v(), right.x(),
                spring.after("backward-euler", 2, h).v(), spring.truly(h).v());
    }
}
