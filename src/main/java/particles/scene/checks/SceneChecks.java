package particles.scene.checks;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalInt;
import particles.effects.EffectKind;
import particles.scene.format.CameraFormat;
import particles.scene.format.OutputDescription;
import particles.scene.format.OutputDescription.Phase;
import particles.scene.format.SceneDescription;
import particles.scene.format.SceneDescription.Contents;
import particles.scene.format.SceneDescription.Drawing;
import particles.scene.format.SceneFormat;
import particles.scene.format.SolverDescription;
import particles.scene.format.SolverFormat;
import particles.scene.format.Tolerances;
import particles.scene.parts.ParticleDescription;
import particles.scene.parts.ParticleIndex;
import particles.scene.parts.ShapeDescription;
import particles.scene.parts.ShapeKind;
import particles.scene.parts.SpringDescription;
import particles.spec.Chosen;
import particles.spec.Key;
import particles.spec.Values;
import particles.spec.messages.Place;
import particles.spec.messages.Problems;
import particles.spec.messages.Wording;
import particles.view.Camera;

/**
 * Checks the conditions between parts of a scene. It checks all parts that have no mistake of their own, so that all
 * problems are reported together.
 */
public final class SceneChecks {
    private static final int MOST_CANDIDATES = 1000;
    private static final long MOST_SPRINGS = 10_000_000;

    private final Values scene;
    private final Problems problems;
    private final Map<String, Place> ids = new HashMap<>();
    private final List<ParticleDescription> particles = new ArrayList<>();
    private final List<ShapeDescription> shapes = new ArrayList<>();
    private final List<SpringDescription> springs = new ArrayList<>();
    private final List<String> broken = new ArrayList<>();
    private ParticleIndex index;

    /**
     * @param scene    the values in the file
     * @param problems receives the problems
     */
    public SceneChecks(Values scene, Problems problems) {
        this.scene = scene;
        this.problems = problems;
    }

    /** @return the description, if there is no problem */
    public Optional<SceneDescription> describe() {
        checkParticles();
        checkShapes();
        RuleChecks.newIds(scene, this::take);
        index = new ParticleIndex(particles, shapes);
        checkSize();
        if (particles.isEmpty() && shapes.isEmpty() && problems.count() == 0) {
            problems.add(scene.getPlace(), RuleChecks.giveBirth(scene)
                    ? "the scene has no particle at the start, and emitters add theirs only later; add one under"
                            + " 'particles', such as {id: source, position: [0, 0, 0], fixed: true}"
                    : "the scene has no particle; add some under 'particles' or 'shapes'");
        }
        ConstraintChecks constraints = new ConstraintChecks(scene, problems, index, this::isKnown);
        checkSprings(constraints);
        constraints.check();
        checkEffects();
        OutsideCheck.check(scene.list(SceneFormat.RULES), particles, shapes, problems);
        new RuleChecks(scene, problems, index, this::isKnown)
                .check(!springs.isEmpty() || shapes.stream().anyMatch(shape -> shape.springCount() > 0));
        Optional<Camera> camera = scene.find(SceneFormat.CAMERA).filter(Values::isSound)
                .flatMap(values -> CameraFormat.of(values, problems));
        checkPhase();
        LookCheck look = new LookCheck(particles, shapes);
        look.check(scene, problems, this::isKnown);
        Optional<Tolerances> tolerances = scene.find(SceneFormat.SOLVER).filter(Values::isSound)
                .flatMap(values -> SolverFormat.tolerances(values, problems));
        RunLimits.check(scene, problems);
        if (problems.count() > 0) {
            return Optional.empty();
        }
        Values noWords = Values.none(scene.getPlace());
        return Optional.of(new SceneDescription(scene,
                new SolverDescription(scene.get(SceneFormat.SOLVER).get(SolverFormat.NAME), tolerances),
                new Contents(List.copyOf(particles), List.copyOf(shapes), List.copyOf(springs), constraints.describe(),
                        List.copyOf(scene.get(SceneFormat.EFFECTS)), List.copyOf(scene.get(SceneFormat.RULES))),
                new Drawing(camera, look.of(scene)),
                OutputDescription.of(scene.find(SceneFormat.OUTPUT).orElse(noWords))));
    }

    private void checkParticles() {
        for (Values values : scene.list(SceneFormat.PARTICLES)) {
            values.find(ParticleDescription.ID).ifPresent(id -> take(id, values.place(ParticleDescription.ID)));
            if (!values.isSound()) {
                values.find(ParticleDescription.ID).ifPresent(broken::add);
                continue;
            }
            ParticleDescription particle = ParticleDescription.of(values);
            if (particle.fixed() && !particle.velocity().isZero()) {
                problems.add(values.place(ParticleDescription.VELOCITY), "'" + particle.id()
                        + "' is fixed and has a velocity; remove one of the two");
            }
            particles.add(particle);
        }
    }

    private void checkShapes() {
        long count = particles.size();
        for (Chosen<ShapeKind> chosen : scene.list(SceneFormat.SHAPES)) {
            Key<String> id = chosen.kind().getId();
            chosen.values().find(id).ifPresent(name -> take(name, chosen.values().place(id)));
            Optional<ShapeDescription> shape = chosen.values().isSound() && count <= ShapeDescription.MOST_PARTICLES
                    ? ShapeDescription.of(chosen, problems) : Optional.empty();
            if (shape.isPresent()) {
                shapes.add(shape.get());
                count += shape.get().lattice().size();
            }
            if (shape.isEmpty()) {
                chosen.values().find(id).ifPresent(broken::add);
            }
        }
    }

    private void checkSize() {
        long count = particles.size();
        long all = scene.list(SceneFormat.SPRINGS).size();
        for (ShapeDescription shape : shapes) {
            count += shape.lattice().size();
            all += shape.springCount();
            if (count > ShapeDescription.MOST_PARTICLES || all > MOST_SPRINGS) {
                problems.add(shape.place(), "with this shape there are " + count + " particles and " + all
                        + " springs; a scene may have at most " + ShapeDescription.MOST_PARTICLES + " and "
                        + MOST_SPRINGS);
                return;
            }
        }
    }

    private void take(String id, Place place) {
        Place first = ids.putIfAbsent(id, place);
        if (first != null) {
            problems.add(place, "the id " + Wording.quote(id)
                    + " is already used at line " + first.line() + "; give another");
        }
    }

    private void checkSprings(ConstraintChecks constraints) {
        for (Values values : scene.list(SceneFormat.SPRINGS)) {
            boolean known = isKnown(values, SpringDescription.FROM) & isKnown(values, SpringDescription.TO);
            if (!known || !values.isSound()) {
                continue;
            }
            SpringDescription spring = SpringDescription.of(values);
            constraints.checkEnds("spring", spring.from(), spring.to(), values.place(SpringDescription.TO));
            springs.add(spring);
        }
    }

    /**
     * Whether a spring's end can be checked further. A known id of a faulty particle is not a problem of the spring.
     */
    private boolean isKnown(Values values, Key<String> key) {
        return values.find(key).isPresent() && isKnown(values.get(key), values.place(key));
    }

    private boolean isKnown(String id, Place place) {
        OptionalInt found = index.find(id);
        String shape = ParticleIndex.shapeOf(id);
        if (found.isPresent() || broken.contains(id) || broken.contains(shape)) {
            return found.isPresent() && !broken.contains(shape);
        }
        if (!areAllIdsKnown()) {
            return false;
        }
        if (problems.isFull()) {
            problems.add(place, "unknown particle");
            return false;
        }
        Optional<ShapeDescription> named = shapes.stream().filter(s -> s.lattice().id().equals(shape)).findFirst();
        List<String> known = ids.keySet().stream().sorted().toList();
        problems.add(place, "unknown particle " + Wording.quote(id) + named.map(s -> "; known in this shape: "
                + s.lattice().range())
                .orElseGet(() -> (known.size() > MOST_CANDIDATES ? ";" : Wording.hint(shape, known)) + " known: "
                        + Wording.some(known)));
        return false;
    }

    /** If the id of a particle or shape could not be read, an unknown id may be theirs. */
    private boolean areAllIdsKnown() {
        Optional<List<Values>> alone = scene.find(SceneFormat.PARTICLES);
        return scene.isIntact(SceneFormat.SHAPES) && alone.isPresent()
                && alone.get().stream().allMatch(values -> values.find(ParticleDescription.ID).isPresent());
    }

    private void checkEffects() {
        List<Chosen<EffectKind>> effects = scene.list(SceneFormat.EFFECTS);
        Map<String, Place> named = new HashMap<>();
        for (Chosen<EffectKind> effect : effects) {
            Place first = named.putIfAbsent(effect.kind().getName(), effect.place());
            if (first != null && !effect.kind().isRepeatable()) {
                problems.add(effect.place(), "'" + effect.kind().getName() + "' is already named at line "
                        + first.line());
            }
        }
        for (Chosen<EffectKind> effect : effects) {
            List<String> needs = effect.kind().needs();
            if (!needs.isEmpty() && scene.isIntact(SceneFormat.EFFECTS)     // else the missing one may be misspelt
                    && needs.stream().noneMatch(named::containsKey)) {
                problems.add(effect.place(), "'" + effect.kind().getName() + "' only acts together with '"
                        + String.join("' or '", needs)
                        + "', which is missing; add '- " + needs.get(0) + ": ...' to 'effects'");
            }
            effect.kind().excludes().stream().filter(named::containsKey).forEach(other ->
                    problems.add(effect.place(), "'"
                    + effect.kind().getName() + "' and '" + other + "' cannot be combined; keep one of them"));
        }
    }

    private void checkPhase() {
        scene.find(SceneFormat.OUTPUT).flatMap(output -> output.find(OutputDescription.PHASE))
                .ifPresent(phase -> {
                    isKnown(phase, Phase.PARTICLE);
                    isKnown(phase, Phase.ABOUT);
                    boolean angle = phase.find(Phase.AXIS).equals(Optional.of(Phase.ANGLE));
                    if (angle && phase.isSound() && phase.find(Phase.ABOUT).isEmpty()) {
                        problems.add(phase.place(Phase.AXIS),
                                "'axis: angle' needs 'about', the particle that the angle is seen from");
                    } else if (!angle && phase.isSound() && phase.find(Phase.ABOUT).isPresent()) {
                        problems.add(phase.place(Phase.ABOUT), "'about' goes with 'axis: angle'");
                    } else if (phase.isSound() && phase.find(Phase.ABOUT).equals(phase.find(Phase.PARTICLE))) {
                        problems.add(phase.place(Phase.ABOUT), "a particle has no angle about itself");
                    }
                });
    }
}
