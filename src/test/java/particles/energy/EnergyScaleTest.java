package particles.energy;

import static deSolvers.problems.Bounds.assertAbove;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import particles.scene.Scene;
import particles.scene.TestScenes;

/** The energy scale of particles that attract each other, whose stored energy is negative, with every solver. */
class EnergyScaleTest {
    private static final String PAIR = """
            particles:
              - {id: a, position: [0, 0, 0], velocity: [%s, %s, 0]}
              - {id: b, position: [%s, 0, 0], velocity: [-%1$s, -%2$s, 0]}
            effects:
              - cohesion: {range: 1, balance: 0.6, depth: 0.01}
            """;
    private final EnergyHistory energy = new EnergyHistory();
    private final EnergyLedgerRecorder ledger = new EnergyLedgerRecorder(1);

    private Scene run(String solver, double deltaT, double duration, String parts) {
        Scene scene = TestScenes.build("""
                title: Bonds
                teaches: Stored energy can be negative.
                solver: %s
                deltaT: %s
                duration: %s
                """.formatted(solver, deltaT, duration) + parts);
        scene.simulation().addObserver(energy);
        scene.simulation().addObserver(ledger);
        scene.simulation().addObserver(new NumericalErrorLimit(energy, ledger, scene.energyEstimate()));
        scene.simulation().run();
        return scene;
    }

    /**
     * Two particles of 1 kg swing about the distance of balance, at which their speed is 0.01 m/s: all energy that
     * moves is 1e-4 J, a hundredth of the bond's. Euler makes it 1.44 times as large, implicit Euler methods 0.73.
     */
    @ParameterizedTest
    @MethodSource("deSolvers.catalog.SolverCatalog#names")
    void aBoundPairsScaleIsItsKineticEnergy(String solver) {
        run(solver, 0.005, 10, PAIR.formatted("0.01", "0", "0.6"));
        boolean firstOrder = solver.endsWith("euler") && !solver.equals("symplectic-euler");
        assertEquals(1e-4, energy.getScale(), firstOrder ? 0.5e-4 : 1e-6);
    }

    /**
     * A spring whose length is right to round-off stores 1e-33 J, and an adaptive solver's tolerance moves it by 1e-9
     * m/s: the scale is the energy of crossing the scene, m (L/T)^2/2 for each.
     */
    @ParameterizedTest
    @MethodSource("deSolvers.catalog.SolverCatalog#names")
    void aSpringAtRestToRoundOffIsAtRest(String solver) {
        Scene scene = run(solver, 0.4, 2, """
                particles:
                  - {id: a, position: [0, 0, 0]}
                  - {id: b, position: [0, 0.01, 0.11]}
                springs: [{from: a, to: b, stiffness: 4.07, restLength: 0.11045361017187262, damping: 0.0126}]
                """);
        double crossing = 0.11 * 0.11 / 4;
        assertEquals(crossing, scene.energyEstimate(), 1e-15);
        assertEquals(crossing, energy.getScaleOr(scene.energyEstimate()), 1e-15);
        assertTrue(Math.abs(ledger.getLatestNumericalError()) < 1e-16);                  // measured 3e-22
    }

    /** At the distance of balance nothing moves: the scale is the energy that holds the two together. */
    @ParameterizedTest
    @MethodSource("deSolvers.catalog.SolverCatalog#names")
    void aPairAtRestIsMeasuredByItsBond(String solver) {
        run(solver, 0.01, 1, PAIR.formatted("0", "0", "0.6"));
        assertEquals(0.01, energy.getScale(), 1e-12);
        assertTrue(Math.abs(ledger.getLatestNumericalError()) < 1e-14);
    }

    /** Two particles circle each other at a distance at which they attract: the kinetic energy is all that moves. */
    @ParameterizedTest
    @MethodSource("deSolvers.catalog.SolverCatalog#names")
    void anOrbitsScaleIsItsKineticEnergy(String solver) {
        run(solver, 0.002, 2, PAIR.formatted("0", "0.08", "0.7"));
        double most = Arrays.stream(energy.chart().series().get(1).y()).max().orElseThrow();     // kinetic
        assertTrue(energy.getScale() >= most * (1 - 1e-12) && energy.getScale() < 1.3 * most,
                energy.getScale() + " J for " + most + " J");
    }

    /** A drop of 27 particles that swings, and the same as a compressed gas that flies apart: no run fails. */
    @ParameterizedTest
    @MethodSource("deSolvers.catalog.SolverCatalog#names")
    void aDropAndAGasRunToTheirEnd(String solver) {
        for (double size : new double[] {1.3, 0.5}) {
            EnergyScaleTest one = new EnergyScaleTest();
            one.run(solver, 0.004, 1, """
                    shapes:
                      - jelly: {id: drop, centre: [0, 0, 0], size: [%s, %1$s, %1$s], columns: 3, rows: 3, layers: 3,
                          totalMass: 2.7, surface: false}
                    effects:
                      - cohesion: {range: 1, balance: 0.6, depth: 0.01}
                    """.formatted(size));
            assertAbove(0.005, one.energy.getScale(), size);
            assertTrue(Math.abs(one.ledger.getLatestNumericalError()) < 0.2 * one.energy.getScale(),
                    size + ": " + one.ledger.getLatestNumericalError() + " of " + one.energy.getScale());
        }
    }
}
