package particles.experiments.work;

import static particles.view.DataTable.column;

import deSolvers.text.Digits;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.function.DoubleSupplier;
import java.util.stream.IntStream;
import particles.Simulation;
import particles.experiments.runs.ProgressListener;
import particles.experiments.runs.SceneRun;
import particles.scene.Scene;
import particles.view.Axis;
import particles.view.Chart;
import particles.view.DataTable;
import particles.view.Look;
import particles.view.Panel;
import particles.view.Series;
import particles.view.Series.Mark;

/**
 * Measures the cost of each effect and rule: the time for a step of a cloth with springs alone, and with one effect or
 * rule more at a time. Effects that a scene does not name cost nothing.
 *
 * <p>All variants take turns, round by round, and the fastest round of each counts: other work on the machine only
 * makes a round slower.
 */
public final class EffectCost {
    private static final double DELTA_T = 1e-3;
    /** The number of rows of the chart. */
    public static final int ROWS = 8;

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
            new Addition("+ muscles", "effects: [muscles: {amplitude: 1e-3, period: 1, wavelength: 0.5}]"),
            new Addition("+ gravitation", "effects: [gravitation: {softening: 1}]"),
            new Addition("+ magnetic field", "effects: [magneticField: {field: [0, 1, 0]}]"),
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

    /**
     * Measures.
     *
     * @param columns  the number of columns, and of rows, of particles in the cloth, 2 or more
     * @param steps    the number of steps in a round, 1 or more
     * @param rounds   the number of rounds, 1 or more
     * @param clock    a clock (s)
     * @param progress receives the progress
     * @return the springs alone, and each addition
     */
    public static List<Cost> measure(int columns, int steps, int rounds, DoubleSupplier clock,
            ProgressListener progress) {
        List<Runnable> variants = ADDITIONS.stream().map(addition -> round(scene(columns, rounds * steps,
                addition.yaml()), steps)).toList();
        double[] fastest = new double[variants.size()];
        Arrays.fill(fastest, Double.POSITIVE_INFINITY);
        for (int round = 0; round < rounds; round++) {
            for (int v = 0; v < fastest.length; v++) {
                progress.reached((round + (double) v / fastest.length) / rounds, ADDITIONS.get(v).name());
                double start = clock.getAsDouble();
                variants.get(v).run();
                fastest[v] = Math.min(fastest[v], (clock.getAsDouble() - start) / steps);
            }
        }
        return IntStream.range(0, fastest.length).mapToObj(v -> new Cost(ADDITIONS.get(v).name(), fastest[v],
                fastest[v] / fastest[0])).toList();
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
        return DataTable.of("effectCost", "The time for a step of rk4", costs,
                column("what the scene names", Cost::name), column("time (\u00b5s)", cost -> 1e6 * cost.seconds()),
                column("time / time with springs alone", 3, Cost::overBase));
    }

    /**
     * @param costs the measured costs
     * @return a row for each of those that cost most, with its name, value and a point; the cheapest is the top row
     */
    public static Panel panel(List<Cost> costs) {
        List<Cost> dearest = costs.stream().sorted(Comparator.comparingDouble(Cost::overBase))
                .skip(Math.max(0, costs.size() - ROWS)).toList();
        return Panel.of("A step of cloth with one effect or rule more", List.of(new Chart(
                Axis.log("time for a step / time with springs alone", ""), Axis.linear("what the scene names", ""),
                List.of(Series.of(Look.OWN, "time for a step", Mark.POINTS, dearest, Cost::overBase, dearest::indexOf)))
                .inRows(dearest.stream().map(cost -> cost.name() + ": " + Digits.few(cost.overBase())).toList())));
    }
}
