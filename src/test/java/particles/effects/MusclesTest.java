package particles.effects;

import static deSolvers.problems.Bounds.assertBelow;
import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import deSolvers.adaptive.DormandPrinceSolver;
import deSolvers.catalog.SolverCatalog;
import org.junit.jupiter.api.Test;
import particles.ParticleSystem;
import particles.Simulation;
import particles.Systems;
import particles.effects.springs.SpringForce;
import particles.energy.EnergyLedger;
import particles.law.Vector3;
import particles.rules.SpringTear;

/** Muscles, against forced oscillators and the laws of momentum and energy. */
class MusclesTest {
    private static final double STIFFNESS = 40;
    private static final double LENGTH = 0.5;
    private static final double AMPLITUDE = 0.2;
    private static final double PERIOD = 1.25;
    private static final double OMEGA = 2 * Math.PI / PERIOD;
    private static final String MUSCLES = "muscles (driven)";

    /** A ball of 1 kg on a muscle that is fixed at the origin. */
    private static ParticleSystem oneMuscle(double damping, double phase, double rise) {
        ParticleSystem system = new ParticleSystem();
        system.addParticle("wall", 1, Vector3.ZERO, Vector3.ZERO, true);
        system.addParticle("ball", 1, new Vector3(LENGTH, 0, 0), Vector3.ZERO, false);
        SpringForce springs = Systems.springs(system);
        springs.addSpring(0, 1, STIFFNESS, LENGTH, damping);
        Muscles muscles = new Muscles(springs, PERIOD, rise);
        muscles.add(0, AMPLITUDE, phase);
        system.addEffect(muscles);
        return system;
    }

    /** With m y'' = -k y + k l a sin(omega t): y = A (sin(omega t) - omega/omega0 sin(omega0 t)). */
    @Test
    void aMuscleForcesAnOscillator() {
        ParticleSystem system = oneMuscle(0, 0, 0);
        new DormandPrinceSolver(1e-13, 1e-13).stepState(system, 7.3);
        double own = Math.sqrt(STIFFNESS);
        double size = STIFFNESS * LENGTH * AMPLITUDE / (STIFFNESS - OMEGA * OMEGA);
        assertEquals(LENGTH + size * (Math.sin(OMEGA * 7.3) - OMEGA / own * Math.sin(own * 7.3)),
                system.getOwnState()[6], 1e-11);
    }

    /**
     * Steady: y = A sin(omega t + phase - delta), A = k l a/sqrt((k - m omega^2)^2 + (c omega)^2); in each period the
     * muscle gives pi k l a A sin(delta), which is what damping takes.
     */
    @Test
    void aDampedMuscleHasAmplitudePhaseAndPowerOfAForcedOscillator() {
        double damping = 3;
        double phase = 0.3;
        ParticleSystem system = oneMuscle(damping, phase, 1);
        double force = STIFFNESS * LENGTH * AMPLITUDE;
        double size = force / Math.hypot(STIFFNESS - OMEGA * OMEGA, damping * OMEGA);
        double delta = Math.atan2(damping * OMEGA, STIFFNESS - OMEGA * OMEGA);
        EnergyLedger ledger = new EnergyLedger();
        Simulation simulation = new Simulation(system, () -> SolverCatalog.create("rk4"), PERIOD / 256, 21 * PERIOD);
        simulation.addObserver(ledger);
        simulation.start();
        for (int step = 0; step < 20 * 256; step++) {
            simulation.advance();
        }
        assertEquals(LENGTH + size * Math.sin(2 * Math.PI * phase - delta), system.getOwnState()[6], 1e-8);
        double given = ledger.getWork().get(MUSCLES);
        double lost = ledger.getWork().get("springs (dissipated)");
        while (!simulation.isOver()) {
            simulation.advance();
        }
        double work = Math.PI * force * size * Math.sin(delta);
        assertEquals(work, ledger.getWork().get(MUSCLES) - given, 1e-7 * work);
        assertEquals(-work, ledger.getWork().get("springs (dissipated)") - lost, 1e-7 * work);
        assertBelow(2e-6, Math.abs(ledger.getNumericalError()));                // measured 3.7e-7 of 36 J
    }

    /** A hexagon of muscles with all its diagonals, in free flight. */
    private static ParticleSystem creature() {
        ParticleSystem system = new ParticleSystem();
        for (int i = 0; i < 6; i++) {
            system.addParticle("p" + i, 1 + 0.3 * i, new Vector3(Math.cos(i * Math.PI / 3), Math.sin(i * Math.PI / 3),
                    0.1 * i), new Vector3(0.2, 0.1 * i, -0.1), false);
        }
        SpringForce springs = Systems.springs(system);
        for (int j = 5; j > 0; j--) {
            for (int i = 0; i < j; i++) {
                springs.addSpring(j, i, 50, Math.abs(i - j) == 1 ? 1 : 1.7, 0.3);
            }
        }
        Muscles muscles = new Muscles(springs, 1, 1);
        for (int s = 0; s < 15; s += 2) {
            muscles.add(s, 0.3, 0.07 * s);
        }
        system.addEffect(muscles);
        return system;
    }

    private static Vector3[] momenta(ParticleSystem system) {
        Vector3 momentum = Vector3.ZERO;
        Vector3 angular = Vector3.ZERO;
        for (int i = 0; i < system.getParticles().count(); i++) {
            Vector3 p = Vector3.at(system.getOwnState(), 6 * i + 3).times(system.getParticles().mass(i));
            momentum = momentum.plus(p);
            angular = angular.plus(Vector3.at(system.getOwnState(), 6 * i).cross(p));
        }
        return new Vector3[] {momentum, angular};
    }

    @Test
    void aFreeCreatureKeepsItsMomentumAndItsAngularMomentum() {
        ParticleSystem system = creature();
        Vector3[] before = momenta(system);
        EnergyLedger ledger = Systems.ledger(system, SolverCatalog.create("rk4"), 0x1p-9, 4);
        assertBelow(1e-12, momenta(system)[0].minus(before[0]).length());
        assertBelow(1e-7, momenta(system)[1].minus(before[1]).length());       // measured 3.7e-8, rk4's error
        assertTrue(ledger.getWork().get(MUSCLES) > 1, "they work");
        assertBelow(1e-6, Math.abs(ledger.getNumericalError()));
    }

    @Test
    void everySolverHasItsOrder() {
        Systems.assertOrders(MusclesTest::creature, 2, 4096, 0.15);
    }

    /** Yoshida's first step looks at times before the beginning, where a muscle without a rise swings as well. */
    @Test
    void aMuscleThatBeginsAtOnceSwungBefore() {
        assertEquals(4, Systems.order(() -> oneMuscle(0, 0.25, 0), "yoshida4", 0.32, 16), 0.2);
    }

    /** The amplitude rises from 0 with no jump of the force, of its rate, or of the rate of that. */
    @Test
    void aMuscleBeginsWithoutAJump() {
        ParticleSystem system = oneMuscle(0, 0.25, 2);
        double most = 0;
        double bend = 0;
        for (int n = -20; n < 3200; n++) {
            double next = force(system, (n + 1) * 1e-3) - force(system, n * 1e-3);
            most = Math.max(most, Math.abs(next));
            bend = Math.max(bend, Math.abs(next - force(system, n * 1e-3) + force(system, (n - 1) * 1e-3)));
        }
        double fastest = STIFFNESS * LENGTH * AMPLITUDE * OMEGA * 1e-3;
        assertEquals(fastest, most, 1e-3 * fastest);
        assertBelow(1.1 * fastest * OMEGA * 1e-3, bend);            // a kink would be 500 times that
        assertEquals(0, force(system, -1e-3));
        assertBelow(5e-9, force(system, 1e-3));                     // 2.6e-9 N, by the formula
    }

    private static double force(ParticleSystem system, double time) {
        double[] force = new double[12];
        system.addUpEffects(system.getOwnState(), time, force);
        return force[9];
    }

    /** The springs are sorted at the first evaluation; then one tears, which the muscle of another survives. */
    @Test
    void aMuscleFollowsItsSpringAndTearsWithIt() {
        ParticleSystem system = Systems.row(4);
        SpringForce springs = Systems.springs(system);
        springs.addSpring(2, 3, 10, 1, 0);
        springs.addSpring(1, 2, 10, 0.4, 0);
        springs.addSpring(0, 1, 10, 1, 0);
        Muscles muscles = new Muscles(springs, 1, 0);
        muscles.add(0, 0.2, 0.25);
        muscles.add(1, 0.2, 0.25);
        system.addEffect(muscles);
        double[] expected = new double[24];
        expected[21] = 2;                                   // k l a on the last ball
        expected[15] = 0.8 - 2;
        expected[9] = -0.8;
        assertArrayEquals(expected, forceOf(muscles, system), 1e-15);
        springs.countBlocks();
        assertEquals(2, springs.from(2), "sorted");
        assertArrayEquals(expected, forceOf(muscles, system), 1e-15);
        new SpringTear(springs, 1).afterStep(system, 1);    // that of rest length 0.4 is longer than 0.8
        expected[15] = -2;
        expected[9] = 0;
        assertArrayEquals(expected, forceOf(muscles, system), 1e-15);
        assertEquals(10 * 0.04 / 2, muscles.getPotentialEnergy(system.getOwnState(), 0), 1e-15);
    }

    private static double[] forceOf(Muscles muscles, ParticleSystem system) {
        double[] force = new double[24];
        muscles.addForces(system.getOwnState(), 0, force);
        return force;
    }
}
