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
 * The checked contents of a scene file.
 *
 * @param source       the file, as the user named it
 * @param title        the title of the scene
 * @param teaches      the lesson of the scene
 * @param solver       the name of the solver
 * @param tolerances   its tolerances, if the scene gives them
 * @param deltaT       the time step (s)
 * @param duration     the duration of the run (s)
 * @param particles    the single particles, first in the state
 * @param shapes       the shapes, whose particles follow
 * @param springs      the springs outside shapes
 * @param constraints  its rods and wires
 * @param effects      the effects it names
 * @param rules        the rules it names
 * @param exactImpacts whether steps are split at impacts
 * @param camera       the camera, if it gives one
 * @param look         the render options
 * @param output       the files to write
 * @param blowUpFactor the factor by which the kinetic energy may exceed the energy estimated for the scene
 * @param threads      the number of threads that evaluate forces, if given
 * @param places       the places of solver, deltaT and duration
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
     * Returns the same scene with another solver, step and duration.
     *
     * @param otherSolver     a solver's name
     * @param otherTolerances its tolerances; only for adaptive solvers
     * @param otherDeltaT     the time step (s)
     * @param otherDuration   the duration of the run (s)
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

    /**
     * The number of particles at a time, if no rule removes any.
     *
     * @param time the time since the start (s)
     * @return the number of the scene's own particles plus those from its emitters that are still alive
     */
    public double particlesAfter(double time) {
        double count = particles.size();
        for (ShapeDescription shape : shapes) {
            count += shape.lattice().size();
        }
        return count + rules.stream().mapToDouble(rule -> rule.kind().alive(rule.values(), deltaT, time)).sum();
    }
}
