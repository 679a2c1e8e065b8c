package benchmarks;

import static particles.view.DataTable.column;

import deSolvers.catalog.SolverCatalog;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.Predicate;
import java.util.function.ToDoubleFunction;
import java.util.stream.Stream;
import particles.experiments.runs.ProgressListener;
import particles.output.FrameBenchmark;
import particles.view.DataTable;

/** The list of all benchmarks, which can be chosen by name. */
public final class Benchmarks {
    private static final int STEPS = 16;
    private static final double MILLI = 1e6;
    private static final List<String> SCENES = List.of("02-one-spring", "09-cloth-in-wind", "10-jelly-block");
    private static final List<String> FRAMES = List.of("05-hanging-chain", "08-cloth", "09-cloth-in-wind");

    private final Predicate<String> included;
    private final Stopwatch stopwatch;
    private final Stopwatch inOneProcess;
    private final ProgressListener progress;
    private int begun;

    /**
     * @param included selects names
     * @param times    measures a benchmark
     * @param progress receives the progress
     */
    public Benchmarks(Predicate<String> included, Measurement times, ProgressListener progress) {
        this(included, times, new Measurement(0, times.iterations(), times.seconds()), progress);
    }

    Benchmarks(Predicate<String> included, Stopwatch stopwatch, Stopwatch inOneProcess, ProgressListener progress) {
        this.included = included;
        this.stopwatch = stopwatch;
        this.inOneProcess = inOneProcess;
        this.progress = progress;
    }

    /** @return the names of all benchmarks */
    public static List<String> names() {
        List<String> names = new ArrayList<>();
        Comparison.plans().forEach(plan -> names.add(plan.toString()));
        runs().forEach(run -> names.add(name("solver", run)));
        steps().forEach(run -> names.add(name("steps", run)));
        SCENES.forEach(scene -> names.add("scene " + scene));
        FRAMES.forEach(scene -> names.add("frame " + scene));
        return names;
    }

    private static List<Run> runs() {
        return runs(List.of("oscillator", "chain"), SolverCatalog.names(), workload -> Workload.of(workload).deltaT());
    }

    /** Solvers that are measured against loops written by hand. */
    private static List<Run> steps() {
        return runs(List.of("oscillator", "chain", "cloth-64", "cloth-256"), ByHand.METHODS, workload ->
                Workload.DELTA_T);
    }

    private static List<Run> runs(List<String> workloads, List<String> solvers, ToDoubleFunction<String> deltaT) {
        return workloads.stream().flatMap(workload -> solvers.stream().map(solver ->
                Run.steps(workload, solver, STEPS * deltaT.applyAsDouble(workload), STEPS))).toList();
    }

    private static String name(String kind, Run run) {
        return kind + " " + run.workload() + " " + run.method();
    }

    /** @return a table for each kind of benchmark, the comparison first */
    public List<DataTable> measure() {
        List<Comparison> comparisons = progress.part(0, 0).each(Comparison.plans().stream().filter(plan ->
                included.test(plan.toString())).toList(), plan -> "settings for " + plan, Comparison::of);
        List<Run> both = comparisons.stream().flatMap(pair -> List.of(pair.ours(), pair.theirs()).stream()).distinct()
                .toList();
        List<Run> runs = runs().stream().filter(run -> included.test(name("solver", run))).toList();
        List<Run> steps = steps().stream().filter(run -> included.test(name("steps", run)))
                .flatMap(run -> Stream.of(run, ByHand.like(run))).toList();
        List<String> scenes = chosen("scene ", SCENES);
        List<String> frames = chosen("frame ", FRAMES);
        int all = both.size() + runs.size() + steps.size() + scenes.size() + frames.size();
        return Stream.of(BenchmarkTables.comparison(comparisons, medians(stopwatch, SolveBenchmark.class,
                        both, all)),
                BenchmarkTables.solvers(runs, medians(stopwatch, SolveBenchmark.class, runs, all)),
                BenchmarkTables.steps(medians(inOneProcess, SolveBenchmark.class, steps, all)),
                timeTable("scenes", "Reading, checking and building a scene",
                        medians(stopwatch, SceneBenchmark.class, scenes, all)),
                timeTable("frames", "Drawing a frame of 1280 x 720 pixels and compressing it to PNG, on one thread",
                        medians(stopwatch, FrameBenchmark.class, frames, all)))
                .filter(table -> !table.rows().isEmpty()).toList();
    }

    private List<String> chosen(String kind, List<String> names) {
        return names.stream().filter(name -> included.test(kind + name)).toList();
    }

    private <T> Map<T, Double> medians(Stopwatch stopwatch, Class<?> benchmark, List<T> what, int all) {
        Map<T, Double> medians = new LinkedHashMap<>();
        for (T one : what) {
            progress.reached((double) begun++ / all, one instanceof Run run ? run.label() : one.toString());
            medians.put(one, stopwatch.median(benchmark, one.toString()));
        }
        return medians;
    }

    private static DataTable timeTable(String name, String title, Map<String, Double> medians) {
        return DataTable.of(name, title, List.copyOf(medians.keySet()), column("scene", scene -> scene),
                column("time (ms)", 3, scene -> medians.get(scene) / MILLI));
    }
}
