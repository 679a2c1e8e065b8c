package particles.reactions;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import deSolvers.linear.EnvelopeMatrix;
import java.util.Arrays;
import java.util.Random;
import org.junit.jupiter.api.RepeatedTest;
import org.junit.jupiter.api.RepetitionInfo;
import org.junit.jupiter.api.Test;
import particles.law.Vector3;

/** The normal forces of one to six planes on one particle satisfy their conditions. */
class ActiveSetMethodTest {

    private static double[] pushes(Vector3[] normals, Vector3 force) {
        int n = normals.length;
        EnvelopeMatrix a = new EnvelopeMatrix();
        double[] b = new double[n];
        for (int r = 0; r < n; r++) {
            a.add(0);
            for (int c = 0; c <= r; c++) {
                a.set(r, c, normals[r].dot(normals[c]), normals[r].dot(normals[c]));
            }
            b[r] = -normals[r].dot(force);
        }
        boolean[] contact = new boolean[n];
        Arrays.fill(contact, true);
        double[] push = new double[n];
        assertTrue(new ActiveSetMethod().solve(a, b, contact, true, contact.clone(), push, new double[n]));
        return push;
    }

    /** Measured over 200 random cases of up to six planes: the worst condition fails by 1.9e-14 of the largest push. */
    @RepeatedTest(200)
    void normalForcesSatisfyTheirConditions(RepetitionInfo info) {
        Random random = new Random(info.getCurrentRepetition());
        Vector3[] normals = new Vector3[1 + random.nextInt(6)];
        for (int p = 0; p < normals.length; p++) {
            normals[p] = new Vector3(random.nextGaussian(), 1 + random.nextGaussian(),
                    random.nextGaussian()).normalized();
        }
        Vector3 force = new Vector3(random.nextGaussian(), random.nextGaussian() - 2, random.nextGaussian());
        double[] push = pushes(normals, force);
        Vector3 total = force;
        double scale = force.length();
        for (int p = 0; p < normals.length; p++) {
            total = total.plus(normals[p].times(push[p]));
            scale = Math.max(scale, push[p]);           // nearly parallel planes can push far harder than the force
        }
        for (int p = 0; p < normals.length; p++) {
            double away = normals[p].dot(total);
            assertTrue(push[p] >= -1.5e-13 * scale, "plane " + p + " pulls: " + push[p]);
            assertTrue(away >= -1.5e-13 * scale, "plane " + p + " is still pressed: " + away);
            assertEquals(0, push[p] * away, 1.5e-13 * scale * scale, "plane " + p + " pushes what moves away");
        }
    }

    /** A rod that has to lengthen against a wall: elastic contacts would yield to 1e6 times the force. */
    @Test
    void aJamHasNoForces() {
        EnvelopeMatrix a = new EnvelopeMatrix();
        a.add(0);
        a.set(0, 0, 1, 1);
        a.add(0);
        a.set(1, 0, -1, -1);
        a.set(1, 1, 1, 1);
        assertFalse(new ActiveSetMethod().solve(a, new double[] {1, 0}, new boolean[] {false, true}, true,
                new boolean[2], new double[2], new double[2]));
    }
}
