package particles.scene.checks;

import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.OptionalInt;
import java.util.function.BiConsumer;
import java.util.function.BiPredicate;
import particles.scene.format.SceneFormat;
import particles.scene.parts.ParticleDescription;
import particles.scene.parts.RuleKind;
import particles.scene.parts.ShapeDescription;
import particles.scene.parts.SpringDescription;
import particles.spec.Chosen;
import particles.spec.Key;
import particles.spec.Values;
import particles.spec.messages.Place;
import particles.spec.messages.Problems;
import particles.spec.messages.Wording;

/** Checks rules against the particles and springs that they name or act on. */
final class RuleChecks {
    private final List<Chosen<RuleKind>> rules;
    private final Problems problems;
    private final BiPredicate<Values, Key<String>> isKnown;
    private final Map<String, Place> moved = new HashMap<>();

    /** @param isKnown tests whether a key names an existing particle, and adds a problem if not */
    RuleChecks(Values scene, Problems problems, BiPredicate<Values, Key<String>> isKnown) {
        rules = rulesOf(scene);
        this.problems = problems;
        this.isKnown = isKnown;
    }

    private static List<Chosen<RuleKind>> rulesOf(Values scene) {
        return scene.list(SceneFormat.RULES);
    }

    /** Reports the id prefixes of particles that rules make. */
    static void newIds(Values scene, BiConsumer<String, Place> take) {
        for (Chosen<RuleKind> rule : rulesOf(scene)) {
            rule.kind().newIds().ifPresent(key -> rule.values().find(key)
                    .ifPresent(id -> take.accept(id, rule.values().isGiven(key) ? rule.values().place(key)
                    : rule.place())));
        }
    }

    /** @return whether a rule makes particles, so that a scene may begin without any */
    static boolean giveBirth(Values scene) {
        return rulesOf(scene).stream().anyMatch(rule -> rule.kind().alive(rule.values(), 1, 1) > 0);
    }

    void check(List<ParticleDescription> particles, List<ShapeDescription> shapes, List<SpringDescription> springs) {
        for (Chosen<RuleKind> rule : rules) {
            rule.kind().anchor().filter(key -> isKnown.test(rule.values(), key))
                    .ifPresent(key -> checkAnchor(rule.values(), key, particles, shapes));
            if (rule.kind().needsSprings() && springs.isEmpty() && problems.count() == 0
                    && shapes.stream().allMatch(shape -> shape.springCount() == 0)) {
                problems.add(rule.place(), "'" + rule.kind().getName() + "' acts on springs, and the scene has none");
            }
        }
    }

    private void checkAnchor(Values values, Key<String> key, List<ParticleDescription> particles,
                             List<ShapeDescription> shapes) {
        String id = values.get(key);
        Place first = moved.putIfAbsent(id, values.place(key));
        if (first != null) {
            problems.add(values.place(key), "particle " + Wording.quote(id)
                    + " already has a motion, at line " + first.line());
        }
        boolean fixed = particles.stream().anyMatch(particle -> particle.id().equals(id) && particle.fixed());
        for (ShapeDescription shape : shapes) {
            OptionalInt n = shape.lattice().find(id);
            fixed |= n.isPresent() && shape.fixed().get(n.getAsInt());
        }
        if (!fixed) {
            problems.add(values.place(key), "particle " + Wording.quote(id)
                    + " is free; only a fixed particle can follow a given motion");
        }
    }
}
