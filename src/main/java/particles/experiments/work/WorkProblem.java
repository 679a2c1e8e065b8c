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
import java.util.Optional;
import java.util.function.Supplier;
import particles.ParticleSystem;
import particles.effects.springs.SpringForce;
import particles.experiments.runs.SceneRun;
import particles.experiments.work.WorkProblem.Budget;
import particles.experiments.work.WorkProblem.Stiff;
import particles.law.Vector3;
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
 * @param budget        the limits of work
 * @param stiff         the range of steps in which it is stiff, if it is
 */
public record WorkProblem(String name, String title, double duration, Supplier<? extends DEStateSource> start,
                          double[] reference, String origin, boolean onlyPositions, double floor, Budget budget,
                          Optional<Stiff> stiff) {
    /** The names of the problems, the smooth ones first. */
    public static final List<String> NAMES = List.of("oscillator", "pendulum", "kepler", "network", "stiff-chain",
            "cloth");

    private static final double SHAKEN_SECONDS = 2;
    private static final double TIGHT = 1e-13;
    private static final String REFERENCE = "bulirsch-stoer";
    /**
     * Round-off, and the differences of references with tolerance 1e-13, stay below a tenth of this; a test checks it.
     */
    private static final double FLOOR = 5e-12;
    private static final double TIGHTEST = 1e-11;

    private static final Budget SMALL = new Budget(600_000, 600_000, TIGHTEST);
    /** Backward Euler needs short steps over 100 s. */
    private static final Budget LONG = new Budget(600_000, 1_100_000, TIGHTEST);

    /**
     * The limits of a solver's work.
     *
     * @param explicit          evaluations beyond which an explicit solver makes no further run
     * @param implicit          the same for an implicit one, which does more for each
     * @param tightestTolerance the tightest tolerance of adaptive implicit solvers; others go down to 1e-11
     */
    public record Budget(long explicit, long implicit, double tightestTolerance) {
    }

    /**
     * The range of steps in which a problem is stiff. Implicit solvers are compared there, at equal steps also the
     * adaptive ones.
     *
     * @param deltaT  the shortest step that is still long for the stiff springs (s)
     * @param reduced the theoretical order in this range, for the solvers with order reduction
     */
    public record Stiff(double deltaT, Map<String, Double> reduced) {
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
            case "oscillator" -> exact(name, "The oscillator x'' = \u2212x", 100, Oscillator::new, LONG);
            case "pendulum" -> exact(name, "A pendulum released at 1.5 rad", 10, () -> new Pendulum(1.5), SMALL);
            case "kepler" -> exact(name, "A Kepler orbit, e = 0.6", 5, () -> new Kepler(0.6), SMALL);
            case "network" -> computed(name, "A damped spring network", 2, WorkProblem::network,
                    new Budget(70_000, 10_000, 1e-8));
            case "stiff-chain" -> new WorkProblem(name, "A stiff chain, shaken", SHAKEN_SECONDS, ShakenChain::new,
                    new ShakenChain().exactState(SHAKEN_SECONDS), "exact", true, 1e-14,
                    new Budget(1_200_000, 80_000, TIGHTEST),
                    Optional.of(new Stiff(ShakenChain.STIFF_DELTA_T, Map.of("radau", 3.0))));
            case "cloth" -> computed(name, "A cloth of 36 particles that falls", 0.5, WorkProblem::cloth,
                    new Budget(20_000, 3_000, 1e-3));
            default -> throw new NoSuchElementException("no problem is called '" + name + "'");
        };
    }

    private static WorkProblem exact(String name, String title, double duration, Supplier<ReferenceProblem> start,
            Budget budget) {
        return new WorkProblem(name, title, duration, start, start.get().exactState(duration), "exact", false, FLOOR,
                budget, Optional.empty());
    }

    private static WorkProblem computed(String name, String title, double duration, Supplier<ParticleSystem> start,
            Budget budget) {
        ParticleSystem source = start.get();
        SolverCatalog.create(REFERENCE, TIGHT, TIGHT).stepState(source, duration);
        return new WorkProblem(name, title, duration, start, source.getStateArray(),
                REFERENCE + " with tolerance " + TIGHT, true, FLOOR, budget, Optional.empty());
    }

    /**
     * Four by four particles, held at the upper corners; springs along both directions and one diagonal, a little
     * damped.
     */
    private static ParticleSystem network() {
        ParticleSystem system = new ParticleSystem();
        SpringForce springs = new SpringForce(system.getParticles());
        int n = 4;
        for (int i = 0; i < n * n; i++) {
            boolean fixed = i == 0 || i == n - 1;
            system.addParticle("p" + i, 1, new Vector3(i % n, -(i / n), 0), fixed ? Vector3.ZERO : new Vector3(0.3,
                    0.1 * (i % n), 0.2), fixed);
        }
        int[][] directions = {{1, 0}, {0, 1}, {1, 1}};
        for (int i = 0; i < n * n; i++) {
            for (int[] to : directions) {
                if (i % n + to[0] < n && i / n + to[1] < n) {
                    int squaredLength = to[0] + to[1];
                    springs.addSpring(i, i + to[0] + n * to[1], 20.0 / squaredLength, Math.sqrt(squaredLength), 0.1);
                }
            }
        }
        system.addEffect(springs);
        return system;
    }

    /** Level at first and held at two corners: structural, shear and bend springs, gravity and drag in still air. */
    private static ParticleSystem cloth() {
        return SceneRun.of("a cloth", """
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
                """).system();
    }
}
