package particles.reactions.contact;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Random;
import org.junit.jupiter.api.RepeatedTest;
import org.junit.jupiter.api.RepetitionInfo;
import org.junit.jupiter.api.Test;
import particles.law.Vector3;

/** The normal forces of one to six planes satisfy their conditions. */
class NormalForcesTest {

    /** Measured over 200 random cases of up to six planes: the worst condition fails by 1.3e-13 of the largest push. */
    @RepeatedTest(200)
    void normalForcesSatisfyTheirConditions(RepetitionInfo info) {
        Random random = new Random(info.getCurrentRepetition());
        int count = 1 + random.nextInt(6);
        Vector3[] normals = new Vector3[count];
        for (int p = 0; p < count; p++) {
            normals[p] = new Vector3(random.nextGaussian(), 1 + random.nextGaussian(),
                    random.nextGaussian()).normalized();
        }
        double[] force = {random.nextGaussian(), random.nextGaussian() - 2, random.nextGaussian()};
        double[] push = new double[count];
        new NormalForces(count).solve(count, normals, force, new double[count], push);
        Vector3 total = new Vector3(force[0], force[1], force[2]);
        double scale = total.length();
        for (int p = 0; p < count; p++) {
            total = total.plus(normals[p].times(push[p]));
            // nearly parallel planes can push far harder than the force on them
            scale = Math.max(scale, push[p]);
        }
        for (int p = 0; p < count; p++) {
            double away = normals[p].dot(total);
            assertTrue(push[p] >= -1e-12 * scale, "plane " + p + " pulls: " + push[p]);
            assertTrue(away >= -1e-12 * scale, "plane " + p + " is still pressed: " + away);
            assertEquals(0, push[p] * away, 1e-12 * scale * scale, "plane " + p + " pushes a particle that moves away");
        }
    }

    @Test
    void aGrooveSharesTheLoad() {
        Vector3[] groove = {new Vector3(1, 1, 0).normalized(), new Vector3(-1, 1, 0).normalized()};
        double[] push = new double[2];
        new NormalForces(2).solve(2, groove, new double[] {0, -10, 0}, new double[2], push);
        assertEquals(10 / Math.sqrt(2), push[0], 1e-13);
        assertEquals(10 / Math.sqrt(2), push[1], 1e-13);
        new NormalForces(2).solve(2, groove, new double[] {0, 10, 0}, new double[2], push);
        assertEquals(0, push[0] + push[1], "no force on a particle that is pulled out");
    }
}
