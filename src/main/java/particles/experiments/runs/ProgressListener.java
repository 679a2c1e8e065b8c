package particles.experiments.runs;

/** Receives the progress of an experiment. */
public interface ProgressListener {

    /**
     * @param part the part that is done, 0 to 1
     * @param what the present task, such as {@code rk4 on the pendulum}
     */
    void reached(double part, String what);
}
