package particles.output.painters;

/**
 * The positions of all particles at a time; immutable, so that threads can share it.
 *
 * @param time   the time (s)
 * @param places three entries a particle (m)
 * @param before the index of each particle in the previous sample, -1 if it was not there; empty if all are the same
 */
public record TrailSample(double time, float[] places, int[] before) {

    /** @return the index in the previous sample of the particle with this index, -1 if it was not there */
    public int earlier(int i) {
        return before.length == 0 ? i : before[i];
    }
}
