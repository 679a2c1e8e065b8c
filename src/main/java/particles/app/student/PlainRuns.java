package particles.app.student;

import deSolvers.catalog.SolverCatalog;
import java.security.SecureRandom;
import java.util.Arrays;
import java.util.function.Consumer;
import java.util.function.Function;
import java.util.function.Supplier;
import particles.ParticleSystem;
import particles.Simulation;
import particles.effects.springs.SpringForce;
import particles.law.Effect;
import particles.law.Particles;
import particles.law.Vector3;
import particles.teaching.GuardedRun;
import particles.teaching.effects.EffectSample;

/** Runs a class once more, to see whether it computes the same outside of the check, and after many calls. */
final class PlainRuns {
    private static final int FEWEST = 50;
    private static final int MOST = 100;
    private static final int STEPS = 200;
    private static final double DELTA_T = 0.01;

    private PlainRuns() {
    }

    /** @return the state after 200 steps of a solver for a block on a spring, as in a scene */
    static double[] ends(String solver) {
        ParticleSystem system = new ParticleSystem();
        int wall = system.addParticle("wall", 1, new Vector3(-4, 0, 0), Vector3.ZERO, true);
        int block = system.addParticle("block", 1, new Vector3(1, 0, 0), Vector3.ZERO, false);
        SpringForce spring = new SpringForce(system.getParticles());
        spring.addSpring(wall, block, 5, 4, 0);
        system.addEffect(spring);
        Simulation run = new Simulation(system, () -> SolverCatalog.create(solver), DELTA_T, STEPS * DELTA_T);
        run.start();
        while (!run.isOver()) {
            run.advance();
            GuardedRun.goesOn();
        }
        return system.getOwnState();
    }

    /** @return the sum of an effect's forces at 200 times */
    static double[] forces(Function<Particles, Effect> law) {
        double[] state = EffectSample.system().getOwnState();
        Effect effect = law.apply(EffectSample.system().getParticles());
        double[] force = new double[state.length];
        for (int call = 0; call < STEPS; call++) {
            effect.addForces(state, call * DELTA_T, force);
            GuardedRun.goesOn();
        }
        return force;
    }

    /**
     * @param check calls what it is given with the check on the stack
     * @param run   what the class computes, with 200 calls of it or more
     * @return whether the result differs, in any bit, when run outside the check and after 10,000 to 20,000 more calls
     *         (a random number)
     */
    static boolean differ(Consumer<Runnable> check, Supplier<double[]> run) {
        double[][] ends = new double[2][];
        check.accept(() -> ends[0] = run.get());
        GuardedRun.await(new Thread(() -> {
            for (int more = new SecureRandom().nextInt(FEWEST, MOST); more > 0; more--) {
                ends[1] = null;                         // stays so if the class throws an exception
                ends[1] = run.get();
            }
        }));
        return !Arrays.equals(ends[0], ends[1]);
    }
}
