package particles.effects;

import deSolvers.ForceDerivatives;
import java.util.ArrayList;
import java.util.BitSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import particles.effects.springs.SpringForce;
import particles.law.BriefForce;
import particles.law.DifferentiableEffect;
import particles.law.Particles;
import particles.law.Require;
import particles.law.Vector3;

/**
 * Muscles: springs whose rest length varies,
 * <pre>
 *   l(t) = l (1 + a sin(2 pi (t/T + phase)))
 * </pre>
 * a the amplitude, T the period. Where the phase falls by s/lambda along a body, a wave of length lambda runs that way.
 * The amplitude may rise from 0 in the first periods, as u&sup3; (10 - 15 u + 6 u&sup2;), so that nothing jumps.
 *
 * <p>The springs' own force has l, so this law adds the difference: with the spring's direction u from its first end i
 * to the other, F_i = -k (l(t) - l) u and F_j = -F_i. A spring that tears, or dies with a particle, takes its muscle
 * with it; strain, for tearing and for colours, is measured from l. Both laws together store k (|r| - l(t))&sup2;/2;
 * this law's share is what the springs' lacks. A muscle that shortens under tension does work: its driven power is -k
 * (|r| - l(t)) dl/dt.
 *
 * <p>Source: G. Miller, "The motion dynamics of snakes and worms", SIGGRAPH 1988.
 */
public final class Muscles implements DifferentiableEffect, BriefForce {
    private final SpringForce springs;
    private final double period;
    private final double rise;
    private final BitSet driven = new BitSet();          // the springs that are muscles
    private List<Muscle> muscles = new ArrayList<>();

    /** A spring, a cos(2 pi phase) and a sin(2 pi phase). */
    private record Muscle(int spring, double cos, double sin) {
    }

    /** What all muscles have in common: sin(2 pi t/T) and cos(2 pi t/T), both times the risen part, or their rates. */
    private record Beat(double sin, double cos) {
        /** (l(t) - l)/l of a muscle, or its rate. */
        double of(Muscle muscle) {
            return sin * muscle.cos + cos * muscle.sin;
        }
    }

    /**
     * @param springs the springs
     * @param period  T (s), positive
     * @param rise    the number of periods in which the amplitude rises from 0; 0 for none
     * @throws IllegalArgumentException if a number is out of its range
     */
    public Muscles(SpringForce springs, double period, double rise) {
        this.springs = springs;
        this.period = Require.positive("a muscle's period", period);
        this.rise = period * Require.notNegative("the rise of a muscle's amplitude", rise);
        springs.onReorder(this::follow);
    }

    /**
     * Makes a spring a muscle, which it is not yet.
     *
     * @param spring    its index
     * @param amplitude a, from 0 to 1
     * @param phase     in periods
     */
    public void add(int spring, double amplitude, double phase) {
        double angle = 2 * Math.PI * phase;
        muscles.add(new Muscle(spring, amplitude * StrictMath.cos(angle), amplitude * StrictMath.sin(angle)));
        driven.set(spring);
    }

    /** @return whether a spring is a muscle */
    boolean hasMuscle(int spring) {
        return driven.get(spring);
    }

    /** Follows the springs to their new places, {@code order[place]} being the old one. */
    private void follow(int[] order) {
        Map<Integer, Muscle> before = new TreeMap<>();
        muscles.forEach(muscle -> before.put(muscle.spring, muscle));
        muscles = new ArrayList<>();
        driven.clear();
        for (int place = 0; place < order.length; place++) {
            Muscle muscle = before.get(order[place]);
            if (muscle != null) {
                muscles.add(new Muscle(place, muscle.cos, muscle.sin));
                driven.set(place);
            }
        }
    }

    @Override
    public String getName() {
        return "muscles";
    }

    @Override
    public Set<Trait> getTraits() {
        return Set.of(Trait.INTERNAL, Trait.TRANSLATION_INVARIANT, Trait.ROTATION_INVARIANT, Trait.DRIVING);
    }

    @Override
    public boolean dependsOnVelocity() {
        return false;
    }

    /** {@inheritDoc} The period. */
    @Override
    public double getShortestTime(double[] state, double time) {
        return !muscles.isEmpty() ? period : Double.POSITIVE_INFINITY;
    }

    private Beat beat(double time) {
        double angle = 2 * Math.PI * time / period;
        double risen = risen(time);
        return new Beat(risen * StrictMath.sin(angle), risen * StrictMath.cos(angle));
    }

    /** d/dt of the beat (1/s). */
    private Beat rate(double time) {
        double omega = 2 * Math.PI / period;
        double sin = StrictMath.sin(omega * time);
        double cos = StrictMath.cos(omega * time);
        double risen = omega * risen(time);
        double u = rise > 0 ? time / rise : 1;
        double rising = u > 0 && u < 1 ? 30 * u * u * (1 - u) * (1 - u) / rise : 0;
        return new Beat(rising * sin + risen * cos, rising * cos - risen * sin);
    }

    /** The part of its amplitude that a muscle has reached. */
    private double risen(double time) {
        double u = rise > 0 ? Math.max(0, time / rise) : 1;
        return u < 1 ? u * u * u * (10 + u * (6 * u - 15)) : 1;
    }

    /** k (l(t) - l) u, 0 where the spring has no direction. */
    private Vector3 push(Muscle muscle, Beat beat, double[] state) {
        int s = muscle.spring;
        double length = springs.length(state, s);
        return length == 0 ? Vector3.ZERO
                : Vector3.at(state, end(s)).minus(Vector3.at(state, start(s))).over(length)
                        .times(springs.stiffness(s) * springs.restLength(s) * beat.of(muscle));
    }

    private int start(int spring) {
        return Particles.STRIDE * springs.from(spring);
    }

    private int end(int spring) {
        return Particles.STRIDE * springs.to(spring);
    }

    @Override
    public void addForces(double[] state, double time, double[] force) {
        Beat beat = beat(time);
        for (Muscle muscle : muscles) {
            Vector3 push = push(muscle, beat, state);
            int i = start(muscle.spring) + 3;
            int j = end(muscle.spring) + 3;
            Vector3.at(force, i).minus(push).put(force, i);
            Vector3.at(force, j).plus(push).put(force, j);
        }
    }

    /** {@inheritDoc} dF_i/dx_i = k (l(t) - l)/|r| (1 - u u<sup>T</sup>). */
    @Override
    public void addForceDerivatives(double[] state, double time, ForceDerivatives derivatives) {
        Beat beat = beat(time);
        double[] dFdX = new double[9];
        double[] dFdV = new double[9];
        double[] u = new double[3];
        for (Muscle muscle : muscles) {
            int s = muscle.spring;
            double length = springs.length(state, s);
            if (length > 0) {
                Vector3.at(state, end(s)).minus(Vector3.at(state, start(s))).over(length).put(u, 0);
                double across = springs.stiffness(s) * springs.restLength(s) * beat.of(muscle) / length;
                for (int e = 0; e < 9; e++) {
                    dFdX[e] = across * ((e % 4 == 0 ? 1 : 0) - u[e / 3] * u[e % 3]);
                }
                derivatives.addPair(springs.from(s), springs.to(s), dFdX, dFdV);
            }
        }
    }

    /** {@inheritDoc} k (|r| - l(t))&sup2;/2 - k (|r| - l)&sup2;/2. */
    @Override
    public double getPotentialEnergy(double[] state, double time) {
        Beat beat = beat(time);
        double energy = 0;
        for (Muscle muscle : muscles) {
            int s = muscle.spring;
            double longer = springs.restLength(s) * beat.of(muscle);
            energy += springs.stiffness(s) * longer * (longer / 2 - springs.length(state, s) + springs.restLength(s));
        }
        return energy;
    }

    @Override
    public double getDrivenPower(double[] state, double time) {
        Beat beat = beat(time);
        Beat rate = rate(time);
        double power = 0;
        for (Muscle muscle : muscles) {
            int s = muscle.spring;
            double stretch = springs.length(state, s) - springs.restLength(s) * (1 + beat.of(muscle));
            power -= springs.stiffness(s) * stretch * springs.restLength(s) * rate.of(muscle);
        }
        return power;
    }
}
