package particles.app.run;

import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import particles.Motion;
import particles.Observer;
import particles.app.student.StudentClasses;
import particles.law.Particles;
import particles.output.raster.CameraProjection;
import particles.scene.Scene;
import particles.scene.SceneBuilder;
import particles.scene.SceneReader;
import particles.scene.format.Overrides;
import particles.scene.format.SceneDescription;

/** Cameras for scenes that name none. */
class CameraFinderTest {
    private static final int WIDTH = 960;
    private static final int HEIGHT = 540;

    private static Scene softChain(Overrides overrides) {
        return SceneBuilder.build(described(), overrides);
    }

    private static SceneDescription described() {
        return SceneReader.read(Path.of("scenes/16-soft-chain.yaml"), new StudentClasses());
    }

    private static CameraProjection view(Overrides overrides) {
        return new CameraProjection(CameraFinder.find(softChain(overrides), described(), overrides), WIDTH, HEIGHT);
    }

    /** The height of the chain at the start, in pixels. */
    private static double size(CameraProjection view, Scene scene) {
        double[] state = scene.system().getOwnState();
        int end = scene.system().getStateSize() - Particles.STRIDE;
        return y(view, state, end) - y(view, state, 0);
    }

    private static double y(CameraProjection view, double[] state, int x) {
        return view.y(state[x], state[x + 1], state[x + 2],
                view.scale(view.depth(state[x], state[x + 1], state[x + 2])));
    }

    /** Ten pixels, when the camera was fitted to all that was seen until the energy was out of bounds. */
    @ParameterizedTest
    @ValueSource(strings = {"euler", "midpoint", "verlet", "adams"})
    void aRunThatBlowsUpIsSeenFromNearby(String solver) {
        Overrides overrides = new Overrides().with("solver", solver, "-").with("deltaT", "0.2", "-");
        double size = size(view(overrides), softChain(overrides));
        assertTrue(size > HEIGHT / 8.0, solver + " shows the chain " + size + " pixels high");
    }

    @Test
    void aRunThatDoesNotBlowUpStaysInThePicture() {
        Scene scene = softChain(new Overrides());
        CameraProjection view = view(new Overrides());
        scene.simulation().addObserver(new Observer() {
            @Override
            public void moved(Motion motion) {
                double[] state = motion.getEndState();
                for (int x = 0; x < state.length; x += Particles.STRIDE) {
                    assertTrue(view.isInPicture(state[x], state[x + 1], state[x + 2]), "t = " + motion.getEndTime());
                }
            }
        });
        scene.simulation().run();
        assertTrue(size(view, scene) < HEIGHT);
    }
}
