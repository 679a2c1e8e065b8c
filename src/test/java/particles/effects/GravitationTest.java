package particles.effects;

import static deSolvers.problems.Bounds.assertBelow;
import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;

import deSolvers.DESolver;
import deSolvers.adaptive.DormandPrinceSolver;
import org.junit.jupiter.api.Test;
import particles.ParticleSystem;
import particles.Systems;
import particles.law.Vector3;

/** Gravitation between particles, against Kepler's laws and a periodic orbit of three. */
class GravitationTest {
    private static final double PERIOD = 6.32591398;

    private static ParticleSystem attracted(double constant, double softening, double[] masses, Vector3... places) {
        ParticleSystem system = new ParticleSystem();
        for (int i = 0; i < masses.length; i++) {
            system.addParticle("p" + i, masses[i], places[2 * i], places[2 * i + 1], false);
        }
        system.addEffect(new Gravitation(system.getParticles(), constant, softening));
        return system;
    }

    /** A. Chenciner, R. Montgomery (2000): G = m = 1. */
    private static ParticleSystem figureOfEight() {
        Vector3 place = new Vector3(0.97000436, -0.24308753, 0);
        Vector3 v = new Vector3(-0.93240737, -0.86473146, 0);
        return attracted(1, 0, new double[] {1, 1, 1}, place, v.times(-0.5), place.times(-1), v.times(-0.5),
                Vector3.ZERO, v);
    }

    private static double distance(double[] state, double[] other) {
        double most = 0;
        for (int i = 0; i < state.length; i++) {
            most = Math.max(most, Math.abs(state[i] - other[i]));
        }
        return most;
    }

    @Test
    void threeBodiesReturnToTheirPlacesOnAFigureOfEight() {
        ParticleSystem system = figureOfEight();
        double[] start = system.getOwnState().clone();
        assertEquals(-1.287142, system.getEnergy(start, 0), 5e-7);
        DESolver solver = new DormandPrinceSolver(1e-13, 1e-13);
        solver.stepState(system, PERIOD);
        assertEquals(3.9e-8, distance(start, system.getOwnState()), 1e-9);      // of the eight digits given
        for (int period = 1; period < 10; period++) {
            solver.stepState(system, PERIOD);
        }
        assertBelow(1e-5, distance(start, system.getOwnState()));               // measured
    }

    @Test
    void everySolverHasItsOrder() {
        Systems.assertOrders(GravitationTest::figureOfEight, 2, 512, 0.2);
    }

    /** Kepler: both go round their centre of mass in 2 pi sqrt(a^3/(G (m1 + m2))). */
    @Test
    void aPlanetPullsItsStar() {
        double star = 3;
        double planet = 0.5;
        double apart = 1.4;
        double speed = Math.sqrt(2 * (star + planet) / apart);                  // of a circle, G = 2
        Vector3 x = new Vector3(1, 0, 0);
        Vector3 y = new Vector3(0, 1, 0);
        double part = planet / (star + planet);
        ParticleSystem system = attracted(2, 0, new double[] {star, planet}, x.times(-apart * part),
                y.times(-speed * part), x.times(apart * (1 - part)), y.times(speed * (1 - part)));
        double[] start = system.getOwnState().clone();
        double period = 2 * Math.PI * Math.sqrt(apart * apart * apart / (2 * (star + planet)));
        DESolver solver = new DormandPrinceSolver(1e-13, 1e-13);
        solver.stepState(system, period / 4);
        assertEquals(-apart * part, system.getOwnState()[1], 2e-13);            // measured 2e-14
        assertEquals(apart * (1 - part), system.getOwnState()[7], 2e-13);
        solver.stepState(system, 0.75 * period);
        assertBelow(1e-10, distance(start, system.getOwnState()));              // measured
    }

    /** With softening s, two at one place oscillate through each other; from far, G m/s^3 is the stiffness. */
    @Test
    void softenedBodiesPassThroughEachOther() {
        double s = 0.5;
        double small = 1e-4;
        ParticleSystem system = attracted(1, s, new double[] {1, 1}, new Vector3(small, 0, 0), Vector3.ZERO,
                new Vector3(-small, 0, 0), Vector3.ZERO);
        double omega = Math.sqrt(2 / (s * s * s));                              // x'' = -2 x/s^3 for each
        new DormandPrinceSolver(1e-12, 1e-14).stepState(system, Math.PI / omega);
        // measured 3e-11
        assertEquals(-small, system.getOwnState()[0], 3e-10 * small);
        assertEquals(0, attracted(1, s, new double[] {1, 1}, Vector3.ZERO, Vector3.ZERO, Vector3.ZERO, Vector3.ZERO)
                .getForceSum().getEffects().stream().mapToDouble(effect -> {
                    double[] force = new double[12];
                    effect.addForces(new double[12], 0, force);
                    return force[3];
                }).sum());
    }

    /** Two fixed ones may stand at one place: they pull others. */
    @Test
    void fixedBodiesAtOnePlaceAreOfTwiceTheMass() {
        ParticleSystem system = new ParticleSystem();
        system.addParticle("a", 1, Vector3.ZERO, Vector3.ZERO, true);
        system.addParticle("b", 1, Vector3.ZERO, Vector3.ZERO, true);
        system.addParticle("c", 1, new Vector3(2, 0, 0), Vector3.ZERO, false);
        system.addEffect(new Gravitation(system.getParticles(), 6, 0));
        double[] dSdt = new double[18];
        system.getStateDerivative(dSdt);
        assertArrayEquals(new double[] {0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, -6 * 2 / 4.0, 0, 0}, dSdt);
    }
}
