package particles.reactions;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import deSolvers.catalog.SolverCatalog;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.MethodSource;
import particles.SimulationException;
import particles.scene.ShortRun;

/** Chains of many rods, which no force derivatives describe: what a step costs, and how runs end. */
class LongChainsTest {
    /** Rods of 0.1 m in a row from the first particle on, which may be fixed. */
    private static String chain(int rods, double x, double y, boolean fixed) {
        return "particles:\n" + IntStream.rangeClosed(0, rods)
                .mapToObj(i -> "  - {id: p%d, position: [%s, %s, 0], fixed: %s}%n".formatted(i, x + 0.1 * i, y,
                        fixed && i == 0)).collect(Collectors.joining())
                + "rods:\n" + IntStream.range(0, rods)
                .mapToObj(i -> "  - {from: p%d, to: p%d}%n".formatted(i, i + 1)).collect(Collectors.joining());
    }

    private static final String SPHERE = chain(40, -1.6, 1.3, false) + """
            rules:
              - sphere: {centre: [0, 0, 0], radius: 1, restitution: 0.2, friction: {law: coulomb, coefficient: 0.3}}
            """;
    private static final String WHIP = chain(40, 0, 0, true) + """
            rules:
              - ground: {restitution: 0.2, friction: {law: coulomb, coefficient: 0.3}}
              - glide: {particle: p0, to: [0.5, 1, 0.5], duration: 0.3}
            """;

    private static long evaluations(String solver, String scene) {
        return ShortRun.of(solver + " clamp 0.002 0.8", scene).getSystem().getEvaluations();
    }

    /**
     * A chain falls on a rough ball, and a hand pulls a whip off rough ground. A step of an implicit solver takes a few
     * times the evaluations of rk4, and not one for each of the 246 entries of the state. Measured: 8.7, 8.2, 1.3 and
     * 54.5 times.
     */
    @Tag("slow")
    @ParameterizedTest
    @CsvSource({"backward-euler, 10", "implicit-midpoint, 10", "linearised-euler, 2", "radau, 60"})
    void anImplicitStepTakesFewEvaluations(String solver, double most) {
        for (String scene : new String[] {SPHERE, WHIP}) {
            double times = (double) evaluations(solver, scene) / evaluations("rk4", scene);
            assertTrue(times < most, solver + ": " + times + " times rk4's");
        }
    }

    /**
     * A rope of 20 rods swings down from level; its end then turns through more than a radian in 5 ms. That is too fast
     * for a fixed step, and each such run ends with the reason. The solvers that choose their own sub-steps follow it.
     */
    @ParameterizedTest
    @MethodSource("deSolvers.catalog.SolverCatalog#names")
    void aRopeTooFastForItsStepEndsWithTheReason(String solver) {
        ShortRun rope = new ShortRun(solver + " clamp 0.005 3.5", chain(20, 0, 0, true));
        if (SolverCatalog.find(solver).orElseThrow().adaptive()) {
            rope.run();
            assertEquals(0, rope.getNumericalError(), 0.02, "measured: 0.0042 J (step-doubling)");
        } else {
            String message = assertThrows(SimulationException.class, rope::run).getMessage();
            assertTrue(message.matches("(?s).*(the rod from .* m too (long|short) .*: the motion is wrong"
                    + "|the kinetic energy is .*, above the limit|did not converge).*"), message);
        }
    }
}
