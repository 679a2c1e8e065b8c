package particles.experiments.grid;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.ConcurrentHashMap;
import java.util.function.Function;
import java.util.function.Predicate;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import particles.EnergyLimit;
import particles.Observer;
import particles.ParticleSystem;
import particles.Rule;
import particles.energy.EnergyRecorder;
import particles.experiments.grid.Grid.Row;
import particles.experiments.grid.Measure.Kind;
import particles.experiments.runs.SceneRun;
import particles.experiments.runs.SceneRun.Outcome;
import particles.experiments.runs.SolverChoice;
import particles.experiments.stability.SceneStability;
import particles.experiments.stability.Spectrum;
import particles.law.Effect;
import particles.law.Particles;
import particles.law.Vector3;
import particles.scene.Scene;
import particles.scene.SceneBuilder;
import particles.scene.format.SceneDescription;
import particles.spec.Setting;
import particles.spec.messages.InvalidInputException;
import particles.spec.messages.Problems;
import particles.spec.messages.Wording;

/**
 * Runs a scene at the points of a grid. A run that fails, or cannot begin, is a result too, with its reason.
 */
public final class SceneGrid {
    /** How a run ends that does not fail. */
    public static final String WHOLE = "done";
    private static final double TOLERANCE = 1e-11;
    private static final double LOOSER = 100;
    /** How the reference of errors is made, in words. */
    public static final String REFERENCE = SolverChoice.ACCURATE.name() + " with a tolerance of " + TOLERANCE
            + "; its own error is its distance from a run with a tolerance of " + LOOSER * TOLERANCE;

    private final Function<List<Setting>, SceneDescription> reader;
    private final Grid grid;
    private final List<Measure> measures;
    private final String option;
    private final Map<List<String>, Optional<Reference>> references = new ConcurrentHashMap<>();

    /** The state at the end of a very accurate run, and its distance from a less accurate one (m). */
    private record Reference(double[] end, double error) {
    }

    /** What observes a run for these measures. */
    private final class Gauges {
        final Scene scene;
        final EnergyRecorder energy;
        final ImpactCount impacts = new ImpactCount();
        final Map<Measure, ParticlePath> paths = new HashMap<>();

        Gauges(Scene scene) {
            this.scene = scene;
            energy = new EnergyRecorder(scene.simulation(), scene.energyEstimate(), 1);
            measures.stream().filter(measure -> measure.kind().isOfParticle()).forEach(measure ->
                    paths.put(measure, new ParticlePath(measure.coordinate(), measure.subject())));
        }

        /** The work of a force: what it took from its potential energy at the start, and what the ledger booked. */
        double work(String name) {
            return stored(name, SceneBuilder.build(scene.description()).system()) - stored(name, scene.system())
                    + energy.getLedger().getWorkByForce().getOrDefault(name, 0.0);
        }

        Outcome run() {
            List<Observer> others = new ArrayList<>(paths.values());
            others.add(impacts);
            energy.attachTo(scene.simulation(), others);
            return SceneRun.run(scene, List.of());
        }
    }

    /**
     * @param reader   reads the scene with these values in place of its own
     * @param grid     its keys and values
     * @param measures what is measured
     * @param option   the option that gives the axes, for messages
     */
    public SceneGrid(Function<List<Setting>, SceneDescription> reader, Grid grid, List<Measure> measures,
            String option) {
        this.reader = reader;
        this.grid = grid;
        this.measures = measures;
        this.option = option;
    }

    /**
     * Reads the scene with each value of each axis, so that a wrong one is reported before the first run.
     *
     * @throws InvalidInputException with the mistakes of the first point that has any
     */
    public void checkAxes() {
        grid.sample().forEach(this::read);
    }

    /** @throws IllegalArgumentException if a measure is of a particle or a force that the scene does not have */
    public void checkMeasures() {
        Scene scene = SceneBuilder.build(read(grid.points().get(0)));
        for (Measure measure : measures) {
            boolean force = measure.kind() == Kind.WORK;
            List<String> known = force ? forces(scene) : particles(scene);
            if ((force || measure.kind().isOfParticle()) && !known.contains(measure.subject())) {
                throw new IllegalArgumentException(Wording.unknown(force ? "force" : "particle", measure.subject(),
                        known.stream().limit(20).toList(), List.of()));
            }
        }
    }

    private static List<String> particles(Scene scene) {
        Particles all = scene.system().getParticles();
        return IntStream.range(0, all.count()).mapToObj(all::id).toList();
    }

    /** The names of what does work: effects, reactions, moving anchors, and rules that are no corrections. */
    private static List<String> forces(Scene scene) {
        EnergyRecorder energy = new EnergyRecorder(scene.simulation(), scene.energyEstimate(), 1);
        energy.getLedger().started(scene.system());
        return Stream.of(scene.system().getEffects().stream().map(Effect::getName),
                energy.getLedger().getWorkByForce().keySet().stream(),
                scene.simulation().getRules().stream().filter(rule -> !rule.isCorrection()
                        && !(rule instanceof EnergyLimit)).map(Rule::getName)).flatMap(names -> names).distinct()
                .toList();
    }

    /** The potential energy of all effects of a name (J). */
    private static double stored(String effect, ParticleSystem system) {
        return system.getEffects().stream().filter(one -> one.getName().equals(effect)).mapToDouble(one ->
                one.getPotentialEnergy(system.getOwnState(), system.getTime())).sum();
    }

    private List<Setting> settings(List<String> point, Predicate<String> which) {
        Problems problems = new Problems();
        List<Setting> settings = IntStream.range(0, point.size()).filter(a -> which.test(grid.axes().get(a).key()))
                .mapToObj(a -> Setting.of(grid.axes().get(a).key(), point.get(a), option, problems))
                .flatMap(Optional::stream).toList();
        problems.throwIfAny();
        return settings;
    }

    private SceneDescription read(List<String> point) {
        return reader.apply(settings(point, key -> true));
    }

    /** @return the result of the run at a point; it may be computed at the same time as others */
    public Row run(List<String> point) {
        try {
            SceneDescription scene = read(point);
            Gauges gauges = new Gauges(SceneBuilder.build(scene));
            Outcome outcome = gauges.run();
            boolean whole = outcome.failure().isEmpty();
            return new Row(point, measures.stream().map(measure -> measure.kind() == Kind.STABLE ? stable(scene)
                    : whole ? value(measure, point, gauges, outcome) : Double.NaN).toList(),
                    outcome.failure().map(SceneGrid::oneLine).orElse(WHOLE));
        } catch (InvalidInputException | IllegalArgumentException e) {     // such as values that do not go together
            return new Row(point, measures.stream().map(measure -> Double.NaN).toList(), oneLine(e.getMessage()));
        }
    }

    private static String oneLine(String reason) {
        return reason.replace("\n", "; ");
    }

    private double value(Measure measure, List<String> point, Gauges gauges, Outcome outcome) {
        ParticlePath path = gauges.paths.get(measure);
        return switch (measure.kind()) {
            case LAST -> path.getLast();
            case MIN -> path.getLeast();
            case MAX -> path.getMost();
            case AMPLITUDE -> path.getAmplitude();
            case PERIOD -> path.getPeriod();
            case ERROR -> reference(point).map(reference -> distance(gauges.scene.system().getOwnState(),
                    reference.end())).orElse(Double.NaN);
            case REFERENCE_ERROR -> reference(point).map(Reference::error).orElse(Double.NaN);
            case ENERGY -> gauges.energy.getHistory().getEnd();
            case KINETIC -> gauges.scene.system().getKineticEnergy(gauges.scene.system().getOwnState());
            case LOST -> gauges.energy.getLedger().getStartEnergy() - gauges.energy.getLedger().getEnergy();
            case DRIFT -> gauges.energy.getLedger().getNumericalError() / gauges.energy.getScale();
            case LARGEST_DRIFT -> gauges.energy.getLedger().getLargestNumericalError() / gauges.energy.getScale();
            case WORK -> gauges.work(measure.subject());
            case EVALUATIONS -> outcome.evaluations();
            case STEPS -> outcome.steps();
            case CPU_TIME -> SceneRun.run(SceneBuilder.build(gauges.scene.description()), List.of()).seconds();
            case FIRST_IMPACT -> gauges.impacts.getFirst();
            case IMPACTS -> gauges.impacts.getCount();
            case STABLE -> throw new IllegalArgumentException(measure.name());
        };
    }

    private static double stable(SceneDescription scene) {
        Spectrum spectrum = SceneStability.spectrum(scene);
        return spectrum.decaying().isEmpty() ? Double.NaN : SceneStability.limit(spectrum, scene.deltaT(),
                SolverChoice.of(scene.solver())).deltaT();
    }

    /** The reference for all points that differ in the solver or its step only; empty if it fails. */
    private Optional<Reference> reference(List<String> point) {
        List<Setting> settings = settings(point, SceneGrid::isPhysics);
        List<String> key = IntStream.range(0, point.size()).filter(a -> isPhysics(grid.axes().get(a).key()))
                .mapToObj(point::get).toList();
        return references.computeIfAbsent(key, unknown -> {
            SceneDescription scene = reader.apply(settings);
            Optional<double[]> loose = end(scene, LOOSER * TOLERANCE);
            return end(scene, TOLERANCE).flatMap(tight -> loose.map(other ->
                    new Reference(tight, distance(other, tight))));
        });
    }

    private static boolean isPhysics(String key) {
        return !key.equals("deltaT") && !key.equals("solver") && !key.startsWith("solver.");
    }

    private static Optional<double[]> end(SceneDescription description, double tolerance) {
        Scene scene = SceneRun.build(description, SceneRun.Setting.accurate(description.deltaT(), tolerance));
        return SceneRun.run(scene, List.of()).failure().isEmpty() ? Optional.of(scene.system().getOwnState())
                : Optional.empty();
    }

    /** The largest distance of a particle (m); NaN where particles were born or died. */
    private static double distance(double[] state, double[] exact) {
        return state.length != exact.length ? Double.NaN : IntStream.range(0, state.length / Particles.STRIDE)
                .mapToDouble(i -> Vector3.at(state, Particles.STRIDE * i).minus(Vector3.at(exact, Particles.STRIDE * i))
                        .length()).max().orElse(0);
    }
}
