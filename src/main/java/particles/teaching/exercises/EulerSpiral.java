package particles.teaching.exercises;

import java.util.List;
import particles.teaching.marking.CommonMistake;
import particles.teaching.marking.Draw;
import particles.teaching.marking.Draw.Picks;
import particles.teaching.marking.NumericExercise;
import particles.teaching.marking.Question;

/** The exercise on Euler's spiral in state space: each step multiplies the energy. */
final class EulerSpiral extends NumericExercise {

    EulerSpiral() {
        super("Why Euler spirals: the energy that steps add", 1.1, 1000,
                "What does one step make of x^2 + (v/omega)^2? Draw the"
                        + " step in state space, and then think of all steps.");
    }

    @Override
    protected Question ask(Picks picks) {
        double m = picks.of(0.4, 0.5, 0.8, 1.25, 1.6, 2, 2.5, 4);
        double k = picks.decimal(20, 90, 1);
        double h = picks.decimal(4, 16, 2);
        int steps = picks.whole(12, 40);
        double growth = ratio(m, k, h, steps);
        double squared = h * h * k / m;
        return new Question("A particle of m = " + Draw.text(m) + " kg on an undamped spring of k = " + Draw.text(k)
                + " N/m is pulled aside and released.\nBy which factor have " + steps + " Euler steps of deltaT = "
                + Draw.text(h)
                + " s multiplied its energy, (m v^2 + k x^2)/2?", "", FOUR_DIGITS, growth, 0, List.of(
                new CommonMistake(Math.sqrt(growth), "This is the factor of the amplitude;"
                        + " energy goes with its square."),
                new CommonMistake(growth * growth,
                        "This is squared once too often: Pythagoras gives"
                                + " the square of the radius, which is the energy."),
                new CommonMistake(ratio(m, k, h, 1), "This is what one step does; each step multiplies again."),
                new CommonMistake(1 + steps * squared,
                        "What the steps add is itself multiplied by later steps: take the power, not the multiple."),
                new CommonMistake(ratio(1, k, h, steps), "The mass is missing: omega^2 = k/m."),
                new CommonMistake(StrictMath.pow(1 + h * Math.sqrt(k / m), 2 * steps),
                        "An undamped spring turns in state space: its step is at right angles to the radius, so that "
                                + "Pythagoras says how far out it ends, and not a sum."),
                new CommonMistake(1, "In truth the energy stays; the question asks for Euler's result.")));
    }

    private static double ratio(double m, double k, double h, int steps) {
        Spring spring = new Spring(m, k, 0, 1, 0);
        double before = spring.energy();
        return spring.after("euler", steps, h).energy() / before;
    }
}
