package particles.law;

/** An effect that keeps indices of particles, and has to follow when particles are removed. */
public interface IndexedEffect extends Effect {

    /**
     * Particles were removed from the system.
     *
     * @param newIndex the new index of each particle by its old one, -1 for those that are gone
     */
    void reindex(int[] newIndex);
}
