package particles.lab;

import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import particles.ParticleSystem;
import particles.law.Particles;
import particles.spec.Ordered;
import particles.view.SpringList;

/**
 * The particles, springs and rods of a run, until some are added or removed.
 *
 * @param ids    the particles' names
 * @param fixed  1 for fixed particles, else 0
 * @param births the time of birth of each particle (s)
 * @param lives  the lifetime of each particle (s); infinite if it has none
 * @param springs the springs and rods
 */
record Structure(String[] ids, int[] fixed, float[] births, float[] lives, SpringList springs) {

    static Structure of(ParticleSystem system) {
        Particles particles = system.getParticles();
        int n = particles.count();
        Structure made = new Structure(new String[n], new int[n], new float[n], new float[n],
                SpringList.of(parts(system)));
        for (int i = 0; i < n; i++) {
            made.ids[i] = particles.id(i);
            made.fixed[i] = particles.isFixed(i) ? 1 : 0;
            made.births[i] = (float) particles.birthTime(i);
            made.lives[i] = (float) (particles.deathTime(i) - particles.birthTime(i));
        }
        return made;
    }

    private static Stream<?> parts(ParticleSystem system) {
        return Stream.concat(system.getEffects().stream(), system.getReactions().stream());
    }

    /**
     * Whether the same particles and springs are still there: ids are never used again, so it is enough to compare the
     * last one.
     */
    boolean isOf(ParticleSystem system) {
        int n = system.getParticles().count();
        return n == ids.length && (n == 0 || ids[n - 1].equals(system.getParticles().id(n - 1)))
                && SpringList.count(parts(system)) == springs.count();
    }

    /** The same, by name, as pages read it. */
    Map<String, Object> facts() {
        IntStream ends = IntStream.range(0, 2 * springs.count())
                .map(k -> k % 2 == 0 ? springs.from()[k / 2] : springs.to()[k / 2]);
        return Ordered.map("ids", List.of(ids), "fixed", fixed, "births", births, "lives", lives, "springs",
                ends.toArray(), "restLengths",
                Arrays.stream(springs.restLength()).boxed().toList(), "rigid",
                IntStream.range(0, springs.count()).map(s -> springs.isRigid(s) ? 1 : 0).toArray());
    }

    /** About the number of bytes that it takes. */
    long bytes() {
        return 100 + 40L * ids.length + 24L * springs.count();
    }
}
