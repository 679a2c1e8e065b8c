package particles.engine;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;

import deSolvers.DESolver;
import deSolvers.catalog.SolverCatalog;
import deSolvers.problems.Steps;
import java.util.Arrays;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.MethodSource;
import particles.ParticleSystem;
import particles.law.AnchorMotion;
import particles.law.AnchorMotion.CircleMotion;
import particles.law.AnchorMotion.GlideMotion;
import particles.law.Vector3;
import particles.scene.ShortRun;

/** Moving anchors follow their motions exactly with every solver, which keeps its order and memory. */
class AnchorsTest {
    private static final AnchorMotion GLIDE = new GlideMotion(Vector3.ZERO, new Vector3(2, 0, 0), 1.02);
    private static final AnchorMotion CRANK = new CircleMotion(new Vector3(0.3, 0, 0), Vector3.ZERO,
            new Vector3(0, 0, 1), 1.5);

    private static ParticleSystem pulled(AnchorMotion motion, double damping) {
        ParticleSystem system = new ShortRun("rk4 clamp 1 1", """
                particles: [{id: hand, position: [0, 0, 0], fixed: true}, {id: block, position: [0, -1, 0.1]}]
                springs: [{from: hand, to: block, stiffness: 20, restLength: 0.8, damping: %s}]
                """.formatted(damping)).getSystem();
        system.moveAnchor(0, motion);
        return system;
    }

    private static void assertIsWhereItShouldBe(ParticleSystem system, AnchorMotion motion) {
        double[] exact = new double[9];
        motion.at(system.getTime(), exact);
        assertArrayEquals(Arrays.copyOf(exact, 6), Arrays.copyOf(system.getOwnState(), 6), "to the bit");
    }

    /**
     * After 400 steps of 0.05 s, forwards or backwards. If the hand's acceleration were integrated, it would be at 1.33
     * m with verlet and euler and at 2.45 m with midpoint instead of 2 m.
     */
    @ParameterizedTest
    @MethodSource("deSolvers.catalog.SolverCatalog#names")
    void anchorsFollowTheirMotionsExactly(String solver) {
        for (AnchorMotion motion : List.of(GLIDE, CRANK)) {
            for (double h : new double[] {0.05, -0.05}) {
                ParticleSystem system = pulled(motion, 0.1);
                DESolver stepper = SolverCatalog.create(solver);
                for (int k = 0; k < 400; k++) {
                    stepper.stepState(system, h);
                    assertIsWhereItShouldBe(system, motion);
                }
            }
        }
        assertArrayEquals(new double[] {2, 0, 0, 0, 0, 0}, Arrays.copyOf(at(GLIDE, 20), 6));
    }

    private static double[] at(AnchorMotion motion, double time) {
        double[] values = new double[9];
        motion.at(time, values);
        return values;
    }

    /**
     * The block on a spring of omega = 3 that is shaken with 4 /s: x = a w/(w&sup2; - W&sup2;) (w sin W t - W sin w t).
     * Measured: within 0.0024 of the order.
     */
    @ParameterizedTest
    @CsvSource({"euler, 1", "symplectic-euler, 1", "backward-euler, 1", "midpoint, 2", "verlet, 2",
            "implicit-midpoint, 2",
        "rk4, 4", "adams, 4", "yoshida4, 4"})
    void solversKeepTheirOrders(String solver, int order) {
        double h = order == 1 ? 0.0005 : order == 2 ? 0.01 : 0.02;
        double slope = Math.log(error(solver, h) / error(solver, h / 4)) / Math.log(4);
        assertEquals(order, slope, 0.01);
    }

    private static double error(String solver, double h) {
        ShortRun run = ShortRun.of(solver + " clamp " + h + " 2", """
                particles: [{id: hand, position: [0, 0, 0], fixed: true}, {id: block, position: [2, 0, 0]}]
                springs: [{from: hand, to: block, stiffness: 9, restLength: 2}]
                effects: []
                rules: [shake: {particle: hand, amplitude: [0.01, 0, 0], period: 1.5707963267948966}]
                """);
        double x = 2 - 0.03 / 7 * (3 * Math.sin(8) - 4 * Math.sin(6));
        double v = -0.36 / 7 * (Math.cos(8) - Math.cos(6));
        return Math.hypot(3 * (run.at(6) - x), run.at(9) - v);
    }

    /** Solvers keep their memory from step to step: nothing is evaluated twice. */
    @ParameterizedTest
    @CsvSource({"verlet, 101", "yoshida4, 301", "adams, 206", "rk4, 400", "dormand-prince, 608"})
    void anchorsCostNoExtraEvaluations(String solver, long evaluations) {
        ParticleSystem system = pulled(CRANK, 0);
        DESolver stepper = SolverCatalog.create(solver);
        Steps.make(100, stepper, system, 0.001);
        assertEquals(evaluations, system.getEvaluations());
    }

    /** Values that a solver sets in an anchor's place have no effect. */
    @Test
    void anchorsAreNotUnknownsOfTheSolver() {
        ParticleSystem system = pulled(CRANK, 0.5);
        system.incTime(0.3);
        double[] state = new double[12];
        double[] dSdt = new double[12];
        system.getState(state);
        system.getStateDerivative(dSdt);
        double[] expected = dSdt.clone();
        Arrays.fill(state, 0, 6, 17.0);
        system.setState(state);
        assertIsWhereItShouldBe(system, CRANK);
        system.getStateDerivative(state, dSdt);
        assertArrayEquals(expected, dSdt);
        assertArrayEquals(new double[6], Arrays.copyOf(dSdt, 6));
        assertArrayEquals(new double[6], Arrays.copyOf(system.getStateArray(), 6));
    }
}
