package particles.scene;

import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import particles.effects.EffectKind;
import particles.scene.format.CameraFormat;
import particles.scene.format.OutputDescription;
import particles.scene.format.OutputDescription.Phase;
import particles.scene.format.RenderFormat;
import particles.scene.format.SceneDescription;
import particles.scene.format.SceneDescription.Drawing;
import particles.scene.format.SceneFormat;
import particles.scene.format.SolverDescription;
import particles.scene.parts.NamedFiles;
import particles.scene.parts.ParticleIndex;
import particles.spec.Kind.Chosen;
import particles.spec.Values;
import particles.spec.messages.Place;
import particles.spec.messages.Problems;
import particles.view.Camera;

/**
 * Checks the conditions between parts of a scene. It checks all parts that have no mistake of their own, so that all
 * problems are reported together.
 */
final class SceneChecks {
    private SceneChecks() {
    }

    /**
     * @param scene    the values in the file
     * @param files    finds the files that the scene names
     * @param problems receives the problems
     * @return the description, if there is no problem
     */
    static Optional<SceneDescription> describe(Values scene, NamedFiles files, Problems problems) {
        KnownParticles known = new KnownParticles(scene, files, problems);
        ParticleIndex index = known.getIndex();
        if (index.count() == 0 && problems.count() == 0) {
            problems.add(scene.getPlace(),
                    "the scene has no particle at the start; add some under 'particles' or 'shapes'");
        }
        new ConstraintChecks(scene, problems, known, index).check();
        checkEffects(scene, problems, known);
        new RuleChecks(scene.list(SceneFormat.RULES), scene, problems, known).check();
        Optional<Camera> camera = scene.find(SceneFormat.CAMERA).filter(Values::isSound)
                .flatMap(values -> CameraFormat.of(values, problems));
        scene.find(SceneFormat.OUTPUT).flatMap(output -> output.find(OutputDescription.PHASE))
                .ifPresent(phase -> checkPhase(phase, problems, known));
        checkLook(scene, problems, known);
        scene.find(SceneFormat.SOLVER).filter(Values::isSound)
                .ifPresent(values -> SolverDescription.checkTolerances(values, problems));
        RunLimits.check(scene, problems);
        if (problems.count() > 0) {
            return Optional.empty();
        }
        return Optional.of(new SceneDescription(scene, index, new Drawing(camera, RenderFormat.of(scene, index)),
                OutputDescription.of(scene.mapping(SceneFormat.OUTPUT))));
    }

    private static void checkEffects(Values scene, Problems problems, KnownParticles known) {
        List<Chosen<EffectKind>> effects = scene.list(SceneFormat.EFFECTS);
        Map<String, Place> named = new HashMap<>();
        for (Chosen<EffectKind> effect : effects) {
            Place first = named.putIfAbsent(effect.kind().getName(), effect.place());
            if (first != null && !effect.kind().isRepeatable()) {
                problems.add(effect.place(), effect.kind().getLabel() + " is already named at line " + first.line());
            }
        }
        for (Chosen<EffectKind> effect : effects) {
            effect.kind().particles(effect.values()).stream().filter(id -> known.getIndex().shape(id).isEmpty())
                    .forEach(id -> known.has(id, effect.place()));
            List<String> needs = effect.kind().needs();
            if (!needs.isEmpty() && scene.isIntact(SceneFormat.EFFECTS)     // else the missing one may be misspelt
                    && needs.stream().noneMatch(named::containsKey)) {
                problems.add(effect.place(), effect.kind().getLabel() + " only acts together with '"
                        + String.join("' or '", needs) + "', which is missing; add '- " + needs.get(0)
                        + ": ...' to 'effects'");
            }
            effect.kind().excludes().stream().filter(named::containsKey).forEach(other ->
                    problems.add(effect.place(), effect.kind().getLabel() + " and '" + other
                            + "' cannot be combined; keep one of them"));
        }
    }

    private static void checkPhase(Values phase, Problems problems, KnownParticles known) {
        known.has(phase, Phase.PARTICLE);
        known.has(phase, Phase.ABOUT);
        Optional<String> about = phase.find(Phase.ABOUT);
        boolean angle = phase.find(Phase.AXIS).equals(Optional.of(Phase.ANGLE));
        if (!phase.isSound()) {
            return;
        }
        if (angle != about.isPresent()) {
            problems.add(phase.place(angle ? Phase.AXIS : Phase.ABOUT),
                    "'axis: angle' goes with 'about', the particle that the angle is seen from");
        } else if (about.equals(phase.find(Phase.PARTICLE))) {
            problems.add(phase.place(Phase.ABOUT), "a particle has no angle about itself");
        }
    }

    private static void checkLook(Values scene, Problems problems, KnownParticles known) {
        scene.find(SceneFormat.LOOK).ifPresent(look -> {
            RenderFormat.check(look, problems);
            look.list(RenderFormat.MARKS).stream()
                    .filter(mark -> mark.find(RenderFormat.MARKED).flatMap(known.getIndex()::shape).isEmpty())
                    .forEach(mark -> known.has(mark, RenderFormat.MARKED));
        });
    }
}
