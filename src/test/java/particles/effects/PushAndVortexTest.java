package particles.effects;

import static deSolvers.problems.Bounds.assertBelow;
import static org.junit.jupiter.api.Assertions.assertEquals;

import deSolvers.RK4Solver;
import java.util.Set;
import org.junit.jupiter.api.Test;
import particles.ParticleSystem;
import particles.law.Vector3;

class PushAndVortexTest {

    /** x = F t^2 / (2 m): a push moves a particle of twice the mass half as far; gravity would move both alike. */
    @Test
    void aPushDoesNotGrowWithMassAndActsOnItsOwnParticles() {
        ParticleSystem system = new ParticleSystem();
        for (double mass : new double[] {1, 2, 1}) {
            system.addParticle("p" + system.getParticles().count(), mass, Vector3.ZERO, Vector3.ZERO, false);
        }
        Push push = new Push(system.getParticles(), Set.of("p0", "p1"), new Vector3(3, 0, 0));
        system.addEffect(push);
        double start = energy(system);
        new RK4Solver().stepState(system, 0.5);
        assertEquals(3 * 0.25 / 2, system.getOwnState()[0], 1e-16);
        assertEquals(3 * 0.25 / 4, system.getOwnState()[6], 1e-16);
        assertEquals(0, system.getOwnState()[12]);
        assertEquals(start, energy(system), 1e-15);
        system.removeParticles(new boolean[] {true, false, false});     // the second is now the first
        new RK4Solver().stepState(system, 0.5);
        assertEquals(3 * 1 / 4.0, system.getOwnState()[0], 1e-15);
        assertEquals(0, system.getOwnState()[6]);
    }

    private static double energy(ParticleSystem system) {
        return system.getEnergy(system.getOwnState(), system.getTime());
    }

    private static Vector3 wind(Wind wind, Vector3 at) {
        double[] state = new double[6];
        double[] air = new double[6];
        at.put(state, 0);
        wind.getVelocities(state, 0, air, 0, 1);
        return Vector3.at(air, 3);
    }

    /** Largest at R, half of that at 0.27 R and 3.73 R, at right angles to the way from the axis. */
    @Test
    void aVortexTurnsAboutItsAxisAndIsFastestAtItsRadius() {
        Vector3 axis = new Vector3(1, 2, -2);
        Vector3 point = new Vector3(0.3, 0, 1);
        Wind vortex = new Vortex(Wind.STILL, point, axis, 3, 0.5);
        Vector3 out = axis.cross(new Vector3(0, 1, 0)).normalized();
        for (double[] pair : new double[][] {{1, 3}, {2 - Math.sqrt(3), 1.5}, {2 + Math.sqrt(3), 1.5}, {0, 0}}) {
            Vector3 u = wind(vortex, point.plus(axis.times(0.7)).plus(out.times(0.5 * pair[0])));
            Vector3 expected = axis.normalized().cross(out).times(pair[1]);
            assertBelow(1e-14, u.minus(expected).length());             // measured 1.4e-15
        }
        Wind both = new Vortex(new GustyWind(new Vector3(5, 0, 0), Vector3.ZERO, 1), point, axis, 3, 0.5);
        assertEquals(new Vector3(5, 0, 0), wind(both, point));
    }

    /** Against central differences of the velocity; the trace, the divergence, is 0. */
    @Test
    void theGradientOfAVortexIsItsDerivative() {
        Wind vortex = new Vortex(Wind.STILL, new Vector3(0.3, 0, 1), new Vector3(1, 2, -2), 3, 0.5);
        Vector3 at = new Vector3(0.9, -0.4, 0.6);
        double[] state = new double[6];
        at.put(state, 0);
        double[] gradient = new double[9];
        vortex.getGradient(state, 0, 0, gradient);
        double h = 1e-5;
        for (int b = 0; b < 3; b++) {
            Vector3 step = new Vector3(b == 0 ? h : 0, b == 1 ? h : 0, b == 2 ? h : 0);
            Vector3 slope = wind(vortex, at.plus(step)).minus(wind(vortex, at.minus(step))).times(1 / (2 * h));
            Vector3 column = new Vector3(gradient[b], gradient[3 + b], gradient[6 + b]);
            assertBelow(2e-8, slope.minus(column).length());             // measured 2.0e-9, the difference's error
        }
        assertEquals(0, gradient[0] + gradient[4] + gradient[8], 1e-14);
    }
}
