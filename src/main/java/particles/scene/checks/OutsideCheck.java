package particles.scene.checks;

import java.util.List;
import java.util.Optional;
import particles.law.Obstacle;
import particles.law.Vector3;
import particles.scene.parts.Lattice;
import particles.scene.parts.ParticleDescription;
import particles.scene.parts.RuleKind;
import particles.scene.parts.ShapeDescription;
import particles.spec.Chosen;
import particles.spec.Values;
import particles.spec.messages.Problems;
import particles.spec.messages.Wording;

/** Whether everything begins outside of the ground and the other solids; what is fixed may stand in them. */
final class OutsideCheck {
    private static final int MOST_RULES = 50;

    private OutsideCheck() {
    }

    static void check(List<Chosen<RuleKind>> rules, List<ParticleDescription> particles, List<ShapeDescription> shapes,
                      Problems problems) {
        if (rules.size() > MOST_RULES) {
            problems.add(rules.get(MOST_RULES).place(),
                    "there are " + rules.size() + " rules; a scene may have at most "
                    + MOST_RULES);
            return;
        }
        for (Chosen<RuleKind> rule : rules) {
            Optional<Obstacle> plane = Optional.of(rule.values()).filter(Values::isSound)
                    .flatMap(rule.kind()::obstacle);
            if (plane.isPresent()) {
                for (ParticleDescription particle : particles) {
                    double distance = distance(plane.get(), particle.position());
                    if (distance < 0 && !particle.fixed()) {
                        problems.add(particle.place(), below(particle.id(), rule, distance));
                    }
                }
                shapes.forEach(shape -> check(shape, plane.get(), rule, problems));
            }
        }
    }

    private static void check(ShapeDescription shape, Obstacle plane, Chosen<RuleKind> rule, Problems problems) {
        Lattice lattice = shape.lattice();
        if (problems.isFull() || plane.isFlat() && lattice.corners().stream().allMatch(n -> distance(plane,
                lattice.position(n)) >= 0)) {
            return;                                     // on a plane's right side all others lie between the corners
        }
        int lowest = -1;
        double least = 0;
        for (int n = 0; n < lattice.size(); n++) {
            double distance = shape.fixed().get(n) ? 0 : distance(plane, lattice.position(n));
            if (distance < least) {
                lowest = n;
                least = distance;
            }
        }
        if (lowest >= 0) {
            problems.add(shape.place(), below(lattice.idOf(lowest), rule, least));
        }
    }

    private static String below(String id, Chosen<RuleKind> rule, double distance) {
        return Wording.quote(id) + " begins " + Wording.number(-distance) + " m inside the '" + rule.kind().name()
                + "' of line "
                + rule.place().line() + "; it has to begin outside";
    }

    /** Places that are on the plane but for rounding are on it. */
    private static double distance(Obstacle plane, Vector3 at) {
        double distance = plane.distance(at.x(), at.y(), at.z());
        return Math.abs(distance) <= 1e-9 * (1 + at.length()) ? 0 : distance;
    }
}
