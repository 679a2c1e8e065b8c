package particles.teaching.solvers;

import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import particles.teaching.Finding;
import particles.teaching.contract.Phrase;

/** The methods that the check knows by name, as data. */
final class KnownMethods {
    static final String EULER = "the Euler method";
    static final String MIDPOINT = "the midpoint method";
    static final String RK4 = "RK4, the classical Runge-Kutta method";
    static final String SYMPLECTIC = "symplectic Euler, the slides' simple particle system algorithm";
    static final List<String> IMPLICIT = List.of("backward Euler", "the implicit midpoint method",
            "the implicit trapezoidal rule");

    static final List<String> ON_SLIDES = List.of(EULER, MIDPOINT, RK4, SYMPLECTIC);

    /** Name, order, rows of the stages, weights; the times are the sums of the rows. */
    private static final String RUNGE_KUTTA = """
            the Euler method | 1 | 0 | 1
            the midpoint method | 2 | 0; 1/2 | 0 1
            RK4, the classical Runge-Kutta method | 4 | 0; 1/2; 0 1/2; 0 0 1 | 1/6 1/3 1/3 1/6
            Heun's method | 2 | 0; 1 | 1/2 1/2
            Ralston's method | 2 | 0; 2/3 | 1/4 3/4
            Ralston's method | 2 | 0; 3/4 | 1/3 2/3
            Kutta's method of order 3 | 3 | 0; 1/2; -1 2 | 1/6 2/3 1/6
            Heun's method of order 3 | 3 | 0; 1/3; 0 2/3 | 1/4 0 3/4
            Ralston's method of order 3 | 3 | 0; 1/2; 0 3/4 | 2/9 1/3 4/9
            SSPRK3, the method of Shu and Osher | 3 | 0; 1; 1/4 1/4 | 1/6 1/6 2/3
            Williamson's method of order 3 | 3 | 0; 1/3; -3/16 15/16 | 1/6 3/10 8/15
            Kutta's 3/8 rule | 4 | 0; 1/3; -1/3 1; 1 -1 1 | 1/8 3/8 3/8 1/8
            Ralston's method of order 4 | 4 | 0; 2/5; 0.2969776092477536 0.15875964497103583; \
            0.21810038822592047 -3.0509651486929308 3.8328647604670103 \
            | 0.17476028226269037 -0.55148066287873294 1.2055355993965235 0.17118478121951903
            Ralston's method of order 4 | 4 | 0; .4; .29697761 .15875964; .21810040 -3.05096516 3.83286476 \
            | .17476028 -.55148066 1.20553560 .17118478
            Gill's method | 4 | 0; 1/2; 0.2071067811865476 0.2928932188134524; \
            0 -0.7071067811865476 1.7071067811865476 | 1/6 0.09763107293781749 0.5690355937288492 1/6
            Nystrom's method of order 3 | 3 | 0; 2/3; 0 2/3 | 1/4 3/8 3/8
            Merson's method | 4 | 0; 1/3; 1/6 1/6; 1/8 0 3/8; 1/2 0 -3/2 2 | 1/6 0 0 2/3 1/6
            Nystrom's method of order 5 | 5 | 0; 1/3; 4/25 6/25; 1/4 -3 15/4; 2/27 10/9 -50/81 8/81; \
            2/25 12/25 2/15 8/75 0 | 23/192 0 125/192 0 -27/64 125/192
            Butcher's method of order 5 | 5 | 0; 1/4; 1/8 1/8; 0 -1/2 1; 3/16 0 0 9/16; -3/7 2/7 12/7 -12/7 8/7 \
            | 7/90 0 32/90 12/90 32/90 7/90
            Butcher's method of order 6 | 6 | 0; 1/3; 0 2/3; 1/12 1/3 -1/12; -1/16 9/8 -3/16 -3/8; \
            0 9/8 -3/8 -3/4 1/2; 9/44 -9/11 63/44 18/11 0 -16/11 | 11/120 0 27/40 27/40 -4/15 -4/15 11/120
            Butcher's method of order 6 | 6 | 0; 1/3; 0 2/3; 1/12 1/3 -1/12; 25/48 -55/24 35/48 15/8; \
            3/20 -11/24 -1/8 1/2 1/10; -261/260 33/13 43/156 -118/39 32/195 80/39 \
            | 13/200 0 11/40 11/40 4/25 4/25 13/200
            Carpenter and Kennedy's method of order 4 | 4 | 0; 0.14965902199922912; \
            -0.008809355635422508 0.37921031299962728; \
            0.40117765364623841 -0.60187691989877696 0.82295502938698172; \
            -0.19042969985249632 0.81382262244373295 -0.36456124786566849 0.69945045594912211 \
            | 0.0055941884550069867 0.34474304234056708 0.028911816184089781 \
            0.46769370505218416 0.15305724796815199
            Fehlberg's method of order 4 | 4 | 0; 1/4; 3/32 9/32; 1932/2197 -7200/2197 7296/2197; \
            439/216 -8 3680/513 -845/4104; -8/27 2 -3544/2565 1859/4104 -11/40 | 25/216 0 1408/2565 2197/4104 -1/5 0
            Fehlberg's method of order 4 | 4 | 0; 1/4; 3/32 9/32; 1932/2197 -7200/2197 7296/2197; \
            439/216 -8 3680/513 -845/4104 | 25/216 0 1408/2565 2197/4104 -1/5
            Fehlberg's method of order 5 | 5 | 0; 1/4; 3/32 9/32; 1932/2197 -7200/2197 7296/2197; \
            439/216 -8 3680/513 -845/4104; -8/27 2 -3544/2565 1859/4104 -11/40 \
            | 16/135 0 6656/12825 28561/56430 -9/50 2/55
            Cash and Karp's method of order 5 | 5 | 0; 1/5; 3/40 9/40; 3/10 -9/10 6/5; -11/54 5/2 -70/27 35/27; \
            1631/55296 175/512 575/13824 44275/110592 253/4096 | 37/378 0 250/621 125/594 0 512/1771
            Cash and Karp's method of order 4 | 4 | 0; 1/5; 3/40 9/40; 3/10 -9/10 6/5; -11/54 5/2 -70/27 35/27; \
            1631/55296 175/512 575/13824 44275/110592 253/4096 | 2825/27648 0 18575/48384 13525/55296 277/14336 1/4
            Dormand and Prince's method of order 5 | 5 | 0; 1/5; 3/40 9/40; 44/45 -56/15 32/9; \
            19372/6561 -25360/2187 64448/6561 -212/729; 9017/3168 -355/33 46732/5247 49/176 -5103/18656 \
            | 35/384 0 500/1113 125/192 -2187/6784 11/84
            Dormand and Prince's method of order 5 | 5 | 0; 1/5; 3/40 9/40; 44/45 -56/15 32/9; \
            19372/6561 -25360/2187 64448/6561 -212/729; 9017/3168 -355/33 46732/5247 49/176 -5103/18656; \
            35/384 0 500/1113 125/192 -2187/6784 11/84 | 35/384 0 500/1113 125/192 -2187/6784 11/84 0
            Dormand and Prince's method of order 4 | 4 | 0; 1/5; 3/40 9/40; 44/45 -56/15 32/9; \
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
            Ruth's method of order 3 | 3 | 1 -2/3 2/3 0 | -1/24 3/4 7/24
            Ruth's method of order 3, the velocity first | 3 | 0 2/3 -2/3 1 | 7/24 3/4 -1/24
            Yoshida's method of order 4 | 4 | 0 1.3512071919596578 -1.7024143839193155 1.3512071919596578 0 \
            | 0.6756035959798289 -0.1756035959798289 -0.1756035959798289 0.6756035959798289
            Yoshida's method of order 4, the position first | 4 \
            | 0.6756035959798289 -0.1756035959798289 -0.1756035959798289 0.6756035959798289 \
            | 1.3512071919596578 -1.7024143839193155 1.3512071919596578
            """;

    /** The two methods of particles that make no turns: name, order, rows and times as in a {@link Scheme}. */
    private static final String NO_TURNS = """
            the Euler method | 1 | 1 0; 1 1; 0 1 1 | 0
            Nystrom's method of order 4 | 4 | 1 0; 1 1/2 1/8; 1 1 0 1/2; 1 1 1/6 1/3 0; 0 1 1/6 2/3 1/6 | 0 1/2 1
            """;

    /** Implicit methods: a row may have weights of its own stage and of later ones. */
    private static final String IMPLICIT_STAGES = """
            Gauss's method of order 4 | 4 | 1/4 -0.038675134594812866; 0.5386751345948129 1/4 | 1/2 1/2
            Gauss's method of order 6 | 6 | 5/36 -0.03597666752493894 0.009789444015308318; 0.3002631949808646 2/9 \
            -0.022485417203086805; 0.26798833376246944 0.48042111196938336 5/36 | 5/18 4/9 5/18
            Radau IIA of order 3 | 3 | 5/12 -1/12; 3/4 1/4 | 3/4 1/4
            Radau IA of order 3 | 3 | 1/4 -1/4; 1/4 5/12 | 1/4 3/4
            Radau IIA of order 5 | 5 | 0.19681547722366044 -0.06553542585019838 0.02377097434822015; \
            0.3944243147390873 0.29207341166522843 -0.04154875212599792; 0.37640306270046725 0.5124858261884216 1/9 \
            | 0.37640306270046725 0.5124858261884216 1/9
            Lobatto IIIA of order 4 | 4 | 0; 5/24 1/3 -1/24; 1/6 2/3 1/6 | 1/6 2/3 1/6
            Lobatto IIIB of order 4 | 4 | 1/6 -1/6; 1/6 1/3; 1/6 5/6 | 1/6 2/3 1/6
            Lobatto IIIC of order 2 | 2 | 1/2 -1/2; 1/2 1/2 | 1/2 1/2
            Lobatto IIIC of order 4 | 4 | 1/6 -1/3 1/6; 1/6 5/12 -1/12; 1/6 2/3 1/6 | 1/6 2/3 1/6
            Alexander's method of order 2 | 2 | 0.2928932188134524; 0.7071067811865476 0.2928932188134524 | \
            0.7071067811865476 0.2928932188134524
            Alexander's method of order 3 | 3 | 0.435866521508459; 0.2820667392457705 0.435866521508459; \
            1.20849664917601 -0.6443631706844692 0.435866521508459 | 1.20849664917601 -0.6443631706844692 \
            0.435866521508459
            Norsett's method of order 3 | 3 | 0.7886751345948129; -0.5773502691896257 0.7886751345948129 | 1/2 1/2
            TR-BDF2 | 2 | 0; 0.2928932188134524 0.2928932188134524; 0.3535533905932738 0.3535533905932738 \
            0.2928932188134524 | 0.3535533905932738 0.3535533905932738 0.2928932188134524
            """;
    /** The same of particles, as the two methods that make no turns. */
    private static final String IMPLICIT_PARTICLES = """
            Newmark's method | 2 | 1 0; 1 1 1/4 1/4; 1 1 1/4 1/4; 0 1 1/2 1/2 | 0 1
            """;

    /**
     * Name, places of the derivatives (0 is the old state, 1 the new one, -1 the one before), weights, mistake, and the
     * clocks if they are not at the places.
     */
    static final String EQUATIONS = """
            backward Euler | 1 | 1 1 |
            the implicit trapezoidal rule | 0 1 | 1 1/2 1/2 |
            the implicit midpoint method | 1/2 | 1 1 |
            the BDF formula of order 2 | 1 | 4/3 -1/3 2/3 |
            the BDF formula of order 3 | 1 | 18/11 -9/11 2/11 6/11 |
            the BDF formula of order 4 | 1 | 48/25 -36/25 16/25 -3/25 12/25 |
            backward Euler | 1 | 1 1 | | 0
            backward Euler | 1 | 1 1 | | 1/2
            the implicit trapezoidal rule | 0 1 | 1 1/2 1/2 | | 0 0
            the implicit trapezoidal rule | 0 1 | 1 1/2 1/2 | | 0 1/2
            the implicit trapezoidal rule | 0 1 | 1 1/2 1/2 | | 1/2 1
            the implicit trapezoidal rule | 0 1 | 1 1/2 1/2 | | 1/2 1/2
            the implicit trapezoidal rule | 0 1 | 1 1/2 1/2 | | 1 1
            the implicit midpoint method | 1/2 | 1 1 | | 0
            the implicit midpoint method | 1/2 | 1 1 | | 1
            the BDF formula of order 2 | 1 | 4/3 -1/3 2/3 | | 0
            the BDF formula of order 2 | 1 | 4/3 -1/3 2/3 | | 1/2
            the BDF formula of order 3 | 1 | 18/11 -9/11 2/11 6/11 | | 0
            backward Euler | 1 | 1 1/2 | : deltaT/2 stands where deltaT is meant
            backward Euler | 1 | 1 2 | : deltaT comes in twice
            backward Euler | 1 | 1 -1 | : the sign is wrong
            the implicit midpoint method | 1/2 | 1 2 | : does deltaT stand where deltaT/2 is meant?
            the implicit midpoint method | 1/2 | 1 1/2 | : the step ends at the midpoint
            the implicit trapezoidal rule | 0 1 | 1 1 1 | : the half is missing
            the implicit trapezoidal rule | 0 1 | 1 1/2 1 | : the weights of the derivatives add up to 3/2, not to 1
            the implicit trapezoidal rule | 0 1 | 1 1 1/2 | : the weights of the derivatives add up to 3/2, not to 1
            the implicit trapezoidal rule | 0 1 | 1 1/2 -1/2 | : a sign is wrong
            the BDF formula of order 2 | 1 | 4/3 -1/3 1 | : the 2/3 is missing
            the BDF formula of order 2 | 1 | 4/3 1/3 2/3 | : the sign of the older state is wrong
            the BDF formula of order 2 | 1 | -1/3 4/3 2/3 | : the old states are exchanged
            the BDF formula of order 2 | 1 | 4/3 -1/3 1/3 | : the weight of the derivative is not 2/3
            the BDF formula of order 3 | 1 | 18/11 -9/11 2/11 1 | : the 6/11 is missing
            the BDF formula of order 3 | 1 | 18/11 -9/11 2/11 2/3 | : the weight of the derivative is not 6/11
            the BDF formula of order 3 | 1 | 18/11 9/11 2/11 6/11 | : the sign of an older state is wrong
            the BDF formula of order 3 | 1 | 2/11 -9/11 18/11 6/11 | : the old states are the other way round
            the BDF formula of order 4 | 1 | 48/25 -36/25 16/25 -3/25 1 | : the 12/25 is missing
            the Adams method of order 2 | 0 -1 | 1 3/2 -1/2 |
            the Adams method of order 3 | 0 -1 -2 | 1 23/12 -4/3 5/12 |
            the Adams method of order 4 | 0 -1 -2 -3 | 1 55/24 -59/24 37/24 -9/24 |
            the Adams method of order 5 | 0 -1 -2 -3 -4 | 1 1901/720 -1387/360 109/30 -637/360 251/720 |
            the Adams method of order 3 | 1 0 -1 | 1 5/12 8/12 -1/12 |
            the Adams method of order 4 | 1 0 -1 -2 | 1 9/24 19/24 -5/24 1/24 |
            """;

    /** What becomes of methods by mistakes that are more than one wrong row: the mistake for a name. */
    private static final String CHANGED = """
            SSPRK3: the weights of the last mean are swapped: 1/3 s + 2/3 (...) is right | 0 | 0; 1; 1/4 1/4 \
            | 1/12 1/12 1/3
            SSPRK3: the weights of the first mean are swapped: 3/4 s + 1/4 (...) is right | 0 | 0; 1; 3/4 3/4 \
            | 1/2 1/2 2/3
            SSPRK3: the weights of both means are swapped: 3/4 s + 1/4 (...) and 1/3 s + 2/3 (...) are right \
            | 0 | 0; 1; 3/4 3/4 | 1/4 1/4 1/3
            RK4: every trial state is added to the one before: go back to the start s before adding. \
            double[] trial = s makes no copy; s.clone() does | 0 | 0; 1/2; 1/2 1/2; 1/2 1/2 1 | 1/6 1/3 1/3 1/6
            RK4: every trial state and the new state are added to the one before: go back to the start s before \
            adding. double[] trial = s makes no copy; s.clone() does | 0 | 0; 1/2; 1/2 1/2; 1/2 1/2 1 | 2/3 5/6 4/3 1/6
            the extrapolation of the Euler method: the weights are swapped: 2 times the short steps minus the long \
            one is right | 0 | 0; 0; 0 1/2 | 2 -1/2 -1/2
            the extrapolation of the Euler method: the weights are swapped: 2 times the short steps minus the long \
            one is right | 0 | 0; 1/2 | 3/2 -1/2
            the extrapolation of the Euler method: 4/3 and -1/3 are the weights for a method of order 2; 2 times the \
            short steps minus the long one is right | 0 | 0; 0; 0 1/2 | -1/3 2/3 2/3
            the extrapolation of the Euler method: 4/3 and -1/3 are the weights for a method of order 2; 2 times the \
            short steps minus the long one is right | 0 | 0; 1/2 | 1/3 2/3
            Williamson's method: the sign of 153/128 is wrong: q = -153/128 q + deltaT f is right | 0 \
            | 0; 1/3; -3/16 15/16 | -13/24 63/40 8/15
            """;

    private static final List<Scheme> ONE_FORMULA = RUNGE_KUTTA.lines().map(KnownMethods::rungeKutta).toList();
    private static final List<Scheme> OF_PARTICLES = Stream.concat(NO_TURNS.lines().map(KnownMethods::rows),
            TURNS.lines().map(KnownMethods::turns)).toList();

    /** Methods whose stages have to be solved for. */
    static final List<Scheme> STAGES = Stream.concat(IMPLICIT_STAGES.lines().map(KnownMethods::rungeKutta),
            IMPLICIT_PARTICLES.lines().map(KnownMethods::rows)).toList();

    private KnownMethods() {
    }

    private static Scheme rungeKutta(String line) {
        String[] parts = line.split("[|]");
        List<double[]> rows = Arrays.stream((parts[2] + ";" + parts[3]).split(";")).map(row -> numbers("1 " + row))
                .toList();
        return scheme(parts, rows, rows.stream().limit(rows.size() - 1).mapToDouble(row -> Combination.sum(row) - 1)
                .toArray(), false);
    }

    private static Scheme rows(String line) {
        String[] parts = line.split("[|]");
        return scheme(parts, Arrays.stream(parts[2].split(";")).map(KnownMethods::numbers).toList(), numbers(parts[3]),
                true);
    }

    private static Scheme turns(String line) {
        String[] parts = line.split("[|]");
        double[] kicks = numbers(parts[3]);
        double[] reached = numbers(parts[2]);
        Arrays.parallelPrefix(reached, Double::sum);
        return scheme(parts, Scheme.inTurn(reached, kicks), Arrays.copyOf(reached, kicks.length), true);
    }

    private static Scheme scheme(String[] parts, List<double[]> rows, double[] times, boolean particles) {
        return new Scheme(parts[0].strip(), (int) numbers(parts[1])[0], rows, times, particles);
    }

    /** @return the numbers and fractions of the text */
    static double[] numbers(String text) {
        return Arrays.stream(text.strip().split("\\s+")).map(word -> word.split("/")).mapToDouble(parts ->
                Double.parseDouble(parts[0]) / (parts.length == 1 ? 1 : Double.parseDouble(parts[1]))).toArray();
    }

    /** @return the mistake that made this step of a known method, if it is one of those that have a name */
    static Optional<Finding> mistake(Scheme found) {
        return CHANGED.lines().map(KnownMethods::rungeKutta).filter(changed -> isSame(changed, found, 1)).findFirst()
                .map(changed -> Phrase.CHANGED.of(changed.name()));
    }

    /** Whether all rows of the stages are the same, and so many of the new state. */
    private static boolean isSame(Scheme method, Scheme found, int ends) {
        return method.size() == found.size() && IntStream.range(0, method.size() + ends).allMatch(i -> Combination.same(
                method.rows().get(i), found.rows().get(i)));
    }

    /** @return the methods of this kind, those of the slides first */
    static List<Scheme> like(Scheme found) {
        int n = found.size();
        String part = "1/" + n + " ";
        return found.isOfParticles() ? OF_PARTICLES : n < 2 ? ONE_FORMULA : Stream.concat(ONE_FORMULA.stream(),
                Stream.of(rungeKutta("the Euler method in " + n + " sub-steps | 1 | 0;" + IntStream.range(1, n)
                .mapToObj(part::repeat).collect(Collectors.joining(";")) + "|" + part.repeat(n)))).toList();
    }

    /**
     * @param ends 1 if the new state has to be the same, too, otherwise 0
     * @return whether a known method evaluates the derivative at these states
     */
    static boolean isAny(Scheme found, int ends) {
        return found.size() > 1 && like(found).stream().anyMatch(method -> isSame(method, found, ends));
    }
}
