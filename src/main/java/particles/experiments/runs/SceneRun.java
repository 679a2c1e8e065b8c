package particles.experiments.runs;

import deSolvers.DESolverException;
import java.util.List;
import java.util.Optional;
import particles.Motion;
import particles.Observer;
import particles.SimulationException;
import particles.scene.Scene;
import particles.scene.SceneBuilder;
import particles.scene.format.Overrides;
import particles.scene.format.SceneDescription;
import particles.scene.format.Tolerances;

/** Runs of a scene with different solvers. A run that fails is a result too: it says when and why. */
public final class SceneRun {
    private SceneRun() {
    }

    /**
     * How a scene is solved.
     *
     * @param solver    with which solver
     * @param deltaT    the time step (s)
     * @param tolerance relative and absolute, where it is adaptive and not its own
     */
    public record Setting(SolverChoice solver, double deltaT, Optional<Double> tolerance) {
    }

    /**
     * How a run went.
     *
     * @param endTime     how far it came (s)
     * @param steps       steps made
     * @param evaluations of the derivative
     * @param seconds     of wall-clock time, observers included
     * @param busy        seconds for which the calling thread kept a processor busy, whatever else the machine does
     * @param failure     why it ended early, if it did
     */
    public record Outcome(double endTime, long steps, long evaluations, double seconds, double busy,
                          Optional<String> failure) {
    }

    /**
     * @param scene     what is to run
     * @param setting   how
     * @param duration  how long (s)
     * @return the scene, ready to run
     */
    public static Scene build(SceneDescription scene, Setting setting, double duration) {
        Optional<Tolerances> tolerances = setting.solver().adaptive()
                ? setting.tolerance().map(Tolerances::both) : Optional.empty();
        return SceneBuilder.build(scene.solvedBy(setting.solver().name(), tolerances, setting.deltaT(), duration),
                new Overrides());
    }

    /**
     * Runs to the end or to a failure.
     *
     * @param scene           from {@link #build}
     * @param mostEvaluations beyond which it is given up
     * @param observers       who looks on
     * @return how it went
     */
    public static Outcome run(Scene scene, long mostEvaluations, List<? extends Observer> observers) {
        observers.forEach(scene.simulation()::addObserver);
        scene.simulation().addObserver(new Budget(mostEvaluations));
        long begin = System.nanoTime();
        double busy = CpuClock.seconds();
        Optional<String> failure = Optional.empty();
        try {
            scene.simulation().run();
        } catch (SimulationException | DESolverException e) {
            failure = Optional.of(e.getMessage());
        }
        return new Outcome(scene.system().getTime(), scene.simulation().getSteps(), scene.system().getEvaluations(),
                (System.nanoTime() - begin) * 1e-9, CpuClock.seconds() - busy, failure);
    }

    /** Ends a run that would go on for hours. */
    private record Budget(long most) implements Observer {
        @Override
        public void moved(Motion motion) {
            if (motion.getSystem().getEvaluations() > most) {
                throw new SimulationException(motion.getEndTime(), -1, "given up after " + most + " evaluations", null);
            }
        }
    }
}
