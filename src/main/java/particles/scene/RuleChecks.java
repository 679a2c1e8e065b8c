package particles.scene;

import static particles.spec.messages.Wording.quote;

import deSolvers.text.Digits;
import java.util.Comparator;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Stream;
import particles.effects.SharedKeys;
import particles.law.Obstacle;
import particles.law.Sphere;
import particles.law.Vector3;
import particles.scene.format.SceneFormat;
import particles.scene.parts.BirthAndDeath;
import particles.scene.parts.ParticleDescription;
import particles.scene.parts.ParticleIndex;
import particles.scene.parts.RuleKind;
import particles.scene.parts.ShapeDescription;
import particles.scene.parts.ShapeKind;
import particles.spec.Kind.Chosen;
import particles.spec.Values;
import particles.spec.messages.Place;
import particles.spec.messages.Problems;

/**
 * Checks rules against the particles and springs that they name or act on, and particles against the solids of rules.
 *
 * @param rules    the rules
 * @param scene    the values in the file
 * @param problems receives the problems
 * @param known    the particles
 */
record RuleChecks(List<Chosen<RuleKind>> rules, Values scene, Problems problems, KnownParticles known) {
    private static final int MOST_RULES = 50;

    /** Hard balls are named once, located at their impacts and neither merged nor split. */
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
        rules.stream().filter(rule -> rule.kind() == BirthAndDeath.SAMPLES).forEach(rule ->
                problems.add(rule.place(), rule.kind().getLabel()
                + " and 'collisions' cannot be combined: hard balls neither merge nor split"));
    }

    void check() {
        checkOutside();
        checkBalls();
        checkScales();
        Map<String, Place> moved = new HashMap<>();
        for (Chosen<RuleKind> rule : rules) {
            if (known.has(rule.values(), RuleKind.ANCHOR)) {
                checkAnchor(rule.values().get(RuleKind.ANCHOR), rule.values().place(RuleKind.ANCHOR), moved);
            }
            if (rule.kind() == BirthAndDeath.TEAR && problems.count() == 0 && scene.list(SceneFormat.SPRINGS).isEmpty()
                    && known.getIndex().getShapes().stream().allMatch(shape -> shape.springCount() == 0)) {
                problems.add(rule.place(), rule.kind().getLabel() + " acts on springs, and the scene has none");
            }
        }
    }

    /** Scales change friction; they need a rule that has some. */
    private void checkScales() {
        if (scene.isIntact(SceneFormat.RULES) && rules.stream().noneMatch(rule ->
                rule.values().isGiven(RuleKind.FRICTION))) {
            scene.list(SceneFormat.SHAPES).forEach(shape -> shape.values().find(ShapeKind.SCALES).ifPresent(scales ->
                    problems.add(scales.getPlace(), "'scales' change friction, and no rule has any; add"
                            + " '- ground: {friction: {law: coulomb, coefficient: 0.5}}' to 'rules'")));
        }
    }

    private void checkAnchor(String id, Place place, Map<String, Place> moved) {
        Place first = moved.putIfAbsent(id, place);
        if (first != null) {
            problems.add(place, "particle " + quote(id) + " already has a motion, at line " + first.line());
        }
        if (!known.getIndex().particle(id).fixed()) {
            problems.add(place, "particle " + quote(id)
                    + " is free; only a fixed particle can follow a given motion");
        }
    }

    /** All free particles, hard balls with their whole radius, begin outside the ground and other solids. */
    private void checkOutside() {
        ParticleIndex index = known.getIndex();
        if (rules.size() > MOST_RULES) {
            problems.add(rules.get(MOST_RULES).place(),
                    "there are " + rules.size() + " rules; a scene may have at most " + MOST_RULES);
            return;
        }
        List<Chosen<RuleKind>> sound = rules.stream().filter(rule -> rule.values().isSound()).toList();
        double all = sound.stream().filter(RuleKind::hasBalls)
                .mapToDouble(rule -> rule.values().get(SharedKeys.BALL_RADIUS)).findFirst().orElse(Double.NaN);
        List<Solid> solids = sound.stream().flatMap(rule -> rule.kind().obstacle(rule.values()).stream()
                .map(solid -> new Solid(rule, solid, all))).toList();
        if (solids.isEmpty()) {
            return;
        }
        solids.forEach(solid -> index.getParticles().forEach(particle -> checkOutside(solid, Stream.of(particle))));
        for (ShapeDescription shape : index.getShapes()) {
            // each particle is made once for all solids, and only a misplaced one is kept: there may be a million
            List<ParticleDescription> misplaced = shape.particles().filter(particle ->
                    solids.stream().anyMatch(solid -> solid.has(particle))).toList();
            solids.forEach(solid -> checkOutside(solid, misplaced.stream()));
        }
    }

    /** Reports the free particle that is deepest inside a solid, if one is. */
    private void checkOutside(Solid solid, Stream<ParticleDescription> particles) {
        particles.filter(solid::has).min(Comparator.comparingDouble(solid::distance))
                .ifPresent(particle -> problems.add(particle.place(), solid.inside(particle)));
    }

    /** A rule's solid; all is the radius of balls without one of their own (m), NaN if particles are not hard balls. */
    private record Solid(Chosen<RuleKind> rule, Obstacle obstacle, double all) {
        boolean has(ParticleDescription particle) {
            return !particle.fixed() && distance(particle) < 0;
        }

        String inside(ParticleDescription particle) {
            boolean hollow = obstacle instanceof Sphere sphere && sphere.hollow();
            double radius = radius(particle);
            String ball = radius > 0 ? ", a ball of radius " + Digits.exact(radius) + " m," : "";
            return quote(particle.id()) + ball + " begins " + Digits.exact(-distance(particle)) + " m "
                    + (hollow ? "outside the hollow '" : "inside the '") + rule.kind().getName() + "' of line "
                    + rule.place().line() + "; it has to begin " + (hollow ? "inside" : "outside");
        }

        /** The radius with which a particle touches solids (m): 0 if particles are not hard balls, which all may be. */
        private double radius(ParticleDescription particle) {
            return Double.isNaN(all) ? 0 : particle.radius().orElse(all);
        }

        /** Distance of a ball's surface from the solid (m); round-off counts as 0. */
        double distance(ParticleDescription particle) {
            Vector3 at = particle.position();
            double distance = obstacle.distance(new double[] {at.x(), at.y(), at.z()}, 0) - radius(particle);
            return Math.abs(distance) <= 1e-9 * (1 + at.length()) ? 0 : distance;
        }
    }
}
