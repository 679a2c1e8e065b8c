package particles.experiments.work;

import static particles.view.DataTable.column;

import deSolvers.text.Digits;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.function.LongSupplier;
import java.util.stream.IntStream;
import particles.effects.springs.SpringForce;
import particles.Simulation;
import particles.experiments.runs.ProgressListener;
import particles.experiments.runs.SceneRun;
import particles.law.Particles;
import particles.scene.Scene;
import particles.view.Axis;
import particles.view.Chart;
import particles.view.DataTable;
import particles.view.Look;
import particles.view.Panel;
import particles.view.Series;
import particles.view.Series.Mark;
import particles.view.SpringView;

/**
 * Measures the cost of each effect and rule: the time for a step of a cloth with springs alone, and with one effect or
 * rule more at a time. Before them comes a plain loop over the cloth's springs, as often as rk4 evaluates
 * the derivative. Effects that a scene does not name cost nothing.
 *
 * <p>All variants take turns, round by round, and the fastest round of each counts: other work on the machine only
 * makes a round slower.
 */
public final class EffectCost {
    private static final double DELTA_T = 1e-3;
    /** Times of the same step differ by less than this factor. */
    private static final double SPREAD = 1.2;
    /** So many bars with their names fit well on a slide. */
    private static final int MOST_BARS = 6;

    /** Structural and shear springs; the top row is fixed. It moves, so that nothing is at rest. */
    private static final String CLOTH = """
            title: A cloth
            teaches: What each effect costs.
            solver: rk4
            deltaT: %s
            duration: %s
            shapes:
              - cloth: {corner: [0, 0, 0], across: [%s, 0, 0], down: [0, -%s, 0], columns: %d, rows: %d, mass: 0.001,
                        velocity: [0.01, 0, 0.02], fixed: [top],
                        structural: {stiffness: 5, damping: 0.001}, shear: {stiffness: 2, damping: 0.001}}
            """;

    /** An effect or rule, and the lines that a scene has for it besides the cloth. */
    private record Addition(String name, String yaml) {
    }

    private static final List<Addition> ADDITIONS = List.of(
            new Addition("springs", ""),
            new Addition("+ gravity", "effects: [gravity]"),
            new Addition("+ drag", "effects: [drag: {coefficient: 0.01}]"),
            new Addition("+ quadratic drag", "effects: [quadraticDrag: {coefficient: 0.01}]"),
            new Addition("+ drag in wind",
                    "effects: [drag: {coefficient: 0.01}, wind: {mean: [1, 0, 0], gust: [0, 0, 1]}]"),
            new Addition("+ drag in turbulence", "effects: [drag: {coefficient: 0.01}, turbulence: {strength: 1}]"),
            new Addition("+ drag in a vortex", "effects: [drag: {coefficient: 0.01}, vortex: {speed: 1}]"),
            new Addition("+ push", "effects: [push: {force: [0, 0.01, 0]}]"),
            new Addition("+ attraction", "effects: [attraction: {strength: 1, centre: [0, -100, 0], softening: 1}]"),
            new Addition("+ cohesion", "effects: [cohesion: {range: 0.06, depth: 1e-9}]"),
            new Addition("+ repulsion", "effects: [repulsion: {radius: 0.03, stiffness: 1e-9}]"),
            new Addition("+ penalty plane", "effects: [penaltyPlane: {point: [0, -100, 0], stiffness: 1}]"),
            new Addition("+ penalty sphere",
                    "effects: [penaltySphere: {centre: [0, -100, 0], radius: 1, stiffness: 1}]"),
            new Addition("+ tear", "rules: [tear: {strain: 10}]"),
            new Addition("+ kill plane", "rules: [kill: {point: [0, -100, 0]}]"),
            new Addition("+ ground, clamp", "rules: [ground: {height: -100}]"),
            new Addition("+ ground, exact", "rules: [ground: {height: -100}]\nimpact: exact"),
            new Addition("+ sphere, exact", "rules: [sphere: {centre: [0, -100, 0], radius: 1}]\nimpact: exact"));
    private static final double SPACING = 0.05;

    private EffectCost() {
    }

    /**
     * The cost of one variant.
     *
     * @param name     the effect or rule that it has besides springs
     * @param seconds  the time for a step of rk4 (s)
     * @param overBase this time divided by the time with springs alone
     */
    public record Cost(String name, double seconds, double overBase) {
    }

    private record Variant(String name, Runnable round) {
    }

    /**
     * Measures.
     *
     * @param columns  the number of columns, and of rows, of particles in the cloth, 2 or more
     * @param steps    the number of steps in a round, 1 or more
     * @param rounds   the number of rounds, 1 or more
     * @param nanoTime a clock (ns)
     * @param progress receives the progress
     * @return the hand-written springs, the springs alone, and each addition
     */
    public static List<Cost> measure(int columns, int steps, int rounds, LongSupplier nanoTime,
            ProgressListener progress) {
        List<Variant> variants = variants(columns, steps, rounds);
        double[] fastest = new double[variants.size()];
        Arrays.fill(fastest, Double.POSITIVE_INFINITY);
        for (int round = 0; round < rounds; round++) {
            for (int v = 0; v < fastest.length; v++) {
                progress.reached((round + (double) v / fastest.length) / rounds, variants.get(v).name());
                long start = nanoTime.getAsLong();
                variants.get(v).round().run();
                fastest[v] = Math.min(fastest[v], (nanoTime.getAsLong() - start) / 1e9 / steps);
            }
        }
        return IntStream.range(0, fastest.length).mapToObj(v -> new Cost(variants.get(v).name(), fastest[v], fastest[v]
                / fastest[1])).toList();
    }

    private static List<Variant> variants(int columns, int steps, int rounds) {
        Scene cloth = scene(columns, steps, "");
        double[] inverseMasses = cloth.system().getParticles().getInverseMasses();
        double[] dSdt = new double[cloth.system().getStateSize()];
        List<Variant> all = new ArrayList<>(List.of(new Variant("springs, hand-written", () -> {
            for (int evaluation = 0; evaluation < 4 * steps; evaluation++) {
                loopOverSprings(cloth.springs(), inverseMasses, cloth.system().getOwnState(), dSdt);
            }
        })));
        ADDITIONS.forEach(addition -> all.add(new Variant(addition.name(), round(scene(columns, rounds * steps,
                addition.yaml()), steps))));
        return all;
    }

    /** @return makes this number of steps of a scene each time */
    static Runnable round(Scene scene, int steps) {
        Simulation simulation = scene.simulation();
        simulation.start();
        return () -> {
            for (int step = 0; step < steps; step++) {
                simulation.advance();
            }
        };
    }

    /**
     * Computes ds/dt of a mass-spring system in a plain loop over its springs, without effects, reactions or any choice
     * at all, by the law of {@link particles.effects.springs.SpringForce}.
     */
    static void loopOverSprings(SpringView springs, double[] inverseMasses, double[] s, double[] dSdt) {
        Arrays.fill(dSdt, 0);
        for (int k = 0; k < springs.springCount(); k++) {
            int i = Particles.STRIDE * springs.from(k);
            int j = Particles.STRIDE * springs.to(k);
            double x = s[j] - s[i];
            double y = s[j + 1] - s[i + 1];
            double z = s[j + 2] - s[i + 2];
            double length = Math.sqrt(x * x + y * y + z * z);
            double stretching = (x * (s[j + 3] - s[i + 3]) + y * (s[j + 4] - s[i + 4]) + z * (s[j + 5] - s[i + 5]))
                    / length;
            double perLength = (springs.stiffness(k) * (length - springs.restLength(k))
                    + springs.damping(k) * stretching) / length;
            dSdt[i + 3] += perLength * x;
            dSdt[i + 4] += perLength * y;
            dSdt[i + 5] += perLength * z;
            dSdt[j + 3] -= perLength * x;
            dSdt[j + 4] -= perLength * y;
            dSdt[j + 5] -= perLength * z;
        }
        for (int k = 0; k < s.length; k += Particles.STRIDE) {
            for (int c = k; c < k + 3; c++) {
                dSdt[c] = s[c + 3];
                dSdt[c + 3] *= inverseMasses[k / Particles.STRIDE];
            }
        }
    }

    /** @return a square cloth that runs for a number of steps, with more lines in its scene */
    static Scene scene(int columns, int steps, String addition) {
        double side = SPACING * (columns - 1);
        String text = Digits.format(CLOTH, DELTA_T, steps * DELTA_T, side, side, columns, columns);
        return SceneRun.of("a cloth", text + addition);
    }

    /**
     * @param costs the measured costs
     * @return a row for each
     */
    public static DataTable table(List<Cost> costs) {
        return DataTable.of("effectCost", "time for a step of rk4", costs, column("what the scene names", Cost::name),
                column("time (\u00b5s)", cost -> 1e6 * cost.seconds()),
                column("over springs alone", 3, Cost::overBase));
    }

    /**
     * @param costs the measured costs
     * @return a bar for each of the dearest, if it costs more than the spread of the measurements, in a row with its
     *         name and value, the cheapest above; one bar for all others; 1 is springs alone
     */
    public static Panel panel(List<Cost> costs) {
        List<Cost> sorted = costs.stream().sorted(Comparator.comparingDouble(Cost::overBase)).toList();
        long dearer = costs.stream().filter(cost -> cost.overBase() > SPREAD).count();
        int others = sorted.size() - (int) Math.min(MOST_BARS, dearer);
        List<Cost> bars = new ArrayList<>(sorted.subList(others, sorted.size()));
        bars.add(0, new Cost("the other " + others + ", at most", 0, sorted.get(others - 1).overBase()));
        List<double[]> lines = new ArrayList<>();
        for (int row = 0; row < bars.size(); row++) {
            lines.addAll(List.of(new double[] {1, row}, new double[] {bars.get(row).overBase(), row},
                    new double[] {Double.NaN, Double.NaN}));            // the pen is lifted between bars
        }
        return Panel.of("A step of cloth with one effect or rule more", List.of(new Chart(
                Axis.log("time for a step / time with springs alone", ""), Axis.linear("what the scene names", ""),
                List.of(Series.of(Look.OWN, "time for a step", Mark.FILL, lines))).inRows(bars.stream()
                .map(cost -> cost.name() + ": " + Digits.few(cost.overBase())).toList())));
    }

    /** @return the time of springs alone, divided by that of the hand-written loop, in words */
    public static String overLoop(List<Cost> costs) {
        return Digits.few(costs.get(1).seconds() / costs.get(0).seconds());
    }
}
