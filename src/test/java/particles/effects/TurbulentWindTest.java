package particles.effects;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;

import java.util.Arrays;
import org.junit.jupiter.api.Test;
import particles.law.SeededRandom;
import particles.law.Vector3;

/** Properties of the turbulent field: no divergence, its strength, its mean, the same field for the same seed. */
class TurbulentWindTest {
    private static final Vector3 MEAN = new Vector3(3, 0, -1);

    private static double[] velocity(TurbulentWind wind, double x, double y, double z, double time) {
        double[] u = new double[6];
        wind.getVelocities(new double[] {x, y, z, 0, 0, 0}, time, u, 0, 1);
        return Arrays.copyOfRange(u, 3, 6);
    }

    /** By central differences of 1e-5 m; measured at most 4e-9 /s where the rates are about 5 /s. */
    @Test
    void theFieldIsDivergenceFree() {
        TurbulentWind wind = new TurbulentWind(MEAN, 2, 1.5, 1);
        SeededRandom random = new SeededRandom(2);
        for (int n = 0; n < 100; n++) {
            double[] at = {10 * random.nextDouble(), 10 * random.nextDouble(), 10 * random.nextDouble()};
            double divergence = 0;
            for (int c = 0; c < 3; c++) {
                double[] ahead = at.clone();
                double[] behind = at.clone();
                ahead[c] += 1e-5;
                behind[c] -= 1e-5;
                divergence += (velocity(wind, ahead[0], ahead[1], ahead[2], 0.7)[c]
                        - velocity(wind, behind[0], behind[1], behind[2], 0.7)[c]) / 2e-5;
            }
            assertEquals(0, divergence, 2e-8);
        }
    }

    /** Over 20,000 distant points; measured: rms 2.00, mean within 0.02. */
    @Test
    void theFieldHasItsStrengthAndMean() {
        TurbulentWind wind = new TurbulentWind(MEAN, 2, 1.5, 5);
        SeededRandom random = new SeededRandom(6);
        double[] sum = new double[3];
        double squares = 0;
        int count = 20000;
        for (int n = 0; n < count; n++) {
            double[] u = velocity(wind, 1e3 * random.nextDouble(), 1e3 * random.nextDouble(), 1e3 * random.nextDouble(),
                    1);
            double[] mean = {MEAN.x(), MEAN.y(), MEAN.z()};
            for (int c = 0; c < 3; c++) {
                sum[c] += u[c] / count;
                squares += (u[c] - mean[c]) * (u[c] - mean[c]) / count;
            }
        }
        assertEquals(2, Math.sqrt(squares), 0.03);
        assertArrayEquals(new double[] {MEAN.x(), MEAN.y(), MEAN.z()}, sum, 0.05);
    }

    /** The bits at one point are pinned: they are the same on every machine. */
    @Test
    void theSameSeedGivesTheSameField() {
        double[] u = velocity(new TurbulentWind(MEAN, 2, 1.5, 715), 0.1, 0.2, 0.3, 0.4);
        assertArrayEquals(u, velocity(new TurbulentWind(MEAN, 2, 1.5, 715), 0.1, 0.2, 0.3, 0.4));
        assertNotEquals(u[0], velocity(new TurbulentWind(MEAN, 2, 1.5, 716), 0.1, 0.2, 0.3, 0.4)[0]);
        assertNotEquals(u[0], velocity(new TurbulentWind(MEAN, 2, 1.5, 715), 0.1, 0.2, 0.3, 0.5)[0]);
        assertArrayEquals(new double[] {MEAN.x(), MEAN.y(), MEAN.z()},
                velocity(new TurbulentWind(MEAN, 0, 1.5, 715), 0.1, 0.2, 0.3, 0.4), "no strength, no eddies");
        assertArrayEquals(new double[] {4.930752761843625, 0.6172041188786974, -0.7308666480643957}, u);
    }

    /** The first outputs for seed 0 and 1234567, as published with SplitMix64's reference implementation. */
    @Test
    void theGeneratorIsSplitMix64() {
        assertEquals(0xe220a8397b1dcdafL, new SeededRandom(0).nextLong());
        SeededRandom random = new SeededRandom(1234567);
        assertEquals(6457827717110365317L, random.nextLong());
        assertEquals(3203168211198807973L, random.nextLong());
    }
}
