package particles.experiments.work;

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

/**
 * The problems of the work-precision diagrams. Their references are exact, or far more accurate than the errors
 * measured.
 */
public final class WorkProblems {
    /** Their names, the smooth ones first. */
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

    private WorkProblems() {
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
            case "network" -> computed(name, "A damped spring network", 2, WorkProblems::network,
                    new Budget(70_000, 10_000, 1e-8));
            case "stiff-chain" -> new WorkProblem(name, "A stiff chain, shaken", SHAKEN_SECONDS, ShakenChain::new,
                    new ShakenChain().exactState(SHAKEN_SECONDS), "exact", true, 1e-14,
                    new Budget(1_200_000, 80_000, TIGHTEST),
                    Optional.of(new Stiff(ShakenChain.STIFF_DELTA_T, Map.of("radau", 3.0))));
            case "cloth" -> computed(name, "A cloth of 36 particles that falls", 0.5, WorkProblems::cloth,
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
        for (int i = 0; i < n * n; i++) {
            if (i % n < n - 1) {
                springs.addSpring(i, i + 1, 20, 1, 0.1);
            }
            if (i + n < n * n) {
                springs.addSpring(i, i + n, 20, 1, 0.1);
            }
            if (i % n < n - 1 && i + n < n * n) {
                springs.addSpring(i, i + n + 1, 10, Math.sqrt(2), 0.1);
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
