package particles.scene;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import particles.Camera;
import particles.Look;
import particles.scene.spec.Chosen;
import particles.scene.spec.Key;
import particles.scene.spec.Place;

/**
 * What a scene file says, checked as a whole.
 *
 * @param source       the file, as it was named
 * @param sha256       the hash of the file's bytes, in hexadecimal digits
 * @param title        what the scene shows
 * @param teaches      what one learns from it
 * @param solver       the name of the solver
 * @param deltaT       the time step (s)
 * @param duration     how long the run lasts (s)
 * @param particles    the particles that stand alone, first in the state
 * @param shapes       the shapes, whose particles follow
 * @param springs      the springs that stand alone
 * @param effects      the effects it names
 * @param rules        the rules it names
 * @param camera       the camera, if it gives one
 * @param look         how things are drawn
 * @param output       what is written
 * @param blowUpFactor by which factor the kinetic energy may exceed the scene's own energy scale
 * @param places       where the solver, deltaT and duration stand
 */
public record SceneDescription(String source, String sha256, String title, String teaches, String solver, double deltaT,
                               double duration, List<ParticleDescription> particles, List<ShapeDescription> shapes,
                               List<SpringDescription> springs, List<Chosen<EffectKind>> effects,
                                       List<Chosen<RuleKind>> rules,
                               Optional<Camera> camera, Look look, OutputDescription output, double blowUpFactor,
                               Map<Key<?>, Place> places) {

    SceneDescription with(String otherSolver, double otherDeltaT, double otherDuration, Map<Key<?>, Place> otherPlaces) {
        return new SceneDescription(source, sha256, title, teaches, otherSolver, otherDeltaT, otherDuration, particles,
                shapes,
                springs, effects, rules, camera, look, output, blowUpFactor, otherPlaces);
    }
}
