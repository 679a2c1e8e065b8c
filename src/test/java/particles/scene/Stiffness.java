package particles.scene;

import java.util.Random;
import particles.law.Particles;
import particles.view.SpringView;

/**
 * The fastest oscillation and the fastest decay of a scene's springs, linearised where it begins, by power iteration.
 */
final class Stiffness {
    private static final int ITERATIONS = 300;

    private Stiffness() {
    }

    /** @return the largest angular frequency of the undamped springs (rad/s) */
    static double largestOmega(Scene scene) {
        return Math.sqrt(largestEigenvalue(scene, false));
    }

    /** @return the largest rate of the dampers alone (1/s) */
    static double largestRate(Scene scene) {
        return largestEigenvalue(scene, true);
    }

    /**
     * Of M^-1 K, or M^-1 C: it is similar to a symmetric matrix, so the Rayleigh quotient in m converges from below.
     */
    private static double largestEigenvalue(Scene scene, boolean damping) {
        Particles particles = scene.system().getParticles();
        double[] state = scene.system().getOwnState();
        SpringView springs = scene.springs();
        double[] x = new Random(1).doubles(3L * particles.count(), -1, 1).toArray();
        double eigenvalue = 0;
        for (int iteration = 0; iteration < ITERATIONS; iteration++) {
            double[] y = new double[x.length];
            for (int s = 0; s < springs.springCount(); s++) {
                int i = springs.from(s);
                int j = springs.to(s);
                double[] r = new double[3];
                double square = 0;
                double stretch = 0;
                for (int c = 0; c < 3; c++) {
                    r[c] = state[6 * j + c] - state[6 * i + c];
                    square += r[c] * r[c];
                    stretch += r[c] * (x[3 * j + c] - x[3 * i + c]);
                }
                double force = (damping ? springs.damping(s) : springs.stiffness(s)) * stretch / square;
                for (int c = 0; c < 3; c++) {
                    y[3 * i + c] -= force * r[c] * particles.getInverseMasses()[i];
                    y[3 * j + c] += force * r[c] * particles.getInverseMasses()[j];
                }
            }
            double xy = 0;
            double xx = 0;
            double norm = 0;
            for (int n = 0; n < x.length; n++) {
                xy += particles.mass(n / 3) * x[n] * y[n];
                xx += particles.mass(n / 3) * x[n] * x[n] * (particles.isFixed(n / 3) ? 0 : 1);
                norm = Math.max(norm, Math.abs(y[n]));
            }
            eigenvalue = xx == 0 ? 0 : xy / xx;
            for (int n = 0; n < x.length; n++) {
                x[n] = norm == 0 ? 0 : y[n] / norm;
            }
        }
        return eigenvalue;
    }
}
