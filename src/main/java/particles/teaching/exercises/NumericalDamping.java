package particles.teaching.exercises;

import java.util.List;
import particles.teaching.marking.Draw.Picks;
import particles.teaching.marking.NumericExercise;
import particles.teaching.marking.Question;

/** The exercise on numerical damping: the physical damper that would take out as much energy as backward Euler does. */
final class NumericalDamping extends NumericExercise {
    private static final int STEPS = 40;

    NumericalDamping() {
        super("Damping that is not physical", "N s/m", 0.1, 15, """
                A particle of m = %s kg swings on a spring of k = %s N/m without any damper. Backward Euler with \
                deltaT = %s s takes energy from it all the same.
                Which damping c would take as much in truth? A damper's force -c v lets the energy decay like \
                e^(-(c/m) t) on average.
                ---
                By which factor does one step of backward Euler multiply the energy? Compare that with what a damper \
                does in deltaT.
                This lets the energy decay as fast as the amplitude does; energy goes with the amplitude's square.
                This is twice as much: the factor of a step is that of the energy already, and its root that of the \
                amplitude.
                This is c/m: multiply by the mass.
                This is the loss of one step; divide by deltaT for that of a second.
                This holds for very short steps only: the steps multiply, and what decays like e^(-(c/m) t) has a \
                logarithm.
                A square is missing in the factor of one step.
                The mass is missing in omega^2 = k/m.
                There is no damper, and yet the energy is lost: that is the solver's doing, and asked for here.
                """);
    }

    @Override
    protected Question ask(Picks picks) {
        double m = Spring.mass(picks);
        double k = picks.decimal(20, 400, 1);
        double h = picks.decimal(5, 30, 2);
        Spring spring = new Spring(m, k, 0, 1, 0);
        double left = spring.after("backward-euler", STEPS, h).energy() / spring.energy();
        double rate = -StrictMath.log(left) / (STEPS * h);
        double c = m * rate;
        return question(c, 0, List.of(m, k, h), c / 2, 2 * c, rate, c * h, h * k,
                m * StrictMath.log(1 + h * Math.sqrt(k / m)) / h, StrictMath.log(1 + h * h * k) / h * m, 0);
    }
}
