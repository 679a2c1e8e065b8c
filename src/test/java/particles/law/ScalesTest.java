package particles.law;

import static deSolvers.problems.Bounds.assertBelow;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Random;
import org.junit.jupiter.api.Test;
import particles.law.Scales.Skin;

/** The two half ellipses of admissible friction, on random axes, factors and motions in the plane z = 0. */
class ScalesTest {
    private static final int CASES = 20_000;

    private final Random random = new Random(63);

    /** A factor between 0.01 and 100. */
    private double factor() {
        return StrictMath.exp(StrictMath.log(100) * (2 * random.nextDouble() - 1));
    }

    private Vector3 vector() {
        double size = StrictMath.exp(6 * random.nextGaussian());
        return new Vector3(size * random.nextGaussian(), size * random.nextGaussian(), 0);
    }

    private Skin skin() {
        return new Skin(vector().normalized(), factor(), factor(), factor());
    }

    /** Friction with sliding, for a normal force and mu with the product 1 N. */
    private static Vector3 friction(Skin skin, Vector3 velocity) {
        Vector3 stretched = skin.stretch(velocity);
        return skin.stretch(stretched).times(-1 / stretched.length());
    }

    @Test
    void slidingFrictionTakesMostEnergyOfAllAdmissibleForcesAndNeverGivesAny() {
        for (int k = 0; k < CASES; k++) {
            Skin skin = skin();
            Vector3 v = vector();
            Vector3 f = friction(skin, v);
            assertTrue(f.dot(v) < 0, "power");
            assertEquals(1, skin.toHold(f.times(-1)), 1e-11, "on the edge");        // measured 2e-12
            Vector3 other = skin.balance(vector(), 1).times(-1);
            assertTrue(f.dot(v) <= other.dot(v) + 1e-12 * v.length() * other.length(), "least power of all");
        }
    }

    @Test
    void forwardBackwardAndAcrossHaveTheirOwnFactors() {
        Skin skin = new Skin(new Vector3(0, 1, 0), 0.5, 3, 2);
        assertAlong(0, -0.5, friction(skin, new Vector3(0, 7, 0)));
        assertAlong(0, 3, friction(skin, new Vector3(0, -7, 0)));
        assertAlong(-2, 0, friction(skin, new Vector3(7, 0, 0)));
        assertAlong(0, 0.5, skin.balance(new Vector3(0, 9, 0), 1));
        assertAlong(0, -3, skin.balance(new Vector3(0, -9, 0), 1));
        assertAlong(0, -2.9, skin.balance(new Vector3(0, -2.9, 0), 1));
        assertAlong(2, 0, skin.balance(new Vector3(9, 0, 0), 1));
    }

    private static void assertAlong(double x, double y, Vector3 force) {
        assertEquals(x, force.x(), 1e-15);
        assertEquals(y, force.y(), 1e-15);
    }

    /** What is balanced is the nearest admissible force: nothing nearer is found, and what is left is normal there. */
    @Test
    void theBalancedForceIsTheNearest() {
        double edge = 0;
        double worst = 0;
        for (int k = 0; k < CASES; k++) {
            Skin skin = skin();
            Vector3 force = vector();
            double most = StrictMath.exp(3 * random.nextGaussian());
            Vector3 balanced = skin.balance(force, most);
            if (skin.toHold(force) <= most) {
                assertEquals(force, balanced);
                continue;
            }
            edge = Math.max(edge, Math.abs(skin.toHold(balanced) / most - 1));
            Vector3 left = force.minus(balanced);
            // sliding along what is left brings just this friction
            Vector3 sliding = friction(skin, left).times(-most);
            worst = Math.max(worst, sliding.minus(balanced).length() / balanced.length() * left.length()
                    / force.length());
        }
        assertBelow(5e-11, edge, "off the edge");       // measured 6.5e-12, with half axes in ratios up to 1e4
        assertBelow(5e-8, worst, "off the nearest force");      // measured 4.8e-9
    }

    @Test
    void equalFactorsAreAFactorOfMu() {
        for (int k = 0; k < 1000; k++) {
            double factor = factor();
            Skin round = new Skin(vector().normalized(), factor, factor, factor);
            Vector3 u = vector();
            assertEquals(0, round.stretch(u).minus(u.times(factor)).length(), 1e-14 * factor * u.length());
            double most = 0.5 * u.length();
            assertEquals(0, round.balance(u, most).minus(Skin.SMOOTH.balance(u, factor * most)).length(),
                    1e-13 * u.length());
        }
    }

    @Test
    void aBodyThatStandsOnItsNoseSlidesAcrossInAllDirections() {
        Scales scales = new Scales(0, 1, 0.5, 3, 2);
        assertEquals(new Skin(Vector3.ZERO, 2, 2, 2), scales.skin(1, Vector3.ZERO));
        assertEquals(new Skin(new Vector3(1, 0, 0), 0.5, 3, 2), scales.skin(4, new Vector3(4, 0, 0)));
        assertEquals(new Skin(Vector3.ZERO, 2, 2, 2), scales.skin(0, Vector3.ZERO));
        assertEquals(8, scales.sharpness());
    }

    @Test
    void factorsAreOverZero() {
        assertThrows(IllegalArgumentException.class, () -> new Scales(0, 1, 0, 1, 1));
        assertThrows(IllegalArgumentException.class, () -> new Scales(0, 1, 1, -1, 1));
        assertThrows(IllegalArgumentException.class, () -> new Scales(0, 1, 1, 1, Double.NaN));
    }
}
