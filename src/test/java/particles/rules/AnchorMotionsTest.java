package particles.rules;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static particles.Systems.entry;
import static particles.Systems.run;

import deSolvers.RK4Solver;
import java.util.List;
import org.junit.jupiter.api.Test;
import particles.ParticleSystem;
import particles.effects.springs.SpringForce;
import particles.law.AnchorMotion;
import particles.law.Vector3;

/** Given motions of anchors: their derivatives are right, and a shaken oscillator follows its closed form. */
class AnchorMotionsTest {
    private static final List<AnchorMotion> MOTIONS = List.of(
            new SineMotion(new Vector3(1, 2, 3), new Vector3(0.3, -0.2, 0.1), 1.7),
            new CircleMotion(new Vector3(1, 2, 3), new Vector3(0, 1, 0), new Vector3(1, 1, 0), 2.3),
            new GlideMotion(new Vector3(1, 2, 3), new Vector3(-1, 0, 5), 2));

    /** Central differences of 1e-4 s; measured at most 4e-8. */
    @Test
    void velocitiesAndAccelerationsAreDerivatives() {
        for (AnchorMotion motion : MOTIONS) {
            for (double time = 0.1; time < 1.9; time += 0.17) {
                double[] now = new double[9];
                double[] ahead = new double[9];
                double[] behind = new double[9];
                motion.at(time, now);
                motion.at(time + 1e-4, ahead);
                motion.at(time - 1e-4, behind);
                for (int k = 0; k < 6; k++) {
                    assertEquals((ahead[k] - behind[k]) / 2e-4, now[k + 3], 4e-7, motion.getClass() + " entry " + k);
                }
            }
        }
    }

    @Test
    void eachMotionBeginsAtItsStart() {
        for (AnchorMotion motion : MOTIONS) {
            double[] values = new double[9];
            motion.at(0, values);
            assertArrayEquals(new double[] {1, 2, 3}, java.util.Arrays.copyOf(values, 3), 1e-15);
        }
        double[] end = new double[9];
        MOTIONS.get(2).at(5, end);
        assertArrayEquals(new double[] {-1, 0, 5, 0, 0, 0, 0, 0, 0}, end, 1e-300);
    }

    private static ParticleSystem shaken(double omega, double amplitude, double shake) {
        ParticleSystem system = new ParticleSystem();
        system.addParticle("hand", 1, Vector3.ZERO, Vector3.ZERO, true);
        system.addParticle("block", 1, new Vector3(2, 0, 0), Vector3.ZERO, false);
        SpringForce spring = new SpringForce(system.getParticles());
        spring.addSpring(0, 1, omega * omega, 2, 0);
        system.addEffect(spring);
        system.moveAnchor(0, new SineMotion(Vector3.ZERO, new Vector3(amplitude, 0, 0), 2 * Math.PI / shake));
        return system;
    }

    /**
     * In resonance x = a/2 (sin w t - w t cos w t): the amplitude grows for ever. Measured with rk4 at w h = 0.03:
     * 1.5e-8.
     */
    @Test
    void amplitudeGrowsWithoutBoundInResonance() {
        double w = 3;
        double a = 0.01;
        ParticleSystem system = shaken(w, a, w);
        run(system, new RK4Solver(), 0.01, 10);
        double exact = a / 2 * (Math.sin(30) - 30 * Math.cos(30));
        assertEquals(2 + exact, entry(system, 6), 4e-8);
        assertTrue(Math.abs(exact) < a / 2 * 31 && a / 2 * 30 > 10 * a);
    }

    /**
     * Off resonance x = a w/(w&sup2; - W&sup2;) (w sin W t - W sin w t), which stays below a w/|w - W|. Measured:
     * 4.6e-10.
     */
    @Test
    void amplitudeBeatsOffResonance() {
        double w = 3;
        double shake = 4;
        double a = 0.01;
        ParticleSystem system = shaken(w, a, shake);
        run(system, new RK4Solver(), 0.01, 10);
        double exact = a * w / (w * w - shake * shake) * (w * Math.sin(10 * shake) - shake * Math.sin(10 * w));
        assertEquals(2 + exact, entry(system, 6), 4e-9);
        assertTrue(Math.abs(entry(system, 6) - 2) < a * w / (shake - w));
    }
}
