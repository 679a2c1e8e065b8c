package particles.lab;

import java.nio.FloatBuffer;
import java.util.stream.Stream;
import particles.ParticleSystem;
import particles.law.Particles;
import particles.view.SpringView.SpringList;

/**
 * The particles, springs and rods of a run, until some are added or removed.
 *
 * @param ids     the particles' names
 * @param numbers three for each particle: 1 if it is fixed, else 0; its time of birth and its lifetime (s), infinite if
 *                it has none. Then four for each spring or rod: the particles at its ends, its rest length (m) and its
 *                stiffness (N/m), infinite for a rod. The page reads thousands of numbers much faster than their text.
 */
record Structure(String[] ids, float[] numbers) {

    static Structure of(ParticleSystem system) {
        Particles particles = system.getParticles();
        SpringList springs = SpringList.of(parts(system));
        String[] ids = new String[particles.count()];
        FloatBuffer numbers = FloatBuffer.allocate(3 * ids.length + 4 * springs.count());
        for (int i = 0; i < ids.length; i++) {
            ids[i] = particles.id(i);
            numbers.put(particles.isFixed(i) ? 1 : 0).put((float) particles.birthTime(i))
                    .put((float) (particles.deathTime(i) - particles.birthTime(i)));
        }
        for (int s = 0; s < springs.count(); s++) {
            numbers.put(springs.from()[s]).put(springs.to()[s]).put((float) springs.restLength()[s])
                    .put((float) springs.stiffness()[s]);
        }
        return new Structure(ids, numbers.array());
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
                && 3 * n + 4 * SpringList.count(parts(system)) == numbers.length;
    }

    /** About the number of bytes that it takes. */
    long bytes() {
        return 100 + 28L * ids.length + 4L * numbers.length;
    }
}
