package particles.scene.format;

import java.util.HashMap;
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
 * The checked contents of a scene file, with options in place of the file's values.
 *
 * @param lesson   what the scene is about
 * @param settings how it is solved
 * @param contents what moves, and by which laws
 * @param drawing  how it is drawn
 * @param output   the files to write
 * @param places   the places of solver, deltaT, duration and shapes, for messages
 */
public record SceneDescription(Lesson lesson, Settings settings, Contents contents, Drawing drawing,
        OutputDescription output, Map<Key<?>, Place> places) {

    /**
     * What a scene is about.
     *
     * @param title   a few words
     * @param teaches a sentence or two
     */
    public record Lesson(String title, String teaches) {
    }

    /**
     * How a scene is solved.
     *
     * @param solver       the solver
     * @param deltaT       the time step (s)
     * @param duration     the duration of the run (s)
     * @param exactImpacts whether steps are split at impacts
     * @param threads      the number of threads that evaluate forces, if given
     * @param blowUpFactor the factor by which the kinetic energy may exceed the energy estimated for the scene
     */
    public record Settings(SolverDescription solver, double deltaT, double duration, boolean exactImpacts,
            Optional<Integer> threads, double blowUpFactor) {
    }

    /**
     * What moves, and by which laws.
     *
     * @param particles   the single particles, first in the state
     * @param shapes      the shapes, whose particles follow
     * @param springs     the springs outside shapes
     * @param constraints the rods and wires
     * @param effects     the effects that the scene names
     * @param rules       the rules that it names
     */
    public record Contents(List<ParticleDescription> particles, List<ShapeDescription> shapes,
            List<SpringDescription> springs, ConstraintDescription constraints, List<Chosen<EffectKind>> effects,
            List<Chosen<RuleKind>> rules) {
    }

    /**
     * How a scene is drawn.
     *
     * @param camera the camera; empty if it is to be fitted to the motion
     * @param look   the render options
     */
    public record Drawing(Optional<Camera> camera, RenderOptions look) {
    }

    /** @return the title */
    public String title() {
        return lesson.title;
    }

    /** @return the name of the solver */
    public String solver() {
        return settings.solver.name();
    }

    /** @return the time step (s) */
    public double deltaT() {
        return settings.deltaT;
    }

    /** @return the duration of the run (s) */
    public double duration() {
        return settings.duration;
    }

    /**
     * @param name a solver's name
     * @return the same scene with this solver, without tolerances
     */
    public SceneDescription withSolver(String name) {
        return withSolver(new SolverDescription(name, Optional.empty()));
    }

    /** @return the same scene with this solver */
    public SceneDescription withSolver(SolverDescription other) {
        return with(new Settings(other, settings.deltaT, settings.duration, settings.exactImpacts, settings.threads,
                settings.blowUpFactor));
    }

    /**
     * @param other a time step (s)
     * @return the same scene with this step
     */
    public SceneDescription withDeltaT(double other) {
        return with(new Settings(settings.solver, other, settings.duration, settings.exactImpacts, settings.threads,
                settings.blowUpFactor));
    }

    /**
     * @param other a duration (s)
     * @return the same scene with this duration
     */
    public SceneDescription withDuration(double other) {
        return with(new Settings(settings.solver, settings.deltaT, other, settings.exactImpacts, settings.threads,
                settings.blowUpFactor));
    }

    /** @return the same scene with contacts that change only between steps */
    public SceneDescription withClampedImpacts() {
        return with(new Settings(settings.solver, settings.deltaT, settings.duration, false, settings.threads,
                settings.blowUpFactor));
    }

    /** @return the same scene with its forces evaluated by this number of threads */
    public SceneDescription withThreads(int number) {
        return with(new Settings(settings.solver, settings.deltaT, settings.duration, settings.exactImpacts,
                Optional.of(number), settings.blowUpFactor));
    }

    /** @return the same scene with other files to write */
    public SceneDescription withOutput(OutputDescription other) {
        return new SceneDescription(lesson, settings, contents, drawing, other, places);
    }

    private SceneDescription with(Settings other) {
        return new SceneDescription(lesson, other, contents, drawing, output, places);
    }

    /** @return the same scene with another place of a value, for messages */
    public SceneDescription placed(Key<?> key, Place place) {
        Map<Key<?>, Place> all = new HashMap<>(places);
        all.put(key, place);
        return new SceneDescription(lesson, settings, contents, drawing, output, Map.copyOf(all));
    }

    /**
     * The number of particles at a time, if no rule removes any.
     *
     * @param time the time since the start (s)
     * @return the number of the scene's own particles plus those from its emitters that are still alive
     */
    public double particlesAfter(double time) {
        double count = contents.particles.size();
        for (ShapeDescription shape : contents.shapes) {
            count += shape.lattice().size();
        }
        return count + contents.rules.stream()
                .mapToDouble(rule -> rule.kind().alive(rule.values(), settings.deltaT, time)).sum();
    }
}
