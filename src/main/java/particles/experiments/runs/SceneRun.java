package particles.experiments.runs;

import deSolvers.DESolverException;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Optional;
import particles.Motion;
import particles.Observer;
import particles.SimulationException;
import particles.scene.Scene;
import particles.scene.SceneBuilder;
import particles.scene.SceneReader;
import particles.scene.format.SceneDescription;
import particles.scene.format.SolverDescription;
import particles.scene.format.SolverDescription.Tolerances;

/** Runs a scene with different solvers. A run that fails is a result too, with the time and the reason. */
public final class SceneRun {
    private static final long MOST_EVALUATIONS = 20_000_000;

    private SceneRun() {
    }

    /**
     * The setting of a run: a solver with its step or tolerance.
     *
     * @param solver    the solver
     * @param deltaT    the time step (s)
     * @param tolerance the relative and absolute tolerance of an adaptive solver; empty for its own
     */
    public record Setting(SolverChoice solver, double deltaT, Optional<Double> tolerance) {
        /** @return a setting in which an adaptive solver has its own tolerance */
        public static Setting of(SolverChoice solver, double deltaT) {
            return new Setting(solver, deltaT, Optional.empty());
        }

        /** @return the setting of a reference */
        public static Setting accurate(double deltaT, double tolerance) {
            return new Setting(SolverChoice.ACCURATE, deltaT, Optional.of(tolerance));
        }

        /** @return the solver's name in charts */
        public String label() {
            return solver.label();
        }
    }

    /**
     * The outcome of a run.
     *
     * @param endTime     the simulated time that it reached (s)
     * @param steps       the number of steps
     * @param evaluations the number of evaluations of the derivative
     * @param seconds     the CPU time of the calling thread (s), observers included
     * @param whole       whether it came to its end, however wrong its motion
     * @param failure     the reason if it ended early or its motion is wrong
     */
    public record Outcome(double endTime, long steps, long evaluations, double seconds, boolean whole,
                          Optional<String> failure) {
    }

    /** @return the scene with this text, named like this in messages */
    public static Scene of(String name, String yaml) {
        return SceneBuilder.build(SceneReader.read(name, yaml.getBytes(StandardCharsets.UTF_8)));
    }

    /** @return the scene with this setting, ready to run */
    public static Scene build(SceneDescription scene, Setting setting) {
        Optional<Tolerances> tolerances = setting.solver().adaptive()
                ? setting.tolerance().map(Tolerances::both) : Optional.empty();
        return SceneBuilder.build(scene.withSolver(new SolverDescription(setting.solver().name(), tolerances))
                .withDeltaT(setting.deltaT()));
    }

    /** @return the outcome of a run to its end, to a failure, or to some minutes' work */
    public static Outcome run(Scene scene, List<? extends Observer> observers) {
        return run(scene, MOST_EVALUATIONS, observers);
    }

    /**
     * Runs to the end or to a failure.
     *
     * @param scene           the scene, from {@link #build}
     * @param mostEvaluations the number of evaluations at which it is given up
     * @param observers       the observers of the run
     * @return the outcome of the run
     */
    public static Outcome run(Scene scene, long mostEvaluations, List<? extends Observer> observers) {
        observers.forEach(scene.simulation()::addObserver);
        scene.simulation().addObserver(new Budget(mostEvaluations));
        double begin = CpuClock.seconds();
        boolean whole = false;
        Optional<String> failure = Optional.empty();
        try {
            scene.simulation().start();
            while (!scene.simulation().isOver()) {
                scene.simulation().advance();
            }
            whole = true;
            scene.simulation().finish();
        } catch (SimulationException | DESolverException e) {
            failure = Optional.of(e.getMessage());
        }
        return new Outcome(scene.system().getTime(), scene.simulation().getSteps(), scene.system().getEvaluations(),
                CpuClock.seconds() - begin, whole, failure);
    }

    /** Ends a run that makes too many evaluations. */
    private record Budget(long most) implements Observer {
        @Override
        public void moved(Motion motion) {
            if (motion.getSystem().getEvaluations() > most) {
                throw new SimulationException(motion.getEndTime(), -1, "given up after " + most + " evaluations", null);
            }
        }
    }
}
