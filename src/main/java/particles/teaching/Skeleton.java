package particles.teaching;

import java.util.List;

/** The text of a class to begin with: it compiles, and has the algorithm's outline as comments. */
public final class Skeleton {
    private static final List<String> MIDPOINT = List.of("deltaS = deltaT * derivative at (s, t)                      the Euler step",
            "gMid   = derivative at (s + deltaS/2, t + deltaT/2)         setState and incTime before getStateDerivative",
            "new s  = s + deltaT * gMid                                  from the start s, not from the middle");

    private static final List<String> RK4 = List.of("k1 = deltaT * derivative at (s, t)                          the Euler step",
            "k2 = deltaT * derivative at (s + k1/2, t + deltaT/2)        the midpoint step",
            "k3 = deltaT * derivative at (s + k2/2, t + deltaT/2)        the refined midpoint step",
            "k4 = deltaT * derivative at (s + k3, t + deltaT)            the refined refined step",
            "new s = s + k1/6 + k2/3 + k3/3 + k4/6                       1/6 is 0 in Java; write 1.0/6");

    private static final List<String> SIMPLE = List.of("for each particle: a = F/m                                  the derivative has it where v stands in s",
            "v += a * deltaT", "x += v * deltaT                                             with the new v");

    private static final List<String> GENERAL = List.of("the derivative at (s, t): one straight step along it would be Euler's",
            "perhaps further derivatives, each at a trial state: setState(trial), incTime, getStateDerivative",
            "new s = s + deltaT * a mean of the derivatives; the weights add up to 1");

    private Skeleton() {
    }

    /**
     * @param name what somebody wants to call a class
     * @return whether that is a class's name: a capital, then letters and digits;
     *         no word of the language begins with a capital
     */
    public static boolean isClassName(String name) {
        return name.matches("[A-Z]\\w*");
    }

    /**
     * @param name the class's name; one that promises a method of the slides, as MyRK4Solver does, brings its outline
     * @return the text of a solver
     */
    public static String solver(String name) {
        StringBuilder outline = new StringBuilder();
        int number = 1;
        for (String line : outline(name)) {
            outline.append("        // ").append(number++).append(". ").append(line).append('\n');
        }
        return """
                package exercises;

                import deSolvers.DESolver;
                import deSolvers.DEStateSource;

                /** My own solver. To see what it is and what is wrong with it: gradle checkSolver -Psolver=exercises.NAME */
                public class NAME extends DESolver {

                    @Override
                    public void stepState(DEStateSource source, double deltaT) {
                        int n = source.getStateSize();
                        double[] state = new double[n];
                        double[] dSdt = new double[n];
                        source.getState(state);                     // s, at time t
                        source.getStateDerivative(dSdt);            // its derivative at (s, t)

                OUTLINE
                        // at the end: source.setState(the new state), and all moves of the clock by source.incTime make deltaT
                    }
                }
                """.replace("OUTLINE\n", outline).replace("NAME", name);
    }

    private static List<String> outline(String name) {
        if (KicksDiagnosis.isPromisedBy(name)) {
            return SIMPLE;
        }
        String method = KnownMethod.promisedBy(name).map(KnownMethod::name).orElse("");
        return method.startsWith("RK4") ? RK4 : method.contains("midpoint") ? MIDPOINT : GENERAL;
    }

    /**
     * @param name the class's name
     * @return the text of a force law
     */
    public static String effect(String name) {
        return """
                package exercises;

                import java.util.EnumSet;
                import java.util.Set;
                import particles.Effect;
                import particles.Particles;

                /** My own force law. To see what is wrong with it: gradle checkEffect -Peffect=exercises.NAME */
                public class NAME implements Effect {
                    private final Particles particles;

                    /** @param particles on whom it acts */
                    public NAME(Particles particles) {
                        this.particles = particles;
                    }

                    @Override
                    public String getName() {
                        return "NAME";
                    }

                    /** What the law claims of itself; the check holds it to that. */
                    @Override
                    public Set<Trait> getTraits() {
                        return EnumSet.noneOf(Trait.class);         // such as EnumSet.of(Trait.CONSERVATIVE)
                    }

                    /** As many items as particles; a law of springs has as many as there are springs. */
                    @Override
                    public int size() {
                        return particles.count();
                    }

                    @Override
                    public boolean dependsOnVelocity() {
                        return false;                               // true for drag and damping
                    }

                    @Override
                    public void addForces(double[] state, double time, double[] force, int from, int to) {
                        for (int i = from; i < to; i++) {
                            // 1. the position of particle i is at state[6 * i], its velocity at state[6 * i + 3], x, y and z each;
                            //    its mass is particles.mass(i)
                            // 2. compute total force F_i on it, in newton: mass times acceleration
                            // 3. add it where the velocity stands: force[6 * i + 3] += ..., + 4 for y and + 5 for z
                            // 4. of a pair, F_ij on i needs its partner F_ji = -F_ij on j
                        }
                    }

                    // A conservative law also overrides getPotentialEnergy (force = - its slope), one that damps getDissipatedPower.
                }
                """.replace("NAME", name);
    }
}
