package particles.teaching.exercises;

import java.util.List;
import particles.teaching.marking.Draw.Picks;
import particles.teaching.marking.NumericExercise;
import particles.teaching.marking.Question;

/** The exercise on one long step of RK4, with a derivative that depends on time. */
final class RK4Step extends NumericExercise {
    /** The largest deltaT c/m, well below the stability limit, 2.785. */
    private static final double LONGEST = 2;
    private static final String WEIGHTS = "1/6 1/3 1/3 1/6";
    private static final String RK4 = """
             0  |
            1/2 | 1/2
            1/2 |  0  1/2
             1  |  0   0   1
            ----+-----------------
                | 1/6 1/3 1/3 1/6
            """;

    RK4Step() {
        super("One step of RK4", "m/s", 0.5, 60, """
                The leaf again: m = %s kg, drag c = %s N s/m, the air moves with b t, b = %s m/s^2, so that v' = \
                -(c/m)(v - b t); at t = 0 it has v = %s m/s.
                What is v after one step of RK4 with deltaT = %s s?
                ---
                Write down k1 to k4, each with the state and the time at which it is evaluated.
                k2 belongs at s + k1/2, not at s + k1.
                k3 belongs at s + k2/2, not at s + k1/2.
                k4 belongs at s + k3, not at s + k3/2.
                k4 is evaluated at t + deltaT/2; the slide says t + deltaT.
                All four were evaluated at time t; the clock has to move with the stages.
                The weights are 1/6, 1/3, 1/3, 1/6, not four times 1/4.
                The weights are the wrong way round: the two in the middle count 1/3, the outer ones 1/6.
                The weights have to add up to 1: 1/6, 1/3, 1/3, 1/6.
                This is the midpoint method.
                This is the Euler method, k1 alone.
                The mass is missing: the acceleration is the force over m.
                """);
    }

    @Override
    protected Question ask(Picks picks) {
        double m = Leaf.mass(picks);
        double c = picks.decimal(4, 20, 1);
        double b = picks.size(0.5, 40);
        double v = picks.size(2, 80);
        double h = picks.of(0.4, 0.5, 0.6, 0.75, 0.8);
        double a = c / m;
        Leaf leaf = new Leaf(a, b, v);
        return question(leaf.after("rk4", 1, h), a * h > LONGEST ? Double.POSITIVE_INFINITY : 0.05 * v,
                List.of(m, c, b, v, h), wrong(leaf, h, "1/2 | 1/2", "1/2 | 1"), wrong(leaf, h, " 0  1/2", "1/2 0"),
                wrong(leaf, h, "0   1", "0 1/2"), wrong(leaf, h, " 1  |", "1/2 |"),
                leaf.afterMistake(RK4.replace("1/2 |", "0 |"), " 1  |", "0 |", 1, h),
                wrong(leaf, h, WEIGHTS, "1/4 1/4 1/4 1/4"), wrong(leaf, h, WEIGHTS, "1/3 1/6 1/6 1/3"),
                wrong(leaf, h, WEIGHTS, "1/6 1/6 1/6 1/6"), leaf.after("midpoint", 1, h), leaf.after("euler", 1, h),
                new Leaf(c, b, v).after("rk4", 1, h));
    }

    private static double wrong(Leaf leaf, double h, String right, String wrong) {
        return leaf.afterMistake(RK4, right, wrong, 1, h);
    }
}
