package particles.app.student;

import java.nio.charset.StandardCharsets;
import java.security.SecureRandom;
import java.util.Arrays;
import java.util.function.Consumer;
import java.util.function.Function;
import java.util.function.Supplier;
import particles.law.Effect;
import particles.law.Particles;
import particles.scene.Scene;
import particles.scene.SceneBuilder;
import particles.scene.SceneReader;
import particles.scene.format.SceneDescription;
import particles.teaching.GuardedRun;
import particles.teaching.effects.EffectSample;

/** Runs a class once more, to see whether it computes the same outside of the check, and after many calls. */
final class PlainRuns {
    private static final int FEWEST = 50;
    private static final int MOST = 100;
    private static final int STEPS = 200;
    private static final double DELTA_T = 0.01;
    private static final String SCENE = """
            title: A block on a spring
            teaches: Nothing.
            solver: %s
            deltaT: 0.01
            duration: 2
            particles: [{id: wall, position: [-4, 0, 0], fixed: true}, {id: block, position: [1, 0, 0]}]
            springs: [{from: wall, to: block, stiffness: 5, restLength: 4}]
            """;

    private PlainRuns() {
    }

    /** @return computes the state after 200 steps of a solver in a scene */
    static Supplier<double[]> ends(String solver) {
        SceneDescription read = SceneReader.read("the check's scene", SCENE.formatted(solver)
                .getBytes(StandardCharsets.UTF_8));
        return () -> {
            Scene scene = SceneBuilder.build(read);
            scene.simulation().start();
            while (!scene.simulation().isOver()) {
                scene.simulation().advance();
                GuardedRun.goesOn();
            }
            return scene.system().getOwnState();
        };
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
