package particles.teaching.exercises;

import deSolvers.DESolver;
import deSolvers.catalog.SolverCatalog;
import java.util.List;
import particles.teaching.marking.Draw.Picks;
import particles.teaching.marking.NumericExercise;
import particles.teaching.marking.Question;

/** The exercise on symplectic Euler's energy, whose error oscillates within fixed limits. */
final class SymplecticEnergy extends NumericExercise {
    private static final int STEPS = 20_000;
    private static final double RESONANCE = 0.01;

    SymplecticEnergy() {
        super("Symplectic Euler: how far the energy swings", "", 1.02, 40, """
                A particle of m = %s kg on an undamped spring of k = %s N/m is pulled aside and released from rest, \
                and moved by the simple algorithm (symplectic Euler) with deltaT = %s s.
                What is the largest energy, (m v^2 + k x^2)/2, within %s steps, as a multiple of the energy at the \
                start?
                ---
                Follow many steps by a program of your own, and note the largest energy after any of them.
                This is the smallest energy of the swing; the question asks for the largest.
                This is the factor of the amplitude; energy goes with its square.
                This is what comes on top; the question asks for the multiple of the energy at the start, 1 plus \
                that.
                This is right for short steps only: the higher powers of deltaT omega count too.
                Verlet would never have more than at the start; symplectic Euler's energy swings to both sides.
                A half is missing beside deltaT omega.
                The mass is missing: omega^2 = k/m.
                """);
    }

    @Override
    protected Question ask(Picks picks) {
        double m = Spring.mass(picks);
        double k = picks.decimal(20, 90, 1);
        double omega = Math.sqrt(k / m);
        double h = Math.rint(2000 * (1 - 1 / (1.05 * StrictMath.pow(30, picks.decimal(0, 9999, 4)))) / omega) / 1000;
        double half = h * omega / 2;
        // at deltaT omega = 1 every sixth step is at the same place, and the highest point is never met
        double smallest = half > 0.97 || Math.abs(4 * half * half - 1) < RESONANCE ? Double.POSITIVE_INFINITY : 0;
        double answer = highest(m, k, h);
        return question(answer, smallest, List.of(m, k, h, STEPS), 1 / (1 + half), Math.sqrt(answer), answer - 1,
                1 + half, 1, 1 / (1 - 2 * half), 1 / (1 - h * Math.sqrt(k) / 2));
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
