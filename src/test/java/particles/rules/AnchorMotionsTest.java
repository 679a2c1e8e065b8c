package particles.rules;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.List;
import org.junit.jupiter.api.Test;
import particles.law.AnchorMotion;
import particles.law.AnchorMotion.CircleMotion;
import particles.law.AnchorMotion.GlideMotion;
import particles.law.AnchorMotion.SineMotion;
import particles.law.Vector3;

/** Given motions of anchors begin at their start, and their derivatives are right. */
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
}
