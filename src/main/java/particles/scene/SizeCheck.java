package particles.scene;

import java.util.List;
import particles.scene.spec.Problems;
import particles.scene.spec.Values;

/** Whether a scene fits: into what a scene may have, and into the memory that Java may use. */
final class SizeCheck {
    private static final long MOST_SPRINGS = 10_000_000;
    /** Id, state, masses, a solver's work arrays, and what output needs. */
    private static final long BYTES_PER_PARTICLE = 800;
    /** The constants, and their copy while arrays grow. */
    private static final long BYTES_PER_SPRING = 90;

    private SizeCheck() {
    }

    static void check(Values scene, List<ParticleDescription> particles, List<ShapeDescription> shapes, Problems problems) {
        long count = particles.size();
        long springs = scene.find(SceneFormat.SPRINGS).orElse(List.of()).size();
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
        long needed = count * BYTES_PER_PARTICLE + springs * BYTES_PER_SPRING;
        long allowed = Runtime.getRuntime().maxMemory();
        if (needed > allowed) {
            problems.add(scene.place(SceneFormat.SHAPES), "the scene needs about " + (needed >> 20)
                    + " MiB of memory, and Java may"
                    + " use " + (allowed >> 20) + "; take fewer particles, or start Java with more (-Xmx)");
        }
    }
}
