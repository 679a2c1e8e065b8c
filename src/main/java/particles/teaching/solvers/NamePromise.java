package particles.teaching.solvers;

import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.regex.Pattern;

/**
 * The method that the name of a solver's class promises.
 *
 * @param says    the meaning of the name
 * @param order   the lowest order of all methods that it can stand for
 * @param methods the methods that it can stand for; empty for all of that order
 * @param whole   whether the name contains nothing else: RichardsonEuler need not be Euler
 * @param adapts  whether the name promises step-size control
 */
record NamePromise(String says, int order, List<String> methods, boolean whole, boolean adapts) {
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

    private static final List<String> IMPLICIT = List.of(BACKWARD_EULER, IMPLICIT_MIDPOINT, TRAPEZOID);

    /** Words in a name that say nothing about the method; a letter and digits before it number an exercise. */
    private static final String NOISE =
            "^[a-z]\\d+|my|solver|stepper|integrator|method|rule|step|the|mine|own|fixed|test|good|newton|new|scheme"
            + "|task|exercise|question|homework|assignment|aufgabe|version|verfahren|explicit|forward|classical|classic"
            + "|standard|slides?|particles?|\\d";
    private static final Pattern ADAPTS = Pattern.compile("adapt|stepdoubling|stepsizecontrol|variablestep");

    private record Row(String says, int order, List<String> methods, List<String> words) {
        Row(String says, int order, String words, String... methods) {
            this(says, order, List.of(methods), List.of(words.split(" ")));
        }
    }

    /** Those with the longest words win: symplecticeuler before euler. */
    private static final List<Row> ROWS = List.of(
            new Row(EULER, 1, "euler expliciteuler forwardeuler", EULER),
            new Row("symplectic Euler", 1, "symplecticeuler semiimplicit semiimpliciteuler cromer eulercromer "
            + "symplectic simplealgorithm simpleparticle",
                    SYMPLECTIC, POSITION_FIRST),
            new Row(BACKWARD_EULER, 1, "backwardeuler impliciteuler", BACKWARD_EULER),
            new Row("the midpoint method", 2, "midpoint", MIDPOINT, IMPLICIT_MIDPOINT),
            new Row(MIDPOINT, 2, "explicitmidpoint", MIDPOINT),
            new Row(IMPLICIT_MIDPOINT, 2, "implicitmidpoint", IMPLICIT_MIDPOINT),
            new Row("a Runge-Kutta method of order 2", 2, "rk2 rungekutta2"),
            new Row(HEUN, 2, "heun", HEUN, RALSTON, "Heun's method of order 3"),
            new Row("Heun's method or the midpoint method", 2, "modifiedeuler improvedeuler", HEUN, MIDPOINT, RALSTON),
            new Row("the trapezoidal rule", 2, "trapez trapezoid trapezoidal", HEUN, TRAPEZOID),
            new Row(TRAPEZOID, 2, "cranknicolson implicittrapez implicittrapezoid implicittrapezoidal", TRAPEZOID),
            new Row("Ralston's method", 2, "ralston", RALSTON, "Ralston's method of order 3"),
            new Row("a Runge-Kutta method of order 3", 3, "rk3 rungekutta3 kutta3 heun3 ralston3 bogackishampine"
                    + " ssprk3 ssp3"),
            new Row("a strong-stability-preserving method", 2, "ssp ssprk shuosher"),
            new Row("a Runge-Kutta method of order 4", 4, "rk4 rungekutta4 rungekutta classicalrk gill"),
            new Row(THREE_EIGHTHS, 4, "rk38 rungekutta38 kutta38 threeeighth", THREE_EIGHTHS),
            new Row("a method of order 4 or 5", 4, "rkf45 rk45 ode45 fehlberg rungekuttafehlberg cashkarp"
                    + " dormandprince dopri"),
            new Row("a Runge-Kutta method of order 5", 5, "rk5 rungekutta5 dopri5 rkf5"),
            new Row("velocity or position Verlet", 2, "verlet velocityverlet positionverlet stormerverlet "
            + "stoermerverlet leapfrog kickdriftkick driftkickdrift stormer"
                    + " stoermer", VERLET, POSITION_VERLET),
            new Row("velocity Verlet", 2, "leapfrogkdk", VERLET),
            new Row("position Verlet", 2, "leapfrogdkd", POSITION_VERLET),
            new Row("Ruth's method of order 3", 3, "ruth ruth3"),
            new Row("a symplectic method of order 4", 4, "yoshida forestruth ruth4 candyrozmus pefrl"),
            new Row("an Adams method of order 2", 2, "ab2 adamsbashforth2 adams2"),
            new Row("an Adams method of order 3", 3, "ab3 adamsbashforth3 adams3 abm3"),
            new Row("an Adams method of order 4", 4, "ab4 adamsbashforth4 adams4 abm4"),
            new Row("an Adams method", 2, "adams adamsbashforth adamsmoulton adamsbashforthmoulton"),
            new Row("a BDF method of order 2", 2, "bdf2"),
            new Row("a BDF method of order 3", 3, "bdf3"),
            new Row("a Radau method", 2, "radau"),
            new Row("a Radau method of order 3", 3, "radau3 radauiia3"),
            new Row("Radau IIA of order 5", 5, "radau5 radauiia5"),
            new Row("a diagonally implicit method of order 2", 2, "sdirk2 dirk2"),
            new Row("a diagonally implicit method of order 3", 3, "sdirk3 dirk3"));

    /**
     * @param className a simple class name, such as {@code MyHeunSolver}
     * @return the promised method, if the name contains one
     */
    static Optional<NamePromise> of(String className) {
        String lower = className.toLowerCase(Locale.ROOT).replaceAll("[^a-z0-9]", "");
        Row best = null;
        String longest = "";
        for (Row row : ROWS) {
            for (String word : row.words) {
                if (lower.contains(word) && word.length() > longest.length()) {
                    longest = word;
                    best = row;
                }
            }
        }
        boolean adapts = ADAPTS.matcher(lower).find();
        if (best == null) {
            return adapts ? Optional.of(new NamePromise("a method with step-size control", 1, List.of(), false, true))
                    : Optional.empty();
        }
        boolean whole = isNoise(lower, longest) || isNoise(lower, longest + "s");      // Heun's method
        return Optional.of(new NamePromise(best.says, best.order, best.methods, whole, adapts));
    }

    private static boolean isNoise(String name, String but) {
        return name.replaceFirst(but, " ").replaceAll(NOISE, "").isBlank();
    }

    /** @return whether a method of this name and order may be called so */
    boolean allows(String method, int itsOrder) {
        return methods.contains(method) || itsOrder >= order && (methods.isEmpty() || !whole);
    }

    /** @return the meaning of the name, with the order */
    String saysWithOrder() {
        return says + (says.contains("order") ? "" : ", of order " + order);
    }

    /** @return whether the name stands for a method that uses derivatives or states of earlier steps */
    boolean remembers() {
        return says.startsWith("an Adams method of") || says.startsWith("a BDF method");
    }

    /** @return whether the name stands for implicit methods only */
    boolean isImplicit() {
        return !methods.isEmpty() && IMPLICIT.containsAll(methods);
    }

    /** @return the finding for a known method that the name does not stand for */
    String contradicts(String method) {
        boolean implicit = isImplicit() && !IMPLICIT.contains(method);
        return "this is " + method + (implicit && !method.contains("explicit") ? ", which is explicit," : "")
                + " and not " + says
                + ", as its name says"
                + (implicit ? ": the equation for the new state is not solved; an iteration has to go on until nothing "
                + "changes" : "");
    }
}
