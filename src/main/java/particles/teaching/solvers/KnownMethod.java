package particles.teaching.solvers;

import deSolvers.rungeKutta.ButcherTableau;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Optional;

/**
 * A method that a solver may turn out to be.
 *
 * @param name      what it is called
 * @param authority who says how it goes: the slide, or the method itself
 * @param spoken    beginnings of class names that mean it, without "Solver" and in small letters
 * @param steps     what its steps are called in formulas, deltaT included
 * @param slopes    what is evaluated, in words
 * @param tableau   its coefficients
 */
public record KnownMethod(String name, String authority, List<String> spoken, List<String> steps, List<String> slopes,
                   ButcherTableau tableau) {
    private static final List<String> K = List.of("k1", "k2", "k3", "k4", "k5", "k6", "k7");

    private static final List<KnownMethod> ALL = List.of(
            new KnownMethod("the Euler method", "the slide", List.of("euler", "expliciteuler", "forwardeuler"), List.of("deltaS"),
                    List.of("dSdt"), ButcherTableau.parse("0 |\n---\n| 1", 1)),
            new KnownMethod("the midpoint method", "the slide", List.of("midpoint", "rk2"), List.of("deltaS", "deltaT gMid"),
                    List.of("dSdt", "gMid"), ButcherTableau.parse("0 |\n1/2 | 1/2\n---\n| 0 1", 2)),
            new KnownMethod("RK4, the classical Runge-Kutta method", "the slide", List.of("rk4", "rungekutta4", "rungekutta",
                    "classicalrk"), K,
                    K, ButcherTableau.parse("0 |\n1/2 | 1/2\n1/2 | 0 1/2\n1 | 0 0 1\n---\n| 1/6 1/3 1/3 1/6", 4)),
            other("Heun's method", List.of("heun", "trapez", "improvedeuler"), "0 |\n1 | 1\n---\n| 1/2 1/2", 2),
            other("Ralston's method", List.of("ralston"), "0 |\n2/3 | 2/3\n---\n| 1/4 3/4", 2),
            other("Kutta's method of order 3", List.of("kutta3", "rk3"), "0 |\n1/2 | 1/2\n1 | -1 2\n---\n| 1/6 2/3 1/6", 3),
            other("Heun's method of order 3", List.of("heun3"), "0 |\n1/3 | 1/3\n2/3 | 0 2/3\n---\n| 1/4 0 3/4", 3),
            other("Ralston's method of order 3", List.of("ralston3"), "0 |\n1/2 | 1/2\n3/4 | 0 3/4\n---\n| 2/9 1/3 4/9", 3),
            other("SSPRK3, the method of Shu and Osher", List.of("ssp"), "0 |\n1 | 1\n1/2 | 1/4 1/4\n---\n| 1/6 1/6 2/3", 3),
            other("Kutta's 3/8 rule", List.of("threeeighth", "rk38", "kutta38"),
                    "0 |\n1/3 | 1/3\n2/3 | -1/3 1\n1 | 1 -1 1\n---\n| 1/8 3/8 3/8 1/8", 4));

    private static KnownMethod other(String name, List<String> spoken, String tableau, int order) {
        return new KnownMethod(name, name, spoken, K, K, ButcherTableau.parse(tableau, order));
    }

    /** @return all, those of the slides first */
    public static List<KnownMethod> all() {
        return ALL;
    }

    /**
     * @param className a simple class name, such as {@code MyHeunSolver}
     * @return the method that it promises: the longest name that it contains
     */
    public static Optional<KnownMethod> promisedBy(String className) {
        String lower = className.toLowerCase(Locale.ROOT).replaceAll("[^a-z0-9]", "");
        KnownMethod best = null;
        int longest = 0;
        for (KnownMethod method : ALL) {
            for (String name : method.spoken) {
                if (lower.contains(name) && name.length() > longest) {
                    longest = name.length();
                    best = method;
                }
            }
        }
        return Optional.ofNullable(best);
    }

    public int stages() {
        return tableau.stages();
    }

    /** @return the row of a stage, as long as there are stages */
    public double[] row(int stage) {
        double[] row = new double[stages()];
        Arrays.setAll(row, j -> j < stage ? tableau.coefficient(stage, j) : 0);
        return row;
    }

    public double[] weights() {
        return tableau.weights(0);
    }
}
