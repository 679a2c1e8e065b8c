package particles.lab;

import deSolvers.catalog.SolverCatalog;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.FloatBuffer;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Base64;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.UnaryOperator;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.teavm.jso.JSByRef;
import org.teavm.jso.JSExport;
import particles.ParticleSystem;
import particles.SimulationException;
import particles.experiments.stability.Amplification;
import particles.law.Effect;
import particles.law.Particles;
import particles.law.Reaction;
import particles.law.Vector3;
import particles.scene.BlowUpMessage;
import particles.scene.Scene;
import particles.scene.SceneBuilder;
import particles.scene.SceneReader;
import particles.scene.format.SceneDescription;
import particles.scene.format.SceneFormat;
import particles.scene.format.SolverDescription;
import particles.scene.format.SolverDescription.Tolerances;
import particles.spec.ClassNames;
import particles.spec.JsonText;
import particles.spec.Setting;
import particles.spec.messages.InvalidInputException;
import particles.spec.messages.Problems;

/**
 * The session of a page: opens a scene, runs it for a while, looks back at earlier times. One scene at a time. The
 * page's scripts call the exported methods.
 */
public final class Session {
    private static final double ABSOLUTE_PART = 1e-3;
    private static final double NANOSECONDS = 1e6;

    private final ClassNames classes;
    private LabRun run;
    private Frame shown;
    private String failure = "";
    private long nanoseconds;

    /** @param classes finds the classes that scenes name */
    public Session(ClassNames classes) {
        this.classes = classes;
    }

    /**
     * Opens a scene at its start, for a page that shows it before its engine runs.
     *
     * @param file   its name in messages
     * @param text   its text
     * @param solver a solver other than the scene's; empty for the scene's
     * @return the catalogue's solvers and, unless the scene has mistakes, what is told of its start, as JSON
     */
    public String opening(String file, String text, String solver) {
        Map<String, Object> told = JsonText.map("solvers", SolverCatalog.all().stream().map(one -> Map.of(
                "name", one.name(), "adaptive", one.adaptive(), "sentence", one.sentence(),
                "evaluations", one.evaluations())).toList(), "facts", open(file, text, solver, "", 0, ""));
        if (run != null) {
            told.put("start", List.of(status(), ids(), base64(List.of(state(), energies(-1), structure()))));
        }
        return JsonText.compact(told);
    }

    /**
     * Opens a scene at its start.
     *
     * @param file      its name in messages
     * @param text      its text
     * @param solver    a solver other than the scene's; empty for the scene's
     * @param deltaT    a time step other than the scene's (s), as it was typed; empty for the scene's
     * @param tolerance a relative tolerance other than the scene's or the solver's; 0 for these
     * @param set       other values for keys of the scene, as {@link Setting#list} reads them; may be blank
     * @return the facts of the scene or, under {@code errors}, the lines about its mistakes, as JSON
     */
    @JSExport
    public String open(String file, String text, String solver, String deltaT, double tolerance, String set) {
        try {
            byte[] bytes = text.getBytes(StandardCharsets.UTF_8);
            Problems problems = new Problems();
            List<Setting> typed = new ArrayList<>(set.isBlank() ? List.of() : Setting.list(set, "set", problems));
            Optional.of(deltaT).filter(given -> !given.isEmpty()).flatMap(given -> Setting.of(SceneFormat.DELTA_T,
                    given, "deltaT", problems)).ifPresent(typed::add);
            problems.throwIfAny();
            SceneDescription described = SceneReader.read(file, bytes, classes, typed);
            boolean same = solver.isEmpty() || solver.equals(described.solver());
            Optional<Tolerances> tolerances = tolerance > 0
                    ? Optional.of(new Tolerances(tolerance, ABSOLUTE_PART * tolerance))
                    : same ? described.solving().tolerances() : Optional.empty();
            Scene scene = SceneBuilder.build(described.withSolver(new SolverDescription(
                    same ? described.solver() : solver, tolerances)));
            run = new LabRun(scene);
            shown = run.getShown();
            failure = "";
            nanoseconds = 0;
            Map<String, Object> facts = SceneFacts.of(scene, run.getFrames());
            facts.put("numbers", SceneReader.numbers(bytes, classes, typed).stream().map(number -> Map.of(
                    "key", number.what(), "value", number.value(), "line", number.place().line(),
                    "column", number.place().column(), "least", number.least(), "most", number.most(),
                    "unit", number.unit())).toList());
            return JsonText.compact(facts);
        } catch (InvalidInputException e) {
            return JsonText.compact(Map.of("errors", e.getLines()));
        }
    }

    /**
     * Makes steps until the run reaches a time, or for as long as it may.
     *
     * @param time         the time to reach (s)
     * @param milliseconds the longest time that it may take
     */
    @JSExport
    public void advance(double time, double milliseconds) {
        long end = System.nanoTime() + (long) (milliseconds * NANOSECONDS);
        work(() -> run.advance(time, () -> System.nanoTime() > end));
    }

    /** Shows the state one step after the moment shown; the run makes that step if it has not yet. */
    @JSExport
    public void step() {
        List<Frame> later = run.getHistory().after(shown.time());
        if (!later.isEmpty()) {
            shown = later.get(0);
            return;
        }
        work(run::step);
    }

    private void work(Runnable work) {
        if (!failure.isEmpty()) {
            return;
        }
        long start = System.nanoTime();
        try {
            work.run();
        } catch (SimulationException e) {
            failure = new BlowUpMessage(run.getScene(), e, UnaryOperator.identity()).lines();
            run.end();
        }
        nanoseconds += System.nanoTime() - start;
        shown = run.getShown();
    }

    /**
     * Shows the latest moment that was kept up to a time.
     *
     * @param time that time (s)
     */
    @JSExport
    public void look(double time) {
        shown = run.getHistory().at(time);
    }

    /**
     * Shows a moment between two that were kept.
     *
     * @param time its time (s)
     */
    @JSExport
    public void between(double time) {
        Frame from = run.getHistory().at(time);
        shown = run.getHistory().after(time).stream().findFirst().map(to -> from.towards(to, time)).orElse(from);
    }

    /** @param endless whether the run goes on after the scene's duration */
    @JSExport
    public void setEndless(boolean endless) {
        run.setEndless(endless);
    }

    /**
     * Drags a particle towards a point from now on, until it is dragged elsewhere or released.
     *
     * @param id the particle; empty to release all
     * @param x  a coordinate of that point (m)
     * @param y  a coordinate of that point (m)
     * @param z  a coordinate of that point (m)
     */
    @JSExport
    public void drag(String id, double x, double y, double z) {
        run.getPointer().drag(indexOf(id), new Vector3(x, y, z));
    }

    private ParticleSystem system() {
        return run.getScene().system();
    }

    private int indexOf(String id) {
        return List.of(run.getFrames().getStructure().ids()).indexOf(id);
    }

    /**
     * @param id a particle
     * @return its mass and the present forces on it, as JSON; empty if it is gone
     */
    @JSExport
    public String particle(String id) {
        int i = indexOf(id);
        return i < 0 ? "{}" : JsonText.compact(Map.of("mass", system().getParticles().mass(i), "forces", forces(i)));
    }

    /** The present forces on particle i by the names of what causes them, three components each (N). */
    private Map<String, Object> forces(int i) {
        Map<String, Object> forces = new LinkedHashMap<>();
        double[] state = system().getOwnState();
        double[] sum = new double[system().getStateSize()];
        for (Effect effect : system().getEffects()) {
            put(forces, effect.getName(), () -> effect.addForces(state, system().getTime(), sum), sum, i);
        }
        for (Reaction reaction : system().getReactions()) {
            if (reaction.isActive()) {
                put(forces, reaction.getName(), () -> reaction.addForces(state, system().getTime(), sum), sum, i);
            }
        }
        return forces;
    }

    /** Puts what adds to the sum of forces, if it changes that on particle i. */
    private static void put(Map<String, Object> forces, String name, Runnable adding, double[] sum, int i) {
        Vector3 before = Vector3.at(sum, Particles.STRIDE * i + 3);
        adding.run();
        Vector3 force = Vector3.at(sum, Particles.STRIDE * i + 3).minus(before);
        if (!force.isZero()) {
            forces.put(name, SceneFacts.vector(force));
        }
    }

    /** @return the time of the run, the time shown, the cost until then, and the time taken so far, as JSON */
    @JSExport
    public String status() {
        Frame.Account account = shown.account();
        double reached = system().getTime();
        return JsonText.compact(JsonText.map("time", shown.time(), "reached", reached, "steps", account.steps(),
                "evaluations", account.evaluations(), "seconds", nanoseconds / (1e3 * NANOSECONDS),
                "work", account.work(), "over", run.isOver() && shown.time() >= reached, "failure", failure));
    }

    /** @return positions and velocities at the moment that is shown, six numbers per particle */
    @JSExport
    @JSByRef
    public float[] state() {
        return shown.state();
    }

    /**
     * @param time a time (s)
     * @return the time and the energies, in the order of the scene's facts (J), after each step kept that ended later
     */
    @JSExport
    @JSByRef
    public float[] energies(double time) {
        return joined(run.getHistory().after(time).stream().flatMap(frame ->
                Stream.of(new float[] {(float) frame.time()}, frame.energies())).toList());
    }

    /**
     * @param time a time (s)
     * @return the time and the state after each step kept that ended later, while the particles were the present ones
     */
    @JSExport
    @JSByRef
    public float[] states(double time) {
        return joined(run.getHistory().after(time).stream().filter(frame -> frame.structure() == shown.structure())
                .flatMap(frame -> Stream.of(new float[] {(float) frame.time()}, frame.state())).toList());
    }

    /**
     * @param solver  a solver
     * @param left    the smallest real part of h lambda
     * @param bottom  the smallest imaginary part
     * @param cell    the side of the squares of a grid
     * @param columns its columns
     * @param rows    its rows
     * @return the factor by which a step multiplies the solution of s' = lambda s, in the middle of each square, row by
     *         row; of a spring, with a solver of your own
     */
    @JSExport
    @JSByRef
    public double[] region(String solver, double left, double bottom, double cell, int columns, int rows) {
        Amplification amplification = SolverCatalog.find(solver).map(Amplification::of)
                .orElseGet(() -> Amplification.ofOwn(() -> SolverCatalog.create(solver)));
        return IntStream.range(0, columns * rows).mapToDouble(k -> amplification.at(
                left + (k % columns + 0.5) * cell, bottom + (k / columns + 0.5) * cell)).toArray();
    }

    /** @return the present state of the run in full precision */
    @JSExport
    @JSByRef
    public double[] exactState() {
        return Arrays.copyOf(system().getOwnState(), system().getStateSize());
    }

    /** @return a number that changes whenever particles or springs were added or removed between the moments shown */
    @JSExport
    public int structureNumber() {
        return System.identityHashCode(shown.structure());
    }

    /** @return the names of the particles at the moment that is shown, as JSON */
    @JSExport
    public String ids() {
        return JsonText.compact(List.of(shown.structure().ids()));
    }

    /** @return what is known of these particles, and the springs and rods: three and four numbers each */
    @JSExport
    @JSByRef
    public float[] structure() {
        return shown.structure().numbers();
    }

    /**
     * @param what  the number of a quantity, as in {@link Frame#value}
     * @param id    a particle
     * @param other another one
     * @param time  a time (s)
     * @return the quantity after each step kept that ended later, and last at the moment shown
     */
    @JSExport
    @JSByRef
    public float[] values(int what, String id, String other, double time) {
        return joined(Stream.concat(run.getHistory().after(time).stream(), Stream.of(shown))
                .map(frame -> new float[] {frame.value(what, id, other)}).toList());
    }

    static String base64(List<float[]> parts) {
        float[] floats = joined(parts);
        ByteBuffer bytes = ByteBuffer.allocate(Float.BYTES * floats.length).order(ByteOrder.LITTLE_ENDIAN);
        bytes.asFloatBuffer().put(floats);
        return Base64.getEncoder().encodeToString(bytes.array());
    }

    private static float[] joined(List<float[]> parts) {
        FloatBuffer all = FloatBuffer.allocate(parts.stream().mapToInt(part -> part.length).sum());
        parts.forEach(all::put);
        return all.array();
    }
}
