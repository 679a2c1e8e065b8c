package particles.experiments.phase;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static particles.Systems.rk4;

import java.util.Arrays;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import particles.ParticleSystem;
import particles.Simulation;
import particles.effects.Gravity;
import particles.effects.springs.SpringForce;
import particles.law.Vector3;
import particles.scene.Scene;
import particles.scene.SceneBuilder;
import particles.scene.TestScenes;
import particles.view.Chart;
import particles.view.Look;
import particles.view.Series;
import particles.view.Series.Mark;
import particles.view.VectorField;

/** Paths in state space and the field that they follow. */
class PhaseHistoryTest {

    /** x'' = -4 (x - 3) along z, started at rest one metre away from there: an ellipse with half axes 1 m and 2 m/s. */
    private static Simulation oscillator(double deltaT, double duration) {
        ParticleSystem system = new ParticleSystem();
        system.addParticle("anchor", 1, Vector3.ZERO, Vector3.ZERO, true);
        system.addParticle("bob", 0.5, new Vector3(0, 0, 4), Vector3.ZERO, false);
        SpringForce springs = new SpringForce(system.getParticles());
        springs.addSpring(0, 1, 2, 3, 0);
        system.addEffect(springs);
        return rk4(system, deltaT, duration);
    }

    private static PhaseHistory observe(Simulation simulation) {
        PhaseHistory phase = new PhaseHistory("bob", Optional.empty(), simulation.getDuration()
                / simulation.getDeltaT());
        simulation.addObserver(phase);
        simulation.run();
        return phase;
    }

    @Test
    void theOscillatorsPathIsAnEllipse() {
        PhaseHistory phase = observe(oscillator(0.02, 4));
        assertEquals(Coordinate.Z, phase.widestAxis());
        Chart chart = phase.chart(Coordinate.Z, Look.OWN, "path");
        Series path = chart.series().get(0);
        assertEquals(201, path.x().length);
        assertEquals(Mark.LINE, path.mark());
        for (int k = 0; k < path.x().length; k++) {
            double x = path.x()[k] - 3;
            double v = path.y()[k] / 2;
            assertEquals(1, x * x + v * v, 5e-8);       // measured 1.1e-8: RK4 loses (h omega)^6 / 72 a step, times 200
        }
        assertEquals("position z of 'bob' (m)", chart.x().label());
        assertArrayEquals(new double[] {4}, chart.series().get(1).x());
        assertArrayEquals(new double[] {0}, chart.series().get(1).y());
        assertEquals(path.x()[path.x().length - 1], chart.series().get(2).x()[0], "the end is marked");
    }

    /** A spring without length holds a bob on a circle: theta = 2 t. RK4's phase error is 20 (h omega)^4 / 120. */
    @Test
    void anAngleGrowsBeyondAWholeTurn() {
        ParticleSystem system = new ParticleSystem();
        system.addParticle("bob", 1, new Vector3(3, 0, 0), new Vector3(2, 0, 0), false);
        system.addParticle("hub", 1, new Vector3(3, 1, 0), Vector3.ZERO, true);
        SpringForce springs = new SpringForce(system.getParticles());
        springs.addSpring(0, 1, 4, 0, 0);
        system.addEffect(springs);
        Simulation simulation = rk4(system, 1.0 / 64, 10);
        PhaseHistory phase = new PhaseHistory("bob", Optional.of("hub"), 640);
        simulation.addObserver(phase);
        simulation.run();
        Chart chart = phase.chart(Coordinate.ANGLE, Look.OWN, "path");
        Series path = chart.series().get(0);
        assertEquals("angle theta of 'bob' about 'hub' (rad)", chart.x().label());
        assertEquals("angular velocity omega of 'bob' about 'hub' (rad/s)", chart.y().label());
        assertEquals(641, path.x().length);
        for (int k = 0; k < path.x().length; k++) {
            assertEquals(2.0 * k / 64, path.x()[k], 1e-6);
            assertEquals(2, path.y()[k], 1e-6);
        }
    }

    @Test
    void fewStatesAreMarkedAndManyAreThinnedToPoints() {
        assertEquals(Mark.LINE_AND_POINTS, observe(oscillator(0.25, 4)).chart(Coordinate.Z, Look.OWN, "path").series()
                .get(0).mark());
        Series thinned = observe(oscillator(1.0 / 64, 1000)).chart(Coordinate.Z, Look.OWN, "path").series().get(0);
        assertEquals(Mark.POINTS, thinned.mark());
        assertEquals(32_001, thinned.x().length);      // every second of 64,001 states
        Series all = observe(oscillator(1.0 / 64, 2)).chart(Coordinate.Z, Look.OWN, "path").series().get(0);
        assertEquals(all.x()[100], thinned.x()[50]);
        // every third of 80,000 steps, which are no multiple of 3, with the first state and the last
        Series uneven = observe(oscillator(1.0 / 64, 80_000 / 64.0)).chart(Coordinate.Z, Look.OWN, "path").series()
                .get(0);
        Series whole = observe(oscillator(1.0 / 64, 20_000 / 64.0)).chart(Coordinate.Z, Look.OWN, "path").series()
                .get(0);
        assertEquals(26_668, uneven.x().length);
        assertEquals(whole.x()[19_998], uneven.x()[6_666]);
    }

    /** A ball lands at t = 0.45 s and at 1.35 s; between the cuts its velocity changes by g deltaT per step. */
    @ParameterizedTest
    @ValueSource(strings = {"clamp", "exact"})
    void aPathIsCutWhereTheBallBounces(String impact) {
        Scene scene = SceneBuilder.build(TestScenes.read(("""
                title: a ball
                teaches: bounces
                solver: rk4
                deltaT: 0.01
                duration: 2
                impact: IMPACT
                particles: [{id: bob, position: [0, 1, 0]}]
                effects: [gravity: {}]
                rules: [ground: {restitution: 1}]
                """).replace("IMPACT", impact)));
        Series path = observe(scene.simulation()).chart(Coordinate.Y, Look.OWN, "path").series().get(0);
        assertEquals(2, Arrays.stream(path.x()).filter(Double::isNaN).count());
        for (int k = 1; k < path.y().length; k++) {
            assertFalse(Math.abs(path.y()[k] - path.y()[k - 1]) > 9.81 * 0.01 + 1e-12, "false where it is cut");
        }
    }

    @Test
    void theFieldIsVelocityAndAcceleration() {
        Simulation simulation = oscillator(0.02, 4);
        Series path = observe(simulation).chart(Coordinate.Z, Look.OWN, "path").series().get(0);
        long evaluations = simulation.getSystem().getEvaluations();
        VectorField field = VectorFields.around(simulation.getSystem(), Coordinate.Z, path.x(), path.y()).orElseThrow();
        for (int k = 0; k < field.dv().length; k++) {
            assertEquals(-4 * (field.x(k) - 3), field.dv()[k], 1e-13);
        }
        assertTrue(Arrays.stream(field.positions()).max().orElse(0) > 4.1);
        assertEquals(evaluations, simulation.getSystem().getEvaluations());
    }

    /**
     * Along x, the spring that lies along z pulls across: no single degree of freedom; nor do two particles have one.
     */
    @Test
    void moreDegreesOfFreedomHaveNoField() {
        Simulation simulation = oscillator(0.02, 4);
        double[] range = {-1, 1};
        assertEquals(Optional.empty(), VectorFields.around(simulation.getSystem(), Coordinate.X, range, range));
        assertTrue(VectorFields.around(simulation.getSystem(), Coordinate.Z, range, range).isPresent());
        simulation.getSystem().addEffect(new Gravity(simulation.getSystem().getParticles(), new Vector3(0, -1, 0)));
        assertEquals(Optional.empty(), VectorFields.around(simulation.getSystem(), Coordinate.Z, range, range));
        Simulation two = oscillator(0.02, 4);
        two.getSystem().addParticle("other", 1, new Vector3(1, 0, 0), Vector3.ZERO, false);
        assertEquals(Optional.empty(), VectorFields.around(two.getSystem(), Coordinate.Z, range, range));
    }

    @Test
    void aParticleThatIsNotThereHasNoPath() {
        PhaseHistory phase = new PhaseHistory("bop", Optional.empty(), 4);
        Simulation simulation = oscillator(0.25, 1);
        simulation.addObserver(phase);
        simulation.run();
        assertThrows(IllegalStateException.class, () -> phase.chart(Coordinate.X, Look.OWN, "path"));
    }
}
