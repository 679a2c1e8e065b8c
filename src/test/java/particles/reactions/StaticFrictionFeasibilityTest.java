package particles.reactions;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import particles.law.Obstacle;
import particles.law.Plane;
import particles.law.Vector3;
import particles.reactions.contact.ContactSurface;

/** The cost of deciding whether friction holds a linkage, counted in calls of the ground's normal. */
class StaticFrictionFeasibilityTest {
    private static final int STEPS = 10;

    /** Level ground that counts the calls of its normal. */
    private static final class CountingGround implements Obstacle {
        private final Plane ground = Plane.ground(0);
        private long looks;

        @Override
        public double distance(double x, double y, double z) {
            return ground.distance(x, y, z);
        }

        @Override
        public Vector3 normal(double x, double y, double z) {
            looks++;
            return ground.normal(x, y, z);
        }

        @Override
        public double curvature(double x, double y, double z) {
            return ground.curvature(x, y, z);
        }

        @Override
        public boolean isFlat() {
            return ground.isFlat();
        }

        @Override
        public int separation(double[] points, double[] coefficients) {
            return ground.separation(points, coefficients);
        }
    }

    private static long looksInAStep(int rods) {
        CountingGround ground = new CountingGround();
        Vector3[] places = new Vector3[rods + 1];
        Vector3[] velocities = new Vector3[rods + 1];
        for (int i = 0; i <= rods; i++) {
            places[i] = new Vector3(0.5 * i, 0, 0);
            velocities[i] = Vector3.ZERO;
        }
        JointCase chain = new JointCase(List.of(new ContactSurface("ground", ground, 0, JointCase.coulomb(0.5), 1e-6)),
                places,
                velocities, IntStream.range(0, rods).mapToObj(i -> new int[] {i, i + 1}).toArray(int[][]::new));
        chain.clamped(1.0 / 256, STEPS / 256.0).run();
        for (int i = 0; i <= rods; i++) {
            assertTrue(chain.contacts.getModes().isSticking(i), "particle " + i);
            assertEquals(0.5 * i, chain.at(i, 0));
        }
        return ground.looks / STEPS;
    }

    /**
     * Each particle checks all ends once. Measured 34, 100 and 340 calls for 4, 8 and 16 rods; a search for loads takes
     * 206,806 for 4 and 1,340,075 for 8.
     */
    @Test
    void aChainAtRestNeedsNoSearchForLoads() {
        for (int rods : new int[] {4, 8, 16}) {
            long looks = looksInAStep(rods);
            assertTrue(looks < 2L * (rods + 1) * (rods + 1), rods + " rods: " + looks);
        }
    }
}
