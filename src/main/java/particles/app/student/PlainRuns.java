package particles.app.student;

import deSolvers.DESolver;
import java.nio.charset.StandardCharsets;
import java.security.SecureRandom;
import java.util.Arrays;
import java.util.function.Supplier;
import particles.scene.Scene;
import particles.scene.SceneBuilder;
import particles.scene.SceneReader;
import particles.teaching.solvers.SolverCheck;

/** Runs a solver in a scene, to see whether it makes other steps there, or after many calls, than in the check. */
final class PlainRuns {
    private static final int FEWEST = 50;
    private static final int MOST = 100;
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

    /**
     * @param solver the full name of its class, which the check has found to be right
     * @return whether the same run ends at other bits once nothing of the check is on the stack, and after 10,000 to
     *         20,000 further steps, a number that nobody knows before
     */
    static boolean differ(String solver) {
        double[][] ends = new double[2][];
        Supplier<DESolver> inTheCheck = () -> {
            ends[0] = end(solver);
            throw new IllegalStateException("the check itself is not wanted");
        };
        SolverCheck.check(inTheCheck, "Solver");
        Thread plain = new Thread(() -> {
            for (int run = new SecureRandom().nextInt(FEWEST, MOST); run > 0; run--) {
                ends[1] = end(solver);
            }
        });
        plain.setDaemon(true);
        plain.start();
        while (plain.isAlive()) {
            Thread.onSpinWait();        // a thread that waits is taken for one that waits for ever
        }
        return !Arrays.equals(ends[0], ends[1]);
    }

    private static double[] end(String solver) {
        Scene scene = SceneBuilder.build(SceneReader.read("the check's scene", SCENE.formatted(solver)
                .getBytes(StandardCharsets.UTF_8)));
        scene.simulation().run();
        return scene.system().getOwnState();
    }
}
