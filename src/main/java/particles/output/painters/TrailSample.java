package particles.output.painters;

/**
 * The positions of all particles at a time; immutable, so that threads can share it.
 *
 * @param time   when (s)
 * @param places three entries a particle (m)
 * @param before the index that each particle had in the sample before, -1 for those that were not there; empty where
 *               all had the same
 */
public record TrailSample(double time, float[] places, int[] before) {

    /** @return the index in the sample before of the particle with this one here, -1 if it was not there */
    public int earlier(int i) {
        return before.length == 0 ? i : before[i];
    }
}
