package particles.scene.checks;

import deSolvers.text.Digits;
import java.util.Comparator;
import java.util.List;
import particles.effects.SharedKeys;
import particles.law.Obstacle;
import particles.law.Sphere;
import particles.law.Vector3;
import particles.scene.parts.ParticleDescription;
import particles.scene.parts.ParticleIndex;
import particles.scene.parts.RuleKind;
import particles.scene.parts.ShapeDescription;
import particles.spec.Kind.Chosen;
import particles.spec.messages.Problems;
import particles.spec.messages.Wording;

/**
 * Checks that all free particles, hard balls with their whole radius, begin outside the ground and other solids.
 *
 * @param rule     the rule of a solid
 * @param solid    the solid
 * @param all      the radius of balls without one of their own (m); NaN if particles are not hard balls
 * @param problems receives the problems
 */
record OutsideCheck(Chosen<RuleKind> rule, Obstacle solid, double all, Problems problems) {
    private static final int MOST_RULES = 50;

    static void check(List<Chosen<RuleKind>> rules, ParticleIndex index, Problems problems) {
        if (rules.size() > MOST_RULES) {
            problems.add(rules.get(MOST_RULES).place(),
                    "there are " + rules.size() + " rules; a scene may have at most " + MOST_RULES);
            return;
        }
        List<Chosen<RuleKind>> sound = rules.stream().filter(rule -> rule.values().isSound()).toList();
        double all = sound.stream().filter(RuleKind::hasBalls)
                .mapToDouble(rule -> rule.values().get(SharedKeys.BALL_RADIUS)).findFirst().orElse(Double.NaN);
        List<OutsideCheck> checks = sound.stream().flatMap(rule -> rule.kind().obstacle(rule.values()).stream()
                .map(solid -> new OutsideCheck(rule, solid, all, problems))).toList();
        if (checks.isEmpty()) {
            return;
        }
        checks.forEach(check -> index.getParticles().forEach(particle -> check.check(List.of(particle))));
        for (ShapeDescription shape : index.getShapes()) {
            // each particle is made once for all solids, and only a misplaced one is kept: there may be a million
            List<ParticleDescription> misplaced = shape.particles().filter(particle ->
                    checks.stream().anyMatch(check -> check.isInside(particle))).toList();
            checks.forEach(check -> check.check(misplaced));
        }
    }

    /** Reports the free particle that is deepest inside the solid, if one is. */
    private void check(List<ParticleDescription> particles) {
        particles.stream().filter(this::isInside).min(Comparator.comparingDouble(this::distance))
                .ifPresent(particle -> problems.add(particle.place(), inside(particle)));
    }

    private boolean isInside(ParticleDescription particle) {
        return !particle.fixed() && distance(particle) < 0;
    }

    private String inside(ParticleDescription particle) {
        boolean hollow = solid instanceof Sphere sphere && sphere.hollow();
        double radius = radius(particle);
        String ball = radius > 0 ? ", a ball of radius " + Digits.exact(radius) + " m," : "";
        return Wording.quote(particle.id()) + ball + " begins " + Digits.exact(-distance(particle)) + " m "
                + (hollow ? "outside the hollow '" : "inside the '") + rule.kind().getName() + "' of line "
                + rule.place().line() + "; it has to begin " + (hollow ? "inside" : "outside");
    }

    /** The radius with which a particle touches solids (m): 0 if particles are not hard balls, which all may be. */
    private double radius(ParticleDescription particle) {
        return Double.isNaN(all) ? 0 : particle.radius().orElse(all);
    }

    /** Distance of a ball's surface from the solid (m); round-off counts as 0. */
    private double distance(ParticleDescription particle) {
        Vector3 at = particle.position();
        double distance = solid.distance(at.x(), at.y(), at.z()) - radius(particle);
        return Math.abs(distance) <= 1e-9 * (1 + at.length()) ? 0 : distance;
    }
}
