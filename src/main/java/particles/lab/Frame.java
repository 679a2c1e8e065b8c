package particles.lab;

import java.nio.FloatBuffer;
import java.util.List;
import java.util.Map;
import java.util.stream.Stream;
import particles.ParticleSystem;
import particles.law.Particles;
import particles.law.Vector3;
import particles.view.SpringView.SpringList;

/**
 * A moment of a run.
 *
 * @param time      t (s)
 * @param state     positions and velocities, six numbers per particle (m, m/s)
 * @param energies  the energies in the order of {@link FrameRecorder#getEnergyNames()} (J)
 * @param structure the particles and springs at that time
 * @param account   what it cost to come there
 */
record Frame(double time, float[] state, float[] energies, Structure structure, Account account) {

    /**
     * What the run had cost by then.
     *
     * @param steps       the steps
     * @param evaluations the evaluations of the derivative
     * @param work        the work done on the system, by name (J)
     */
    record Account(long steps, long evaluations, Map<String, Double> work) {
    }

    /**
     * A moment between this one and the next, on straight lines.
     *
     * @param time its time (s)
     */
    Frame towards(Frame next, double time) {
        if (next.structure != structure) {
            return this;
        }
        float part = (float) ((time - this.time) / (next.time - this.time));
        float[] between = new float[state.length];
        for (int i = 0; i < between.length; i++) {
            between[i] = state[i] + part * (next.state[i] - state[i]);
        }
        return new Frame(time, between, energies, structure, account);
    }

    /**
     * @param what  -1 for the time (s), 0 to 2 for a coordinate (m), 3 to 5 for a velocity, 6 for the speed (m/s), 7
     *              for the distance from the other particle (m), 8 and more for an energy (J)
     * @param id    a particle
     * @param other another one
     * @return that number; NaN if something of it is not there
     */
    float value(int what, String id, String other) {
        if (what < 0) {
            return (float) time;
        }
        if (what > 7) {
            return what - 8 < energies.length ? energies[what - 8] : Float.NaN;
        }
        int i = 6 * List.of(structure.ids).indexOf(id);
        int j = 6 * List.of(structure.ids).indexOf(other);
        if (i < 0 || what == 7 && j < 0) {
            return Float.NaN;
        }
        return what < 6 ? state[i + what] : what == 6 ? length(state[i + 3], state[i + 4], state[i + 5])
                : length(state[i] - state[j], state[i + 1] - state[j + 1], state[i + 2] - state[j + 2]);
    }

    private static float length(double x, double y, double z) {
        return (float) new Vector3(x, y, z).length();
    }

    /** About the number of bytes that it takes, without its structure, which it shares with others. */
    long bytes() {
        return 200 + 100L * account.work().size() + 4L * state.length + 4L * energies.length;
    }

    /**
     * The particles, springs and rods of a run, until some are added or removed.
     *
     * @param ids     the particles' names
     * @param numbers three for each particle: 1 if it is fixed, else 0; its time of birth and its lifetime (s),
     *                infinite if it has none. Then four for each spring or rod: the particles at its ends, its rest
     *                length (m) and its stiffness (N/m), infinite for a rod. The page reads thousands of numbers much
     *                faster than their text.
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
         * Whether the same particles and springs are still there: ids are never used again, so it is enough to compare
         * the last one.
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
}
