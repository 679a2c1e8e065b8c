package particles.experiments.work;

import deSolvers.RK4Solver;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.Locale;
import java.util.function.BiConsumer;
import java.util.function.LongSupplier;
import particles.ParticleSystem;
import particles.Simulation;
import particles.effects.Cohesion;
import particles.effects.Gravity;
import particles.effects.GustyWind;
import particles.effects.LinearDrag;
import particles.effects.PenaltyPlane;
import particles.effects.PenaltySphere;
import particles.effects.PointAttraction;
import particles.effects.QuadraticDrag;
import particles.effects.TurbulentWind;
import particles.effects.Wind;
import particles.effects.springs.SpringForce;
import particles.experiments.runs.ProgressListener;
import particles.law.Obstacle;
import particles.law.Plane;
import particles.law.Sphere;
import particles.law.Vector3;
import particles.reactions.RestingContacts;
import particles.reactions.contact.ContactSurface;
import particles.reactions.contact.Friction;
import particles.rules.ClampedImpacts;
import particles.rules.ExactImpacts;
import particles.rules.KillPlane;
import particles.rules.SpringTear;
import particles.view.ChartData;
import particles.view.ChartData.Mark;
import particles.view.ChartData.Series;
import particles.view.DataTable;

/**
 * Measures the cost of each effect and rule: the time for a step of a cloth with springs alone, and with one effect or
 * rule more at a time. Before them comes the same cloth as the fastest hand-written code known to us for springs alone,
 * which is a lower bound. Effects that a scene does not name cost nothing, so the first two should hardly differ.
 *
 * <p>All variants take turns, round by round, and the fastest round of each counts: other work on the machine only
 * makes a round slower.
 */
public final class EffectCost {
    private static final double DELTA_T = 1e-3;
    private static final double SPACING = 0.05;
    private static final double TWO_DECIMALS = 10;
    private static final Vector3 FAR_BELOW = new Vector3(0, -100, 0);

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

    private interface Steps {
        void make(int count);
    }

    private record Variant(String name, Steps steps) {
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
        List<Variant> variants = variants(columns);
        double[] fastest = new double[variants.size()];
        Arrays.fill(fastest, Double.POSITIVE_INFINITY);
        for (int round = 0; round < rounds; round++) {
            for (int v = 0; v < fastest.length; v++) {
                progress.reached((round + (double) v / fastest.length) / rounds, variants.get(v).name());
                long start = nanoTime.getAsLong();
                variants.get(v).steps().make(steps);
                fastest[v] = Math.min(fastest[v], (nanoTime.getAsLong() - start) / 1e9 / steps);
            }
        }
        List<Cost> costs = new ArrayList<>();
        for (int v = 0; v < fastest.length; v++) {
            costs.add(new Cost(variants.get(v).name(), fastest[v], fastest[v] / fastest[1]));
        }
        return costs;
    }

    private static List<Variant> variants(int columns) {
        List<Variant> all = new ArrayList<>();
        all.add(new Variant("springs, hand-written", byHand(columns)));
        all.add(with(columns, "springs", (system, simulation) -> { }));
        all.add(with(columns, "+ gravity",
                (s, r) -> s.addEffect(new Gravity(s.getParticles(), new Vector3(0, -9.81, 0)))));
        all.add(with(columns, "+ drag", (s, r) -> s.addEffect(new LinearDrag(s.getParticles(), 0.01, Wind.STILL))));
        all.add(with(columns, "+ quadratic drag",
                (s, r) -> s.addEffect(new QuadraticDrag(s.getParticles(), 0.01, Wind.STILL))));
        all.add(with(columns, "+ drag in wind", (s, r) -> s.addEffect(new LinearDrag(s.getParticles(), 0.01,
                new GustyWind(new Vector3(1, 0, 0), new Vector3(0, 0, 1), 1)))));
        all.add(with(columns, "+ drag in turbulence", (s, r) -> s.addEffect(new LinearDrag(s.getParticles(), 0.01,
                new TurbulentWind(Vector3.ZERO, 1, 1, 1)))));
        all.add(with(columns, "+ attraction",
                (s, r) -> s.addEffect(new PointAttraction(s.getParticles(), FAR_BELOW, 1, 1))));
        all.add(with(columns, "+ cohesion", (s, r) -> s.addEffect(new Cohesion(s.getParticles(), 1.2 * SPACING, SPACING,
                1e-9, 0))));
        all.add(with(columns, "+ penalty plane",
                (s, r) -> s.addEffect(new PenaltyPlane(s.getParticles(), Plane.ground(-100), 1, 0))));
        all.add(with(columns, "+ penalty sphere", (s, r) -> s.addEffect(
                new PenaltySphere(s.getParticles(), new Sphere(FAR_BELOW, 1, false), 1, 0))));
        all.add(with(columns, "+ tear", (s, r) -> r.addRule(new SpringTear((SpringForce) s.getEffects().get(0), 10))));
        all.add(with(columns, "+ kill plane", (s, r) -> r.addRule(new KillPlane(Plane.ground(-100)))));
        all.add(with(columns, "+ ground, clamp",
                (s, r) -> r.addRule(new ClampedImpacts(contacts(s, Plane.ground(-100))))));
        all.add(with(columns, "+ ground, exact",
                (s, r) -> r.addEventRule(new ExactImpacts(contacts(s, Plane.ground(-100))),
                new RK4Solver())));
        all.add(with(columns, "+ sphere, exact", (s, r) -> r.addEventRule(new ExactImpacts(contacts(s,
                new Sphere(FAR_BELOW, 1, false))), new RK4Solver())));
        return all;
    }

    private static RestingContacts contacts(ParticleSystem system, Obstacle obstacle) {
        RestingContacts contacts = new RestingContacts(system.getParticles(),
                List.of(new ContactSurface("solid", obstacle, 0.5, Friction.NONE, 0.01)));
        system.addReaction(contacts);
        return contacts;
    }

    /** A square of particles with structural and shear springs, its top row fixed. */
    static ParticleSystem cloth(int columns) {
        ParticleSystem system = new ParticleSystem();
        SpringForce springs = new SpringForce(system.getParticles());
        for (int n = 0; n < columns * columns; n++) {
            int column = n % columns;
            int row = n / columns;
            double z = 0.01 * SPACING * (column * 7 % 5);           // not quite flat, so that nothing is at rest
            system.addParticle("c" + n, 0.001, new Vector3(SPACING * column, -SPACING * row, z), Vector3.ZERO,
                    row == 0);
            double diagonal = SPACING * Math.sqrt(2);
            if (column > 0) {
                springs.addSpring(n - 1, n, 5, SPACING, 0.001);
            }
            if (row > 0) {
                springs.addSpring(n - columns, n, 5, SPACING, 0.001);
            }
            if (row > 0 && column > 0) {
                springs.addSpring(n - columns - 1, n, 2, diagonal, 0.001);
                springs.addSpring(n - columns, n - 1, 2, diagonal, 0.001);
            }
        }
        system.addEffect(springs);
        return system;
    }

    private static Steps byHand(int columns) {
        ParticleSystem system = cloth(columns);
        HandwrittenBaseline source = new HandwrittenBaseline(system, (SpringForce) system.getEffects().get(0));
        RK4Solver solver = new RK4Solver();
        return count -> {
            for (int step = 0; step < count; step++) {
                solver.stepState(source, DELTA_T);
            }
        };
    }

    private static Variant with(int columns, String name, BiConsumer<ParticleSystem, Simulation> addition) {
        ParticleSystem system = cloth(columns);
        RK4Solver solver = new RK4Solver();
        return new Variant(name, new Steps() {
            private Simulation simulation;

            @Override
            public void make(int count) {
                if (simulation == null) {
                    simulation = new Simulation(system, solver, DELTA_T, count * DELTA_T, Double.POSITIVE_INFINITY);
                    addition.accept(system, simulation);
                }
                simulation.run();
            }
        });
    }

    /**
     * @param costs the measured costs
     * @return a row for each
     */
    public static DataTable table(List<Cost> costs) {
        List<List<Object>> rows = new ArrayList<>();
        for (Cost cost : costs) {
            rows.add(List.of(cost.name(), 1e6 * cost.seconds(), cost.overBase()));
        }
        return new DataTable("effectCost", "time for a step of rk4", List.of(DataTable.column("what the scene names"),
                DataTable.column("time (\u00b5s)"), new DataTable.Column("over springs alone", 3)), rows);
    }

    /**
     * @param costs the measured costs
     * @return a bar for each, in a row with its name and value, the cheapest above; 1 is springs alone
     */
    public static ChartData chart(List<Cost> costs) {
        List<Cost> sorted = costs.stream().sorted(Comparator.comparingDouble(Cost::overBase)).toList();
        double[] x = new double[3 * sorted.size()];
        double[] y = new double[3 * sorted.size()];
        for (int k = 0; k < sorted.size(); k++) {
            x[3 * k] = 1;
            x[3 * k + 1] = sorted.get(k).overBase();
            x[3 * k + 2] = Double.NaN;                  // the pen is lifted between bars
            y[3 * k] = k;
            y[3 * k + 1] = k;
            y[3 * k + 2] = Double.NaN;
        }
        Cost dearest = sorted.get(sorted.size() - 1);
        List<String> rows = sorted.stream().map(cost -> cost.name() + ": " + times(cost)).toList();
        return new ChartData("The dearest is '" + dearest.name() + "': a step takes " + times(dearest)
                + " times as long as with springs alone", "time for a step / time with springs alone",
                "what the scene names", true, false, rows, List.of(new Series("time for a step", Mark.BAND, x, y)));
    }

    /** @return the time of springs alone, divided by that of the hand-written code, in words */
    public static String overBound(List<Cost> costs) {
        return String.format(Locale.ROOT, "%.2f", costs.get(1).seconds() / costs.get(0).seconds());
    }

    private static String times(Cost cost) {
        return String.format(Locale.ROOT, cost.overBase() < TWO_DECIMALS ? "%.2f" : "%.0f", cost.overBase());
    }
}
