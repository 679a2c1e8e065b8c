package particles.output;

import particles.Memory;

/**
 * Where the particles were at a time; never changed once it is made, so that threads may share it.
 *
 * @param time   when (s)
 * @param places three entries a particle (m)
 * @param before the index that each particle had in the sample before, -1 for those that were not there; empty where all
 *               had the same
 */
record TrailSample(double time, float[] places, int[] before) {

    /** Passes a sample through a memory, and returns the one to go on with. */
    static TrailSample remembered(Memory memory, TrailSample sample) {
        double time = memory.keep(sample.time);
        int[] bits = new int[sample.places.length];
        for (int k = 0; k < bits.length; k++) {
            bits[k] = Float.floatToRawIntBits(sample.places[k]);
        }
        bits = memory.keep(bits, bits.length);
        float[] places = new float[bits.length];
        for (int k = 0; k < bits.length; k++) {
            places[k] = Float.intBitsToFloat(bits[k]);
        }
        return new TrailSample(time, places, memory.keep(sample.before, sample.before.length));
    }

    /** @return the index in the sample before of the particle with this one here, -1 if it was not there */
    int earlier(int i) {
        return before.length == 0 ? i : before[i];
    }
}
