package particles.output.painters;

/**
 * The positions of all particles at a time; nobody changes it any more, so that threads can share it.
 *
 * @param time   the time (s)
 * @param places three entries a particle (m)
 * @param ids    the ids of the particles
 */
public record TrailSample(double time, float[] places, String[] ids) {

    /**
     * @param later its index at a later time: particles keep their order, and new ones are the last
     * @return the index of a particle, or -1 if it was not there
     */
    int index(String id, int later) {
        for (int i = later; i < ids.length; i++) {
            if (ids[i].equals(id)) {
                return i;
            }
        }
        return -1;
    }
}
