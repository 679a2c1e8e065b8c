package particles.teaching.exercises;

import java.util.List;
import particles.teaching.marking.CommonMistake;
import particles.teaching.marking.Draw;
import particles.teaching.marking.Draw.Picks;
import particles.teaching.marking.NumericExercise;
import particles.teaching.marking.Question;

/** The exercise on two steps of the midpoint method, with a derivative that depends on time. */
final class MidpointSteps extends NumericExercise {
    private static final int STEPS = 2;
    /** The largest deltaT c/m, well below the stability limit, 2. */
    private static final double LONGEST = 1.5;

    MidpointSteps() {
        super("Two steps of the midpoint method", 0.5, 20,
                "Write down dSdt, the state half way and gMid of the first step, each with its time.");
    }

    @Override
    protected Question ask(Picks picks) {
        double m = picks.of(0.2, 0.4, 0.5, 0.8, 1.25, 1.6);
        double c = picks.decimal(4, 20, 1);
        double b = picks.decimal(10, 40, 1);
        double v = picks.decimal(20, 90, 1);
        double h = picks.of(0.2, 0.25, 0.3, 0.4, 0.5);
        double a = c / m;
        Leaf leaf = new Leaf(a, b, v);
        return new Question("A leaf of m = " + Draw.text(m)
                + " kg drifts in a wind that freshens: the air's velocity is b t with b = "
                + Draw.text(b) + " m/s^2, and the drag coefficient c = " + Draw.text(c)
                + " N s/m, so that v' = -(c/m)(v - b t). At t = 0 the leaf has v = "
                + Draw.text(v) + " m/s.\nWhat is v after two steps of the midpoint method with deltaT = " + Draw.text(h)
                + " s?", "m/s", FOUR_DIGITS,
                leaf.after("midpoint", STEPS, h), a * h > LONGEST ? Double.POSITIVE_INFINITY : 0.05 * v, List.of(
                new CommonMistake(leaf.after("euler", STEPS, h),
                        "This is the Euler method: take the step with gMid, the derivative half way."),
                new CommonMistake(wrong(leaf, h, 0, 0.5, 1),
                        "gMid was evaluated at time t; half way the clock stands at t + deltaT/2."),
                new CommonMistake(wrong(leaf, h, 1, 1, 1),
                        "gMid was evaluated at the end of the Euler step;"
                                + " half way means s + deltaS/2 and t + deltaT/2."),
                new CommonMistake(wrong(leaf, h, 0.5, 1, 1), "The state half way is s + deltaS/2, not s + deltaS."),
                new CommonMistake(wrong(leaf, h, 1, 0.5, 1), "The time half way is t + deltaT/2, not t + deltaT."),
                new CommonMistake(wrong(leaf, h, 0.5, 0.5, 0.5),
                        "The last step was half as long as it should be: deltaT gMid, from the start."),
                new CommonMistake(leaf.afterMistake(STEPS, h, new double[] {0, 0.5}, new double[][] {{}, {0.5}},
                        new double[] {0.5, 1}),
                        "Go back to the start: the step with gMid begins at s, not at the point half way."),
                new CommonMistake(leaf.after("midpoint", 1, h), "This is one step; two are wanted."),
                new CommonMistake(new Leaf(c, b, v).after("midpoint", STEPS, h),
                        "The mass is missing: the acceleration is the force over m.")));
    }

    private static double wrong(Leaf leaf, double h, double time, double state, double weight) {
        return leaf.afterMistake(STEPS, h, new double[] {0, time}, new double[][] {{}, {state}},
                new double[] {0, weight});
    }
}
