package particles.teaching.solvers;

import deSolvers.rungeKutta.ButcherTableau;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.stream.IntStream;

/**
 * A Runge-Kutta method that the check knows by name.
 *
 * @param name      its name
 * @param authority the source of the formula: the slide, or the method itself
 * @param steps     the names of its steps in formulas, deltaT included
 * @param slopes    the evaluated slopes, in words
 * @param tableau   its coefficients
 */
record KnownMethod(String name, String authority, List<String> steps, List<String> slopes, ButcherTableau tableau) {
    private static final List<String> K = List.of("k1", "k2", "k3", "k4", "k5", "k6", "k7");
    private static final String FEHLBERG = "0 |\n1/4 | 1/4\n3/8 | 3/32 9/32\n12/13 | 1932/2197 -7200/2197 7296/2197\n"
            + "1 | 439/216 -8 3680/513 -845/4104\n1/2 | -8/27 2 -3544/2565 1859/4104 -11/40\n---\n| ";
    private static final String CASH_KARP = "0 |\n1/5 | 1/5\n3/10 | 3/40 9/40\n3/5 | 3/10 -9/10 6/5\n"
            + "1 | -11/54 5/2 -70/27 35/27\n7/8 | 1631/55296 175/512 575/13824 44275/110592 253/4096\n---\n| ";
    private static final String DORMAND_PRINCE = "0 |\n1/5 | 1/5\n3/10 | 3/40 9/40\n4/5 | 44/45 -56/15 32/9\n"
            + "8/9 | 19372/6561 -25360/2187 64448/6561 -212/729\n1 | 9017/3168 -355/33 46732/5247 49/176 -5103/18656\n";

    private static final List<KnownMethod> ALL = List.of(
            new KnownMethod(NamePromise.EULER, "the slide", List.of("deltaS"), List.of("dSdt"),
                    ButcherTableau.parse("0 |\n---\n| 1", 1)),
            new KnownMethod(NamePromise.MIDPOINT, "the slide", List.of("deltaS", "deltaT gMid"), List.of("dSdt",
                    "gMid"),
                    ButcherTableau.parse("0 |\n1/2 | 1/2\n---\n| 0 1", 2)),
            new KnownMethod(NamePromise.RK4, "the slide", K, K,
                    ButcherTableau.parse("0 |\n1/2 | 1/2\n1/2 | 0 1/2\n1 | 0 0 1\n---\n| 1/6 1/3 1/3 1/6", 4)),
            other(NamePromise.HEUN, "0 |\n1 | 1\n---\n| 1/2 1/2", 2),
            other(NamePromise.RALSTON, "0 |\n2/3 | 2/3\n---\n| 1/4 3/4", 2),
            other("Kutta's method of order 3", "0 |\n1/2 | 1/2\n1 | -1 2\n---\n| 1/6 2/3 1/6", 3),
            other("Heun's method of order 3", "0 |\n1/3 | 1/3\n2/3 | 0 2/3\n---\n| 1/4 0 3/4", 3),
            other("Ralston's method of order 3", "0 |\n1/2 | 1/2\n3/4 | 0 3/4\n---\n| 2/9 1/3 4/9", 3),
            other("SSPRK3, the method of Shu and Osher", "0 |\n1 | 1\n1/2 | 1/4 1/4\n---\n| 1/6 1/6 2/3", 3),
            other(NamePromise.THREE_EIGHTHS,
                    "0 |\n1/3 | 1/3\n2/3 | -1/3 1\n1 | 1 -1 1\n---\n| 1/8 3/8 3/8 1/8", 4),
            other("Fehlberg's method of order 4", FEHLBERG + "25/216 0 1408/2565 2197/4104 -1/5 0", 4),
            other("Fehlberg's method of order 5", FEHLBERG + "16/135 0 6656/12825 28561/56430 -9/50 2/55", 5),
            other("Cash and Karp's method of order 5", CASH_KARP + "37/378 0 250/621 125/594 0 512/1771", 5),
            other("Cash and Karp's method of order 4", CASH_KARP
                    + "2825/27648 0 18575/48384 13525/55296 277/14336 1/4", 4),
            other("Dormand and Prince's method of order 5", DORMAND_PRINCE
                    + "---\n| 35/384 0 500/1113 125/192 -2187/6784 11/84", 5),
            other("Dormand and Prince's method of order 5", DORMAND_PRINCE
                    + "1 | 35/384 0 500/1113 125/192 -2187/6784 11/84\n---\n"
                    + "| 35/384 0 500/1113 125/192 -2187/6784 11/84 0", 5),
            other("Dormand and Prince's method of order 4", DORMAND_PRINCE
                    + "1 | 35/384 0 500/1113 125/192 -2187/6784 11/84\n---\n"
                    + "| 5179/57600 0 7571/16695 393/640 -92097/339200 187/2100 1/40", 4));

    private static KnownMethod other(String name, String tableau, int order) {
        return new KnownMethod(name, name, K, K, ButcherTableau.parse(tableau, order));
    }

    /** @return all, those of the slides first */
    static List<KnownMethod> all() {
        return ALL;
    }

    /**
     * @param promise the method that a class's name promises
     * @param stages  the number of evaluations of the derivative
     * @return the first method that the name can stand for, if it has as many evaluations or more
     */
    static Optional<KnownMethod> meantBy(Optional<NamePromise> promise, int stages) {
        return ALL.stream().filter(method -> method.stages() >= stages
                && promise.map(name -> name.allows(method.name, method.order())).orElse(false)).findFirst();
    }

    /** @return k1, k2 and so on */
    static List<String> numbered(int stages) {
        return IntStream.rangeClosed(1, stages).mapToObj(i -> "k" + i).toList();
    }

    /** @return whether a known method evaluates the derivative at these states, whatever its weights */
    static boolean isRowsOfAny(double[][] a) {
        return a.length > 1 && ALL.stream().anyMatch(method -> method.stages() == a.length
                && IntStream.range(0, a.length).allMatch(i -> MethodDifferences.same(a[i], method.row(i))));
    }

    int order() {
        return tableau.order(0);
    }

    int stages() {
        return tableau.stages();
    }

    /** @return the row of a stage, as long as there are stages */
    double[] row(int stage) {
        double[] row = new double[stages()];
        Arrays.setAll(row, j -> j < stage ? tableau.coefficient(stage, j) : 0);
        return row;
    }

    double[] weights() {
        return tableau.weights(0);
    }
}
