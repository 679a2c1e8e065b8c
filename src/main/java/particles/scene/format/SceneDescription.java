package particles.scene.format;

import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import particles.scene.parts.ParticleIndex;
import particles.scene.parts.RuleKind;
import particles.spec.Key;
import particles.spec.Kind.Chosen;
import particles.spec.Values;
import particles.view.Camera;
import particles.view.RenderOptions;

/**
 * The checked contents of a scene file, with options in place of the file's values.
 *
 * @param values    the values by their keys in {@link SceneFormat}; the output may since have been replaced
 * @param particles the single particles, first in the state, and the shapes, whose particles follow
 * @param drawing   how it is drawn
 * @param output    the files to write
 */
public record SceneDescription(Values values, ParticleIndex particles, Drawing drawing, OutputDescription output) {

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
        return values.get(SceneFormat.TITLE);
    }

    /** @return remarks about its shapes and effects for the person who made them, one line each */
    public List<String> remarks() {
        return Stream.concat(particles.getShapes().stream().flatMap(shape -> shape.layout().remarks().stream()),
                values.list(SceneFormat.EFFECTS).stream().flatMap(chosen -> chosen.kind().remark(particles.count())
                .stream())).toList();
    }

    /** @return the solver */
    public SolverDescription solving() {
        return SolverDescription.of(values.get(SceneFormat.SOLVER));
    }

    /** @return the name of the solver */
    public String solver() {
        return solving().name();
    }

    /** @return the time step (s) */
    public double deltaT() {
        return values.get(SceneFormat.DELTA_T);
    }

    /** @return the duration of the run (s) */
    public double duration() {
        return values.get(SceneFormat.DURATION);
    }

    /** @return the rules that the scene names */
    public List<Chosen<RuleKind>> rules() {
        return values.get(SceneFormat.RULES);
    }

    /** @return whether steps are split at impacts */
    public boolean exactImpacts() {
        return values.get(SceneFormat.IMPACT).equals("exact") || hasHardBalls();
    }

    /** @return whether bounces become ever smaller and never end */
    public boolean bouncesForEver() {
        return rules().stream().anyMatch(RuleKind::bouncesForEver);
    }

    /** @return whether particles are hard balls */
    public boolean hasHardBalls() {
        return rules().stream().anyMatch(RuleKind::hasBalls);
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
        return with(SceneFormat.SOLVER, other.values(values.place(SceneFormat.SOLVER)));
    }

    /**
     * @param other a time step (s)
     * @return the same scene with this step
     */
    public SceneDescription withDeltaT(double other) {
        return with(SceneFormat.DELTA_T, other);
    }

    /**
     * @param other a duration (s)
     * @return the same scene with this duration
     */
    public SceneDescription withDuration(double other) {
        return with(SceneFormat.DURATION, other);
    }

    /** @return the same scene with other files to write */
    public SceneDescription withOutput(OutputDescription other) {
        return new SceneDescription(values, particles, drawing, other);
    }

    /** @return the same scene with another value of a key */
    public <T> SceneDescription with(Key<T> key, T value) {
        return new SceneDescription(values.with(key, value, values.place(key)), particles, drawing, output);
    }

    /**
     * The number of particles at a time, if no rule removes any.
     *
     * @param time the time since the start (s)
     * @return the number of the scene's own particles plus those from its emitters that are still alive
     */
    public double particlesAfter(double time) {
        return particles.count() + rules().stream()
                .mapToDouble(rule -> RuleKind.alive(rule.values(), deltaT(), time)).sum();
    }
}
