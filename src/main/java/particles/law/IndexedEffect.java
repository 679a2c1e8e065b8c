package particles.law;

/** An effect that stores particle indices and must update them when particles are removed. */
public interface IndexedEffect extends Effect {

    /**
     * Called after particles were removed from the system.
     *
     * @param newIndex the new index of each particle by its old one, -1 for those that are gone
     */
    void reindex(int[] newIndex);
}
