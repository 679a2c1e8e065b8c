package particles.app.student;

import deSolvers.DESolver;
import java.security.SecureRandom;
import java.util.Arrays;
import java.util.function.Consumer;
import java.util.function.Function;
import java.util.function.IntFunction;
import java.util.function.Supplier;
import java.util.stream.IntStream;
import particles.ParticleSystem;
import particles.Simulation;
import particles.effects.springs.SpringForce;
import particles.law.Effect;
import particles.law.Particles;
import particles.law.Vector3;
import particles.teaching.GuardedRun;
import particles.teaching.effects.EffectSample;

/** Runs a class for longer than the check does, and without it, to see whether it still computes the same. */
final class PlainRuns {
    private static final int FEWEST = 50;
    private static final int MOST = 100;
    private static final int STEPS = 200;
    private static final double DELTA_T = 0.01;
    /** Two-step Adams-Bashforth, begun anew with a step of Euler, is off by up to 3e-4 of the motion. */
    private static final double RESTARTED = 3e-3;

    private PlainRuns() {
    }

    /** A block on a spring, as in a scene. */
    private static ParticleSystem spring() {
        ParticleSystem system = new ParticleSystem();
        int wall = system.addParticle("wall", 1, new Vector3(-4, 0, 0), Vector3.ZERO, true);
        int block = system.addParticle("block", 1, new Vector3(1, 0, 0), Vector3.ZERO, false);
        SpringForce spring = new SpringForce(system.getParticles());
        spring.addSpring(wall, block, 5, 4, 0);
        system.addEffect(spring);
        return system;
    }

    /** The state after some steps, and after the last 200. */
    private static double[][] steps(ParticleSystem system, DESolver solver, int steps) {
        Simulation run = new Simulation(system, () -> solver, DELTA_T, steps * DELTA_T);
        double[] before = system.getOwnState().clone();
        run.start();
        for (int done = 0; !run.isOver(); done++) {
            before = done == steps - STEPS ? system.getOwnState().clone() : before;
            run.advance();
            GuardedRun.goesOn();
        }
        return new double[][] {before, system.getOwnState()};
    }

    /**
     * Makes 200 steps from a start that is always the same, with a solver that has run before, and was reset.
     *
     * @param maker  makes the solver
     * @param before how long it has run before, in 200 steps without a reset
     * @return the state at the end; nothing if the steps before were not those of a new solver from there
     */
    static double[] solver(Supplier<DESolver> maker, int before) {
        DESolver solver = maker.get();
        if (before > 0) {
            double[][] late = steps(spring(), solver, before * STEPS);
            ParticleSystem again = spring();
            again.setState(late[0]);
            double[] end = steps(again, maker.get(), STEPS)[1];
            if (!(distance(end, late[1]) <= RESTARTED * distance(late[0], late[1]))) {
                return new double[0];
            }
        }
        solver.reset();
        return steps(spring(), solver, STEPS)[1];
    }

    private static double distance(double[] a, double[] b) {
        return IntStream.range(0, a.length).mapToDouble(i -> Math.abs(a[i] - b[i])).max().orElse(0);
    }

    /** @return the sum of an effect's forces at 200 times, which it was asked for as often as this before */
    static double[] effect(Function<Particles, Effect> law, int before) {
        double[] state = EffectSample.system().getOwnState();
        Effect effect = law.apply(EffectSample.system().getParticles());
        double[] force = {};
        for (int round = 0; round <= before; round++) {
            force = new double[state.length];
            for (int call = 0; call < STEPS; call++) {
                effect.addForces(state, call * DELTA_T, force);
                GuardedRun.goesOn();
            }
        }
        return force;
    }

    /**
     * @param check calls what it is given with the check on the stack
     * @param run   what the class computes after as many runs before
     * @return whether the result differs, in any bit, outside the check and after 10,000 to 20,000 steps or calls (a
     *         random number)
     */
    static boolean differ(Consumer<Runnable> check, IntFunction<double[]> run) {
        double[][] ends = new double[2][];              // the second one stays null if the class throws an exception
        check.accept(() -> ends[0] = run.apply(0));
        GuardedRun.await(new Thread(() -> ends[1] = run.apply(new SecureRandom().nextInt(FEWEST, MOST))));
        return !Arrays.equals(ends[0], ends[1]);
    }
}
