package progress;

import java.io.FileDescriptor;
import java.io.FileOutputStream;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.util.Timer;
import java.util.TimerTask;
import org.junit.platform.engine.TestExecutionResult;
import org.junit.platform.engine.support.descriptor.ClassSource;
import org.junit.platform.engine.support.descriptor.MethodSource;
import org.junit.platform.launcher.TestExecutionListener;
import org.junit.platform.launcher.TestIdentifier;
import org.junit.platform.launcher.TestPlan;

/**
 * Prints every five seconds how many tests are done and which one runs. JUnit finds it by the file in
 * META-INF/services.
 */
public final class TestProgress implements TestExecutionListener {
    private static final String SWITCH = "desolver.testProgress";
    private static final int PAUSE_SECONDS = 5;

    /** The system's own stream: a test may have put another in the place of System.out. */
    private final PrintStream out = new PrintStream(new FileOutputStream(FileDescriptor.out), true,
            StandardCharsets.UTF_8);
    private Timer timer;
    private int seconds;
    private int done;
    private int failed;
    private String current = "";

    @Override
    public synchronized void testPlanExecutionStarted(TestPlan plan) {
        if (!Boolean.getBoolean(SWITCH)) {
            return;                                     // mutation tests start thousands of plans
        }
        timer = new Timer("test progress", true);
        timer.scheduleAtFixedRate(new TimerTask() {
            @Override
            public void run() {
                print();
            }
        }, 1000L * PAUSE_SECONDS, 1000L * PAUSE_SECONDS);
    }

    @Override
    public synchronized void testPlanExecutionFinished(TestPlan plan) {
        if (timer != null) {
            timer.cancel();
        }
    }

    @Override
    public synchronized void executionStarted(TestIdentifier test) {
        test.getSource().ifPresent(source -> {
            if (source instanceof MethodSource method) {
                current = method.getClassName() + "." + method.getMethodName();
            } else if (source instanceof ClassSource type) {
                current = type.getClassName();
            }
        });
    }

    @Override
    public synchronized void executionFinished(TestIdentifier test, TestExecutionResult result) {
        done += test.isTest() ? 1 : 0;
        failed += result.getStatus() == TestExecutionResult.Status.FAILED ? 1 : 0;
    }

    private synchronized void print() {
        seconds += PAUSE_SECONDS;
        out.println(seconds + " s: " + done + " tests done, " + failed + " failed; now " + current);
    }
}
