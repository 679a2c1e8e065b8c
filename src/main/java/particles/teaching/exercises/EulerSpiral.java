package particles.teaching.exercises;

import java.util.List;
import particles.teaching.marking.Draw;
import particles.teaching.marking.Draw.Picks;
import particles.teaching.marking.NumericExercise;
import particles.teaching.marking.Question;

/** The exercise on Euler's spiral in state space: each step multiplies the energy. */
final class EulerSpiral extends NumericExercise {

    EulerSpiral() {
        super("Why Euler spirals: the energy that steps add", "", 1.1, 1000, """
                A particle of m = %s kg on an undamped spring of k = %s N/m is pulled aside and released.
                By which factor have %s Euler steps of deltaT = %s s multiplied its energy, (m v^2 + k x^2)/2?
                ---
                What does one step make of x^2 + (v/omega)^2? Draw the step in state space, and then think of all \
                steps.
                This is the factor of the amplitude; energy goes with its square.
                This is squared once too often: Pythagoras gives the square of the radius, which is the energy.
                This is what one step does; each step multiplies again.
                What the steps add is itself multiplied by later steps: take the power, not the multiple.
                The mass is missing: omega^2 = k/m.
                The step is perpendicular to the radius, so the new radius follows from Pythagoras, not from adding \
                lengths.
                The exact energy is constant; the question asks for Euler's result.
                """);
    }

    @Override
    protected Question ask(Picks picks) {
        double m = Spring.mass(picks);
        double k = picks.decimal(20, 90, 1);
        double h = picks.decimal(4, 16, 2);
        int steps = picks.whole(12, 40);
        double growth = ratio(m, k, h, steps);
        return question(growth, 0, List.of(m, k, steps, h), Math.sqrt(growth), growth * growth, ratio(m, k, h, 1),
                1 + steps * h * h * k / m, ratio(1, k, h, steps),
                StrictMath.pow(1 + h * Math.sqrt(k / m), 2 * steps), 1);
    }

    private static double ratio(double m, double k, double h, int steps) {
        Spring spring = new Spring(m, k, 0, 1, 0);
        return spring.after("euler", steps, h).energy() / spring.energy();
    }
}
