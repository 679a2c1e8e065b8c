package particles.app.run;

import particles.Motion;
import particles.Observer;
import particles.SimulationException;
import particles.experiments.runs.Extent;
import particles.output.raster.CameraFraming;
import particles.scene.Scene;
import particles.scene.SceneBuilder;
import particles.scene.format.Overrides;
import particles.scene.format.SceneDescription;
import particles.view.Camera;

/**
 * A camera for scenes that give none: as near as it can be with everything in the picture. Where things go is found by
 * a rehearsal, a run of its own that nobody else sees.
 */
final class CameraFinder {
    /**
     * A rehearsal makes no more steps than this, times particles: it shows where things go, and a second or two is
     * enough.
     */
    private static final double MOST_PARTICLE_STEPS = 3e6;
    /** A run that gains more than this, times its energy scale, is on its way to blow up, and leaves any picture. */
    private static final double MOST_ENERGY = 20;

    private CameraFinder() {
    }

    /**
     * @param scene     a scene that is ready to run; it is not run here
     * @param described what its file says
     * @param overrides what goes before it
     * @return the scene's own camera, or one that suits it
     */
    static Camera find(Scene scene, SceneDescription described, Overrides overrides) {
        return scene.camera().orElseGet(() -> {
            Extent extent = rehearse(SceneBuilder.build(described, overrides));
            return CameraFraming.around(extent.low(), extent.high(),
                    (double) scene.output().width() / scene.output().height());
        });
    }

    private static Extent rehearse(Scene copy) {
        Extent extent = new Extent();
        copy.simulation().addObserver(new Limits(copy));
        copy.simulation().addObserver(extent);
        try {
            copy.simulation().run();
        } catch (SimulationException | StoppedException e) {
            return extent;          // what was seen until then is what there is to see; the run itself says why
        }
        return extent;
    }

    /** Ends a rehearsal that has lasted long enough, or leaves every picture, before that is seen. */
    private static final class Limits implements Observer {
        private final double mostEnergy;
        private double stepsLeft;

        Limits(Scene scene) {
            mostEnergy = MOST_ENERGY * scene.energyScale();
            stepsLeft = MOST_PARTICLE_STEPS / scene.system().getParticles().count();
        }

        @Override
        public void moved(Motion motion) {
            if (stepsLeft-- < 0 || motion.getSystem().getKineticEnergy(motion.getEndState()) > mostEnergy) {
                throw new StoppedException();
            }
        }
    }
}
