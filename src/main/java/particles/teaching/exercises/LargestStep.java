package particles.teaching.exercises;

import deSolvers.DESolver;
import deSolvers.DESolverException;
import deSolvers.catalog.SolverCatalog;
import java.util.List;
import particles.ParticleSystem;
import particles.effects.springs.SpringForce;
import particles.law.Vector3;
import particles.teaching.marking.Draw.Picks;
import particles.teaching.marking.NumericExercise;
import particles.teaching.marking.Question;

/** The exercise on the largest step with which RK4 stays stable on a chain between two walls, found by trial. */
final class LargestStep extends NumericExercise {
    private static final int STEPS = 600;
    private static final int HALVINGS = 20;
    private static final double AMPLITUDE = 1e-6;
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
        return question(limit(count, m, k, IMAGINARY / (4 * omega)), 0, List.of(count, m, count + 1, k), REAL / highest,
                LEAPFROG / highest, IMAGINARY / omega, IMAGINARY / (2 * omega), IMAGINARY / lowest,
                2 * Math.PI / highest, IMAGINARY / (highest * highest), IMAGINARY / (highest * m / k));
    }

    /**
     * Finds the limit by bisection, between a step that is stable for any chain of such springs and four times that,
     * which is stable for none.
     */
    private static double limit(int count, double m, double k, double stable) {
        double low = stable;
        double high = 4 * stable;
        for (int halving = 0; halving < HALVINGS; halving++) {
            double middle = (low + high) / 2;
            if (grows(count, m, k, middle)) {
                high = middle;
            } else {
                low = middle;
            }
        }
        return low;
    }

    private static boolean grows(int count, double m, double k, double deltaT) {
        ParticleSystem system = new ParticleSystem();
        SpringForce springs = new SpringForce(system.getParticles());
        for (int i = 0; i < count + 2; i++) {
            boolean wall = i == 0 || i == count + 1;
            double aside = wall ? 0 : i % 2 == 0 ? AMPLITUDE : -AMPLITUDE;
            system.addParticle("p" + i, m, new Vector3(i + aside, 0, 0), Vector3.ZERO, wall);
            if (i > 0) {
                springs.addSpring(i - 1, i, k, 1, 0);
            }
        }
        system.addEffect(springs);
        DESolver solver = SolverCatalog.create("rk4");
        double before = system.getEnergy(system.getOwnState(), 0);
        try {
            for (int n = 0; n < STEPS; n++) {
                solver.stepState(system, deltaT);
                if (!(system.getEnergy(system.getOwnState(), 0) < 100 * before)) {
                    return true;
                }
            }
        } catch (DESolverException e) {
            return true;                                // it overflowed, or two particles met
        }
        return system.getEnergy(system.getOwnState(), 0) > before;
    }
}
