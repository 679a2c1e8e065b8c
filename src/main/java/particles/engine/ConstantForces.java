package particles.engine;

import java.util.Arrays;
import particles.law.ConstantForce;
import particles.law.Particles;

/** The sum of constant forces, kept until particles are added or removed. */
final class ConstantForces {
    private static final int STRIDE = Particles.STRIDE;

    private final Particles particles;
    private ConstantForce[] effects = {};
    private boolean known;
    private long version;                               // of the particles for which the sum is known
    private double[] sum = {};                          // (0, F) of each particle

    ConstantForces(Particles particles) {
        this.particles = particles;
    }

    void add(ConstantForce effect) {
        effects = Arrays.copyOf(effects, effects.length + 1);
        effects[effects.length - 1] = effect;
        known = false;
    }

    /** Computes the sum again if particles have changed. */
    void update(double[] state, double time) {
        if (!known || version != particles.getVersion()) {
            addUp(state, time);
        }
    }

    private void addUp(double[] state, double time) {
        int n = particles.count();
        if (sum.length < STRIDE * n) {
            sum = new double[STRIDE * (n + n / 3)];
        }
        Arrays.fill(sum, 0);
        for (ConstantForce effect : effects) {
            effect.addForces(state, time, sum, 0, n);
        }
        known = true;
        version = particles.getVersion();
    }

    /** Writes (factor v, F) of these particles, F being the constant forces. */
    void put(double[] state, double factor, double[] dSdt, int from, int to) {
        double[] sum = this.sum;
        for (int x = STRIDE * from; x < STRIDE * to; x += STRIDE) {
            double vx = state[x + 3];
            double vy = state[x + 4];
            double vz = state[x + 5];
            dSdt[x] = factor * vx;
            dSdt[x + 1] = factor * vy;
            dSdt[x + 2] = factor * vz;
            dSdt[x + 3] = sum[x + 3];
            dSdt[x + 4] = sum[x + 4];
            dSdt[x + 5] = sum[x + 5];
        }
    }
}
