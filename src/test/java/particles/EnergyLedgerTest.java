package particles;

import static deSolvers.problems.Bounds.assertBelow;
import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import deSolvers.DESolver;
import deSolvers.DEStateSource;
import deSolvers.EulerSolver;
import deSolvers.RK4Solver;
import deSolvers.symplectic.SymplecticEulerSolver;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import particles.effects.AirDrag;
import particles.effects.Wind;
import particles.energy.EnergyLedger;
import particles.law.ParticleForce;
import particles.law.Vector3;
import particles.scene.Scene;
import particles.scene.ShortRun;

/** Tests the ledger's work against closed forms, and its numerical error against the orders of the solvers. */
class EnergyLedgerTest {

    /** x'' = -x in three dimensions: a spring of rest length 0. */
    private static final String OSCILLATOR = """
            particles: [{id: block, position: [1, 0, 0]}, {id: wall, position: [0, 0, 0], fixed: true}]
            springs: [{from: wall, to: block, stiffness: 1, restLength: 0}]
            effects: []
            """;

    /** A law that claims nothing: F = (1, -2, 0) N; it may store energy all the same. */
    private static ParticleForce undeclared(ParticleSystem system, boolean stores) {
        return new ParticleForce(system.getParticles()) {
            @Override
            protected Vector3 getForce(Vector3 position, Vector3 velocity, double mass, double time) {
                return new Vector3(1, -2, 0);
            }

            @Override
            protected double getPotentialEnergy(Vector3 position, double mass, double time) {
                return stores ? 2 * position.y() - position.x() : 0;
            }

            @Override
            public String getName() {
                return "push";
            }
        };
    }

    /** A student's first force says nothing of its energy: its work is F x = 2.5 t^2, and none of it an error. */
    @ParameterizedTest
    @ValueSource(booleans = {false, true})
    void theWorkOfALawThatClaimsNothingIsNoError(boolean stores) {
        for (DESolver solver : List.of(new RK4Solver(), new EulerSolver())) {
            ParticleSystem system = new ParticleSystem();
            system.addParticle("a", 1, Vector3.ZERO, Vector3.ZERO, false);
            system.addParticle("nail", 1, new Vector3(0, 1, 0), Vector3.ZERO, true);
            system.moveAnchor(1, (time, values) -> values[3] = 1);
            system.addEffect(undeclared(system, stores));
            EnergyLedger ledger = Systems.ledger(system, solver, 0.125, 2);
            boolean exact = solver instanceof RK4Solver;
            // Euler's path is shorter by g h t/2
            assertEquals(stores ? 0 : exact ? 10 : 10 - 5 * 0.125 * 2 / 2, ledger.getWork().get("push"), 1e-12);
            assertEquals(exact ? 0 : 5 * 0.125 * 2 / 2, ledger.getNumericalError(), 1e-12, "m g^2 h t/2");
        }
    }

    /**
     * Every smooth effect: damped springs with rest lengths, gravity, both drags in gusts, attraction, cohesion with
     * damping, and an anchor that is shaken.
     */
    private static final String EVERYTHING = """
            particles:
              - {id: hand, position: [0, 0, 0], fixed: true}
              - {id: a, position: [1, 0, 0.2]}
              - {id: b, position: [1.5, -0.8, 0], velocity: [0.3, 0, 1], mass: 0.5}
            springs:
              - {from: hand, to: a, stiffness: 30, restLength: 0.9, damping: 0.3}
              - {from: a, to: b, stiffness: 20, restLength: 1, damping: 0.2}
              - {from: hand, to: b, stiffness: 5, restLength: 1.5, damping: 0.1}
            effects:
              - gravity
              - drag: {coefficient: 0.1}
              - quadraticDrag: {coefficient: 0.05}
              - wind: {mean: [2, 0, 0.5], gust: [1, 0, 1], period: 0.9}
              - attraction: {strength: 1, centre: [0, -2, 1], softening: 0.5}
              - cohesion: {range: 4, balance: 0.5, depth: 0.5, damping: 0.05}
            rules:
              - shake: {particle: hand, amplitude: [0.3, 0, 0], period: 3.141592653589793}
            """;

    /** The exponent with which the unexplained energy falls from step h to h/4. */
    private static double slope(String text, String solver, double h, double duration) {
        double[] errors = new double[2];
        for (int k = 0; k < 2; k++) {
            errors[k] = Math.abs(ShortRun.of(solver + " clamp " + h / (1 + 3 * k) + " " + duration, text)
                    .getNumericalError());
        }
        return Math.log(errors[0] / errors[1]) / Math.log(4);
    }

    /** Bound: within 0.2 of the order. Measured: 1.01, 0.97, 2.11, 2.02, 3.86, 0.99, 2.00, 4.13, 4.00. */
    @ParameterizedTest
    @CsvSource(textBlock = """
            euler,             1, 0.002
            symplectic-euler,  1, 0.002
            midpoint,          2, 0.0002
            verlet,            2, 0.008
            rk4,               4, 0.01
            backward-euler,    1, 0.002
            implicit-midpoint, 2, 0.016
            adams,             4, 0.002
            yoshida4,          4, 0.016
            """)
    void numericalErrorFallsWithTheSolversOrder(String solver, int order, double h) {
        assertEquals(order, slope(EVERYTHING, solver, h, 1.03), 0.2);
    }

    /** Bound: 10 tolerances times the energy scale. Measured 0.023, with the kinetic energy, 6.9 J, as the scale. */
    @ParameterizedTest
    @ValueSource(strings = {"step-doubling", "dormand-prince", "bulirsch-stoer", "radau"})
    void numericalErrorOfAdaptiveSolversIsWithinTheTolerance(String solver) {
        for (double[] run : new double[][] {{1e-3, 0.05}, {1e-4, 0.02}, {1e-6, 0.01}}) {
            ShortRun end = ShortRun.of("{'name':'%1$s','relativeTolerance':%2$s,'absoluteTolerance':%2$s} clamp %3$s 1"
                    .formatted(solver, run[0], run[1]), EVERYTHING);
            double scale = end.getSystem().getKineticEnergy(end.getState());
            assertEquals(0, end.getNumericalError(), 0.2 * run[0] * scale);
        }
    }

    /**
     * A step of 10 s, in which springs swing about ten times, is far too long for Simpson's rule; its sub-steps are
     * not. Those of bulirsch-stoer are long too, up to a quarter of the gusts' period, and then the ledger says so.
     * Measured error, as a part of the uncertainty: 0.0011, 0.0052, 0.048 and 0.0054.
     */
    @ParameterizedTest
    @CsvSource(textBlock = """
            step-doubling,  0.00229
            dormand-prince, 0.00175
            bulirsch-stoer, 1.76
            radau,          4.99e-5
            """)
    void aLongStepOfAnAdaptiveSolverIsBookedInItsSubSteps(String solver, double uncertainty) {
        EnergyLedger ledger = ShortRun.of(solver + " clamp 10 10", EVERYTHING).getLedger();
        assertEquals(uncertainty, ledger.getUncertainty(), 0.05 * uncertainty);
        assertEquals(0, ledger.getNumericalError(), 0.1 * uncertainty);
        assertEquals(-15.4, ledger.getWork().get("drag (dissipated)"), 0.1 * uncertainty + 0.01);
        double none = ShortRun.of("rk4 clamp 0.1 10", EVERYTHING).getLedger().getUncertainty();
        assertEquals(0, none, "rk4 has no sub-steps");
    }

    /**
     * E0 (1 + (omega h)&sup2;)^-n for backward Euler, E0 (1 + (omega h)&sup2;)^n for Euler: without other effects all
     * change is error.
     */
    @Test
    void energyDriftWithoutOtherEffectsIsAllNumericalError() {
        double factor = Math.pow(1 + 0.01 * 0.01, -1000);
        EnergyLedger backward = ShortRun.of("backward-euler clamp 0.01 10", OSCILLATOR).getLedger();
        assertEquals(0.5 * factor, backward.getEnergy(), 0.5 * factor * 1e-9);
        assertEquals(backward.getEnergy() - backward.getStartEnergy(), backward.getNumericalError());
        assertTrue(backward.getWork().values().stream().allMatch(work -> work == 0), backward.getWork().toString());
        EnergyLedger forward = ShortRun.of("euler clamp 0.01 10", OSCILLATOR).getLedger();
        assertEquals(0.5 / factor, forward.getEnergy(), 1e-9);
        assertEquals(forward.getEnergy() - 0.5, forward.getNumericalError());
    }

    /**
     * Nothing is counted twice: bounces, with restitution e = 0.5 and friction mu = 0.1, take mu (1 + e) v e^k from the
     * speed along the ground, together mu v (1 + e)/(1 - e) for the speed v of the fall; sliding takes what is left.
     */
    @Test
    void bouncesAndRestAreBookedOnce() {
        ShortRun run = ShortRun.of("rk4 exact 0.01 4", """
                particles: [{id: p, position: [0, 1, 0], velocity: [3, 0, 0]}]
                rules:
                  - ground: {restSpeed: 1e-6, friction: {law: coulomb, coefficient: 0.1, static: 0.2, threshold: 0}}
                """);
        double left = 3 - 0.1 * Math.sqrt(2 * 9.81) * 3;
        assertEquals(-9.81 - (9 - left * left) / 2, run.work("impacts"), 1e-5);
        assertEquals(-left * left / 2, run.work("contact"), 1e-5, "friction stops the motion along the ground");
        assertEquals(0, run.getLedger().getEnergy(), 1e-12);
        assertEquals(0, run.getNumericalError(), 1e-9);
    }

    @Test
    void theLedgerDoesNotChangeTheTrajectory() {
        ParticleSystem booked = ShortRun.of("symplectic-euler clamp 0.01 1", EVERYTHING).getSystem();
        Scene alone = new ShortRun("symplectic-euler clamp 0.01 1", EVERYTHING).getScene();
        Systems.run(alone.system(), new SymplecticEulerSolver(), 0.01, 1, alone.simulation().getRules()
                .toArray(Rule[]::new));
        assertArrayEquals(alone.system().getOwnState(), booked.getOwnState());
        assertEquals(alone.system().getEvaluations(), booked.getEvaluations());
    }

    /**
     * A particle in drag with c/m = 1000 1/s, in steps of 0.1 s: v falls to 1/101 in each step of backward Euler, and
     * Simpson's rule over such a step would find 41 times the energy that there is. Drag takes h c v_1^2; the rest of
     * the loss, m (v_1 - v_0)^2/2 in each step, is the solver's.
     */
    @Test
    void dragThatAStepJumpsOverTakesNoMoreThanThereIs() {
        EnergyLedger ledger = ShortRun.of("backward-euler clamp 0.1 0.3", """
                particles: [{id: p, position: [0, 0, 0], velocity: [1, 0, 0]}]
                effects: [drag: {coefficient: 1000}]
                """).getLedger();
        assertEquals(-0.5 * (1 - 1 / 101.0) * (1 - 1 / 101.0) / (1 - 1 / (101.0 * 101.0)), ledger.getNumericalError(),
                0.005);                                 // a hundredth of the energy may be booked in another way
        assertEquals(-100 / (101.0 * 101.0), ledger.getWork().get("drag (dissipated)"), 0.005);
    }

    /** A drag that decays the velocity by e^-2 in a step is still integrated by Simpson's rule, e^-2.1 no longer. */
    @ParameterizedTest
    @ValueSource(doubles = {2, 2.1})
    void simpsonsRuleHoldsForDragUpToTwiceItsTime(double h) {
        ParticleSystem system = Systems.oneParticle(Vector3.ZERO, new Vector3(1, 0, 0));
        double m = system.getParticles().mass(0);
        system.addEffect(AirDrag.linear(system.getParticles(), m, Wind.STILL));
        EnergyLedger ledger = Systems.ledger(system, new DESolver() {
            @Override
            public void stepState(DEStateSource source, double deltaT) {        // in one step, and exactly
                double[] decayed = new double[6];
                decayed[0] = 1 - Math.exp(-deltaT);
                decayed[3] = Math.exp(-deltaT);
                source.setState(decayed);
                source.incTime(deltaT);
            }
        }, h, h);
        double end = Math.exp(-h);
        double mean = (1 - end) / h;
        double middle = 1.5 * mean - (1 + end) / 4;     // the cubic's velocity there
        double work = h < 2.05 ? (1 + 4 * middle * middle + end * end) / 6 : mean * mean;
        assertEquals(-m * h * work, ledger.getWork().get("drag (dissipated)"), 1e-8);
    }

    /**
     * A spring with omega h = 31.6 and damping that decays 100 times in a step, by the implicit midpoint rule: the
     * velocity changes its sign in every step, and the power is that at the mean velocity. For a linear spring that is
     * the method's own balance, so that nothing is left over.
     */
    @Test
    void dampingThatAStepJumpsOverIsWhatTheMidpointRuleTakes() {
        EnergyLedger ledger = ShortRun.of("implicit-midpoint clamp 1 5", """
                particles:
                  - {id: wall, position: [0, 0, 0], fixed: true}
                  - {id: block, position: [1, 0, 0], velocity: [1, 0, 0]}
                springs: [{from: wall, to: block, stiffness: 1000, restLength: 1, damping: 100}]
                effects: []
                """).getLedger();
        assertBelow(0.9 * 0.5, ledger.getEnergy(), "the damping did work");
        assertEquals(0, ledger.getNumericalError(), 1e-9);
    }
}
