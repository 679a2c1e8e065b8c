package particles.experiments.work;

import deSolvers.DEStateSource;
import deSolvers.SecondOrderStateSource;
import deSolvers.catalog.SolverCatalog;
import deSolvers.problems.Kepler;
import deSolvers.problems.Oscillator;
import deSolvers.problems.Pendulum;
import deSolvers.problems.ReferenceProblem;
import deSolvers.problems.ShakenChain;
import java.util.List;
import java.util.Map;
import java.util.NoSuchElementException;
import java.util.function.Supplier;
import particles.ParticleSystem;
import particles.experiments.runs.SceneRun;
import particles.view.Axis;

/**
 * A test problem of the work-precision experiment.
 *
 * @param name          its name in options
 * @param title         a short description
 * @param duration      the time over which it is solved (s)
 * @param start         creates a source in its initial state
 * @param reference     the state at the end
 * @param origin        the origin of the reference, in words
 * @param onlyPositions whether errors are of positions alone (m); else of the whole state
 * @param floor         errors below this may be round-off, or errors of the reference
 * @param mostExplicit  evaluations beyond which an explicit solver makes no further run
 * @param mostImplicit  the same for an implicit one, which does more for each
 * @param stiffDeltaT   the shortest step that is still long for stiff springs (s); 0 without them
 * @param reduced       the theoretical order with such steps, for the solvers with order reduction
 */
public record WorkProblem(String name, String title, double duration, Supplier<? extends DEStateSource> start,
                          double[] reference, String origin, boolean onlyPositions, double floor, long mostExplicit,
                          long mostImplicit, double stiffDeltaT, Map<String, Double> reduced) {
    /** The names of the problems, the smooth ones first. */
    public static final List<String> NAMES = List.of("oscillator", "pendulum", "kepler", "network", "stiff-chain",
            "cloth");

    private static final double SHAKEN_SECONDS = 2;
    private static final long SMOOTH = 600_000;
    private static final double TIGHT = 1e-13;
    private static final String REFERENCE = "bulirsch-stoer";
    /**
     * Round-off, and the differences of references with tolerance 1e-13, stay below a tenth of this; a test checks it.
     */
    private static final double FLOOR = 5e-12;
    private static final String NETWORK = """
            title: A damped spring network
            teaches: What precision costs.
            solver: rk4
            deltaT: 0.01
            duration: 2
            shapes:
              - cloth: {corner: [0, 0, 0], across: [3, 0, 0], down: [0, -3, 0], columns: 4, rows: 4, mass: 1,
                  velocity: [0.3, 0.1, 0.2], fixed: [top-left, top-right],
                  structural: {stiffness: 20, damping: 0.1}, shear: {stiffness: 10, damping: 0.1}}
            """;
    /** Level at first and held at two corners: structural, shear and bend springs, gravity and drag in still air. */
    private static final String CLOTH = """
            title: A cloth that falls
            teaches: What precision costs.
            solver: rk4
            deltaT: 0.01
            duration: 1
            shapes:
              - cloth: {corner: [0, 0, 0], across: [0.5, 0, 0], down: [0, 0, 0.5], columns: 6, rows: 6, mass: 0.01,
                  fixed: [top-left, top-right], structural: {stiffness: 60, damping: 0.02},
                  shear: {stiffness: 20, damping: 0.02}, bend: {stiffness: 5, damping: 0.02}}
            effects: [gravity, drag: {coefficient: 0.002}]
            """;

    /** @return whether implicit solvers are compared with steps for which it is stiff */
    public boolean isStiff() {
        return stiffDeltaT > 0;
    }

    /**
     * @param source a source at the end of a run
     * @return the largest error of a position, or the length of the state's error
     */
    public double error(DEStateSource source) {
        double[] state = new double[reference.length];
        source.getState(state);
        int d = source instanceof SecondOrderStateSource motion ? motion.getDimension() : state.length;
        double largest = 0;
        double squares = 0;
        for (int k = 0; k < state.length; k++) {
            double error = Math.abs(state[k] - reference[k]);
            squares += error * error;
            if (k % (2 * d) < d) {
                largest = Math.max(largest, error);
            }
        }
        return onlyPositions ? largest : Math.sqrt(squares);
    }

    /** @return the number of evaluations of a problem's source */
    static long evaluations(DEStateSource source) {
        return source instanceof ParticleSystem system ? system.getEvaluations()
                : ((ReferenceProblem) source).getEvaluations();
    }

    /** @return the axis of the error */
    Axis errorAxis() {
        return onlyPositions ? Axis.log("largest position error at the end", "m")
                : Axis.log("error of the state at the end", "");
    }

    /**
     * @param name one of {@link #NAMES}
     * @return the problem, with its reference
     * @throws NoSuchElementException if there is none of this name
     */
    public static WorkProblem of(String name) {
        return switch (name) {
            // backward Euler needs short steps over 100 s
            case "oscillator" -> exact(name, "The oscillator x'' = \u2212x", 100, Oscillator::new, 1_100_000);
            case "pendulum" -> exact(name, "A pendulum released at 1.5 rad", 10, () -> new Pendulum(1.5), SMOOTH);
            case "kepler" -> exact(name, "A Kepler orbit, e = 0.6", 5, () -> new Kepler(0.6), SMOOTH);
            case "network" -> computed(name, "A damped spring network", 2, NETWORK, 70_000, 10_000);
            case "stiff-chain" -> new WorkProblem(name, "A stiff chain, shaken", SHAKEN_SECONDS, ShakenChain::new,
                    new ShakenChain().exactState(SHAKEN_SECONDS), "exact", true, 1e-14, 1_200_000, 80_000,
                    ShakenChain.STIFF_DELTA_T, Map.of("radau", 3.0));
            case "cloth" -> computed(name, "A cloth of 36 particles that falls", 0.5, CLOTH, 20_000, 3_000);
            default -> throw new NoSuchElementException("no problem is called '" + name + "'");
        };
    }

    private static WorkProblem exact(String name, String title, double duration, Supplier<ReferenceProblem> start,
            long mostImplicit) {
        return new WorkProblem(name, title, duration, start, start.get().exactState(duration), "exact", false, FLOOR,
                SMOOTH, mostImplicit, 0, Map.of());
    }

    private static WorkProblem computed(String name, String title, double duration, String scene, long mostExplicit,
            long mostImplicit) {
        Supplier<ParticleSystem> start = () -> SceneRun.of(name, scene).system();
        ParticleSystem source = start.get();
        SolverCatalog.create(REFERENCE, TIGHT, TIGHT).stepState(source, duration);
        return new WorkProblem(name, title, duration, start, source.getStateArray(),
                REFERENCE + " with tolerance " + TIGHT, true, FLOOR, mostExplicit, mostImplicit, 0, Map.of());
    }
}
