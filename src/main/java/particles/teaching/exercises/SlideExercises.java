package particles.teaching.exercises;

import java.util.List;
import particles.teaching.exercises.NumericExercise.Worked;

/** The exercises on the methods of the slides: Euler, midpoint and RK4. */
final class SlideExercises {
    private static final int EULER_STEPS = 3;
    private static final int MIDPOINT_STEPS = 2;
    /** The largest deltaT c/m, well below the stability limit, 2. */
    private static final double LONGEST_MIDPOINT = 1.5;

    private static final String MIDPOINT = """
             0  |
            1/2 | 1/2
            ----+---------
                |  0   1
            """;
    /** The largest deltaT c/m, well below the stability limit, 2.785. */
    private static final double LONGEST_RK4 = 2;
    private static final String WEIGHTS = "1/6 1/3 1/3 1/6";
    private static final String RK4 = """
             0  |
            1/2 | 1/2
            1/2 |  0  1/2
             1  |  0   0   1
            ----+-----------------
                | 1/6 1/3 1/3 1/6
            """;
    private static final int FEWEST_STEPS = 16;
    private static final double HUNDRED = 100;

    private SlideExercises() {
    }

    /** The exercise on three steps of the Euler method by hand. */
    static NumericExercise eulerSteps() {
        return new NumericExercise("Three steps of the Euler method", "m", -9, 8, """
                A particle of m = %s kg slides on a spring of k = %s N/m, without gravity or friction: x'' = -(k/m) \
                x. It is at x = %s m and moves with v = %s m/s.
                Where is it after three Euler steps of deltaT = %s s?
                ---
                Write down x, v and a for the start, make one step, and go on from there; compute a anew each step.
                The position was moved with the new velocity: that is the simple algorithm (symplectic Euler). Euler \
                uses the derivative at the start of the step for both.
                These are two steps; three are wanted.
                These are four steps; three are wanted.
                This is one step of three times deltaT; the derivative has to be evaluated anew after each step.
                This is the velocity; the question asks for the place.
                The mass is missing: a = F/m = -(k/m) x.
                The spring pulls back: the sign of its force is minus.
                This is the midpoint method; Euler evaluates the derivative once, at the start of the step.
                This is the exact motion; the question asks for Euler's result.
                """, picks -> {
            double m = Spring.mass(picks);
            double k = picks.decimal(20, 90, 1);
            double x = picks.decimal(50, 300, 2);
            double v = picks.decimal(5, 60, 1);
            double h = picks.of(0.1, 0.15, 0.2, 0.25);
            Spring spring = new Spring(m, k, 0, x, v);
            Spring right = spring.after("euler", EULER_STEPS, h);
            return new Worked(right.x(), 0.1 * x, List.of(m, k, x, v, h),
                    spring.after("symplectic-euler", EULER_STEPS, h).x(),
                    spring.after("euler", EULER_STEPS - 1, h).x(), spring.after("euler", EULER_STEPS + 1, h).x(),
                    spring.after("euler", 1, EULER_STEPS * h).x(), right.v(),
                    new Spring(1, k, 0, x, v).after("euler", EULER_STEPS, h).x(),
                    new Spring(m, -k, 0, x, v).after("euler", EULER_STEPS, h).x(),
                    spring.after("midpoint", EULER_STEPS, h).x(), spring.truly(EULER_STEPS * h).x());
        });
    }

    /** The exercise on Euler's spiral in state space: each step multiplies the energy. */
    static NumericExercise eulerSpiral() {
        return new NumericExercise("Why Euler spirals: the energy that steps add", "", 1.1, 1000, """
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
                """, picks -> {
            double m = Spring.mass(picks);
            double k = picks.decimal(20, 90, 1);
            double h = picks.decimal(4, 16, 2);
            int steps = picks.whole(12, 40);
            double growth = ratio(m, k, h, steps);
            return new Worked(growth, 0, List.of(m, k, steps, h), Math.sqrt(growth), growth * growth, ratio(m, k, h, 1),
                    1 + steps * h * h * k / m, ratio(1, k, h, steps),
                    StrictMath.pow(1 + h * Math.sqrt(k / m), 2 * steps), 1);
        });
    }

    private static double ratio(double m, double k, double h, int steps) {
        Spring spring = new Spring(m, k, 0, 1, 0);
        return spring.after("euler", steps, h).energy() / spring.energy();
    }

    /** The exercise on two steps of the midpoint method, with a derivative that depends on time. */
    static NumericExercise midpointSteps() {
        return new NumericExercise("Two steps of the midpoint method", "m/s", 0.5, 20, """
                A leaf of m = %s kg drifts in a wind that freshens: the air's velocity is b t with b = %s m/s^2, and \
                the drag coefficient c = %s N s/m, so that v' = -(c/m)(v - b t). At t = 0 the leaf has v = %s m/s.
                What is v after two steps of the midpoint method with deltaT = %s s?
                ---
                Write down dSdt, the state half way and gMid of the first step, each with its time.
                This is the Euler method: take the step with gMid, the derivative half way.
                gMid was evaluated at time t; half way the clock stands at t + deltaT/2.
                gMid was evaluated at the end of the Euler step; half way means s + deltaS/2 and t + deltaT/2.
                The state half way is s + deltaS/2, not s + deltaS.
                The time half way is t + deltaT/2, not t + deltaT.
                The last step was half as long as it should be: deltaT gMid, from the start.
                Go back to the start: the step with gMid begins at s, not at the point half way.
                This is one step; two are wanted.
                The mass is missing: the acceleration is the force over m.
                """, picks -> {
            double m = Leaf.mass(picks);
            double c = picks.decimal(4, 20, 1);
            double b = picks.size(0.5, 10);
            double v = picks.size(2, 50);
            double h = picks.of(0.2, 0.25, 0.3, 0.4, 0.5);
            double a = c / m;
            Leaf leaf = new Leaf(a, b, v);
            double smallest = a * h > LONGEST_MIDPOINT ? Double.POSITIVE_INFINITY : 0.05 * v;
            return new Worked(leaf.after("midpoint", MIDPOINT_STEPS, h), smallest, List.of(m, b, c, v, h),
                    leaf.after("euler", MIDPOINT_STEPS, h), wrongMidpoint(leaf, h, "1/2 |", "0 |"),
                    wrongMidpoint(leaf, h, "1/2", "1"), wrongMidpoint(leaf, h, "| 1/2", "| 1"),
                    wrongMidpoint(leaf, h, "1/2 |", "1 |"), wrongMidpoint(leaf, h, "0   1", "0 1/2"),
                    wrongMidpoint(leaf, h, "0   1", "1/2 1"), leaf.after("midpoint", 1, h),
                    new Leaf(c, b, v).after("midpoint", MIDPOINT_STEPS, h));
        });
    }

    private static double wrongMidpoint(Leaf leaf, double h, String right, String wrong) {
        return leaf.afterMistake(MIDPOINT, right, wrong, MIDPOINT_STEPS, h);
    }

    /** The exercise on one long step of RK4, with a derivative that depends on time. */
    static NumericExercise rk4Step() {
        return new NumericExercise("One step of RK4", "m/s", 0.5, 60, """
                The leaf again: m = %s kg, drag c = %s N s/m, the air moves with b t, b = %s m/s^2, so that v' = \
                -(c/m)(v - b t); at t = 0 it has v = %s m/s.
                What is v after one step of RK4 with deltaT = %s s?
                ---
                Write down k1 to k4, each with the state and the time at which it is evaluated.
                k2 belongs at s + k1/2, not at s + k1.
                k3 belongs at s + k2/2, not at s + k1/2.
                k4 belongs at s + k3, not at s + k3/2.
                k4 is evaluated at t + deltaT/2; the slide says t + deltaT.
                All four were evaluated at time t; the clock has to move with the stages.
                The weights are 1/6, 1/3, 1/3, 1/6, not four times 1/4.
                The weights are the wrong way round: the two in the middle count 1/3, the outer ones 1/6.
                The weights have to add up to 1: 1/6, 1/3, 1/3, 1/6.
                This is the midpoint method.
                This is the Euler method, k1 alone.
                The mass is missing: the acceleration is the force over m.
                """, picks -> {
            double m = Leaf.mass(picks);
            double c = picks.decimal(4, 20, 1);
            double b = picks.size(0.5, 40);
            double v = picks.size(2, 80);
            double h = picks.of(0.4, 0.5, 0.6, 0.75, 0.8);
            double a = c / m;
            Leaf leaf = new Leaf(a, b, v);
            double smallest = a * h > LONGEST_RK4 ? Double.POSITIVE_INFINITY : 0.05 * v;
            return new Worked(leaf.after("rk4", 1, h), smallest, List.of(m, c, b, v, h),
                    wrongRK4(leaf, h, "1/2 | 1/2", "1/2 | 1"), wrongRK4(leaf, h, " 0  1/2", "1/2 0"),
                    wrongRK4(leaf, h, "0   1", "0 1/2"), wrongRK4(leaf, h, " 1  |", "1/2 |"),
                    leaf.afterMistake(RK4.replace("1/2 |", "0 |"), " 1  |", "0 |", 1, h),
                    wrongRK4(leaf, h, WEIGHTS, "1/4 1/4 1/4 1/4"), wrongRK4(leaf, h, WEIGHTS, "1/3 1/6 1/6 1/3"),
                    wrongRK4(leaf, h, WEIGHTS, "1/6 1/6 1/6 1/6"), leaf.after("midpoint", 1, h),
                    leaf.after("euler", 1, h), new Leaf(c, b, v).after("rk4", 1, h));
        });
    }

    private static double wrongRK4(Leaf leaf, double h, String right, String wrong) {
        return leaf.afterMistake(RK4, right, wrong, 1, h);
    }

    /**
     * The exercise that the lecture calls UDOO: the cost of RK4 against midpoint for similar accuracy, with the
     * student's own duration and accuracy.
     */
    static NumericExercise costOfRK4() {
        return new NumericExercise("What midpoint costs against RK4", "", 6, 150, """
                x'' = -omega^2 x with omega = %s 1/s begins at x = 1 m, v = 0, and is followed for %s s. The error \
                at the end, |(x - x exact, (v - v exact)/omega)|, may be %s m.
                How many times as many evaluations of the derivative does the midpoint method need as RK4, each with \
                the fewest steps of equal length that are good enough?
                ---
                For each method, write down how the error at the end goes with the number of steps; the frequency \
                and the duration count too.
                This is the ratio of the steps; a step of midpoint has two evaluations and one of RK4 four.
                The weights are the wrong way round: midpoint has two evaluations per step, RK4 four.
                This is RK4's cost over midpoint's; the question asks for midpoint's over RK4's.
                This compares one step with one step; for the same accuracy RK4 may take far longer ones.
                This is about the ratio for a hundredth of the error: check the power of ten.
                The orders alone do not do it: the errors' constants and the duration count too.
                """, picks -> {
            double duration = picks.whole(30, 60);
            double omega = picks.decimal(100, 150, 2);
            double error = picks.size(3e-7, 0.01);
            double midpoint = steps("midpoint", 2, omega, duration, error);
            double rk4 = steps("rk4", 4, omega, duration, error);
            double ratio = 2 * midpoint / (4 * rk4);
            return new Worked(ratio, 0, List.of(omega, duration, error), 2 * ratio, 4 * ratio, 1 / ratio, 0.5,
                    StrictMath.pow(HUNDRED, 0.25) * ratio, StrictMath.pow(error, -0.25));
        });
    }

    /** The fewest steps that are accurate enough; a guess by the order of the method is at most a few steps off. */
    private static int steps(String solver, int order, double omega, double duration, double error) {
        int steps = FEWEST_STEPS;
        double found = error(solver, omega, duration, steps);
        while (found > error) {
            steps = (int) Math.ceil(steps * Math.min(8, StrictMath.pow(found / error, 1.0 / order)));
            found = error(solver, omega, duration, steps);
        }
        while (error(solver, omega, duration, steps - 1) <= error) {
            steps--;
        }
        return steps;
    }

    private static double error(String name, double omega, double duration, int steps) {
        Spring spring = new Spring(1, omega * omega, 0, 1, 0).after(name, steps, duration / steps);
        double dx = spring.x() - StrictMath.cos(omega * duration);
        double dv = spring.v() / omega + StrictMath.sin(omega * duration);
        return Math.sqrt(dx * dx + dv * dv);
    }
}
