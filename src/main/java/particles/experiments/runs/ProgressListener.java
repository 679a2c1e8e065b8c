package particles.experiments.runs;

/** Hears how far an experiment has come. */
public interface ProgressListener {

    /**
     * @param part how much is done, 0 to 1
     * @param what what is being done, such as {@code rk4 on the pendulum}
     */
    void reached(double part, String what);
}
