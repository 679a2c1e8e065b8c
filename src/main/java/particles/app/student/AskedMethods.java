package particles.app.student;

import deSolvers.DESolver;
import deSolvers.catalog.SolverCatalog;
import deSolvers.catalog.SolverInfo.Family;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.function.Supplier;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import particles.spec.messages.Wording;
import particles.teaching.Finding;
import particles.teaching.Finding.Kind;
import particles.teaching.solvers.SolverCheck;
import particles.teaching.solvers.SolverVerdict;

/** The methods that a solver can be asked to be: those that the check tells from all others. */
public final class AskedMethods {
    /** In place of a method: any right one, or the one that the name of the class promises. */
    public static final String ANY = "any";

    /** The name of each method, and the words with which the check identifies it. */
    private static final Map<String, String> METHODS = Stream.of("""
            euler = the Euler method
            midpoint = the midpoint method
            heun = Heun's method
            ralston = Ralston's method
            rk4 = RK4, the classical Runge-Kutta method
            rk38 = Kutta's 3/8 rule
            symplectic-euler = symplectic Euler
            verlet = velocity Verlet or position Verlet
            yoshida4 = Yoshida's method of order 4
            backward-euler = backward Euler
            implicit-midpoint = the implicit midpoint method
            trapezoidal = the implicit trapezoidal rule
            multistep = a method that uses earlier steps
            """.split("\n")).map(line -> line.split(" = ")).collect(Collectors.toUnmodifiableMap(
            row -> row[0], row -> row[1]));

    /** The names; the last one is {@link #ANY}. */
    public static final List<String> NAMES = Stream.concat(METHODS.keySet().stream().sorted(), Stream.of(ANY)).toList();

    private AskedMethods() {
    }

    /** @return why another name cannot be asked for, in a line */
    public static String refusal(String name) {
        return SolverCatalog.find(name).map(solver -> "'" + name + "' cannot be asked for: the check sees whether"
                + " such a method is right, but cannot tell it from others of its kind; write "
                + (solver.family() == Family.MULTISTEP ? "multistep" : ANY))
                .orElseGet(() -> Wording.unknown("method", name, NAMES, List.of()));
    }

    /**
     * Checks a solver.
     *
     * @param maker     makes a new one
     * @param className the simple name of its class
     * @param method    one of the names; a right solver of another method gets a mistake
     * @return the verdict
     */
    static SolverVerdict check(Supplier<DESolver> maker, String className, String method) {
        SolverVerdict verdict = SolverCheck.check(maker, method.equals(ANY) ? className : method);
        if (method.equals(ANY) || !verdict.wrong().isEmpty() || Stream.of(METHODS.get(method).split(" or "))
                .anyMatch(words -> verdict.identity().matches("This is " + words + "(?! of order).*"))) {
            return verdict;
        }
        List<Finding> findings = new ArrayList<>(verdict.findings());
        findings.add(0, new Finding(Kind.NAME, "it is asked to be " + METHODS.get(method)));
        return new SolverVerdict(verdict.identity(), findings, verdict.multistep());
    }
}
