package particles.scene.checks;

import deSolvers.text.Digits;
import java.util.List;
import java.util.Optional;
import particles.law.Obstacle;
import particles.law.Sphere;
import particles.law.Vector3;
import particles.scene.parts.Lattice;
import particles.scene.parts.ParticleDescription;
import particles.scene.parts.ParticleIndex;
import particles.scene.parts.RuleKind;
import particles.scene.parts.ShapeDescription;
import particles.spec.Chosen;
import particles.spec.Values;
import particles.spec.messages.Problems;
import particles.spec.messages.Wording;

/** Checks that all free particles, hard balls with their whole radius, begin outside the ground and other solids. */
final class OutsideCheck {
    private static final int MOST_RULES = 50;

    private OutsideCheck() {
    }

    static void check(List<Chosen<RuleKind>> rules, ParticleIndex index, Problems problems) {
        if (rules.size() > MOST_RULES) {
            problems.add(rules.get(MOST_RULES).place(),
                    "there are " + rules.size() + " rules; a scene may have at most "
                    + MOST_RULES);
            return;
        }
        double all = rules.stream().filter(RuleKind::hasBalls).filter(rule -> rule.values().isSound())
                .mapToDouble(rule -> rule.kind().ballRadius(rule.values())).findFirst().orElse(Double.NaN);
        for (Chosen<RuleKind> rule : rules) {
            Optional<Obstacle> solid = Optional.of(rule.values()).filter(Values::isSound)
                    .flatMap(rule.kind()::obstacle);
            if (solid.isPresent()) {
                for (ParticleDescription particle : index.getParticles()) {
                    double radius = radius(particle.radius(), all);
                    double distance = distance(solid.get(), particle.position(), radius);
                    if (distance < 0 && !particle.fixed()) {
                        problems.add(particle.place(), inside(particle.id(), radius, rule, solid.get(), distance));
                    }
                }
                index.getShapes().forEach(shape -> check(shape, solid.get(), rule,
                        radius(shape.radius(), all), problems));
            }
        }
    }

    /** The radius with which a particle touches solids: 0 if particles are not hard balls, which all may be. */
    private static double radius(Optional<Double> own, double all) {
        return Double.isNaN(all) ? 0 : own.orElse(all);
    }

    private static void check(ShapeDescription shape, Obstacle solid, Chosen<RuleKind> rule, double radius,
            Problems problems) {
        Lattice lattice = shape.lattice();
        if (problems.isFull() || solid.isFlat() && lattice.corners().stream().allMatch(n -> distance(solid,
                lattice.position(n), radius) >= 0)) {
            return;                                     // if all corners are outside a plane, so are all particles
        }
        int lowest = -1;
        double least = 0;
        for (int n = 0; n < lattice.size(); n++) {
            double distance = shape.fixed().get(n) ? 0 : distance(solid, lattice.position(n), radius);
            if (distance < least) {
                lowest = n;
                least = distance;
            }
        }
        if (lowest >= 0) {
            problems.add(shape.place(), inside(lattice.idOf(lowest), radius, rule, solid, least));
        }
    }

    private static String inside(String id, double radius, Chosen<RuleKind> rule, Obstacle solid, double distance) {
        boolean hollow = solid instanceof Sphere sphere && sphere.hollow();
        String ball = radius > 0 ? ", a ball of radius " + Digits.exact(radius) + " m," : "";
        return Wording.quote(id) + ball + " begins " + Digits.exact(-distance) + " m "
                + (hollow ? "outside the hollow '" : "inside the '") + rule.kind().getName() + "' of line "
                + rule.place().line() + "; it has to begin " + (hollow ? "inside" : "outside");
    }

    /** Distance of a ball's surface from a solid; round-off counts as 0. */
    private static double distance(Obstacle solid, Vector3 at, double radius) {
        double distance = solid.distance(at.x(), at.y(), at.z()) - radius;
        return Math.abs(distance) <= 1e-9 * (1 + at.length()) ? 0 : distance;
    }
}
