package particles.scene.format;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import particles.effects.EffectKind;
import particles.scene.parts.ConstraintDescription;
import particles.scene.parts.ParticleDescription;
import particles.scene.parts.RuleKind;
import particles.scene.parts.ShapeDescription;
import particles.scene.parts.SpringDescription;
import particles.spec.Chosen;
import particles.spec.Key;
import particles.spec.messages.Place;
import particles.view.Camera;
import particles.view.RenderOptions;

/**
 * What a scene file says, checked as a whole.
 *
 * @param source       the file, as it was named
 * @param title        what the scene shows
 * @param teaches      what one learns from it
 * @param solver       the name of the solver
 * @param tolerances   what it is allowed, if the scene says so
 * @param deltaT       the time step (s)
 * @param duration     how long the run lasts (s)
 * @param particles    the particles that stand alone, first in the state
 * @param shapes       the shapes, whose particles follow
 * @param springs      the springs that stand alone
 * @param constraints  its rods and wires
 * @param effects      the effects it names
 * @param rules        the rules it names
 * @param exactImpacts whether steps are divided at impacts
 * @param camera       the camera, if it gives one
 * @param look         how things are drawn
 * @param output       what is written
 * @param blowUpFactor by which factor the kinetic energy may exceed the scene's own energy scale
 * @param threads      how many threads may evaluate forces, if it says so
 * @param places       where the solver, deltaT and duration stand
 */
public record SceneDescription(String source, String title, String teaches, String solver,
                               Optional<Tolerances> tolerances, double deltaT, double duration,
                                       List<ParticleDescription> particles, List<ShapeDescription> shapes,
                               List<SpringDescription> springs, ConstraintDescription constraints,
                                       List<Chosen<EffectKind>> effects,
                                       List<Chosen<RuleKind>> rules,
                               boolean exactImpacts, Optional<Camera> camera, RenderOptions look,
                               OutputDescription output,
                                       double blowUpFactor, Optional<Integer> threads,
                               Map<Key<?>, Place> places) {

    /**
     * The same scene, solved otherwise.
     *
     * @param otherSolver     a solver's name
     * @param otherTolerances what it is allowed; only for those that are adaptive
     * @param otherDeltaT     the time step (s)
     * @param otherDuration   how long the run lasts (s)
     * @return the description; the scene builder checks it
     */
    public SceneDescription solvedBy(String otherSolver, Optional<Tolerances> otherTolerances, double otherDeltaT,
            double otherDuration) {
        return with(otherSolver, otherTolerances, otherDeltaT, otherDuration, threads, places);
    }

    SceneDescription with(String otherSolver, Optional<Tolerances> otherTolerances, double otherDeltaT,
            double otherDuration, Optional<Integer> otherThreads, Map<Key<?>, Place> otherPlaces) {
        return new SceneDescription(source, title, teaches, otherSolver, otherTolerances,
                otherDeltaT, otherDuration, particles,
                shapes,
                springs, constraints, effects, rules, exactImpacts, camera, look,
                output, blowUpFactor, otherThreads, otherPlaces);
    }
}
