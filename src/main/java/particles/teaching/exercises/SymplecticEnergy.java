package particles.teaching.exercises;

import deSolvers.DESolver;
import deSolvers.catalog.SolverCatalog;
import java.util.List;
import particles.teaching.marking.CommonMistake;
import particles.teaching.marking.Draw;
import particles.teaching.marking.Draw.Picks;
import particles.teaching.marking.NumericExercise;
import particles.teaching.marking.Question;

/** The exercise on symplectic Euler's energy, whose error oscillates within fixed limits. */
final class SymplecticEnergy extends NumericExercise {
    private static final int STEPS = 20_000;
    private static final double RESONANCE = 0.01;

    SymplecticEnergy() {
        super("Symplectic Euler: how far the energy swings", 1.02, 12,
                "Follow many steps by a program of your own, and note the largest energy after any of them.");
    }

    @Override
    protected Question ask(Picks picks) {
        double m = picks.of(0.4, 0.5, 0.8, 1.25, 1.6, 2, 2.5, 4);
        double k = picks.decimal(20, 90, 1);
        double h = picks.decimal(10, 60, 2);
        double half = h * Math.sqrt(k / m) / 2;
        // at deltaT omega = 1 every sixth step is at the same place, and the highest point is never met
        double smallest = half > 0.9 || Math.abs(4 * half * half - 1) < RESONANCE ? Double.POSITIVE_INFINITY : 0;
        double answer = highest(m, k, h);
        return new Question("A particle of m = " + Draw.text(m) + " kg on an undamped spring of k = " + Draw.text(k)
                + " N/m is pulled aside and released from rest, and moved by the simple algorithm (symplectic Euler) "
                + "with deltaT = " + Draw.text(h)
                + " s.\nWhat is the largest energy, (m v^2 + k x^2)/2, within " + STEPS
                + " steps, as a multiple of the energy at the start?",
                "", FOUR_DIGITS, answer, smallest, List.of(
                new CommonMistake(1 / (1 + half),
                        "This is the smallest energy of the swing; the question asks for the largest."),
                new CommonMistake(Math.sqrt(answer), "This is the factor of the amplitude;"
                        + " energy goes with its square."),
                new CommonMistake(answer - 1, "This is what comes on top; the question asks"
                        + " for the multiple of the energy at the "
                        + "start, 1 plus that."),
                new CommonMistake(1 + half, "This is right for short steps only: the"
                        + " higher powers of deltaT omega count too."),
                new CommonMistake(1, "Verlet would never have more than at the start;"
                        + " symplectic Euler's energy swings to both sides."),
                new CommonMistake(1 / (1 - 2 * half), "A half is missing beside deltaT omega."),
                new CommonMistake(1 / (1 - h * Math.sqrt(k) / 2), "The mass is missing: omega^2 = k/m.")));
    }

    private static double highest(double m, double k, double h) {
        Spring spring = new Spring(m, k, 0, 1, 0);
        double before = spring.energy();
        double highest = before;
        DESolver solver = SolverCatalog.create("symplectic-euler");
        for (int n = 0; n < STEPS && highest < 1e6 * before; n++) {
            solver.stepState(spring, h);
            highest = Math.max(highest, spring.energy());
        }
        return highest / before;
    }
}
