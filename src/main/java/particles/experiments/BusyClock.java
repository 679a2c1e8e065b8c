package particles.experiments;

import java.lang.management.ManagementFactory;
import java.lang.management.ThreadMXBean;

/** Says for how long the calling thread has kept a processor busy: what else the machine does is not in it. */
final class BusyClock {
    private static final ThreadMXBean THREADS = ManagementFactory.getThreadMXBean();
    private static final double NANO = 1e-9;

    private BusyClock() {
    }

    /** @return since some moment (s); where the virtual machine does not know that, all time counts */
    static double seconds() {
        return NANO * (THREADS.isCurrentThreadCpuTimeSupported() ? THREADS.getCurrentThreadCpuTime() : System.nanoTime());
    }
}
