package particles.scene.parts;

import java.util.List;

/** The catalogue of all rules that scenes can name; apart from {@link RuleKind}, which each of them needs first. */
public final class RuleCatalog {
    /** All rules. */
    public static final List<RuleKind> ALL = List.of(RuleKind.GROUND, RuleKind.PLANE, RuleKind.SPHERE,
            RuleKind.COLLISIONS, BirthAndDeath.TEAR, RuleKind.SHAKE, RuleKind.CIRCLE, RuleKind.GLIDE,
            BirthAndDeath.EMITTER, BirthAndDeath.KILL, BirthAndDeath.SAMPLES);

    private RuleCatalog() {
    }
}
