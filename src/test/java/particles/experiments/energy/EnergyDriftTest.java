package particles.experiments.energy;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static particles.Texts.assertHas;

import java.util.List;
import java.util.Map;
import java.util.NoSuchElementException;
import org.junit.jupiter.api.Test;
import particles.experiments.energy.EnergyDrift.Comparison;
import particles.experiments.energy.EnergyDrift.Drift;
import particles.experiments.runs.SolverChoice;
import particles.scene.SceneBuilder;
import particles.scene.TestScenes;
import particles.scene.format.SceneDescription;

/** On the oscillator x'' = -x, whose energy each method multiplies by |R(ih)| squared in each step. */
class EnergyDriftTest {
    private static final SceneDescription SPIRAL = TestScenes.named("11-euler-spiral");

    private static SceneDescription spring(double deltaT, double duration) {
        return SPIRAL.withSolver("euler").withDeltaT(deltaT).withDuration(duration);
    }

    private static Comparison compare(SceneDescription scene, String solvers) {
        return EnergyDrift.compare(scene, SolverChoice.list(solvers), (part, what) -> { });
    }

    @Test
    void endDriftIsThatOfTheStabilityFunction() {
        Comparison comparison = compare(spring(0.125, 25), "euler, midpoint, rk4, backward-euler");
        assertEquals(0.5, comparison.scale(), 1e-6);                // the energy at the start, by a run to 1e-9
        double square = 0.125 * 0.125;
        double cosine = 1 - square / 2 + square * square / 24;
        double sine = 0.125 * (1 - square / 6);
        Map<String, Double> factors = Map.of("euler", 1 + square, "midpoint", 1 + square * square / 4,
                "rk4", cosine * cosine + sine * sine, "backward-euler", 1 / (1 + square));
        for (Drift drift : comparison.drifts()) {
            String solver = drift.setting().solver().name();
            double energy = Math.pow(factors.get(solver), 200);
            assertEquals(energy - 1, drift.end(), 1e-7 * energy, solver);
            assertEquals(drift.end(), drift.extreme(), "it only grows");
        }
    }

    /** Midpoint gains h^4/4 of the energy in a step: h^3/4 a second, and the exponential makes it a little more. */
    @Test
    void slopeOfASmallDriftIsTheGainASecond() {
        Drift drift = compare(spring(0.05, 25), "midpoint").drifts().get(0);
        assertEquals(1, drift.slope() / (0.05 * 0.05 * 0.05 / 4), 0.001);       // measured 1.0008
    }

    @Test
    void symplecticErrorsAreBoundedByTheStep() {
        for (Drift drift : compare(spring(0.125, 100), "symplectic-euler, verlet, yoshida4").drifts()) {
            double rise = 100 * Math.abs(drift.slope() / drift.extreme());      // measured 0.01 or less
            assertTrue(rise < 0.05, drift.setting().solver().name() + ": " + rise);
        }
        // of symplectic Euler E + h x v / 2 is constant: the error is at most h/4 of the scale 1/2
        assertEquals(0.125 / 2, Math.abs(compare(spring(0.125, 100), "symplectic-euler").drifts().get(0).extreme()),
                0.005);
    }

    /** {@code gradle run -Pscene=16 -Psolver=euler} stops at t = 1.04 s for the same reason. */
    @Test
    void aBlowUpEndsWhenARunEndsIt() {
        SceneDescription chain = TestScenes.named("16-soft-chain");
        Drift drift = compare(chain, "euler").drifts().get(0);
        assertFalse(drift.outcome().whole());
        assertEquals(26, drift.outcome().steps());
        assertEquals(drift.outcome().endTime(), drift.time()[drift.time().length - 1]);
        assertTrue(drift.extreme() > 1000 && drift.extreme() < 3000, drift.toString());
        assertTrue(drift.outcome().failure().orElseThrow().startsWith("the numerical error is "), drift.toString());
        assertEquals(1.04, drift.outcome().endTime(), 1e-12);
    }

    /** Euler's steps are stable, but add more energy than the spring ever has. */
    @Test
    void aRunThatComesToItsEndDoesNotStop() {
        Drift drift = compare(TestScenes.named("03").withDeltaT(0.0125), "euler").drifts().get(0);
        assertTrue(drift.outcome().whole() && drift.outcome().failure().isPresent());
    }

    /**
     * Bounces that take nine tenths of the energy are physics, and free fall is exact for methods of order 2.
     * Symplectic Euler
     * loses m g^2 h^2 / 2 in each step of a fall, whatever the floor does: m g^2 h / 2 a second.
     */
    @Test
    void bouncesArePhysicsAndNoDrift() {
        SceneDescription ball = TestScenes.named("06-bouncing-ball");
        Comparison comparison = compare(ball.withSolver("rk4").withDeltaT(0.002).withDuration(1.5),
                "rk4, verlet, symplectic-euler");
        for (Drift drift : comparison.drifts().subList(0, 2)) {
            assertTrue(Math.abs(drift.extreme()) < 2e-13, "measured 2.2e-14, now " + drift.extreme());
        }
        Drift euler = comparison.drifts().get(2);
        double mass = SceneBuilder.build(ball).system().getParticles().mass(0);
        // measured 1.000
        assertEquals(1, euler.slope() / (-mass * 9.81 * 9.81 * 0.002 / 2 / comparison.scale()), 0.02);
    }

    /** Drops that come with energy and take it away again: the books change with each, and rk4 does not. */
    @Test
    void birthsAndDeathsArePhysicsAndNoDrift() {
        SceneDescription fountain = TestScenes.named("27-fountain");
        Comparison comparison = compare(fountain.withSolver("rk4").withDeltaT(0.01).withDuration(2),
                "rk4, backward-euler");
        assertTrue(Math.abs(comparison.drifts().get(0).extreme()) < 2e-10, "measured 2.2e-11, now "
                + comparison.drifts().get(0).extreme());
        // backward Euler takes m g^2 h^2 / 2 from a falling drop in a step of h; 150 births a second divide every two
        // steps of 0.01 s into 1/150, 1/300, 1/300 and 1/150 s; after t there are 150 t drops. Measured -0.7956 J
        double perSecond = 0.01 * 9.81 * 9.81 / 2 * 2 * (1 / 22_500.0 + 1 / 90_000.0) / 0.02;
        assertEquals(-perSecond * 150 * 2 * 2 / 2, comparison.drifts().get(1).end() * comparison.scale(), 0.01);
    }

    @Test
    void listsOfSolversAreChecked() {
        assertEquals(List.of("rk4", "euler"),
                SolverChoice.list(" rk4, euler,").stream().map(SolverChoice::label).toList());
        assertEquals(14, SolverChoice.list("all").size());
        String message = assertThrows(NoSuchElementException.class, () -> SolverChoice.list("rk4,eular")).getMessage();
        assertHas(message, "did you mean 'euler'");
        assertThrows(IllegalArgumentException.class, () -> SolverChoice.list(" ,"));
        assertEquals("'rk4' appears twice", assertThrows(IllegalArgumentException.class,
                () -> SolverChoice.list("rk4,euler, rk4")).getMessage());
    }
}
