package particles.app.student;

import deSolvers.DESolver;
import java.util.List;
import java.util.function.Supplier;
import java.util.stream.Stream;
import particles.teaching.declared.Method;
import particles.teaching.solvers.SolverCheck;
import particles.teaching.solvers.SolverVerdict;

/** The methods that a solver can be asked to be, by name. */
public final class AskedMethods {
    /** In place of a method: any right one, or the one that the name of the class declares. */
    public static final String ANY = "any";

    /** The names; the last one is {@link #ANY}. */
    public static final List<String> NAMES = Stream.concat(Method.declarable().stream().map(Method::option).sorted(),
            Stream.of(ANY)).toList();

    private AskedMethods() {
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
        return Method.declarable().stream().filter(one -> one.option().equals(method)).findFirst().map(one ->
                SolverCheck.check(maker, one)).orElseGet(() -> SolverCheck.check(maker, className));
    }
}
