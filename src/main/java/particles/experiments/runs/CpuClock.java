package particles.experiments.runs;

import java.lang.management.ManagementFactory;
import java.lang.management.ThreadMXBean;

/** Measures CPU time, which does not include other work on the machine. */
public final class CpuClock {
    private static final ThreadMXBean THREADS = ManagementFactory.getThreadMXBean();
    private static final double NANO = 1e-9;

    private CpuClock() {
    }

    /**
     * @return the time since some moment (s): CPU time of the calling thread, or elapsed time if the virtual machine
     *         does not measure CPU time
     */
    public static double seconds() {
        return NANO * (THREADS.isCurrentThreadCpuTimeSupported() ? THREADS.getCurrentThreadCpuTime()
                : System.nanoTime());
    }
}
