package particles.teaching;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static particles.Texts.assertHas;
import static particles.Texts.assertStarts;

import deSolvers.DESolver;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.concurrent.Callable;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.atomic.AtomicLong;
import javax.tools.ToolProvider;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import particles.teaching.solvers.PlantedSolvers;
import particles.teaching.solvers.SolverCheck;
import particles.teaching.sources.Springs;
import particles.teaching.sources.StudentSource;

/** A class that does not come back ends its check with a clear line, and with the place where it was. */
class GuardedRunTest {

    /** What students write; the name lets the machinery be told from them. */
    private static final class PlantedClasses {
        static long endlessLoop(AtomicLong steps) {
            // the test's only concession: it ends when it is told to
            while (!Thread.currentThread().isInterrupted()) {
                steps.incrementAndGet();
            }
            return steps.get();
        }

        static int dividesByZero() {
            return 1 / new ArrayList<String>().size();
        }
    }

    private static String failure(Callable<?> what) {
        GuardedRun.Outcome<?> outcome = new GuardedRun(0.3).run(what);
        assertTrue(outcome.value().isEmpty());
        return outcome.failure().orElseThrow().toString();
    }

    private static void assertTold(String expected, String found) {
        assertStarts(found, expected);
        assertHas(found, "GuardedRunTest.java");
    }

    @Test
    void whatComesBackIsHandedOn() {
        assertEquals("done", new GuardedRun(0.3).run(() -> "done").value().orElseThrow());
    }

    /** The thread that waits for it takes no CPU time, and is not taken for one that waits for ever. */
    @Test
    void anEndlessLoopInAnotherThreadIsStopped() {
        AtomicLong steps = new AtomicLong();
        assertTold("failure: it did not come back within 3/10 s of CPU time: an endless loop, in "
                + "PlantedClasses.endlessLoop, line ", failure(() -> {
                    GuardedRun.await(new Thread(() -> PlantedClasses.endlessLoop(steps)));
                    return steps.get();
                }));
    }

    @Test
    void costlyStepsWithoutEndAreNotDecided() {
        String found = new GuardedRun(0.1).run(() -> {
            for (int step = 1; step > 0 && !Thread.currentThread().isInterrupted(); step++) {
                GuardedRun.goesOn();
            }
            return "";
        }).failure().orElseThrow().toString();
        assertHas(found, "not decided: ", " s were too little for all steps: ");
    }

    /** Each step comes back, after less CPU time and fewer evaluations than an endless one has; all take far more. */
    @Test
    void manyCostlyStepsAreNoEndlessLoop() {
        DESolver costly = PlantedSolvers.solver((source, deltaT) -> {
            for (int evaluation = 0; evaluation < 20_000; evaluation++) {
                PlantedSolvers.slope(source);
            }
        });
        assertEquals(20_000_000L, new GuardedRun(0.3).run(() -> StudentSource.after(new Springs(), costly, 1000, 1)
                .getEvaluations()).value().orElseThrow());
    }

    /**
     * Where a build compiles students' classes with the program's, the place that they come from does not tell them
     * apart.
     */
    @Test
    void aLoopThatCallsTheProgramIsTheStudentsLoop(@TempDir Path folder) throws Exception {
        Path source = Files.writeString(folder.resolve("LoopSolver.java"), """
                package exercises;

                public class LoopSolver extends deSolvers.DESolver {
                    @Override
                    public void stepState(deSolvers.DEStateSource source, double deltaT) {
                        double[] s = new double[source.getStateSize()];
                        while (!Thread.currentThread().isInterrupted()) {
                            source.getState(s);
                        }
                    }
                }
                """);
        assertEquals(0, ToolProvider.getSystemJavaCompiler().run(null, null, null, "-d", folder.toString(),
                source.toString()));
        byte[] bytes = Files.readAllBytes(folder.resolve("exercises/LoopSolver.class"));
        ClassLoader program = StudentFailure.class.getClassLoader();
        ClassLoader besideTheProgram = new ClassLoader(program) {
            @Override
            protected Class<?> findClass(String name) {
                return defineClass(name, bytes, 0, bytes.length, StudentFailure.class.getProtectionDomain());
            }
        };
        DESolver solver = (DESolver) besideTheProgram.loadClass("exercises.LoopSolver").getConstructor().newInstance();
        Thread.currentThread().setContextClassLoader(besideTheProgram);
        try {
            String found = failure(() -> SolverCheck.check(() -> solver, "LoopSolver"));
            assertTrue(found.matches(".*: an endless loop, in LoopSolver.stepState, line [78] of LoopSolver.java"),
                    found);
        } finally {
            Thread.currentThread().setContextClassLoader(program);
        }
    }

    @Test
    void whatTheJvmPutsBetweenIsNobodysPlace() {
        StackTraceElement lambda =
                new StackTraceElement("particles.app.student.CheckRun$$Lambda$22/0x00007f5e08027988", "call",
                null, -1);
        StackTraceElement ours = new StackTraceElement("particles.ParticleSystem", "getState", "ParticleSystem.java",
                90);
        assertEquals("", StudentFailure.place(new StackTraceElement[] {lambda}));
        assertEquals(", in ParticleSystem.getState, line 90 of ParticleSystem.java",
                StudentFailure.place(new StackTraceElement[] {lambda, ours}));
    }

    @Test
    void waitingForEverIsStopped() {
        CountDownLatch never = new CountDownLatch(1);
        String found = failure(() -> {
            never.await();
            return 1;
        });
        assertStarts(found, "failure: it did not come back within 3/10 s of CPU time: it waits for something "
                + "that never comes");
    }

    @Test
    void anExceptionIsNamedWithItsPlace() {
        assertTold("failure: it ends in an exception: java.lang.ArithmeticException: / by zero, in "
                + "PlantedClasses.dividesByZero, line ",
                failure(PlantedClasses::dividesByZero));
    }
}
