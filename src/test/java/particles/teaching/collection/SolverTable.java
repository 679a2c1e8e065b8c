package particles.teaching.collection;

import deSolvers.DESolver;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.function.Supplier;
import java.util.regex.Pattern;
import java.util.stream.Collectors;

/**
 * Solvers as rows of a table: name, what it is or what is wrong with it, the words of the report (after an equals sign:
 * its beginning, word by word), the method, and its changes. A method is its kind and its numbers, as in textbooks:
 *
 * <ul>
 * <li>{@code rk 1/2 -> 0 1 @ 0 1/2}: the rows from the second stage on, the weights, and the times if they are not the
 * sums of the rows;
 * <li>{@code irk 1/2 -> 1 @ 1/2 : newton 1e-10 50}: all rows, and the iteration, its tolerance and the most rounds;
 * <li>{@code turns 0 1 -> 1}: drifts and kicks in turn;
 * <li>{@code nystrom 1/2 -> 1/2 0 -> 1/2 1/2}: the rows of the positions from the second stage on, and the weights of
 * the new positions and velocities;
 * <li>{@code pair 1 -> 1/2 1/2 -> 1 0 : 1e-6 2}: an embedded pair, its tolerance and order, and slips;
 * <li>{@code adams 4 4} or {@code bdf 2/3}: the number of evaluations, the order at the beginning, and slips.
 * </ul>
 */
final class SolverTable {
    private SolverTable() {
    }

    /** Abbreviations for the coefficients of methods. */
    private static final Map<String, String> NAMES = """
            HEUN = 1 -> 1/2 1/2
            RK4 = 1/2; 0 1/2; 0 0 1 ->
            SIXTHS = 1/6 1/3 1/3 1/6
            THREE_EIGHTHS = 1/3; -1/3 1; 1 -1 1 ->
            EIGHTHS = 1/8 3/8 3/8 1/8
            DOPRI = 1/5; 3/40 9/40; 44/45 -56/15 32/9; 19372/6561 -25360/2187 64448/6561 -212/729; \
            9017/3168 -355/33 46732/5247 49/176 -5103/18656; 35/384 0 500/1113 125/192 -2187/6784 11/84 ->
            DOPRI5 = 35/384 0 500/1113 125/192 -2187/6784 11/84 0
            DOPRI4 = 5179/57600 0 7571/16695 393/640 -92097/339200 187/2100 1/40
            FEHLBERG = 1/4; 3/32 9/32; 1932/2197 -7200/2197 7296/2197; 439/216 -8 3680/513 -845/4104; \
            -8/27 2 -3544/2565 1859/4104 -11/40 ->
            FEHLBERG5 = 16/135 0 6656/12825 28561/56430 -9/50 2/55
            FEHLBERG4 = 25/216 0 1408/2565 2197/4104 -1/5 0
            CASH_KARP = 1/5; 3/40 9/40; 3/10 -9/10 6/5; -11/54 5/2 -70/27 35/27; \
            1631/55296 175/512 575/13824 44275/110592 253/4096 ->
            CASH_KARP5 = 37/378 0 250/621 125/594 0 512/1771
            CASH_KARP4 = 2825/27648 0 18575/48384 13525/55296 277/14336 1/4
            BOGACKI = 1/2; 0 3/4; 2/9 1/3 4/9 -> 2/9 1/3 4/9 0 -> 7/24 1/4 1/3 1/8
            LEAPFROG = turns 0 1 0 -> 1/2 1/2
            DKD = turns 1/2 1/2 -> 1
            YOSHIDA = turns 0.6756035959798289 -0.17560359597982889 -0.17560359597982889 0.6756035959798289 \
            -> 1.3512071919596578 -1.7024143839193155 1.3512071919596578
            THREE_LEAPFROGS = turns 0 1.3512071919596578 0 -1.7024143839193155 0 1.3512071919596578 0 \
            -> 0.6756035959798289 0.6756035959798289 -0.8512071919596577 -0.8512071919596577 0.6756035959798289 \
            0.6756035959798289
            BACKWARD = irk 1 -> 1
            IMPLICIT_MIDPOINT = irk 1/2 -> 1
            TRAPEZOID = irk ; 1/2 1/2 -> 1/2 1/2
            NEWTON = : newton 1e-10 50
            SIMPLE = : simple 1e-12 500
            """.lines().collect(Collectors.toMap(line -> line.split(" = ")[0], line -> line.split(" = ")[1]));

    /** @return the specimens of a table's rows */
    static List<Specimen> read(String table) {
        return table.lines().map(line -> line.split("\\s*\\|\\s*", -1)).map(parts -> new Specimen(parts[0], parts[1],
                parts[2].startsWith("= ") ? "^" + Pattern.quote(parts[2].substring(2)) : parts[2].replace("/or/", "|"),
                maker(parts[3], parts.length > 4 ? parts[4] : ""))).toList();
    }

    private static Supplier<DESolver> maker(String method, String changes) {
        String whole = Arrays.stream(method.split(" ")).map(word -> NAMES.getOrDefault(word, word)).collect(
                Collectors.joining(" "));
        String[] kind = whole.strip().split("\\s+", 2);
        String[] slips = kind[1].split(" : ", 2);
        String[] clocks = slips[0].split("@");
        String[] parts = clocks[0].split("->");
        double[] times = clocks.length > 1 ? numbers(clocks[1]) : new double[0];
        List<String> words = List.of((slips.length > 1 ? slips[1] : "").split(" "));
        return switch (kind[0]) {
            case "rk" -> Changes.solver(edit -> Methods.rungeKutta(rows("; " + parts[0]), numbers(parts[1]), times,
                    edit), changes);
            case "irk" -> Changes.solver(edit -> Methods.implicit(rows(parts[0]), numbers(parts[1]), times, words),
                    changes);
            case "turns" -> Changes.solver(edit -> Methods.turns(numbers(parts[0]), numbers(parts[1])), changes);
            case "nystrom" -> Changes.solver(edit -> Methods.nystrom(rows("; " + parts[0]), numbers(parts[1]), numbers(
                    parts[2]), times), changes);
            case "pair" -> () -> new EmbeddedPair(rows("; " + parts[0]), numbers(parts[1]), numbers(parts[2]), times,
                    words);
            case "adams" -> () -> new Multistep((int) numbers(parts[0])[0], (int) numbers(parts[0])[1], 0, words);
            default -> () -> new Multistep(2, 1, numbers(parts[0])[0], words);
        };
    }

    static double[][] rows(String text) {
        return Arrays.stream(text.split(";", -1)).map(SolverTable::numbers).toArray(double[][]::new);
    }

    static double[] numbers(String row) {
        return Arrays.stream(row.strip().split("\\s+")).filter(word -> !word.isEmpty()).mapToDouble(word -> {
            String[] parts = word.split("/");
            return Double.parseDouble(parts[0]) / (parts.length == 1 ? 1 : Double.parseDouble(parts[1]));
        }).toArray();
    }
}
