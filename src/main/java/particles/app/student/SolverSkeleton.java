package particles.app.student;

import java.util.Locale;
import java.util.regex.Matcher;
import particles.teaching.declared.Declaration;

/** The template of a student's solver: it compiles, and has the algorithm's outline as comments. */
final class SolverSkeleton {
    private static final String MIDPOINT = """
                    // 1. deltaS = deltaT * derivative at (s, t)                 the Euler step
                    // 2. gMid   = derivative at (s + deltaS/2, t + deltaT/2)    after half the time and half of deltaS
                    // 3. new s  = s + deltaT * gMid                             from the start s, not from the middle
            """;
    private static final String RK4 = """
                    // 1. k1 = deltaT * derivative at (s, t)                    the Euler step
                    // 2. k2 = deltaT * derivative at (s + k1/2, t + deltaT/2)  the midpoint step
                    // 3. k3 = deltaT * derivative at (s + k2/2, t + deltaT/2)  the refined midpoint step
                    // 4. k4 = deltaT * derivative at (s + k3, t + deltaT)      the refined refined step
                    // 5. new s = s + k1/6 + k2/3 + k3/3 + k4/6                 in Java 1/6 * k1[i] is 0: write 1.0/6
            """;
    private static final String SIMPLE = """
                    // 1. for each particle: a = F/m                  the derivative has it where v stands in s
                    // 2. v += a * deltaT
                    // 3. x += v * deltaT                             with the new v
            """;
    private static final String GENERAL = """
                    // 1. the derivative at (s, t): one straight step along it would be Euler's
                    // 2. perhaps further derivatives, each at a trial state and its own time
                    // 3. new s = s + deltaT * a mean of the derivatives; the weights add up to 1
            """;

    private static final String ON_DE_SOLVER = """
            package exercises;

            import deSolvers.DESolver;
            import deSolvers.DEStateSource;

            /** My own solver. To check it: gradle checkSolver -Psolver=exercises.NAME */
            public class NAME extends DESolver {

                @Override
                public void stepState(DEStateSource source, double deltaT) {
                    int n = source.getStateSize();
                    double[] state = new double[n];
                    double[] dSdt = new double[n];
                    source.getState(state);         // s at time t: x, y, z, vx, vy, vz of one particle after the other
                    source.getStateDerivative(dSdt);            // its derivative at (s, t)

            OUTLINE
                    // at the end: source.setState(the new state); the calls of source.incTime add up to deltaT
                }
            }
            """;

    private static final String ON_FIXED_STEP_SOLVER = """
            package exercises;

            import deSolvers.DEStateSource;
            import deSolvers.FixedStepSolver;

            /** My own solver. To check it: gradle checkSolver -Psolver=exercises.NAME */
            public class NAME extends FixedStepSolver {

                @Override
                protected void step(DEStateSource source, double[] s, double deltaT) {
                    double[] dSdt = derivative(s);              // the derivative at (s, t)
                    // s is x, y, z, vx, vy, vz of one particle after the other, and so is its derivative

                    // helpers: eulerStep(a, deltaT) is deltaT times the derivative at a; plus(s, 0.5, k) is s + 0.5 k;
                    // source.incTime(deltaT / 2) moves the clock before the next derivative
            OUTLINE
                    // at the end s is the new state: s[i] = ...; FixedStepSolver sets the clock to t + deltaT
                }
            }
            """;

    /** The class that a solver extends to begin with; the first as on the slides. */
    enum Base {
        DESOLVER(ON_DE_SOLVER),
        FIXEDSTEPSOLVER(ON_FIXED_STEP_SOLVER);

        private final String text;

        Base(String text) {
            this.text = text;
        }
    }

    /** A whole solver, to compare one's own with; the text is what follows the derivative. */
    enum Example {
        EULER("""
                for (int i = 0; i < n; i++) {
                    state[i] += deltaT * dSdt[i];
                }
                source.setState(state);                     // the new state, at time t + deltaT
                source.incTime(deltaT);
        """),
        MIDPOINT("""
                double[] middle = new double[n];
                for (int i = 0; i < n; i++) {
                    middle[i] = state[i] + deltaT / 2 * dSdt[i];
                }
                source.setState(middle);                    // a trial state, half way
                source.incTime(deltaT / 2);
                source.getStateDerivative(dSdt);
                for (int i = 0; i < n; i++) {
                    state[i] += deltaT * dSdt[i];           // from the start, along the derivative in the middle
                }
                source.setState(state);
                source.incTime(deltaT / 2);                 // t + deltaT
        """),
        HEUN("""
                double[] trial = new double[n];
                for (int i = 0; i < n; i++) {
                    trial[i] = state[i] + deltaT * dSdt[i];
                }
                source.setState(trial);                     // a trial state: Euler's
                source.incTime(deltaT);                     // and its time, t + deltaT
                double[] end = new double[n];
                source.getStateDerivative(end);
                for (int i = 0; i < n; i++) {
                    state[i] += deltaT / 2 * (dSdt[i] + end[i]);
                }
                source.setState(state);                     // the clock is at t + deltaT already
        """);

        private final String text;

        Example(String text) {
            this.text = text;
        }
    }

    private SolverSkeleton() {
    }

    /**
     * @param name    the class's name
     * @param example the method
     * @return the text of a whole solver
     */
    static String example(String name, Example example) {
        return ON_DE_SOLVER.replaceFirst("(?s)OUTLINE.*add up to deltaT\n", Matcher.quoteReplacement(example.text))
                .replace("My own solver", "An example: " + example.name().toLowerCase(Locale.ROOT))
                .replace("NAME", name);
    }

    /**
     * @param name the class's name; one that declares a method of the slides, as MyRK4Solver does, brings its outline
     * @param base the class that it extends
     * @return the text of a solver
     */
    static String solver(String name, Base base) {
        String outline = Declaration.of(name).map(Declaration::method).map(method -> switch (method) {
            case MIDPOINT, RK2 -> MIDPOINT;
            case RK4 -> RK4;
            case SYMPLECTIC_EULER, VERLET -> SIMPLE;
            default -> GENERAL;
        }).orElse(GENERAL);
        return base.text.replace("OUTLINE\n", outline).replace("NAME", name);
    }
}
