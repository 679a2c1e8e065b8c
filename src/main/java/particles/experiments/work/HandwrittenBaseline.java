package particles.experiments.work;

import deSolvers.ArrayStateSource;
import java.util.Arrays;
import java.util.Comparator;
import java.util.stream.IntStream;
import particles.ParticleSystem;
import particles.law.Particles;
import particles.view.SpringView;

/**
 * A mass-spring system written out by hand, without effects, reactions, or any choice at all: the fastest code known to
 * us for springs alone, as a baseline for {@link ParticleSystem}. It has the same layout, the same law and the same
 * results up to round-off.
 *
 * <p>Each spring belongs to the one of its particles with the lower index. Particles are taken in order: the numbers of
 * the first end stay in registers for all its springs, and after these no other spring acts on it, so that its
 * derivative is completed in the same pass.
 */
final class HandwrittenBaseline implements ArrayStateSource {
    private static final int STRIDE = Particles.STRIDE;

    // springs sorted by their first end; where the numbers of both ends begin in the state
    private final int[] from;
    private final int[] to;
    private final double[] stiffness;
    private final double[] restLength;
    private final double[] damping;
    private final double[] inverseMass;
    private final double[] state;
    private double time;

    HandwrittenBaseline(ParticleSystem like, SpringView springs) {
        int[] order = IntStream.range(0, springs.springCount()).boxed()
                .sorted(Comparator.<Integer>comparingInt(s -> Math.min(springs.from(s), springs.to(s)))
                        .thenComparingInt(s -> Math.max(springs.from(s), springs.to(s))))
                .mapToInt(Integer::intValue).toArray();
        from = Arrays.stream(order).map(s -> STRIDE * Math.min(springs.from(s), springs.to(s))).toArray();
        to = Arrays.stream(order).map(s -> STRIDE * Math.max(springs.from(s), springs.to(s))).toArray();
        stiffness = Arrays.stream(order).mapToDouble(springs::stiffness).toArray();
        restLength = Arrays.stream(order).mapToDouble(springs::restLength).toArray();
        damping = Arrays.stream(order).mapToDouble(springs::damping).toArray();
        state = Arrays.copyOf(like.getOwnState(), like.getStateSize());
        inverseMass = Arrays.copyOf(like.getParticles().getInverseMasses(), like.getParticles().count());
    }

    @Override
    public void getStateDerivative(double[] dSdt) {
        getStateDerivative(state, dSdt);
    }

    @Override
    public void getStateDerivative(double[] state, double[] dSdt) {
        Arrays.fill(dSdt, 0);
        for (int p = 0, s = 0; p < inverseMass.length; p++) {
            int i = STRIDE * p;
            double x = state[i];
            double y = state[i + 1];
            double z = state[i + 2];
            double vx = state[i + 3];
            double vy = state[i + 4];
            double vz = state[i + 5];
            double fx = dSdt[i + 3];
            double fy = dSdt[i + 4];
            double fz = dSdt[i + 5];
            for (; s < from.length && from[s] == i; s++) {
                int j = to[s];
                double rx = state[j] - x;
                double ry = state[j + 1] - y;
                double rz = state[j + 2] - z;
                double length = Math.sqrt(Math.fma(rx, rx, Math.fma(ry, ry, rz * rz)));
                double stretching = Math.fma(rx, state[j + 3] - vx,
                        Math.fma(ry, state[j + 4] - vy, rz * (state[j + 5] - vz)));
                double inverse = 1 / length;
                double perLength = Math.fma(damping[s] * stretching, inverse, stiffness[s] * (length - restLength[s]))
                        * inverse;
                fx = Math.fma(perLength, rx, fx);
                fy = Math.fma(perLength, ry, fy);
                fz = Math.fma(perLength, rz, fz);
                dSdt[j + 3] = Math.fma(-perLength, rx, dSdt[j + 3]);
                dSdt[j + 4] = Math.fma(-perLength, ry, dSdt[j + 4]);
                dSdt[j + 5] = Math.fma(-perLength, rz, dSdt[j + 5]);
            }
            dSdt[i] = vx;
            dSdt[i + 1] = vy;
            dSdt[i + 2] = vz;
            dSdt[i + 3] = fx * inverseMass[p];
            dSdt[i + 4] = fy * inverseMass[p];
            dSdt[i + 5] = fz * inverseMass[p];
        }
    }

    @Override
    public int getStateSize() {
        return state.length;
    }

    @Override
    public void getState(double[] state) {
        System.arraycopy(this.state, 0, state, 0, state.length);
    }

    @Override
    public void setState(double[] state) {
        System.arraycopy(state, 0, this.state, 0, state.length);
    }

    @Override
    public double[] getStateArray() {
        return state;
    }

    @Override
    public double getTime() {
        return time;
    }

    @Override
    public void incTime(double deltaT) {
        time += deltaT;
    }
}
