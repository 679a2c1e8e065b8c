package particles.teaching.solvers;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import particles.teaching.Finding;

/** The methods that the check knows by name, as data. */
final class KnownMethods {
    static final String EULER = "the Euler method";
    static final String MIDPOINT = "the midpoint method";
    static final String HEUN = "Heun's method";
    static final String RALSTON = "Ralston's method";
    static final String RK4 = "RK4, the classical Runge-Kutta method";
    static final String THREE_EIGHTHS = "Kutta's 3/8 rule";
    static final String SYMPLECTIC = "symplectic Euler, the slides' simple particle system algorithm";
    static final String POSITION_FIRST = "symplectic Euler with the position first";
    static final String VERLET = "velocity Verlet (leapfrog: kick, drift, kick)";
    static final String POSITION_VERLET = "position Verlet (drift, kick, drift)";
    static final String BACKWARD_EULER = "backward Euler";
    static final String IMPLICIT_MIDPOINT = "the implicit midpoint method";
    static final String TRAPEZOID = "the implicit trapezoidal rule";
    static final List<String> IMPLICIT = List.of(BACKWARD_EULER, IMPLICIT_MIDPOINT, TRAPEZOID);

    static final List<String> ON_SLIDES = List.of(EULER, MIDPOINT, RK4, SYMPLECTIC);

    private static final double R = StrictMath.sqrt(0.5);
    private static final double W = 1 / (2 - StrictMath.cbrt(2));

    /** Name, order, rows from the second stage on, weights; the times are the sums of the rows. */
    private static final String RUNGE_KUTTA = """
            the Euler method | 1 | | 1
            the midpoint method | 2 | 1/2 | 0 1
            RK4, the classical Runge-Kutta method | 4 | 1/2; 0 1/2; 0 0 1 | 1/6 1/3 1/3 1/6
            Heun's method | 2 | 1 | 1/2 1/2
            Ralston's method | 2 | 2/3 | 1/4 3/4
            Kutta's method of order 3 | 3 | 1/2; -1 2 | 1/6 2/3 1/6
            Heun's method of order 3 | 3 | 1/3; 0 2/3 | 1/4 0 3/4
            Ralston's method of order 3 | 3 | 1/2; 0 3/4 | 2/9 1/3 4/9
            SSPRK3, the method of Shu and Osher | 3 | 1; 1/4 1/4 | 1/6 1/6 2/3
            Kutta's 3/8 rule | 4 | 1/3; -1/3 1; 1 -1 1 | 1/8 3/8 3/8 1/8
            Ralston's method of order 4 (its eight printed digits) | 4 | .4; .29697761 .15875964; \
            .21810040 -3.05096516 3.83286476 | .17476028 -.55148066 1.20553560 .17118478
            Gill's method | 4 | 1/2; R-.5 1-R; 0 -R 1+R | 1/6 1-R/3 1+R/3 1/6
            Fehlberg's method of order 4 | 4 | 1/4; 3/32 9/32; 1932/2197 -7200/2197 7296/2197; \
            439/216 -8 3680/513 -845/4104; -8/27 2 -3544/2565 1859/4104 -11/40 | 25/216 0 1408/2565 2197/4104 -1/5 0
            Fehlberg's method of order 5 | 5 | 1/4; 3/32 9/32; 1932/2197 -7200/2197 7296/2197; \
            439/216 -8 3680/513 -845/4104; -8/27 2 -3544/2565 1859/4104 -11/40 \
            | 16/135 0 6656/12825 28561/56430 -9/50 2/55
            Cash and Karp's method of order 5 | 5 | 1/5; 3/40 9/40; 3/10 -9/10 6/5; -11/54 5/2 -70/27 35/27; \
            1631/55296 175/512 575/13824 44275/110592 253/4096 | 37/378 0 250/621 125/594 0 512/1771
            Cash and Karp's method of order 4 | 4 | 1/5; 3/40 9/40; 3/10 -9/10 6/5; -11/54 5/2 -70/27 35/27; \
            1631/55296 175/512 575/13824 44275/110592 253/4096 | 2825/27648 0 18575/48384 13525/55296 277/14336 1/4
            Dormand and Prince's method of order 5 | 5 | 1/5; 3/40 9/40; 44/45 -56/15 32/9; \
            19372/6561 -25360/2187 64448/6561 -212/729; 9017/3168 -355/33 46732/5247 49/176 -5103/18656 \
            | 35/384 0 500/1113 125/192 -2187/6784 11/84
            Dormand and Prince's method of order 5 | 5 | 1/5; 3/40 9/40; 44/45 -56/15 32/9; \
            19372/6561 -25360/2187 64448/6561 -212/729; 9017/3168 -355/33 46732/5247 49/176 -5103/18656; \
            35/384 0 500/1113 125/192 -2187/6784 11/84 | 35/384 0 500/1113 125/192 -2187/6784 11/84 0
            Dormand and Prince's method of order 4 | 4 | 1/5; 3/40 9/40; 44/45 -56/15 32/9; \
            19372/6561 -25360/2187 64448/6561 -212/729; 9017/3168 -355/33 46732/5247 49/176 -5103/18656; \
            35/384 0 500/1113 125/192 -2187/6784 11/84 \
            | 5179/57600 0 7571/16695 393/640 -92097/339200 187/2100 1/40
            """;
    /** Name, order, drifts (x += v d deltaT) and kicks (v += a k deltaT), which are made in turn, a drift first. */
    private static final String TURNS = """
            symplectic Euler, the slides' simple particle system algorithm | 1 | 0 1 | 1
            symplectic Euler with the position first | 1 | 1 0 | 1
            velocity Verlet (leapfrog: kick, drift, kick) | 2 | 0 1 0 | 1/2 1/2
            position Verlet (drift, kick, drift) | 2 | 1/2 1/2 | 1
            Ruth's method of order 3 | 3 | 1 -2/3 2/3 | -1/24 3/4 7/24
            Ruth's method of order 3, the velocity first | 3 | 0 2/3 -2/3 1 | 7/24 3/4 -1/24
            Yoshida's method of order 4 | 4 | 0 W Z W | W/2 Y Y W/2
            Yoshida's method of order 4, the position first | 4 | W/2 Y Y W/2 | W Z W
            """;

    /** What becomes of methods by mistakes that are more than one wrong row: name, rows, weights, the mistake. */
    private static final String CHANGED = """
            SSPRK3 | 1; 1/4 1/4 | 1/12 1/12 1/3 | the weights of the last mean are swapped: 1/3 s + 2/3 (...) is right
            SSPRK3 | 1; 3/4 3/4 | 1/2 1/2 2/3 | the weights of the first mean are swapped: 3/4 s + 1/4 (...) is right
            SSPRK3 | 1; 3/4 3/4 | 1/4 1/4 1/3 | the weights of both means are swapped: 3/4 s + 1/4 (...) and \
            1/3 s + 2/3 (...) are right
            RK4 | 1/2; 1/2 1/2; 1/2 1/2 1 | 1/6 1/3 1/3 1/6 | every trial state is added to the one before: go back to \
            the start s before adding. double[] trial = s makes no copy; s.clone() does
            RK4 | 1/2; 1/2 1/2; 1/2 1/2 1 | 2/3 5/6 4/3 1/6 | every trial state and the new state are added to the one \
            before: go back to the start s before adding. double[] trial = s makes no copy; s.clone() does
            """;

    private static final List<Scheme> ONE_FORMULA = RUNGE_KUTTA.lines().map(KnownMethods::rungeKutta).toList();
    private static final List<Scheme> OF_PARTICLES = Stream.concat(Stream.of(Scheme.ofParticles(EULER, 1,
            List.of(numbers("0"), numbers("1"), numbers("1")), new double[1])), TURNS.lines().map(KnownMethods::turns))
            .toList();

    private KnownMethods() {
    }

    private static Scheme rungeKutta(String line) {
        String[] parts = line.split("\\|");
        List<double[]> rows = new ArrayList<>();
        Arrays.stream((parts[2].isBlank() ? parts[3] : "; " + parts[2] + ";" + parts[3]).split(";")).forEach(row ->
                rows.add(numbers(row)));
        if (rows.size() == 1) {
            rows.add(0, numbers(""));
        }
        return Scheme.oneFormula(parts[0].strip(), order(parts), rows, rows.stream().limit(rows.size() - 1)
                .mapToDouble(row -> Combination.sum(row) - 1).toArray());
    }

    private static int order(String[] parts) {
        return Integer.parseInt(parts[1].strip());
    }

    private static Scheme turns(String line) {
        String[] parts = line.split("\\|");
        double[] drifts = numbers(parts[2]);
        double[] kicks = numbers(parts[3]);
        double[] position = {1, 0};
        double[] velocity = {0, 1};                     // of the position's change
        List<double[]> rows = new ArrayList<>();
        for (int j = 1; j < drifts.length; j++) {
            position = Combination.plus(position, drifts[j], velocity);
            if (j < kicks.length) {
                rows.add(position);
                velocity = Arrays.copyOf(velocity, j + 2);
                velocity[j + 1] = kicks[j];
            }
        }
        double[] times = rows.stream().mapToDouble(row -> row[1]).toArray();
        rows.add(position);
        rows.add(kicks);
        return Scheme.ofParticles(parts[0].strip(), order(parts), rows, times);
    }

    /** @return 1, the weight of the old state, then the numbers of the text */
    private static double[] numbers(String text) {
        return Arrays.stream(("1 " + text).split("\\s+")).mapToDouble(word -> {
            String[] parts = word.split("/");
            return number(parts[0]) / (parts.length == 1 ? 1 : number(parts[1]));
        }).toArray();
    }

    private static double number(String word) {
        return switch (word) {
            case "W" -> W;
            case "Z" -> 1 - 2 * W;
            case "Y" -> (1 - W) / 2;
            case "R" -> R;
            case "-R" -> -R;
            case "R-.5" -> R - 0.5;
            case "1-R" -> 1 - R;
            case "1+R" -> 1 + R;
            default -> Double.parseDouble(word);
        };
    }

    /** @return the mistake that made this step of a known method, if it is one of those that have a name */
    static Optional<Finding> mistake(Scheme found) {
        return CHANGED.lines().map(line -> line.split("\\|")).filter(parts -> {
            Scheme changed = rungeKutta(parts[0] + "| 0 |" + parts[1] + "|" + parts[2]);
            return !found.isOfParticles() && changed.size() == found.size() && isStages(changed, found)
                    && changed.ends().get(0).is(found.ends().get(0));
        }).findFirst().map(parts -> Phrase.CHANGED.of(parts[0].strip(), parts[3].strip()));
    }

    private static boolean isStages(Scheme method, Scheme found) {
        return method.size() == found.size() && IntStream.range(0, method.size()).allMatch(i -> method.stages().get(i)
                .is(found.stages().get(i)));
    }

    /** @return the methods of this kind, those of the slides first */
    static List<Scheme> like(Scheme found) {
        return found.isOfParticles() ? OF_PARTICLES : found.size() < 2 ? ONE_FORMULA : Stream.concat(ONE_FORMULA
                .stream(), Stream.of(subSteps(found.size()))).toList();
    }

    private static Scheme subSteps(int n) {
        List<double[]> rows = new ArrayList<>();
        for (int i = 0; i <= n; i++) {
            double[] row = new double[i + 1];
            Arrays.fill(row, 1.0 / n);
            row[0] = 1;
            rows.add(row);
        }
        return Scheme.oneFormula("the Euler method in " + n + " sub-steps", 1, rows, IntStream.range(0, n).mapToDouble(i
                -> (double) i / n).toArray());
    }

    /** @return whether a known method evaluates the derivative at these states, whatever its weights */
    static boolean isStagesOfAny(Scheme found) {
        return found.size() > 1 && like(found).stream().anyMatch(method -> isStages(method, found));
    }
}
