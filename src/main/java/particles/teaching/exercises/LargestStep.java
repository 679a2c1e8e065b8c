package particles.teaching.exercises;

import java.util.List;
import particles.teaching.marking.Draw.Picks;
import particles.teaching.marking.NumericExercise;
import particles.teaching.marking.Question;

/** The exercise on the largest step with which RK4 stays stable on a chain between two walls, found by trial. */
final class LargestStep extends NumericExercise {
    /** The limits of RK4 on the imaginary and on the real axis, and of the leapfrogs. */
    private static final double IMAGINARY = 2 * Math.sqrt(2);
    private static final double REAL = 2.785294;
    private static final double LEAPFROG = 2;

    LargestStep() {
        super("The largest stable step of a chain", "s", 0.005, 0.3, """
                %s particles of m = %s kg each stand in a row between two walls, joined to each other and to the \
                walls by %s springs of k = %s N/m, without damping; they move along the row.
                What is the largest deltaT with which RK4 is stable?
                ---
                Which way of swinging is the fastest of this chain, and which number belongs to RK4 without damping?
                2.785 is RK4's limit on the real axis, for damping; undamped springs lie on the imaginary one.
                2 is the limit of symplectic Euler and verlet (and of Euler for damping), not that of RK4.
                sqrt(k/m) is one particle on one spring; here each has two, and neighbours that swing against it.
                This is the limit for a very long chain; this one is short, and its fastest swinging is slower.
                This is stable for the slowest swinging; the fastest one, neighbours against each other, sets the \
                limit.
                This is the shortest period; RK4 has a number of its own in the place of 2 pi.
                The root is missing: this divides by omega^2.
                Mass and stiffness are the wrong way round: omega is the root of k/m.
                """);
    }

    @Override
    protected Question ask(Picks picks) {
        int count = picks.whole(2, 4);
        double m = picks.decimal(2, 60, 2);
        double k = picks.whole(30, 900);
        double omega = Math.sqrt(k / m);
        double highest = 2 * omega * StrictMath.sin(count * Math.PI / (2.0 * (count + 1)));
        double lowest = 2 * omega * StrictMath.sin(Math.PI / (2.0 * (count + 1)));
        return question(IMAGINARY / highest, 0, List.of(count, m, count + 1, k), REAL / highest,
                LEAPFROG / highest, IMAGINARY / omega, IMAGINARY / (2 * omega), IMAGINARY / lowest,
                2 * Math.PI / highest, IMAGINARY / (highest * highest), IMAGINARY / (highest * m / k));
    }
}
