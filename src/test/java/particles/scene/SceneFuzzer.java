package particles.scene;

import deSolvers.catalog.SolverCatalog;
import hunts.TaskOptions;
import java.io.IOException;
import java.lang.management.ManagementFactory;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.Random;
import java.util.Set;
import java.util.concurrent.TimeUnit;
import particles.Motion;
import particles.Observer;
import particles.SimulationException;

/**
 * Fuzzer of scenes: reads, builds and steps millions of almost valid scenes. Each must be refused with clear lines, end
 * with a SimulationException, or run. Inputs with new error messages are mutated further. {@code gradle fuzz
 * -Pseconds=1200} runs it by itself.
 */
final class SceneFuzzer {
    private static final int STEPS = 3;
    private static final long SLOW_NANOS = TimeUnit.SECONDS.toNanos(2);

    private final SceneMutator mutator;
    private final Set<String> words = new HashSet<>();
    private final Path found;
    private long executions;
    private long built;
    private long stopped;
    private long slowest;
    private int failures;

    /** @param found the folder for inputs that end in any other way */
    SceneFuzzer(long seed, Path found) throws IOException {
        this.found = found;
        List<byte[]> seeds = new ArrayList<>();
        for (Path file : SceneFiles.list(Path.of("scenes"))) {
            seeds.add(Files.readAllBytes(file));
        }
        mutator = new SceneMutator(seeds, new Random(seed));
    }

    /** Ends a run that goes well. */
    private static final class Enough extends RuntimeException {
        private static final long serialVersionUID = 1L;

        Enough() {
            super("enough", null, false, false);
        }
    }

    /**
     * Tries one input; returns whether it ended as documented. Reading and building must be fast, steps need not be.
     */
    boolean execute(byte[] scene) throws IOException {
        long begin = System.nanoTime();
        executions++;
        try {
            Optional<Scene> ready = build(scene);
            long time = System.nanoTime() - begin;
            if (time > SLOW_NANOS) {
                // measuring it is slow, and other processes may have had the processor
                long computing = threadTime();
                build(scene);
                time = threadTime() - computing;
            }
            slowest = Math.max(slowest, time);
            if (time > SLOW_NANOS) {
                return failed(scene,
                        new IllegalStateException("it took " + time / 1e9 + " s of computing to read and build it"));
            }
            ready.filter(made -> !isAdaptive(made)).ifPresent(SceneFuzzer::run);
        } catch (SimulationException e) {
            stopped++;
        } catch (RuntimeException | Error e) {
            return failed(scene, e);
        }
        return true;
    }

    private Optional<Scene> build(byte[] scene) {
        try {
            Scene ready = SceneBuilder.build(SceneReader.read("x.yaml", scene));
            built++;
            return Optional.of(ready);
        } catch (SceneException e) {
            String line = e.getLines().get(0).replaceAll("'[^']*'?|[0-9.e+-]+", "?");
            if (words.add(line.substring(0, Math.min(40, line.length())))) {
                mutator.keep(scene);
            }
            return Optional.empty();
        }
    }

    /** Adaptive solvers may make hundreds of thousands of sub-steps in a step of an absurd scene. */
    private static boolean isAdaptive(Scene scene) {
        String solver = scene.description().solver();
        return SolverCatalog.names().contains(solver) && SolverCatalog.info(solver).adaptive();
    }

    private static long threadTime() {
        return ManagementFactory.getThreadMXBean().getCurrentThreadCpuTime();
    }

    private static void run(Scene scene) {
        scene.simulation().addObserver(new Observer() {
            private int left = STEPS;

            @Override
            public void moved(Motion motion) {
                if (--left <= 0) {
                    throw new Enough();
                }
            }
        });
        try {
            scene.simulation().run();
        } catch (Enough e) {
            return;                                         // later steps are for other tests
        }
    }

    private boolean failed(byte[] scene, Throwable e) throws IOException {
        Files.createDirectories(found);
        Path file = found.resolve("found-" + failures++ + ".yaml");
        Files.write(file, scene);
        StackTraceElement[] trace = e.getStackTrace();
        System.out.println(file + ": " + e + (trace.length > 0 ? " at " + trace[0] : ""));
        return false;
    }

    /** Returns the number of inputs that did not end as documented. */
    int run(long mostExecutions, double seconds) throws IOException {
        long end = System.nanoTime() + (long) (seconds * 1e9);
        while (executions < mostExecutions && System.nanoTime() < end && failures < 100) {
            execute(mutator.next());
        }
        return failures;
    }

    @Override
    public String toString() {
        return String.format(Locale.ROOT,
                "%d executions: %d built, of which %d stopped; refused in %d ways; %d seeds; the slowest took"
                + " %.2f s; %d failures", executions, built, stopped, words.size(), mutator.seeds(), slowest / 1e9,
                failures);
    }

    /** @param args {@code --seconds=20}, {@code --executions=10000000}, {@code --seed=1}, each may be left out */
    public static void main(String[] args) throws IOException {
        long seed;
        long seconds;
        long executions;
        try {
            TaskOptions options = new TaskOptions(args, List.of("seconds", "executions", "seed"));
            seed = options.getCount("seed", System.nanoTime());
            seconds = options.getCount("seconds", 1200);
            executions = options.getCount("executions", 10_000_000);
        } catch (IllegalArgumentException e) {
            System.err.println(e.getMessage());
            System.exit(2);
            return;
        }
        System.out.println("seed " + seed);
        SceneFuzzer fuzzer = new SceneFuzzer(seed, Path.of("build", "fuzz"));
        int failures = fuzzer.run(executions, seconds);
        System.out.println(fuzzer);
        System.exit(failures == 0 ? 0 : 1);
    }
}
