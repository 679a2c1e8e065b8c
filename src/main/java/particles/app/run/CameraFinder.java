package particles.app.run;

import java.util.List;
import java.util.concurrent.CancellationException;
import particles.Motion;
import particles.Observer;
import particles.ParticleSystem;
import particles.SimulationException;
import particles.energy.EnergyLedger;
import particles.law.Vector3;
import particles.scene.Scene;
import particles.scene.SceneBuilder;
import particles.scene.format.SceneDescription;
import particles.view.Camera;

/**
 * Finds a camera for scenes without one: as near as possible with everything in the picture. A rehearsal, a separate
 * run without output, shows where particles go.
 */
public final class CameraFinder {
    /**
     * The largest number of evaluations times particles of a rehearsal, about a second or two. Steps of adaptive and
     * implicit solvers may take hundreds of evaluations.
     */
    private static final double MOST_PARTICLE_EVALUATIONS = 1.2e7;
    /**
     * A run whose energy grows by more than this many times the energy scale is blowing up, unless forces did that much
     * work: the scale does not know students' own forces.
     */
    private static final double MOST_ENERGY = 20;

    /** If a run blows up, the picture shows this many times the width of the motion before. */
    private static final double GROWTH = 1.5;

    private CameraFinder() {
    }

    /**
     * @param scene what is to be run
     * @return the scene's own camera, or one that suits it
     */
    public static Camera find(SceneDescription scene) {
        return scene.drawing().camera().orElseGet(() -> {
            Box box = rehearse(SceneBuilder.build(scene));
            return Camera.around(box.low, box.high,
                    (double) scene.output().frames().width() / scene.output().frames().height());
        });
    }

    private static Box rehearse(Scene copy) {
        Extent extent = new Extent();
        Limits limits = new Limits(copy, extent);
        try {
            copy.simulation().run();
        } catch (SimulationException | CancellationException e) {
            limits.blewUp |= e instanceof SimulationException;      // the run itself reports why it ends
        }
        return limits.blewUp ? limits.beforeBlowUp : Box.of(extent, 1);
    }

    /** A box from the lowest to the highest coordinates (m). */
    private record Box(Vector3 low, Vector3 high) {
        static Box of(Extent extent, double growth) {
            Vector3 more = extent.high().minus(extent.low()).times((growth - 1) / 2);
            return new Box(extent.low().minus(more), extent.high().plus(more));
        }
    }

    /**
     * Ends a rehearsal that has lasted long enough or blown up, and records the extent as long as the motion was mostly
     * physical.
     */
    private static final class Limits implements Observer {
        private final EnergyLedger ledger = new EnergyLedger();
        private final Extent extent;
        private final double mostEnergy;
        private final double mostEvaluations;
        private Box beforeBlowUp;
        private boolean blewUp;

        /** @param extent an observer that is called before this one */
        Limits(Scene scene, Extent extent) {
            this.extent = extent;
            List.of(ledger, extent, this).forEach(scene.simulation()::addObserver);
            mostEnergy = MOST_ENERGY * scene.energyEstimate();
            mostEvaluations = MOST_PARTICLE_EVALUATIONS / scene.system().getParticles().count();
            extent.started(scene.system());
            beforeBlowUp = Box.of(extent, GROWTH);      // a run may fail before its first step
        }

        @Override
        public void moved(Motion motion) {
            ParticleSystem system = motion.getSystem();
            double[] state = motion.getEndState();
            double energy = system.getInternalEnergy(state, motion.getEndTime());
            boolean right = Math.abs(ledger.getNumericalError()) <= energy / 2;
            if (right) {
                beforeBlowUp = Box.of(extent, GROWTH);
            }
            blewUp = system.getKineticEnergy(state) > mostEnergy && !right;
            if (blewUp || system.getEvaluations() > mostEvaluations) {
                throw new CancellationException();
            }
        }
    }
}
