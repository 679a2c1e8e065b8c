package particles.teaching.solvers;

import static particles.teaching.solvers.KnownMethods.IMPLICIT;

import java.util.Comparator;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import particles.teaching.Finding;
import particles.teaching.contract.Phrase;

/**
 * The method that the name of a solver's class promises.
 *
 * @param says    the meaning of the name; empty if it promises nothing
 * @param order   the lowest order of all methods that it can stand for
 * @param methods the methods that it can stand for; empty for all of that order
 * @param kind    "implicit", "earlier" if it uses derivatives or states of earlier steps, or "symmetric" if it goes
 *                back the way that it came; empty for others
 * @param changed whether a word of it makes another method of it: RichardsonEuler need not be Euler
 * @param adapts  whether the name promises step-size control
 */
record NamePromise(String says, int order, List<String> methods, String kind, boolean changed, boolean adapts) {
    private static final Pattern CHANGES = Pattern.compile("romberg|adapt|embedded|pair|doubling"
            + "|sub|small|tiny|twice|half|halves|multi|rosenbrock|exponential|linear|ensemble|corrected|compos|blend"
            + "|filter|lowstorage|stabili[sz]ed|chebyshev|predict");
    private static final int SHORT = 4;
    /** Orders, from 2 on: SdirkTwo is one of order 2. Before words such as Stage they are the number of those. */
    private static final String[] NUMBERS = ("Two|Zwei|Deux|Dos Three|Third|Drei|Dritter|Trois|Tres|Tercer"
            + " Four(th)?|Vier(ter)?|Quatre|Cuatro Five|Fifth|Fuenf(ter)?|Cinq|Cinco Six(th)?|Sechs(ter)?|Seis"
            + " Seven(th)?|Sieben|Siete Eighth?(?![hs])|Acht(er)?(?!el)|Huit|Ocho").split(" ");
    private static final String NUMBER = "(%s)(?!(?i)stage|step|phase|point|eighth|achtel|octav"
            + "|stufig|schritt|punkt|etap|paso)";
    /** A number right behind the name of an extrapolation method is its order. */
    private static final String ORDER = ".*([3-8])(rd|th)?(order|ordnung).*|.*(order|ordnung|ordre|orden|bulirsch"
            + "|stoer|gbs|romberg|richardson|extrapolat(?:ed|ion)(?:euler|midpoint)?)([3-8])(?!d).*|.*";
    /** A word that may say what the name means: what is left of it is more than these and two letters. */
    private static final String OTHER_WORD = "^(?!(my|our|the|new|own|simple|plain|basic|classic(al)?|klassisch(es)?"
            + "|standard|fixed|fast|slow|first|best|euler|runge|kutta|solver|methode?|metodo|verfahren|schema|scheme"
            + "|integrator|stepper|step|ode|student|team|group|gruppe|task|exercise|aufgabe"
            + "|homework|test|final|\\d)*.{0,2}$)";
    private static final Pattern EXTRAPOLATES = Pattern.compile("richardson|extrapol");
    private static final Pattern ADAPTS = Pattern.compile("adapt|stepdoubling|stepsizecontrol|variablestep");

    /** Meaning, order, words in names (? is any other), names of methods, kind; the longest word in a name wins. */
    private static final String TABLE = """
            the Euler method | 1 | euler explicit-euler forward-euler | the Euler method |
            the Euler method, or an improved one | 1 | euler-? | the Euler method; Heun's method; the midpoint method; \
            Ralston's method |
            symplectic Euler | 1 | symplectic-euler semi-implicit semi-implicit-euler \
            semi-implizit semi-implizit-euler symplekti-euler cromer euler-cromer symplectic \
            kickdrift driftkick simplealgorithm simpleparticle \
            | symplectic Euler, the slides' simple particle system algorithm; \
            symplectic Euler with the position first |
            backward Euler | 1 | backward-euler implicit-euler newton-euler implizit-euler \
            rueckwaerts-euler rckwrts-euler atras-euler arriere-euler indietro-euler \
            stiff-euler fixedpoint-euler iterat-euler | backward Euler | implicit
            the midpoint method | 2 | midpoint | the midpoint method; the implicit midpoint method |
            the midpoint method | 2 | explicit-midpoint | the midpoint method |
            the implicit midpoint method | 2 | implicit-midpoint newton-midpoint \
            | the implicit midpoint method | implicit
            a Runge-Kutta method of order 2 | 2 | rk2 rungekutta2 second-rungekutta 2nd-rungekutta 2order-rungekutta \
            order2-rungekutta | |
            Heun's method | 2 | heun | Heun's method; Ralston's method; Heun's method of order 3 |
            Heun's method or the midpoint method | 2 | modified-euler improved-euler mejorado-euler \
            modificado-euler verbessert-euler modifiziert-euler ameliore-euler modifie-euler migliorato-euler \
            | Heun's method; \
            the midpoint method; Ralston's method |
            the trapezoidal rule | 2 | trapez trapezoid trapezoidal | Heun's method; the implicit trapezoidal rule |
            the implicit trapezoidal rule | 2 | crank-nicolson implicit-trapez implicit-trapezoid \
            implicit-trapezoidal newton-trapezoidal | the implicit trapezoidal rule | implicit
            Ralston's method | 2 | ralston | Ralston's method; Ralston's method of order 3; \
            Ralston's method of order 4 |
            a Runge-Kutta method of order 3 | 3 | rk3 rungekutta3 kutta3 heun3 \
            ralston3 bogackishampine ssprk3 ssprk43 ssp3 | |
            a strong-stability-preserving method | 2 | ssp ssprk ssprk42 shuosher | |
            an implicit Runge-Kutta method | 1 | rungekutta-implicit rungekutta-implizit | backward Euler; \
            the implicit midpoint method; the implicit trapezoidal rule | implicit
            a Runge-Kutta method | 1 | rungekutta-? | |
            a Runge-Kutta method of order 4 | 4 | rk4 rungekutta4 rungekutta classicalrk ralston4 ralstonrk4 \
            ssprk4 ssprk54 ssprk104 | |
            a Runge-Kutta method of order 6 | 6 | rk6 rungekutta6 butcher6 | |
            a Runge-Kutta method of order 7 | 7 | rk7 rungekutta7 | |
            a Runge-Kutta method of order 8 | 8 | rk8 rungekutta8 | |
            Gill's method | 4 | gill | Gill's method |
            Merson's method | 4 | merson kuttamerson rungekuttamerson | Merson's method |
            a stabilized method | 1 | chebyshev legendre rkc rkl | |
            Kutta's 3/8 rule | 4 | rk38 rungekutta38 kutta38 threeeighth dreiachtel troishuit tresoctav \
            | Kutta's 3/8 rule |
            a method of order 4 or 5 | 4 | rkf45 rk45 ode45 fehlberg rungekuttafehlberg cashkarp dormandprince dopri | |
            a Runge-Kutta method of order 5 | 5 | rk5 rungekutta5 dopri5 rkf5 dormandprince5 \
            fehlberg5 cashkarp5 | |
            velocity or position Verlet | 2 | verlet velocity-verlet position-verlet stormer-verlet stoermer-verlet \
            leapfrog kickdriftkick driftkickdrift stormer stoermer | velocity Verlet (leapfrog: kick, drift, kick); \
            position Verlet (drift, kick, drift) |
            velocity Verlet | 2 | leapfrogkdk | velocity Verlet (leapfrog: kick, drift, kick) |
            position Verlet | 2 | leapfrogdkd | position Verlet (drift, kick, drift) |
            Ruth's method of order 3 | 3 | ruth ruth3 | |
            a symplectic method of order 4 | 4 | yoshida forestruth ruth4 candyrozmus pefrl suzuki4 suzukitrotter4 \
            suzukifractal | |
            a symplectic method of order 6 | 6 | yoshida6 suzuki6 kahanli | |
            a symmetric splitting | 2 | strang suzukitrotter trotter2 | | symmetric
            an Adams method of order 2 | 2 | ab2 adamsbashforth2 adams2 | | earlier
            an Adams method of order 3 | 3 | ab3 adamsbashforth3 adams3 abm3 | | earlier
            an Adams method of order 4 | 4 | ab4 adamsbashforth4 adams4 abm4 | | earlier
            an Adams method of order 5 | 5 | ab5 adamsbashforth5 adams5 abm5 | | earlier
            Milne's or Hamming's method | 4 | milne hamming milnesimpson milnehamming | | earlier
            a Taylor method of order 2 | 2 | taylor2 taylorseries | |
            a Taylor method of order 3 | 3 | taylor3 | |
            a Taylor method of order 4 | 4 | taylor4 | |
            an Adams method | 2 | adams adamsbashforth adamsmoulton adamsbashforthmoulton | |
            a BDF method of order 2 | 2 | bdf2 | | earlier
            a Rosenbrock method | 1 | rosenbrock | | implicit
            a Rosenbrock method of order 2 | 2 | ros2 rosenbrock2 | | implicit
            a Rosenbrock method of order 3 | 3 | ros3 rosenbrock3 rodas3 | | implicit
            a Rosenbrock method of order 4 | 4 | ros4 rosenbrock4 rodas kapsrentrop grk4 | | implicit
            an exponential method of order 2 | 2 | etd2 etdrk2 exponentialmidpoint exponential-rosenbrock | |
            an exponential method of order 4 | 4 | etd4 etdrk4 lawson4 | |
            TR-BDF2 | 2 | trbdf2 | TR-BDF2 | implicit
            a Nystrom method | 3 | nystrom nystroem rkn | |
            a Nystrom method of order 4 | 4 | nystrom4 nystroem4 rkn4 | |
            a Nystrom method of order 5 | 5 | nystrom5 nystroem5 rkn5 | |
            a BDF method of order 3 | 3 | bdf3 | | earlier
            a BDF method of order 4 | 4 | bdf4 | | earlier
            a BDF method of order 5 | 5 | bdf5 | | earlier
            a BDF method of order 6 | 6 | bdf6 | | earlier
            Beeman's method | 2 | beeman | |
            Newmark's method | 2 | newmark averageacceleration meanacceleration \
            | the implicit trapezoidal rule; velocity Verlet (leapfrog: kick, drift, kick); Newmark's method |
            Gragg's method | 2 | gragg modifiedmidpoint | |
            an extrapolation method | 3 | bulirsch stoer bulirsch-stoer gragg-bulirsch \
            gragg-extrapol gragg-bulirsch-stoer bulirsch-stoer-extrapol gbs | |
            an extrapolation method | 2 | romberg romberg-extrapol | |
            a predictor-corrector method | 2 | pec pece predictor-corrector | |
            a Gauss method | 2 | gauss gausslegendre | the implicit midpoint method; Gauss's method of order 4; \
            Gauss's method of order 6 | implicit
            a Gauss method of order 4 | 4 | gauss4 gausslegendre4 | Gauss's method of order 4; \
            Gauss's method of order 6 | implicit
            a Gauss method of order 6 | 6 | gauss6 gausslegendre6 | Gauss's method of order 6 | implicit
            a Lobatto method of order 4 | 4 | lobatto4 | Lobatto IIIA of order 4; Lobatto IIIB of order 4; \
            Lobatto IIIC of order 4 | implicit
            a Lobatto method | 2 | lobatto | the implicit trapezoidal rule; Lobatto IIIC of order 2; \
            Lobatto IIIA of order 4; Lobatto IIIB of order 4; Lobatto IIIC of order 4 | implicit
            a Radau method | 3 | radau | Radau IIA of order 3; Radau IA of order 3; Radau IIA of order 5 | implicit
            a Radau method of order 3 | 3 | radau3 radauiia3 | Radau IIA of order 3; Radau IA of order 3; \
            Radau IIA of order 5 | implicit
            Radau IIA of order 5 | 5 | radau5 radauiia5 | Radau IIA of order 5 | implicit
            a diagonally implicit method of order 2 | 2 | sdirk2 dirk2 | the implicit midpoint method; \
            the implicit trapezoidal rule; Alexander's method of order 2 | implicit
            Alexander's method | 2 | alexander | Alexander's method of order 2; Alexander's method of order 3 | implicit
            a Hermite method | 4 | hermite | |
            a diagonally implicit method of order 3 | 3 | sdirk3 dirk3 | Alexander's method of order 3; \
            Norsett's method of order 3 | implicit
            a diagonally implicit method of order 4 | 4 | sdirk4 dirk4 | | implicit
            """;

    /** The parts of a word stand in a name in any order. */
    private record Row(List<String> parts, String says, int order, List<String> methods, String kind) {
        static Stream<Row> of(String line) {
            String[] parts = line.split(" *[|] *", -1);
            List<String> methods = Stream.of(parts[3].split("; ")).filter(name -> !name.isEmpty()).toList();
            return Stream.of(parts[2].split(" ")).map(word -> new Row(List.of(word.replace("?",
                    OTHER_WORD).split("-")), parts[0], Integer.parseInt(parts[1]), methods, parts[4]));
        }

        /** A short part begins a word: there is no rk5 in Homework5. */
        boolean isIn(String name) {
            return parts.stream().allMatch(part -> Pattern.compile((part.length() > SHORT ? ""
                    : "((?<![A-Za-z])|(?=[A-Z0-9]))") + "(?i)" + part).matcher(name).find());
        }

        /** In RungeKuttaHeun, the other word says which. */
        int length() {
            return parts.get(0).equals("rungekutta") ? 0 : String.join("", parts).replace(OTHER_WORD, "?").length();
        }
    }

    private static final List<Row> ROWS = TABLE.lines().flatMap(Row::of).toList();

    /**
     * @param className a simple class name, such as {@code MyHeunSolver}
     * @return the promise
     */
    static NamePromise of(String className) {
        String digits = className.replaceAll("[^A-Za-z0-9]", "");
        for (int n = 0; n < NUMBERS.length; n++) {
            digits = digits.replaceAll(NUMBER.formatted(NUMBERS[n]), String.valueOf(n + 2));
        }
        String bare = digits.replaceFirst("^(.)(RungeKutta)(?!\\d)", "$2$1");       // ThirdRungeKutta
        String lower = bare.toLowerCase(Locale.ROOT);
        int said = Integer.parseInt("0" + lower.replaceAll(ORDER, "$1$5"));
        boolean adapts = ADAPTS.matcher(lower).find();
        return ROWS.stream().filter(row -> row.isIn(bare)).max(Comparator.comparingInt(Row::length)).map(best -> {
            String rest = lower.replaceAll("(" + String.join("|", best.parts) + ")(s(?=method|rule|solver|$))?", " ");
            boolean more = EXTRAPOLATES.matcher(rest).find();
            String says = said > best.order ? best.says.split(" of order")[0] + " of order " + said : best.says;
            return new NamePromise((more ? "the extrapolation of " : "") + says,
                    Math.max(said, best.order + (more ? 1 : 0)), best.methods, best.kind,
                    more || ROWS.stream().anyMatch(row -> row.parts.stream().allMatch(rest::contains))
                    || CHANGES.matcher(rest).find(), adapts);      // HeunEuler is another method
        }).orElseGet(() -> new NamePromise(said > 0 ? "a method of order " + said : "", said, List.of(), "",
                true, adapts));
    }

    /**
     * @param results how often a step begins at the old state; each further one of Gragg's results gains two orders,
     *                and each of Euler's one
     * @return the lowest order that the name promises
     */
    int order(int results) {
        return order + (extrapolates() ? (order - 1) * Math.max(0, results - 2) : 0);
    }

    /** @return whether it is an extrapolation method whose order grows with its results */
    boolean extrapolates() {
        return says.equals("an extrapolation method");
    }

    /** @return whether the name promises something */
    boolean isGiven() {
        return order > 0;
    }

    /** @return whether a method of this name and order may be called so */
    boolean allows(String method, int itsOrder) {
        boolean high = itsOrder >= order || order <= 2 && IMPLICIT.indexOf(method) > 0;     // those are of order 2
        return methods.contains(method) && (high || itsOrder == 0 && order <= 2)
                || high && (methods.isEmpty() || changed);
    }

    /** @return the meaning of the name, with this order */
    String saysWithOrder(int order) {
        return "the name promises " + says + (says.contains("order") ? "" : ", of order " + order);
    }

    /** @return whether the name stands for implicit methods only */
    boolean isImplicit() {
        return kind.equals("implicit") && !changed;
    }

    /** @return whether a step back has to undo a step, as it need not with extrapolation or step-size control */
    boolean isSymmetric() {
        return kind.equals("symmetric") && !changed && !adapts;
    }

    /** @return the finding for a known method that the name does not stand for; none for no method */
    Optional<Finding> contradicted(String method, int itsOrder) {
        return method.isEmpty() || allows(method, itsOrder) ? Optional.empty()
                : Optional.of(method.equals(KnownMethods.EULER) && methods.contains(KnownMethods.SYMPLECTIC)
                ? Phrase.OLD_VELOCITY.of() : method.startsWith("symplectic Euler") && methods.contains(
                KnownMethods.EULER) ? Phrase.NEW_VELOCITY.of() : (isImplicit() && !IMPLICIT.contains(method)
                ? Phrase.EXPLICIT : Phrase.CONTRADICTS).of(method, says));
    }
}
