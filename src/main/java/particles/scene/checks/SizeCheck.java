package particles.scene.checks;

import java.util.List;
import particles.scene.format.SceneFormat;
import particles.scene.parts.ParticleDescription;
import particles.scene.parts.ShapeDescription;
import particles.spec.Values;
import particles.spec.messages.Problems;

/** Checks the numbers of particles and springs before anything is built. */
final class SizeCheck {
    private static final long MOST_SPRINGS = 10_000_000;

    private SizeCheck() {
    }

    static void check(Values scene, List<ParticleDescription> particles, List<ShapeDescription> shapes,
            Problems problems) {
        long count = particles.size();
        long springs = scene.list(SceneFormat.SPRINGS).size();
        for (ShapeDescription shape : shapes) {
            count += shape.lattice().size();
            springs += shape.springCount();
            if (count > ShapeDescription.MOST_PARTICLES || springs > MOST_SPRINGS) {
                problems.add(shape.place(), "with this shape there are " + count + " particles and " + springs
                        + " springs; a scene"
                        + " may have at most " + ShapeDescription.MOST_PARTICLES + " and " + MOST_SPRINGS);
                return;
            }
        }
    }
}
