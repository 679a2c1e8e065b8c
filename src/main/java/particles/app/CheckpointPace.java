package particles.app;

import particles.Simulation;

/**
 * How often a run is written down to be continued later. The steps are part of what the run computes, since its solver
 * begins anew after so many; the pause is not.
 *
 * @param steps after how many steps it may be
 * @param pause between two at least (s)
 * @param share of the time that the writing may take at most
 */
record CheckpointPace(int steps, double pause, double share) {
    /** What is lost at worst is little beside the time it takes to start again. */
    static final CheckpointPace USUAL = new CheckpointPace(Simulation.CHECKPOINT_STEPS, 1, 0.02);
}
