package hunts;

import deSolvers.catalog.SolverCatalog;
import hunts.Judge.Verdict;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collections;
import java.util.EnumMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.Random;
import java.util.TreeMap;
import java.util.stream.Collectors;
import net.jqwik.api.RandomGenerator;
import net.jqwik.api.Shrinkable;
import net.jqwik.api.sessions.JqwikSession;

/**
 * Fuzzer: reads, builds and steps millions of almost valid texts, and runs whole drawn scenes, see {@link Judge}. Texts
 * with new error messages are changed further. What is found is shrunk by jqwik. {@code gradle fuzz -Pseconds=1200}
 * runs it by itself; the same seed and number of executions give the same finds, whatever the number of cores.
 */
final class SceneFuzzer {
    /** One execution in so many is a drawn scene, whose physics is judged. */
    static final int SCENE_EVERY = 30;
    private static final int BATCH = 3000;
    private static final int GENERATOR_SIZE = 1000;
    private static final int MOST_FINDS = 100;
    private static final int MOST_SHRINKS = 50;
    /** The median of this many orders, or more, has to be the solver's. Measured: within 0.2. */
    private static final int ENOUGH = 30;
    private static final double ORDER_OFF = 0.4;

    private final Random random;
    private final Path found;
    private final BrokenText texts = new BrokenText();
    private final Map<String, Integer> kinds = new TreeMap<>();
    private final Map<String, List<Double>> orders = new TreeMap<>();
    /** Of each kind, how many were drawn, and how many of those were compared with a reference. */
    private final Map<DrawnScene.Kind, int[]> hunted = new EnumMap<>(DrawnScene.Kind.class);
    private long executions;
    private int finds;

    /** An input, drawn, and how it is judged. */
    private record Input(Shrinkable<?> drawn, Object value) {
        Input(Shrinkable<?> drawn) {
            this(drawn, drawn.value());
        }

        byte[] text() {
            return value instanceof BrokenText.Draw draw ? draw.text()
                    : value.toString().getBytes(StandardCharsets.UTF_8);
        }

        Verdict judged() {
            return value instanceof BrokenText.Draw draw ? Judge.ofText(draw.text()) : Judge.ofScene(value.toString());
        }
    }

    /** @param found the folder for inputs with which something is wrong */
    SceneFuzzer(long seed, Path found) {
        random = new Random(seed);
        this.found = found;
    }

    /** Returns the number of finds. */
    int run(long mostExecutions, double seconds) {
        JqwikSession.run(() -> {
            long begin = System.nanoTime();
            RandomGenerator<BrokenText.Draw> text = texts.any().generator(GENERATOR_SIZE);
            RandomGenerator<DrawnScene> scene = DrawnScene.any().generator(GENERATOR_SIZE);
            while (executions < mostExecutions && System.nanoTime() - begin < seconds * 1e9 && finds < MOST_FINDS) {
                List<Input> batch = new ArrayList<>();
                for (; batch.size() < BATCH && executions < mostExecutions; executions++) {
                    batch.add(new Input((executions % SCENE_EVERY == 0 ? scene : text).next(random)));
                }
                List<Verdict> verdicts = batch.parallelStream().map(Input::judged).collect(Collectors.toList());
                for (int k = 0; k < batch.size(); k++) {
                    note(batch.get(k), verdicts.get(k));
                }
            }
            checkOrders();
        });
        return finds;
    }

    private void note(Input input, Verdict verdict) throws IOException {
        if (kinds.merge(verdict.kind(), 1, Integer::sum) == 1 && input.value instanceof BrokenText.Draw draw) {
            texts.keep(draw);
        }
        if (!Double.isNaN(verdict.order())) {
            orders.computeIfAbsent(verdict.kind(), kind -> new ArrayList<>()).add(verdict.order());
        }
        if (input.value instanceof DrawnScene scene) {
            for (DrawnScene.Kind kind : scene.kinds()) {
                int[] count = hunted.computeIfAbsent(kind, k -> new int[2]);
                count[0]++;
                count[1] += verdict.compared() ? 1 : 0;
            }
        }
        if (!verdict.find().isEmpty()) {
            Input least = shrunk(input, verdict.find());
            Files.createDirectories(found);
            Path file = found.resolve("found-" + finds++ + ".yaml");
            Files.write(file, least.text());
            System.out.println(file + ": " + verdict.find() + "; shrunk: " + least.judged().find());
        }
    }

    /** The least input that jqwik finds on its way down with which the same is wrong. */
    private static Input shrunk(Input input, String find) {
        String same = find.substring(0, Math.min(20, find.length()));
        Input least = input;
        Optional<Input> next = Optional.of(input);
        for (int k = 0; k < MOST_SHRINKS && next.isPresent(); k++) {
            least = next.get();
            next = least.drawn.shrink().limit(MOST_SHRINKS).map(Input::new)
                    .filter(smaller -> smaller.judged().find().startsWith(same)).findFirst();
        }
        return least;
    }

    /** A solver that loses its order in some kind of scene has a mistake, or the scene has. */
    private void checkOrders() {
        orders.forEach((kind, values) -> {
            Collections.sort(values);
            double median = values.get(values.size() / 2);
            int order = kind.equals(Judge.CLAMP) ? 1 : SolverCatalog.info(kind.replaceFirst(",.*", "")).order();
            if (values.size() >= ENOUGH && Math.abs(median - order) > ORDER_OFF) {
                finds++;
                System.out.printf(Locale.ROOT, "%s: order %.2f in %d scenes%n", kind, median, values.size());
            }
        });
    }

    private String hunted() {
        return hunted.entrySet().stream().map(kind -> kind.getValue()[0] + " of "
                + kind.getKey().toString().toLowerCase(Locale.ROOT).replace('_', ' ') + " (" + kind.getValue()[1] + ")")
                .collect(Collectors.joining(", "));
    }

    private int sum(String pattern) {
        return kinds.keySet().stream().filter(kind -> kind.matches(pattern)).mapToInt(kinds::get).sum();
    }

    @Override
    public String toString() {
        return String.format(Locale.ROOT, """
                %d executions: %d texts built, %d scenes drawn; %d runs stopped; refused in %d ways
                drawn scenes: %d cut short, %d not resolved, %d measure an order
                hunted, in brackets compared with a reference: %s
                %d finds""", executions, sum("built"), (executions + SCENE_EVERY - 1) / SCENE_EVERY, sum("stopped"),
                kinds.keySet().stream().filter(kind -> kind.startsWith("refused")).count(), sum("cut|no reference"),
                sum("not resolved"), orders.values().stream().mapToInt(List::size).sum(), hunted(),
                finds);
    }

    /** @param args {@code --seconds=20}, {@code --executions=10000000}, {@code --seed=1}, each may be left out */
    public static void main(String[] args) {
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
        int finds = fuzzer.run(executions, seconds);
        System.out.println(fuzzer);
        System.exit(finds == 0 ? 0 : 1);
    }
}
