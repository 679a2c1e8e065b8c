package benchmarks;

import static particles.Systems.addGravity;
import static particles.Systems.springs;

import deSolvers.ArrayStateSource;
import deSolvers.DEStateSource;
import deSolvers.problems.Oscillator;
import java.util.function.LongSupplier;
import org.hipparchus.ode.ODEState;
import org.hipparchus.ode.OrdinaryDifferentialEquation;
import org.hipparchus.ode.nonstiff.DormandPrince853Integrator;
import particles.Cloth;
import particles.ParticleSystem;
import particles.effects.springs.SpringForce;
import particles.law.Vector3;

/**
 * A problem for benchmarks, solved repeatedly from the same start: the lecture's oscillator behind the simple
 * interface, a chain of 100 particles, or a cloth of 12 x 12, 64 x 64 or 256 x 256. The same object is our solvers'
 * source and Hipparchus' equation.
 *
 * @param name     its name
 * @param source   the equations
 * @param counter  counts evaluations of the derivative
 * @param duration the duration (s): about three periods of the oscillator, or a well-resolved swing of chain and cloth
 * @param deltaT   a step at which every solver stays stable for the duration (s)
 * @param initial  the state at the start
 */
record Workload(String name, DEStateSource source, LongSupplier counter, double duration, double deltaT,
        double[] initial) implements OrdinaryDifferentialEquation {
    /** A step at which every solver stays stable on chains and cloths (s). */
    static final double DELTA_T = 1.0 / 4096;
    private static final double STRICT = 1e-13;
    private static final double SHORTEST = 1e-12;

    private static Workload of(String name, DEStateSource source, LongSupplier counter, double duration,
            double deltaT) {
        double[] initial = new double[source.getStateSize()];
        source.getState(initial);
        return new Workload(name, source, counter, duration, deltaT, initial);
    }

    static Workload of(String name) {
        if (name.equals("oscillator")) {
            Oscillator oscillator = new Oscillator();
            return of(name, oscillator, oscillator::getEvaluations, 20, 1.0 / 16);
        }
        if (name.equals("chain")) {
            ParticleSystem chain = chain();
            return of(name, chain, chain::getEvaluations, 0.5, DELTA_T);
        }
        ParticleSystem cloth = Cloth.hanging(name.equals("cloth") ? 12 : Integer.parseInt(name.substring(6)), 50, 0);
        return of(name, cloth, cloth::getEvaluations, 0.125, DELTA_T);
    }

    /** 100 particles of 10 g on springs of 10 cm, level and pulled a little, held at both ends. */
    private static ParticleSystem chain() {
        ParticleSystem system = new ParticleSystem();
        addGravity(system);
        SpringForce springs = springs(system);
        for (int i = 0; i < 100; i++) {
            system.addParticle("c" + i, 0.01, new Vector3(0.11 * i, 0, 0), Vector3.ZERO, i == 0 || i == 99);
            if (i > 0) {
                springs.addSpring(i - 1, i, 100, 0.1, 0);
            }
        }
        return system;
    }

    /** The number of evaluations of its derivative so far. */
    long evaluations() {
        return counter.getAsLong();
    }

    ODEState start() {
        return new ODEState(0, initial);
    }

    void restart() {
        source.setState(initial);
        source.incTime(-source.getTime());
    }

    /** Stores a result of Hipparchus. */
    void end(double time, double[] state) {
        source.setState(state);
        source.incTime(time - source.getTime());
    }

    @Override
    public int getDimension() {
        return initial.length;
    }

    @Override
    public double[] computeDerivatives(double t, double[] state) {
        double[] dSdt = new double[state.length];
        source.incTime(t - source.getTime());
        if (source instanceof ArrayStateSource arrays) {        // avoids copies for Hipparchus too
            arrays.getStateDerivative(state, dSdt);
        } else {
            source.setState(state);
            source.getStateDerivative(dSdt);
        }
        return dSdt;
    }

    /** The reference solution: Hipparchus' pair of order 8 at 1e-13, which is not part of any comparison. */
    double[] reference(double time) {
        restart();
        return new DormandPrince853Integrator(SHORTEST, time, STRICT, STRICT).integrate(this, start(),
                time).getPrimaryState();
    }

    /** The largest deviation of an entry of the state, relative to the largest entry. */
    double error(double[] reference) {
        double[] state = new double[initial.length];
        source.getState(state);
        double largest = 0;
        double error = 0;
        for (int i = 0; i < state.length; i++) {
            largest = Math.max(largest, Math.abs(reference[i]));
            error = Math.max(error, Math.abs(state[i] - reference[i]));
        }
        return error / largest;
    }
}
