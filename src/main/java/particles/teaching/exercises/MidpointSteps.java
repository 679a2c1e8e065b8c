package particles.teaching.exercises;

import java.util.List;
import particles.teaching.marking.Draw.Picks;
import particles.teaching.marking.NumericExercise;
import particles.teaching.marking.Question;

/** The exercise on two steps of the midpoint method, with a derivative that depends on time. */
final class MidpointSteps extends NumericExercise {
    private static final int STEPS = 2;
    /** The largest deltaT c/m, well below the stability limit, 2. */
    private static final double LONGEST = 1.5;

    private static final String MIDPOINT = """
             0  |
            1/2 | 1/2
            ----+---------
                |  0   1
            """;

    MidpointSteps() {
        super("Two steps of the midpoint method", "m/s", 0.5, 20, """
                A leaf of m = %s kg drifts in a wind that freshens: the air's velocity is b t with b = %s m/s^2, and \
                the drag coefficient c = %s N s/m, so that v' = -(c/m)(v - b t). At t = 0 the leaf has v = %s m/s.
                What is v after two steps of the midpoint method with deltaT = %s s?
                ---
                Write down dSdt, the state half way and gMid of the first step, each with its time.
                This is the Euler method: take the step with gMid, the derivative half way.
                gMid was evaluated at time t; half way the clock stands at t + deltaT/2.
                gMid was evaluated at the end of the Euler step; half way means s + deltaS/2 and t + deltaT/2.
                The state half way is s + deltaS/2, not s + deltaS.
                The time half way is t + deltaT/2, not t + deltaT.
                The last step was half as long as it should be: deltaT gMid, from the start.
                Go back to the start: the step with gMid begins at s, not at the point half way.
                This is one step; two are wanted.
                The mass is missing: the acceleration is the force over m.
                """);
    }

    @Override
    protected Question ask(Picks picks) {
        double m = Leaf.mass(picks);
        double c = picks.decimal(4, 20, 1);
        double b = picks.size(0.5, 10);
        double v = picks.size(2, 50);
        double h = picks.of(0.2, 0.25, 0.3, 0.4, 0.5);
        double a = c / m;
        Leaf leaf = new Leaf(a, b, v);
        return question(leaf.after("midpoint", STEPS, h), a * h > LONGEST ? Double.POSITIVE_INFINITY : 0.05 * v,
                List.of(m, b, c, v, h), leaf.after("euler", STEPS, h), wrong(leaf, h, "1/2 |", "0 |"),
                wrong(leaf, h, "1/2", "1"), wrong(leaf, h, "| 1/2", "| 1"), wrong(leaf, h, "1/2 |", "1 |"),
                wrong(leaf, h, "0   1", "0 1/2"), wrong(leaf, h, "0   1", "1/2 1"), leaf.after("midpoint", 1, h),
                new Leaf(c, b, v).after("midpoint", STEPS, h));
    }

    private static double wrong(Leaf leaf, double h, String right, String wrong) {
        return leaf.afterMistake(MIDPOINT, right, wrong, STEPS, h);
    }
}
