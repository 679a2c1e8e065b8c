package particles.experiments.work;

import deSolvers.ArrayStateSource;
import java.util.Arrays;
import particles.ParticleSystem;
import particles.law.Particles;
import particles.view.SpringView;

/**
 * A mass-spring system written out by hand, without effects, reactions, or any choice at all: what a system costs that
 * knows of nothing but springs, to hold {@link ParticleSystem} against. Same layout, same law, the same numbers but for
 * rounding.
 */
final class HandwrittenBaseline implements ArrayStateSource {
    private static final int STRIDE = Particles.STRIDE;

    private final int[] from;
    private final int[] to;
    private final double[] stiffness;
    private final double[] restLength;
    private final double[] damping;
    private final double[] inverseMass;
    private double[] state;
    private double time;

    HandwrittenBaseline(ParticleSystem like, SpringView springs) {
        int count = springs.springCount();
        from = new int[count];
        to = new int[count];
        stiffness = new double[count];
        restLength = new double[count];
        damping = new double[count];
        for (int s = 0; s < count; s++) {
            from[s] = STRIDE * springs.from(s);
            to[s] = STRIDE * springs.to(s);
            stiffness[s] = springs.stiffness(s);
            restLength[s] = springs.restLength(s);
            damping[s] = springs.damping(s);
        }
        state = Arrays.copyOf(like.getOwnState(), like.getStateSize());
        inverseMass = Arrays.copyOf(like.getParticles().inverseMasses(), like.getParticles().count());
    }

    @Override
    public void getStateDerivative(double[] dSdt) {
        getStateDerivative(state, dSdt);
    }

    @Override
    public void getStateDerivative(double[] state, double[] dSdt) {
        Arrays.fill(dSdt, 0);
        for (int s = 0; s < from.length; s++) {
            int i = from[s];
            int j = to[s];
            double rx = state[j] - state[i];
            double ry = state[j + 1] - state[i + 1];
            double rz = state[j + 2] - state[i + 2];
            double inverse = 1 / Math.sqrt(rx * rx + ry * ry + rz * rz);
            double stretching = rx * (state[j + 3] - state[i + 3]) + ry * (state[j + 4] - state[i + 4])
                    + rz * (state[j + 5] - state[i + 5]);
            double perLength = stiffness[s] * (1 - restLength[s] * inverse)
                    + damping[s] * stretching * inverse * inverse;
            double fx = perLength * rx;
            double fy = perLength * ry;
            double fz = perLength * rz;
            dSdt[i + 3] += fx;
            dSdt[i + 4] += fy;
            dSdt[i + 5] += fz;
            dSdt[j + 3] -= fx;
            dSdt[j + 4] -= fy;
            dSdt[j + 5] -= fz;
        }
        for (int i = 0, x = 0; i < inverseMass.length; i++, x += STRIDE) {
            for (int c = x; c < x + 3; c++) {
                dSdt[c] = state[c + 3];
                dSdt[c + 3] *= inverseMass[i];
            }
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
    public double[] exchangeState(double[] state) {
        double[] before = this.state;
        this.state = state;
        return before;
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
