package particles.energy;

import static deSolvers.problems.Bounds.assertAbove;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static particles.Systems.springs;
import static particles.Texts.assertMatches;

import deSolvers.DESolver;
import deSolvers.EulerSolver;
import deSolvers.StepTransaction;
import deSolvers.adaptive.AdaptiveSolver;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import particles.ParticleSystem;
import particles.Simulation;
import particles.SimulationException;
import particles.Systems;
import particles.effects.springs.SpringForce;
import particles.law.ParticleForce;
import particles.law.Vector3;
import particles.scene.Scene;
import particles.scene.ShortRun;
import particles.scene.TestScenes;

/** Which numerical errors fail a run: gains without a cause, and no others. */
class NumericalErrorLimitTest {

    private static void run(Simulation simulation, double energyScale) {
        run(simulation, energyScale, 1);
    }

    private static void run(Simulation simulation, double energyScale, long stride) {
        EnergyHistory energy = new EnergyHistory(stride);
        EnergyLedgerRecorder books = new EnergyLedgerRecorder(stride);
        simulation.addObserver(energy);
        simulation.addObserver(books);
        simulation.addObserver(new NumericalErrorLimit(energy, books, energyScale));
        simulation.run();
    }

    /** x'' = -x from (1, 0), with drag c. */
    private static void swing(String steps, double drag) {
        run(new ShortRun(steps, """
                particles: [{id: wall, position: [0, 0, 0], fixed: true}, {id: block, position: [1, 0, 0]}]
                springs: [{from: wall, to: block, stiffness: 1, restLength: 0}]
                effects: [drag: {coefficient: %s}]
                """.formatted(drag)).getSimulation(), 0.5);
    }

    private static SimulationException failure(String steps, double drag) {
        return assertThrows(SimulationException.class, () -> swing(steps, drag));
    }

    private static Simulation of(ParticleSystem system, DESolver solver, double deltaT, double duration) {
        return new Simulation(system, () -> solver, deltaT, duration);
    }

    /**
     * Euler multiplies the energy by 1 + h^2 = 2 in each step: (2^n - 1)/2 J are error. To be expected is 1 J, the
     * force of 1 N times the length of 1 m.
     */
    @Test
    void aGainOfAThousandEndsTheRunAtOnce() {
        assertEquals(SimulationException.End.WRONG_MOTION, failure("euler clamp 1 10", 0).getEnd());    // 511.5 J
        SimulationException e = failure("euler clamp 1 100", 0);
        assertEquals(SimulationException.End.NUMERICAL_ERROR, e.getEnd());
        assertEquals(11, e.getTime());
        assertEquals(1, e.getParticle());
        assertEquals("the numerical error is 1020 J, over 1000 times the rest of the energy",
                e.getMessage());
    }

    /** 7.5 J after 4 s, 15.5 J after 5 s, beside the 1 J that is to be expected. */
    @Test
    void tenTimesTheRestOfTheEnergyFailsTheRunAtItsEnd() {
        swing("euler clamp 1 4", 0);
        SimulationException e = failure("euler clamp 1 5", 0);
        assertEquals("the numerical error of 15.5 J is over 10 times the rest of the energy, 1 J", e.getMessage());
        assertEquals(5, e.getTime());
    }

    /** Both gain the same factor; the heavy block has nearly all of the energy, the light one is twice as fast. */
    @Test
    void theParticleWithTheMostEnergyIsNamed() {
        ShortRun run = new ShortRun("euler clamp 1 100", """
                particles: [{id: wall, position: [0, 0, 0], fixed: true},
                            {id: heavy, position: [1, 0, 0], mass: 100}, {id: light, position: [2, 0, 0], mass: 0.01}]
                springs: [{from: wall, to: heavy, stiffness: 100, restLength: 0},
                          {from: wall, to: light, stiffness: 0.01, restLength: 0}]
                """);
        assertEquals(1, assertThrows(SimulationException.class, () -> run(run.getSimulation(), 50))
                .getParticle());
    }

    /**
     * With drag of c/m = h = 0.1, Euler keeps the amplitude: |1 + h lambda|^2 = 1 - h c + h^2 = 1. What drag takes, on
     * the average c v^2 = 0.05 W, Euler gives, so that the error passes the energy of 0.5 J after about 10 s.
     */
    @Test
    void anErrorAboveTheEnergyFailsTheRunAtItsEnd() {
        SimulationException e = failure("euler clamp 0.1 30", 0.1);
        assertEquals(10, e.getTime(), 1);               // the work swings about its average
        assertEquals(SimulationException.End.WRONG_MOTION, e.getEnd());
        assertMatches(e.getMessage(), "the numerical error of 1\\.\\d+ J is larger than the energy scale, 0\\.5\\d* J");
        swing("euler clamp 0.1 8", 0.1);
        swing("rk4 clamp 0.1 30", 0.1);
    }

    /** A student's energy of sqrt(1 - x) is not a number beyond x = 1, where the particle is after five steps. */
    @ParameterizedTest
    @CsvSource({"1, 1.25", "100, 2"})
    void anEnergyThatIsNotANumberFailsTheRun(long stride, double end) {
        ParticleSystem system = Systems.oneParticle(Vector3.ZERO, new Vector3(1, 0, 0));
        system.addEffect(new ParticleForce(system.getParticles()) {
            @Override
            public String getName() {
                return "own";
            }

            @Override
            protected Vector3 getForce(Vector3 position, Vector3 velocity, double mass, double time) {
                return Vector3.ZERO;
            }

            @Override
            protected double getPotentialEnergy(Vector3 position, double mass, double time) {
                return Math.sqrt(1 - position.x());
            }
        });
        SimulationException e = assertThrows(SimulationException.class,
                () -> run(of(system, new EulerSolver(), 0.25, 2), 0.5, stride));
        assertEquals(end, e.getTime());
        assertEquals("the numerical error of its energy is not a number", e.getMessage());
    }

    /**
     * A hand shakes a block on a stiff spring, which swings twice in each step of 0.5 s. The tolerance keeps its energy
     * to a thousandth of 14.7 J; Simpson's rule over whole steps leaves 125 J.
     */
    @ParameterizedTest
    @ValueSource(strings = {"step-doubling", "dormand-prince", "bulirsch-stoer", "radau"})
    void manySwingsInAStepOfAnAdaptiveSolverAreNoError(String solver) {
        Scene scene = TestScenes.build(TestScenes.shaken(solver, 0.3));
        run(scene.simulation(), scene.energyEstimate());
    }

    /**
     * Euler that calls itself accurate, in sub-steps of 0.5 s: each multiplies the energy by 1 + h^2 - c h = 1.2, so
     * that 0.5 J become 735 J after 20 s and 28 kJ after 30 s.
     */
    @Test
    void anAdaptiveSolverThatIsWrongFailsInALongStepToo() {
        ParticleSystem oscillator = new ShortRun("rk4 clamp 1 1", """
                particles: [{id: wall, position: [0, 0, 0], fixed: true}, {id: block, position: [1, 0, 0]}]
                springs: [{from: wall, to: block, stiffness: 1, restLength: 0}]
                effects: [drag: {coefficient: 0.1}]
                """).getSystem();
        DESolver wrong = new AdaptiveSolver(0, 1) {
            @Override
            protected void resize(int n) {
            }

            @Override
            protected double attempt(StepTransaction source, double[] state, double[] slope, double offset, double h,
                    double[] newState) {
                for (int i = 0; i < state.length; i++) {
                    newState[i] = state[i] + h * slope[i];
                }
                return 0;
            }

            @Override
            protected double nextSubStep(double h, double error) {
                return 0.5;
            }

            @Override
            protected int errorExponent() {
                return 2;
            }
        };
        assertEquals(30, assertThrows(SimulationException.class,
                () -> run(of(oscillator, wrong, 10, 200), 0.5)).getTime());
    }

    /** Backward Euler loses (1 + h^2) a step, all energy in the end: it damps, and invents nothing. */
    @Test
    void lossesNeverFail() {
        swing("backward-euler clamp 0.5 100", 0);
    }

    /**
     * Without force nothing has an energy; with springs at their rest lengths it is rounding, which Euler multiplies by
     * some millions in 150 steps.
     */
    @ParameterizedTest
    @ValueSource(doubles = {0, 1})
    void nothingAtRestFails(double stiffness) {
        ParticleSystem system = new ParticleSystem();
        Vector3[] corners = {new Vector3(0.1, 0.2, 0.3), new Vector3(1.3, 0.7, -0.4), new Vector3(0.6, 1.9, 0.8)};
        SpringForce springs = springs(system);
        for (int i = 0; i < corners.length; i++) {
            system.addParticle("p" + i, 1, corners[i], Vector3.ZERO, false);
        }
        for (int i = 0; i < corners.length; i++) {
            Vector3 edge = corners[(i + 1) % 3].minus(corners[i]);
            springs.addSpring(i, (i + 1) % 3, stiffness, Math.nextUp(edge.length()), 0);
        }
        run(of(system, new EulerSolver(), 0.2, 30), 1);
        assertTrue(system.getKineticEnergy(system.getOwnState()) < 1e-20);
    }

    /**
     * Euler gives every drop (g h)^2/2 in each of 20 steps, 2.4 J to the 12.5 J of its birth: after a minute the sum
     * over 600 drops is more than 10 ever have at once. That is no blow-up, as births put in much more.
     */
    @Test
    void anErrorThatIsASmallPartOfWhatIsPutInDoesNotFail() {
        Scene scene = new ShortRun("euler clamp 0.05 60", """
                particles: [{id: nozzle, position: [0, 0, 0], fixed: true}]
                rules: [emitter: {id: jet, position: [0, 0, 0], speed: 5, rate: 10, lifetime: 1}]
                """).getScene();
        EnergyLedgerRecorder books = new EnergyLedgerRecorder(1);
        EnergyHistory energy = new EnergyHistory();
        scene.simulation().addObserver(energy);
        scene.simulation().addObserver(books);
        run(scene.simulation(), scene.energyEstimate());
        assertAbove(1.5 * energy.getScale(), books.getNumericalError());
    }

    /**
     * A level net at rest has no energy, and a height of round-off. After Euler's first step it has m (g h)^2/2, all of
     * which is error, as it is still where it was.
     */
    @Test
    void aLevelNetMayBeginToFallByEuler() {
        ShortRun run = new ShortRun("euler clamp 0.01 1", """
                particles: [{id: a, position: [0, 0.3, 0]}, {id: b, position: [1, %s, 0]}]
                effects: [gravity: {acceleration: [0, -10, 0]}]
                """.formatted(Math.nextUp(0.3)));
        run(run.getSimulation(), 100);
        assertEquals(-10, run.at(4), 1e-12);
    }
}
