package particles.scene;

import particles.ParticleSystem;
import particles.Simulation;
import particles.scene.format.SceneDescription;
import particles.scene.format.SceneFormat;
import particles.view.Scenery;
import particles.view.SpringView;

/**
 * A scene that is built and ready to run.
 *
 * @param description what it was built from
 * @param simulation  the simulation; it can be run once
 * @param springs     its springs, maybe none
 * @param scenery     surfaces, planes, spheres and wires to draw
 * @param energyEstimate the estimated energy (J)
 */
public record Scene(SceneDescription description, Simulation simulation, SpringView springs, Scenery scenery,
        double energyEstimate) {

    /** @return the kinetic energy above which the run counts as blown up and is ended (J) */
    public double energyLimit() {
        return description.values().get(SceneFormat.BLOW_UP_FACTOR) * energyEstimate;
    }

    /** @return the particles and forces */
    public ParticleSystem system() {
        return simulation.getSystem();
    }
}
