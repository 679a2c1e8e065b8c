package particles.reactions;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static particles.reactions.Pendulums.chain;
import static particles.reactions.Pendulums.constraints;
import static particles.reactions.Pendulums.distance;

import deSolvers.catalog.SolverCatalog;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import particles.ParticleSystem;
import particles.Rule;
import particles.Systems;
import particles.energy.EnergyLedger;
import particles.law.AnchorMotion;
import particles.law.AnchorMotion.CircleMotion;
import particles.law.AnchorMotion.SineMotion;
import particles.law.Vector3;
import particles.rules.ConstraintProjection;
import particles.scene.ShortRun;

/** Rods, wires and surfaces do no work unless anchors move; any other change of energy is numerical error. */
class ConstraintWorkTest {

    private static EnergyLedger run(ParticleSystem system, String solver, double deltaT, double duration,
            Rule... rules) {
        return Systems.ledger(system, SolverCatalog.create(solver), deltaT, duration, rules);
    }

    /** Ten seconds of a double pendulum. Measured: 3.0e-7 J. */
    @Test
    void rodsDoNoWork() {
        EnergyLedger ledger = run(chain(2, 60, 5), "rk4", 0.005, 10);
        assertEquals(0, ledger.getWork().get("rods"), "exactly");
        assertEquals(0, ledger.getNumericalError(), 3e-6);
    }

    /**
     * A pendulum at steps of 0.02 s: all energy gained or lost by steps, feedback or projection is numerical error. The
     * table has the error measured after 8 s, relative to 9.81 J.
     */
    @ParameterizedTest
    @CsvSource({"verlet, false, -0.011", "verlet, true, -0.0031", "midpoint, false, 0.0446", "midpoint, true, 0.0080",
        "rk4, false, -1.5e-6", "rk4, true, -4.2e-5"})
    void energyGainedAtAFixedPivotIsNumericalError(String solver, boolean projected, double measured) {
        ParticleSystem system = chain(1, 90, 5);
        EnergyLedger ledger = run(system, solver, 0.02, 8,
                projected ? new Rule[] {new ConstraintProjection(constraints(system))} : new Rule[0]);
        double change = ledger.getEnergy() - ledger.getStartEnergy();
        assertEquals(measured, change / 9.81, 0.05 * Math.abs(measured));
        assertEquals(change, ledger.getNumericalError(), "and no work: " + ledger.getWork());
    }

    /**
     * In a smooth hollow ball, v&sup2; = 4.5 g r at the bottom: verlet gains 0.402 J in 0.3 s, which is booked as
     * error.
     */
    @Test
    void aSmoothBallDoesNoWork() {
        ShortRun ball = new ShortRun("verlet clamp 0.01 0.3", """
                particles: [{id: p, position: [0, -1, 0], velocity: [%s, 0, 0]}]
                rules: [sphere: {centre: [0, 0, 0], radius: 1, hollow: true}]
                """.formatted(Math.sqrt(4.5 * 9.81)));
        ball.contacts().getContacts().getModes().set(0, 0, ContactModes.Mode.SLIDING);
        ParticleSystem system = ball.getSystem();
        EnergyLedger ledger = run(system, "verlet", 0.01, 0.3);
        double change = ledger.getEnergy() - ledger.getStartEnergy();
        assertEquals(0.402, change, 0.01);
        assertEquals(0, ledger.getWork().get("contact"), "exactly");
        assertEquals(change, ledger.getNumericalError());
    }

    private static ParticleSystem moved(int rods, AnchorMotion motion) {
        ParticleSystem system = chain(rods, 0, 5);
        system.moveAnchor(0, motion);
        constraints(system).project(system.getOwnState(), 0);       // the anchor may begin with a velocity
        return system;
    }

    private static final AnchorMotion SHAKE = new SineMotion(Vector3.ZERO, new Vector3(0.2, 0.05, 0), 2);
    private static final AnchorMotion CRANK = new CircleMotion(Vector3.ZERO, new Vector3(0.3, 0, 0),
            new Vector3(0, 0, 1), 1.5);

    /**
     * A shaken pendulum and a double pendulum on a crank: the anchor's work equals their energy, 1.95 and 5.01 J, up to
     * an error of the solver's order. Measured: slopes 3.98 and 3.93 for rk4, 4.00 for yoshida4, 1.999 to 2.016 for
     * those of order 2, 1.003 and 0.999 for euler.
     */
    @ParameterizedTest
    @CsvSource({"rk4, 4, 0.004", "yoshida4, 4, 0.004", "verlet, 2, 0.005", "midpoint, 2, 0.005",
            "implicit-midpoint, 2, 0.005",
        "euler, 1, 0.0005"})
    void workOfMovingAnchorsBalancesToTheSolversOrder(String solver, int order, double h) {
        for (int rods = 1; rods <= 2; rods++) {
            double[] errors = new double[2];
            for (int k = 0; k < 2; k++) {
                EnergyLedger ledger = run(moved(rods, rods == 1 ? SHAKE : CRANK), solver, h / (1 + k), 2);
                assertTrue(ledger.getWork().get("moving anchors") > 1.9, ledger.getWork().toString());
                errors[k] = ledger.getNumericalError();
            }
            assertEquals(order, Math.log(errors[0] / errors[1]) / Math.log(2), 0.15);
        }
    }

    /** A moving hand drags a bob along by a rod: its work, by way of the rod, is the bob's energy. */
    @Test
    void aMovingHandWorksThroughItsRod() {
        ParticleSystem system = moved(1, (time, values) -> {
            values[0] = 0.2 * (1 - StrictMath.cos(3 * time));
            values[3] = 0.6 * StrictMath.sin(3 * time);
            values[6] = 1.8 * StrictMath.cos(3 * time);
        });
        EnergyLedger ledger = run(system, "rk4", 0.005, 5);
        assertTrue(Math.abs(ledger.getWork().get("moving anchors")) > 0.5, ledger.getWork().toString());
        assertEquals(0, ledger.getNumericalError(), 1e-7, "measured: 7.7e-9");
        assertEquals(1, distance(system, 0, 1), 7e-9, "measured: 7e-10");
    }
}
