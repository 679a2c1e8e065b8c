package particles.teaching.exercises;

import deSolvers.DESolver;
import deSolvers.catalog.SolverCatalog;
import java.util.List;
import particles.teaching.exercises.NumericExercise.Worked;

/** The exercises on the length of a step: stability, energy, damping, adaptive steps. */
final class StepExercises {
    /** The limits of RK4 on the imaginary and on the real axis, and of the leapfrogs. */
    private static final double IMAGINARY = 2 * Math.sqrt(2);
    private static final double REAL = 2.785294;
    private static final double LEAPFROG = 2;
    private static final int SWINGS = 20_000;
    private static final double RESONANCE = 0.01;
    private static final int DAMPED_STEPS = 40;
    private static final int ERROR_ORDER = 5;
    private static final int RICHARDSON = 15;

    private StepExercises() {
    }

    /** The exercise on the largest step with which RK4 stays stable on a chain between two walls, found by trial. */
    static NumericExercise largestStep() {
        return new NumericExercise("The largest stable step of a chain", "s", 0.005, 0.3, """
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
                """, picks -> {
            int count = picks.whole(2, 4);
            double m = picks.decimal(2, 60, 2);
            double k = picks.whole(30, 900);
            double omega = Math.sqrt(k / m);
            double highest = 2 * omega * StrictMath.sin(count * Math.PI / (2.0 * (count + 1)));
            double lowest = 2 * omega * StrictMath.sin(Math.PI / (2.0 * (count + 1)));
            return new Worked(IMAGINARY / highest, 0, List.of(count, m, count + 1, k), REAL / highest,
                    LEAPFROG / highest, IMAGINARY / omega, IMAGINARY / (2 * omega), IMAGINARY / lowest,
                    2 * Math.PI / highest, IMAGINARY / (highest * highest), IMAGINARY / (highest * m / k));
        });
    }

    /** The exercise on symplectic Euler's energy, whose error oscillates within fixed limits. */
    static NumericExercise symplecticEnergy() {
        return new NumericExercise("Symplectic Euler: how far the energy swings", "", 1.02, 40, """
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
                """, picks -> {
            double m = Spring.mass(picks);
            double k = picks.decimal(20, 90, 1);
            double omega = Math.sqrt(k / m);
            double largest = 1.05 * StrictMath.pow(30, picks.decimal(0, 9999, 4));
            double h = Math.rint(2000 * (1 - 1 / largest) / omega) / 1000;
            double half = h * omega / 2;
            // at deltaT omega = 1 every sixth step is at the same place, and the highest point is never met
            double smallest = half > 0.97 || Math.abs(4 * half * half - 1) < RESONANCE ? Double.POSITIVE_INFINITY : 0;
            double answer = highest(m, k, h);
            return new Worked(answer, smallest, List.of(m, k, h, SWINGS), 1 / (1 + half), Math.sqrt(answer), answer - 1,
                    1 + half, 1, 1 / (1 - 2 * half), 1 / (1 - h * Math.sqrt(k) / 2));
        });
    }

    private static double highest(double m, double k, double h) {
        Spring spring = new Spring(m, k, 0, 1, 0);
        double before = spring.energy();
        double highest = before;
        DESolver solver = SolverCatalog.create("symplectic-euler");
        for (int n = 0; n < SWINGS && highest < 1e6 * before; n++) {
            solver.stepState(spring, h);
            highest = Math.max(highest, spring.energy());
        }
        return highest / before;
    }

    /**
     * The exercise on numerical damping: the physical damper that would take out as much energy as backward Euler does.
     */
    static NumericExercise numericalDamping() {
        return new NumericExercise("Damping that is not physical", "N s/m", 0.1, 15, """
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
                """, picks -> {
            double m = Spring.mass(picks);
            double k = picks.decimal(20, 400, 1);
            double h = picks.decimal(5, 30, 2);
            Spring spring = new Spring(m, k, 0, 1, 0);
            double left = spring.after("backward-euler", DAMPED_STEPS, h).energy() / spring.energy();
            double rate = -StrictMath.log(left) / (DAMPED_STEPS * h);
            double c = m * rate;
            return new Worked(c, 0, List.of(m, k, h), c / 2, 2 * c, rate, c * h, h * k,
                    m * StrictMath.log(1 + h * Math.sqrt(k / m)) / h, StrictMath.log(1 + h * h * k) / h * m, 0);
        });
    }

    /** The exercise on backward Euler for a spring that is much too stiff for Euler. */
    static NumericExercise stiffSpring() {
        return new NumericExercise("A stiff spring and backward Euler", "m/s", -30, 12, """
                A particle of m = %s kg on a stiff spring of k = %s N/m with a damper of c = %s N s/m is at x = %s m \
                and has v = %s m/s.
                What is its velocity after one step of backward Euler with deltaT = %s s, where force and velocity \
                are those at the end of the step?
                ---
                Write down both equations with x and v at the end of the step as unknowns, and put one into the \
                other.
                This is the Euler method: the forces are those at the start of the step.
                The spring's force has to be that at the end of the step too: k (x + deltaT v), with the new v.
                The damper's force has to be that at the end of the step too: c times the new v.
                This is the implicit midpoint method: half way, not at the end.
                The damper is missing.
                The mass is missing: a = F/m.
                This is the position; the question asks for the velocity.
                These are two steps; one is wanted.
                This is the exact motion; the question asks for backward Euler's result.
                """, picks -> {
            double m = Spring.mass(picks);
            double k = 10 * picks.whole(20, 120);
            double c = picks.decimal(20, 120, 1);
            double x = picks.decimal(50, 150, 2);
            double v = picks.decimal(20, 200, 1);
            double h = picks.of(0.05, 0.06, 0.08, 0.1, 0.12);
            Spring spring = new Spring(m, k, c, x, v);
            Spring right = spring.after("backward-euler", 1, h);
            double pull = v - h * k / m * x;
            return new Worked(right.v(), 0.1 * v, List.of(m, k, c, x, v, h), spring.after("euler", 1, h).v(),
                    pull / (1 + h * c / m), (pull - v * h * c / m) / (1 + h * h * k / m),
                    spring.after("implicit-midpoint", 1, h).v(),
                    new Spring(m, k, 0, x, v).after("backward-euler", 1, h).v(),
                    new Spring(1, k, c, x, v).after("backward-euler", 1, h).v(), right.x(),
                    spring.after("backward-euler", 2, h).v(), spring.truly(h).v());
        });
    }

    /** The exercise on adaptive steps as on the slide: two steps of deltaT, one of twice that, compare, adjust. */
    static NumericExercise adaptiveStep() {
        return new NumericExercise("Adaptive steps: the next deltaT", "s", 0.01, 0.4, """
                A particle of m = %s kg on a spring of k = %s N/m is at x = %s m with v = %s m/s. Take two steps of \
                RK4 with deltaT = %s s, and one of 2 deltaT from the same start; the difference of the two x is the \
                error.
                Which deltaT would make this error %s m? Assume that it grows with deltaT as the error of a single \
                step, not of a whole run, of a method of order 4.
                ---
                Calculate the difference first; then ask how it changes when deltaT becomes half as long.
                The error over a given time goes with the fourth power; that of one step goes with the fifth.
                The fraction is the wrong way round: too large an error needs a shorter step.
                The error does not go with deltaT itself but with its fifth power: take the fifth root.
                The square root belongs to a method of order 1; RK4's error of one step goes with the fifth power.
                The cube root belongs to a method of order 2; RK4's error of one step goes with the fifth power.
                The fifteenth of the difference is the error of the better result; the question asks for the \
                difference itself.
                This is 2 deltaT; the question asks for deltaT, the length of the short steps.
                The steps are those of the midpoint method; RK4's are wanted.
                The mass is missing: a = F/m = -(k/m) x.
                """, picks -> {
            double m = Spring.mass(picks);
            double k = picks.size(1, 30);
            double x = picks.decimal(50, 150, 2);
            double v = picks.decimal(5, 15, 1);
            double h = picks.of(0.1, 0.12, 0.15, 0.2, 0.25);
            double bound = picks.of(1e-7, 3e-7, 1e-6, 3e-6, 1e-5, 3e-5, 1e-4);
            Spring spring = new Spring(m, k, 0, x, v);
            double error = difference("rk4", spring, h);
            double factor = bound / error;
            double smallest = error < 1e-6 * x ? Double.POSITIVE_INFINITY : 0;      // roundings on the way would show
            double next = next(h, factor, ERROR_ORDER);
            return new Worked(next, smallest, List.of(m, k, x, v, h, bound), next(h, factor, ERROR_ORDER - 1),
                    next(h, 1 / factor, ERROR_ORDER), next(h, factor, 1), next(h, factor, 2), next(h, factor, 3),
                    next(h, RICHARDSON * factor, ERROR_ORDER), 2 * next,
                    next(h, bound / difference("midpoint", spring, h), ERROR_ORDER),
                    next(h, bound / difference("rk4", new Spring(1, k, 0, x, v), h), ERROR_ORDER));
        });
    }

    private static double next(double h, double factor, double root) {
        return h * StrictMath.pow(factor, 1 / root);
    }

    private static double difference(String solver, Spring spring, double h) {
        return Math.abs(spring.after(solver, 2, h).x() - spring.after(solver, 1, 2 * h).x());
    }
}
