package particles.teaching.exercises;

import java.util.List;
import particles.teaching.marking.CommonMistake;
import particles.teaching.marking.Draw;
import particles.teaching.marking.Draw.Picks;
import particles.teaching.marking.NumericExercise;
import particles.teaching.marking.Question;

/** The exercise on numerical damping: the physical damper that would take out as much energy as backward Euler does. */
final class NumericalDamping extends NumericExercise {
    private static final int STEPS = 40;

    NumericalDamping() {
        super("Damping that is not physical", 0.1, 3,
                "By which factor does one step of backward Euler multiply the energy? Compare that with what a damper "
                        + "does in deltaT.");
    }

    @Override
    protected Question ask(Picks picks) {
        double m = picks.of(0.4, 0.5, 0.8, 1.25, 1.6, 2, 2.5, 4);
        double k = picks.decimal(20, 90, 1);
        double h = picks.decimal(5, 30, 2);
        Spring spring = new Spring(m, k, 0, 1, 0);
        double before = spring.energy();
        double left = spring.after("backward-euler", STEPS, h).energy() / before;
        double rate = -StrictMath.log(left) / (STEPS * h);
        double c = m * rate;
        return new Question("A particle of m = " + Draw.text(m) + " kg swings on a spring of k = " + Draw.text(k)
                + " N/m without any damper. Backward Euler with deltaT = " + Draw.text(h)
                + " s takes energy from it all the same.\nWhich damping c would take as much in truth?"
                + " A damper's force -c v lets the energy decay like e^(-(c/m) t) on average.",
                "N s/m", FOUR_DIGITS, c, 0, List.of(
                new CommonMistake(c / 2, "This lets the energy decay as fast as the amplitude does; energy goes with "
                        + "the amplitude's square."),
                new CommonMistake(2 * c, "This is twice as much: the factor of a step is that of the energy already, "
                        + "and its root that of the amplitude."),
                new CommonMistake(rate, "This is c/m: multiply by the mass."),
                new CommonMistake(c * h, "This is the loss of one step; divide by deltaT for that of a second."),
                new CommonMistake(h * k, "This holds for very short steps only: the steps multiply, and what decays "
                + "like e^(-(c/m) t) has a logarithm."),
                new CommonMistake(m * StrictMath.log(1 + h * Math.sqrt(k / m)) / h,
                        "A square is missing in the factor of one step."),
                new CommonMistake(StrictMath.log(1 + h * h * k) / h * m, "The mass is missing in omega^2 = k/m."),
                new CommonMistake(0, "There is no damper, and yet the energy is lost: that is the solver's doing, and "
                + "asked for here.")));
    }
}
