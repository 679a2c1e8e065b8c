package particles.experiments.problems;

import deSolvers.DESolver;
import deSolvers.DEStateSource;
import deSolvers.catalog.DidYouMean;
import deSolvers.catalog.SolverCatalog;
import java.util.List;
import java.util.NoSuchElementException;
import java.util.function.Supplier;
import particles.ParticleSystem;
import particles.Vector3;
import particles.effects.Gravity;
import particles.effects.LinearDrag;
import particles.effects.SpringForce;
import particles.effects.Wind;

/** The problems of the work-precision diagrams. Their references are exact, or computed far more accurately than is asked. */
public final class WorkProblems {
    /** Their names, the smooth ones first. */
    public static final List<String> NAMES = List.of("oscillator", "pendulum", "kepler", "network", "stiff-chain", "cloth");

    private static final long SMALL = 600_000;
    private static final double ECCENTRICITY = 0.6;
    private static final double CLOTH_SECONDS = 0.5;
    private static final double TIGHT = 1e-13;

    private WorkProblems() {
    }

    /**
     * @param name one of {@link #NAMES}
     * @return the problem, with its reference
     * @throws NoSuchElementException if there is none of this name
     */
    public static WorkProblem of(String name) {
        return switch (name) {
            case "oscillator" -> exact(name, "The oscillator x'' = \u2212x", 100, Oscillator::new, Oscillator.exactState(100));
            case "pendulum" -> computed(name, "A pendulum released at 1.5 rad", 10, Pendulum::new, "bulirsch-stoer", SMALL, true);
            case "kepler" -> exact(name, "A Kepler orbit, e = 0.6", 20, () -> new Kepler(ECCENTRICITY),
                    Kepler.exactState(ECCENTRICITY, 20));
            case "network" -> computed(name, "A damped spring network", 2, WorkProblems::network, "bulirsch-stoer", 6_000, true);
            case "stiff-chain" -> computed(name, "A stiff chain", 3, WorkProblems::stiffChain, "radau", 30_000, false);
            case "cloth" -> computed(name, "A cloth of 64 particles that falls", CLOTH_SECONDS, WorkProblems::cloth,
                    "bulirsch-stoer", 4_000, false);
            default -> throw new NoSuchElementException("no problem is called '" + name + "'"
                    + DidYouMean.hint(name, NAMES, "'%s'"::formatted) + " known: " + String.join(", ", NAMES));
        };
    }

    private static WorkProblem exact(String name, String title, double duration, Supplier<TestProblem> start, double[] reference) {
        return new WorkProblem(name, title, duration, start, WorkProblems::evaluations, reference, "exact", false, SMALL, true);
    }

    private static WorkProblem computed(String name, String title, double duration, Supplier<? extends DEStateSource> start,
                                        String solver, long mostWork, boolean smooth) {
        DEStateSource source = start.get();
        double tolerance = solver.equals("radau") ? 1e-11 : TIGHT;
        DESolver tight = SolverCatalog.create(solver, tolerance, tolerance);
        tight.stepState(source, duration);
        double[] reference = new double[source.getStateSize()];
        source.getState(reference);
        return new WorkProblem(name, title, duration, start, WorkProblems::evaluations, reference,
                solver + " with tolerance " + tolerance, source instanceof ParticleSystem, mostWork, smooth);
    }

    private static long evaluations(DEStateSource source) {
        return source instanceof ParticleSystem system ? system.getEvaluations() : ((TestProblem) source).getEvaluations();
    }

    /** Four by four particles, held at the upper corners; springs along both directions and one diagonal, a little damped. */
    private static ParticleSystem network() {
        ParticleSystem system = new ParticleSystem();
        SpringForce springs = new SpringForce(system.getParticles());
        int n = 4;
        for (int i = 0; i < n * n; i++) {
            boolean fixed = i == 0 || i == n - 1;
            system.addParticle("p" + i, 1, new Vector3(i % n, -(i / n), 0), fixed ? Vector3.ZERO : new Vector3(0.3, 0.1 * (i % n), 0.2),
                    fixed);
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
        ParticleSystem system = new ParticleSystem();
        SpringForce springs = new SpringForce(system.getParticles());
        int n = 8;
        for (int i = 0; i < n * n; i++) {
            system.addParticle("p" + i, 0.01, new Vector3(0.1 * (i % n), 0, 0.1 * (i / n)), Vector3.ZERO, i == 0 || i == n - 1);
        }
        int[][] families = {{1, 0, 60}, {0, 1, 60}, {1, 1, 20}, {-1, 1, 20}, {2, 0, 5}, {0, 2, 5}};
        for (int i = 0; i < n * n; i++) {
            for (int[] family : families) {
                int column = i % n + family[0];
                int row = i / n + family[1];
                if (column >= 0 && column < n && row < n) {
                    springs.addSpring(i, row * n + column, family[2],
                            0.1 * Math.sqrt(family[0] * family[0] + family[1] * family[1]), 0.02);
                }
            }
        }
        system.addEffect(springs);
        system.addEffect(new Gravity(system.getParticles(), new Vector3(0, -9.81, 0)));
        system.addEffect(new LinearDrag(system.getParticles(), 0.002, Wind.STILL));
        return system;
    }

    /** Pairs of particles on stiff, strongly damped springs that are at rest, on soft springs between two walls. */
    private static ParticleSystem stiffChain() {
        ParticleSystem system = new ParticleSystem();
        SpringForce springs = new SpringForce(system.getParticles());
        int n = 8;
        for (int i = 0; i < n; i++) {
            boolean fixed = i == 0 || i == n - 1;
            system.addParticle("p" + i, 1, new Vector3(i, 0, 0), fixed ? Vector3.ZERO : new Vector3(1, 0, 0), fixed);
        }
        for (int i = 0; i + 1 < n; i++) {
            boolean stiff = i % 2 == 1;
            springs.addSpring(i, i + 1, stiff ? 1e6 : 10, 1, stiff ? 200 : 0);
        }
        system.addEffect(springs);
        return system;
    }
}
