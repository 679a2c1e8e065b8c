package particles.scene;

import deSolvers.DESolver;
import java.util.Optional;
import particles.ParticleSystem;
import particles.Simulation;
import particles.scene.format.OutputDescription;
import particles.scene.format.SceneDescription;
import particles.view.Camera;
import particles.view.RenderOptions;
import particles.view.Scenery;
import particles.view.SpringView;

/**
 * A scene, ready to run.
 *
 * @param description what its file says, with what was overridden
 * @param simulation  to be run once, with whatever observers are added
 * @param system      what moves
 * @param solver      what moves it
 * @param springs     its springs; none, if it has none
 * @param scenery     what there is to be drawn beside particles and springs
 * @param camera      the camera; none if it is to be found by what there is to see
 * @param look        how it is drawn
 * @param output      what is written
 * @param phase       what the phase-space plot shows, if the scene wants one
 * @param energyScale how much energy of motion is to be expected (J); {@code blowUpFactor} times that ends the run
 */
public record Scene(SceneDescription description, Simulation simulation, ParticleSystem system, DESolver solver,
                    SpringView springs, Scenery scenery, Optional<Camera> camera, RenderOptions look,
                    OutputDescription output, Optional<Phase> phase, double energyScale) {

    /**
     * What the phase-space plot shows.
     *
     * @param particle the index of the particle
     * @param axis     0 for x, 1 for y, 2 for z
     */
    public record Phase(int particle, int axis) {
    }
}
