package particles.law;

/** An effect that stores particle indices and must update them when particles are removed. */
public interface IndexedEffect extends Effect {

    /**
     * Called after particles were removed from the system.
     *
     * @param newIndex for each old index, the new one, or -1 if the particle was removed
     */
    void reindex(int[] newIndex);
}
