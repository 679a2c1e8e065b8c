package particles.lab;

import java.util.List;
import java.util.Map;
import java.util.stream.Stream;
import particles.ParticleSystem;
import particles.law.Particles;
import particles.spec.Ordered;
import particles.view.SpringView;

/**
 * The particles, springs and rods of a run, until some are added or removed.
 *
 * @param ids    the particles' names
 * @param fixed  1 for fixed particles, else 0
 * @param births the time of birth of each particle (s)
 * @param lives  the lifetime of each particle (s); infinite if it has none
 * @param links  the springs and rods
 */
record Structure(String[] ids, int[] fixed, float[] births, float[] lives, Links links) {

    /**
     * Springs and rods.
     *
     * @param ends        the particles at their ends, two each
     * @param restLengths their lengths at rest (m)
     * @param rigid       1 for rods, else 0
     */
    record Links(int[] ends, float[] restLengths, int[] rigid) {
        Links(int count) {
            this(new int[2 * count], new float[count], new int[count]);
        }
    }

    static Structure of(ParticleSystem system) {
        Particles particles = system.getParticles();
        int n = particles.count();
        int count = views(system).stream().mapToInt(SpringView::springCount).sum();
        Structure made = new Structure(new String[n], new int[n], new float[n], new float[n],
                new Links(count));
        for (int i = 0; i < n; i++) {
            made.ids[i] = particles.id(i);
            made.fixed[i] = particles.isFixed(i) ? 1 : 0;
            made.births[i] = (float) particles.birthTime(i);
            made.lives[i] = (float) (particles.deathTime(i) - particles.birthTime(i));
        }
        int next = 0;
        for (SpringView view : views(system)) {
            for (int s = 0; s < view.springCount(); s++, next++) {
                made.links.ends[2 * next] = view.from(s);
                made.links.ends[2 * next + 1] = view.to(s);
                made.links.restLengths[next] = (float) view.restLength(s);
                made.links.rigid[next] = view.stiffness(s) == Double.POSITIVE_INFINITY ? 1 : 0;
            }
        }
        return made;
    }

    private static List<SpringView> views(ParticleSystem system) {
        return Stream.concat(system.getEffects().stream(), system.getReactions().stream())
                .filter(SpringView.class::isInstance).map(SpringView.class::cast).toList();
    }

    /**
     * Whether the same particles and springs are still there: ids are never used again, so it is enough to compare the
     * last one.
     */
    boolean isOf(ParticleSystem system) {
        int n = system.getParticles().count();
        return n == ids.length && (n == 0 || ids[n - 1].equals(system.getParticles().id(n - 1)))
                && views(system).stream().mapToInt(SpringView::springCount).sum() == links.restLengths.length;
    }

    /** The same, by name, as pages read it. */
    Map<String, Object> facts() {
        return Ordered.map("ids", List.of(ids), "fixed", fixed, "births", births, "lives", lives, "springs", links.ends,
                "restLengths", links.restLengths, "rigid", links.rigid);
    }

    /** About the number of bytes that it takes. */
    long bytes() {
        return 100 + 40L * ids.length + 16L * links.restLengths.length;
    }
}
