package particles.scene.checks;

import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import particles.scene.format.SceneFormat;
import particles.scene.parts.RuleKind;
import particles.spec.Kind.Chosen;
import particles.spec.Values;
import particles.spec.messages.Place;
import particles.spec.messages.Problems;
import particles.spec.messages.Wording;

/**
 * Checks rules against the particles and springs that they name or act on.
 *
 * @param rules    the rules
 * @param scene    the values in the file
 * @param problems receives the problems
 * @param known    the particles
 */
record RuleChecks(List<Chosen<RuleKind>> rules, Values scene, Problems problems, KnownParticles known) {
    /** @return whether a rule makes particles, so that a scene may begin without any */
    boolean giveBirth() {
        return rules.stream().anyMatch(rule -> RuleKind.alive(rule.values(), 1, 1) > 0);
    }

    /** Hard balls are named once, located at their impacts and as many as at the start. */
    private void checkBalls() {
        List<Chosen<RuleKind>> balls = rules.stream().filter(RuleKind::hasBalls).toList();
        if (balls.isEmpty()) {
            return;
        }
        Place place = balls.get(0).place();
        if (balls.size() > 1) {
            problems.add(balls.get(1).place(), "'collisions' is already named at line " + place.line());
        }
        if (scene.isGiven(SceneFormat.IMPACT) && scene.find(SceneFormat.IMPACT).equals(Optional.of("clamp"))) {
            problems.add(scene.place(SceneFormat.IMPACT), "'collisions' needs 'impact: exact'");
        }
        scene.list(SceneFormat.EFFECTS).stream().filter(e -> e.kind().getName().equals("repulsion")).forEach(effect ->
                problems.add(effect.place(), "'repulsion' and 'collisions' cannot be combined; keep one of them"));
        rules.stream().filter(rule -> rule.kind().newIds().isPresent() || RuleKind.removes(rule)).forEach(rule ->
                problems.add(rule.place(), rule.kind().getLabel() + " and 'collisions' cannot be combined:"
                        + " hard balls are neither born nor removed"));
    }

    void check() {
        checkBalls();
        Map<String, Place> moved = new HashMap<>();
        for (Chosen<RuleKind> rule : rules) {
            if (known.has(rule.values(), RuleKind.ANCHOR)) {
                checkAnchor(rule.values().get(RuleKind.ANCHOR), rule.values().place(RuleKind.ANCHOR), moved);
            }
            if (RuleKind.needsSprings(rule) && problems.count() == 0 && scene.list(SceneFormat.SPRINGS).isEmpty()
                    && known.getIndex().getShapes().stream().allMatch(shape -> shape.springCount() == 0)) {
                problems.add(rule.place(), rule.kind().getLabel() + " acts on springs, and the scene has none");
            }
        }
    }

    private void checkAnchor(String id, Place place, Map<String, Place> moved) {
        Place first = moved.putIfAbsent(id, place);
        if (first != null) {
            problems.add(place, "particle " + Wording.quote(id) + " already has a motion, at line " + first.line());
        }
        if (!known.getIndex().particle(id).fixed()) {
            problems.add(place, "particle " + Wording.quote(id)
                    + " is free; only a fixed particle can follow a given motion");
        }
    }
}
