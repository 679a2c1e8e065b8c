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
 * A scene that is built and ready to run.
 *
 * @param description the contents of its file, with options applied
 * @param simulation  the simulation; it can be run once
 * @param system      the particles and forces
 * @param solver      the solver
 * @param springs     its springs, maybe none
 * @param scenery     surfaces, planes, spheres and wires to draw
 * @param camera      the camera; empty if it is to be fitted to the motion
 * @param look        the render options
 * @param output      the files to write
 * @param phase       the phase-space plot, if the scene has one
 * @param energyEstimate the estimated energy (J); a run whose kinetic energy exceeds {@code blowUpFactor} times this
 *                    value is ended
 */
public record Scene(SceneDescription description, Simulation simulation, ParticleSystem system, DESolver solver,
                    SpringView springs, Scenery scenery, Optional<Camera> camera, RenderOptions look,
                    OutputDescription output, Optional<Phase> phase, double energyEstimate) {

    /**
     * The coordinate shown by the phase-space plot.
     *
     * @param particle the index of the particle
     * @param axis     0 for x, 1 for y, 2 for z, 3 for the angle about another particle
     * @param about    the id of that other particle
     */
    public record Phase(int particle, int axis, Optional<String> about) {
    }
}
