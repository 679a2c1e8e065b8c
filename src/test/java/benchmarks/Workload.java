package benchmarks;

import deSolvers.ArrayStateSource;
import deSolvers.DEStateSource;
import deSolvers.problems.Oscillator;
import java.util.List;
import java.util.NoSuchElementException;
import java.util.function.LongSupplier;
import org.hipparchus.ode.ODEState;
import org.hipparchus.ode.OrdinaryDifferentialEquation;
import org.hipparchus.ode.nonstiff.DormandPrince853Integrator;
import particles.Cloth;
import particles.ParticleSystem;
import particles.Systems;
import particles.effects.Gravity;
import particles.effects.springs.SpringForce;
import particles.law.Vector3;

/**
 * A problem for benchmarks, solved repeatedly from the same start: the lecture's oscillator behind the simple
 * interface, a chain of 100 particles, or a cloth of 12 x 12, 64 x 64 or 256 x 256. The same object is our solvers'
 * source and Hipparchus' equation.
 */
final class Workload implements OrdinaryDifferentialEquation {
    static final List<String> NAMES = List.of("oscillator", "chain", "cloth");
    /** A step at which every solver stays stable on chains and cloths (s). */
    static final double DELTA_T = 1.0 / 4096;
    private static final double STRICT = 1e-13;
    private static final double SHORTEST = 1e-12;

    private final String name;
    private final DEStateSource source;
    private final LongSupplier evaluations;
    private final double[] start;
    /** The duration (s): about three periods of the oscillator, or a well-resolved swing of chain and cloth. */
    private final double duration;
    /** A step at which every solver stays stable for the duration (s). */
    private final double deltaT;

    private Workload(String name, DEStateSource source, LongSupplier evaluations, double duration, double deltaT) {
        this.name = name;
        this.source = source;
        this.evaluations = evaluations;
        this.duration = duration;
        this.deltaT = deltaT;
        start = new double[source.getStateSize()];
        source.getState(start);
    }

    static Workload of(String name) {
        switch (name) {
            case "oscillator":
                Oscillator oscillator = new Oscillator();
                return new Workload(name, oscillator, oscillator::getEvaluations, 20, 1.0 / 16);
            case "chain":
                ParticleSystem chain = chain();
                return new Workload(name, chain, chain::getEvaluations, 0.5, DELTA_T);
            case "cloth":
            case "cloth-64":
            case "cloth-256":
                int n = name.equals("cloth") ? 12 : Integer.parseInt(name.substring(6));
                ParticleSystem cloth = Cloth.hanging(n, 50, 0);
                return new Workload(name, cloth, cloth::getEvaluations, 0.125, DELTA_T);
            default:
                throw new NoSuchElementException("no workload is called '" + name + "'");
        }
    }

    /** 100 particles of 10 g on springs of 10 cm, level and pulled a little, held at both ends. */
    private static ParticleSystem chain() {
        ParticleSystem system = new ParticleSystem();
        SpringForce springs = new SpringForce(system.getParticles());
        for (int i = 0; i < 100; i++) {
            system.addParticle("c" + i, 0.01, new Vector3(0.11 * i, 0, 0), Vector3.ZERO, i == 0 || i == 99);
            if (i > 0) {
                springs.addSpring(i - 1, i, 100, 0.1, 0);
            }
        }
        system.addEffect(new Gravity(system.getParticles(), Systems.GRAVITY));
        system.addEffect(springs);
        return system;
    }

    String name() {
        return name;
    }

    DEStateSource source() {
        return source;
    }

    double duration() {
        return duration;
    }

    double deltaT() {
        return deltaT;
    }

    /** The number of evaluations of its derivative so far. */
    long evaluations() {
        return evaluations.getAsLong();
    }

    ODEState start() {
        return new ODEState(0, start);
    }

    void restart() {
        source.setState(start);
        source.incTime(-source.getTime());
    }

    /** Stores a result of Hipparchus. */
    void end(double time, double[] state) {
        source.setState(state);
        source.incTime(time - source.getTime());
    }

    @Override
    public int getDimension() {
        return start.length;
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
        double[] state = new double[start.length];
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
