package particles.teaching.declared;

import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;

/**
 * The methods that a solver can be declared to be, by {@code -Pmethod} or by the name of its class, and those that the
 * check knows by their steps.
 *
 * <p>A class name declares a method if these words stand in it one after the other, as in {@code MyRK4Solver}, {@code
 * BackwardEuler} or {@code AB2Stepper}:
 *
 * <table>
 * <caption>Words in class names</caption>
 * <tr><td>Euler, ExplicitEuler, ForwardEuler</td><td>the Euler method</td></tr>
 * <tr><td>Midpoint, ExplicitMidpoint</td><td>the midpoint method</td></tr>
 * <tr><td>Heun</td><td>Heun's method</td></tr>
 * <tr><td>Ralston</td><td>Ralston's method</td></tr>
 * <tr><td>RK2, RungeKutta2, ModifiedEuler, ImprovedEuler, EulerRichardson</td><td>order 2</td></tr>
 * <tr><td>RK3, RungeKutta3, SSPRK3</td><td>order 3</td></tr>
 * <tr><td>RK4, RungeKutta4, ClassicalRungeKutta</td><td>order 4, such as the classical Runge-Kutta method</td></tr>
 * <tr><td>RK38, RungeKutta38, Kutta38, ThreeEighths</td><td>Kutta's 3/8 rule</td></tr>
 * <tr><td>Gill</td><td>Gill's method</td></tr>
 * <tr><td>RK5, RungeKutta5, DormandPrince5, DoPri5</td><td>order 5</td></tr>
 * <tr><td>RK45, RKF45, Fehlberg, CashKarp, DormandPrince</td><td>order 4 or more</td></tr>
 * <tr><td>SymplecticEuler, SemiImplicitEuler, EulerCromer</td><td>symplectic Euler</td></tr>
 * <tr><td>Verlet, VelocityVerlet, PositionVerlet, Leapfrog</td><td>Verlet, of order 2</td></tr>
 * <tr><td>Yoshida, Yoshida4, ForestRuth</td><td>a symplectic method of order 4</td></tr>
 * <tr><td>BackwardEuler, ImplicitEuler</td><td>backward Euler</td></tr>
 * <tr><td>ImplicitMidpoint</td><td>the implicit midpoint method</td></tr>
 * <tr><td>Trapezoidal, Trapezoid, CrankNicolson</td><td>the trapezoidal rule</td></tr>
 * <tr><td>AB2, AB3, AB4, AdamsBashforth2, ...</td><td>Adams and Bashforth's methods</td></tr>
 * <tr><td>BDF2, BDF3</td><td>backward differentiation</td></tr>
 * <tr><td>Radau, RadauIIA</td><td>a Radau method, of order 3 or more</td></tr>
 * <tr><td>Adams, AdamsBashforth, AdamsMoulton</td><td>an Adams method, of order 2 or more</td></tr>
 * <tr><td>Adaptive, StepDoubling</td><td>step-size control</td></tr>
 * </table>
 */
public enum Method {
    EULER("euler", "the Euler method", 1, names("expliciteuler", "forwardeuler"), Scheme.rungeKutta(w(1))),
    MIDPOINT("midpoint", "the midpoint method", 2, names("explicitmidpoint"), Scheme.rungeKutta(w(0, 1), w(0.5))),
    HEUN("heun", "Heun's method", 2, names(), Scheme.rungeKutta(w(0.5, 0.5), w(1))),
    RALSTON("ralston", "Ralston's method", 2, names(), Scheme.rungeKutta(w(0.25, 0.75), w(2.0 / 3)),
            Scheme.rungeKutta(w(1.0 / 3, 2.0 / 3), w(0.75))),
    RK2("rk2", "a Runge-Kutta method of order 2", 2, names("rungekutta2", "modifiedeuler", "improvedeuler",
            "eulerrichardson")),
    RK3("rk3", "a Runge-Kutta method of order 3", 3, names("rungekutta3", "ssprk3", "heun3")),
    KUTTA3("kutta3", "Kutta's method of order 3", 3, names(), Scheme.rungeKutta(w(1.0 / 6, 2.0 / 3, 1.0 / 6), w(0.5),
            w(-1, 2))),
    HEUN3("", "Heun's method of order 3", 3, names(), Scheme.rungeKutta(w(0.25, 0, 0.75), w(1.0 / 3), w(0, 2.0 / 3))),
    SHU_OSHER("", "SSPRK3, the method of Shu and Osher", 3, names(), Scheme.rungeKutta(w(1.0 / 6, 1.0 / 6, 2.0 / 3),
            w(1), w(0.25, 0.25))),
    RK4("rk4", "RK4, the classical Runge-Kutta method", 4, names("rungekutta4", "classicalrungekutta"),
            Scheme.rungeKutta(w(1.0 / 6, 1.0 / 3, 1.0 / 3, 1.0 / 6), w(0.5), w(0, 0.5), w(0, 0, 1))),
    GILL("", "Gill's method", 4, names("gill", "rungekuttagill"), Scheme.rungeKutta(w(1.0 / 6, (2 - root()) / 6, (2
            + root()) / 6, 1.0 / 6), w(0.5),
            w((root() - 1) / 2, (2 - root()) / 2), w(0, -root() / 2, 1 + root() / 2))),
    RK38("rk38", "Kutta's 3/8 rule", 4, names("rungekutta38", "kutta38", "threeeighths"), Scheme.rungeKutta(w(0.125,
            0.375, 0.375, 0.125), w(1.0 / 3),
            w(-1.0 / 3, 1), w(1, -1, 1))),
    RK5("rk5", "a Runge-Kutta method of order 5", 5, names("rungekutta5", "dormandprince5", "dopri5")),
    RK45("rk45", "a Runge-Kutta method of order 4 or 5", 4, names("rkf45", "fehlberg", "cashkarp", "dormandprince")),
    SYMPLECTIC_EULER("symplectic-euler", "symplectic Euler, the slides' simple particle system algorithm", 1,
            names("semiimpliciteuler", "eulercromer"), Scheme.turns(w(0, 1), w(1)), Scheme.turns(w(1, 0), w(1))),
    VERLET("verlet", "Verlet's method (leapfrog)", 2, names("velocityverlet", "positionverlet", "leapfrog"),
            Scheme.turns(w(0, 1, 0), w(0.5, 0.5)), Scheme.turns(w(0.5, 0.5), w(1))),
    YOSHIDA4("yoshida4", "Yoshida's method of order 4", 4, names("yoshida", "forestruth"), yoshida(0), yoshida(1)),
    BACKWARD_EULER("backward-euler", "backward Euler", 1, names("impliciteuler"), new Equation(w(1), w(1), 1)),
    IMPLICIT_MIDPOINT("implicit-midpoint", "the implicit midpoint method", 2, names(), new Equation(w(1), w(0.5), 1)),
    TRAPEZOIDAL("trapezoidal", "the implicit trapezoidal rule", 2, names("trapezoid", "cranknicolson",
            "implicittrapezoidal"), new Equation(w(1), w(0, 1), 0.5, 0.5)),
    AB2("ab2", "Adams and Bashforth's method of order 2", 2, names("adamsbashforth2"), Equation.adams(1.5, -0.5)),
    AB3("ab3", "Adams and Bashforth's method of order 3", 3, names("adamsbashforth3"), Equation.adams(23.0 / 12,
            -4.0 / 3, 5.0 / 12)),
    AB4("ab4", "Adams and Bashforth's method of order 4", 4, names("adamsbashforth4"), Equation.adams(55.0 / 24,
            -59.0 / 24, 37.0 / 24, -9.0 / 24)),
    BDF2("bdf2", "the BDF method of order 2", 2, names(), new Equation(w(4.0 / 3, -1.0 / 3), w(1), 2.0 / 3)),
    BDF3("bdf3", "the BDF method of order 3", 3, names(), new Equation(w(18.0 / 11, -9.0 / 11, 2.0 / 11), w(1),
            6.0 / 11)),
    RADAU("", "a Radau method", 3, names("radau", "radauiia")),
    ADAMS("", "an Adams method", 2, names("adams", "adamsbashforth", "adamsmoulton")),
    MULTISTEP("multistep", "a method that uses earlier steps (a multistep method)", 2, names()),
    ADAPTIVE("adaptive", "a method with step-size control", 1, names("stepdoubling"));

    private final String option;
    private final String title;
    private final int order;
    private final List<String> names;
    private final List<Scheme> schemes;
    private final Optional<Equation> equation;

    Method(String option, String title, int order, List<String> names, Scheme... schemes) {
        this(option, title, order, names, null, schemes);
    }

    Method(String option, String title, int order, List<String> names, Equation equation, Scheme... schemes) {
        this.option = option;
        this.title = title;
        this.order = order;
        this.names = names;
        this.schemes = List.of(schemes);
        this.equation = Optional.ofNullable(equation);
    }

    /** Three Verlet steps in one, that begin with a kick, 0, or with a drift, 1. */
    private static Scheme yoshida(int drift) {
        double outer = 1 / (2 - StrictMath.cbrt(2));
        double inner = 1 - 2 * outer;
        double ends = outer / 2;
        double between = (outer + inner) / 2;
        return drift == 1 ? Scheme.turns(w(ends, between, between, ends), w(outer, inner, outer))
                : Scheme.turns(w(0, outer, inner, outer, 0), w(ends, between, between, ends));
    }

    private static double root() {
        return Math.sqrt(2);
    }

    private static double[] w(double... weights) {
        return weights;
    }

    private static List<String> names(String... names) {
        return List.of(names);
    }

    /** @return the methods that can be declared, by the names that the commands take */
    public static List<Method> declarable() {
        return Arrays.stream(values()).filter(method -> !method.option.isEmpty()).toList();
    }

    /** @return the name on command lines, such as {@code rk4}; empty for one that is only recognised */
    public String option() {
        return option;
    }

    /** @return what it is called, such as {@code Heun's method} */
    public String title() {
        return title;
    }

    /** @return its order, or the lowest one of its kind */
    public int order() {
        return order;
    }

    /** @return its steps, if it is an explicit one with fixed weights; the first is that of textbooks */
    public List<Scheme> schemes() {
        return schemes;
    }

    /** @return the equation of the new state, if it is an implicit or a multistep one */
    public Optional<Equation> equation() {
        return equation;
    }

    /** @return whether each step solves an equation for the new state */
    public boolean isImplicit() {
        return this == RADAU || equation.filter(one -> one.isImplicit() && !one.usesEarlier()).isPresent();
    }

    /** @return whether its steps use earlier ones */
    public boolean usesEarlier() {
        return this == MULTISTEP || equation.filter(Equation::usesEarlier).isPresent();
    }

    /** @return the words that declare it in the name of a class, in small letters without a space */
    Stream<String> words() {
        return Stream.concat(names.stream(), Stream.of(option.replace("-", ""))).filter(word ->
                !word.isEmpty());
    }

    /** @return whether it is no method but all of a kind and order */
    public boolean isFamily() {
        return schemes.isEmpty() && equation.isEmpty();
    }

    /** @return whether the name of this method in a class's name may stand for another one */
    boolean mayBe(Method other) {
        return switch (this) {
            case MIDPOINT -> other == IMPLICIT_MIDPOINT;
            case HEUN -> other == RALSTON || other == HEUN3;
            case TRAPEZOIDAL -> other == HEUN;
            default -> isFamily() || this == RK4 && other.order >= order;
        };
    }
}
