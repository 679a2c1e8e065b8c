package particles.experiments.runs;

import java.lang.management.ManagementFactory;
import java.lang.management.ThreadMXBean;

/** Says for how long the calling thread has kept a processor busy: what else the machine does is not in it. */
public final class CpuClock {
    private static final ThreadMXBean THREADS = ManagementFactory.getThreadMXBean();
    private static final double NANO = 1e-9;

    private CpuClock() {
    }

    /** @return since some moment (s); where the virtual machine does not know that, all time counts */
    public static double seconds() {
        return NANO * (THREADS.isCurrentThreadCpuTimeSupported() ? THREADS.getCurrentThreadCpuTime()
                : System.nanoTime());
    }
}
