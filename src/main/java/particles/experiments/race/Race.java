package particles.experiments.race;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.function.Supplier;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import particles.Motion;
import particles.Observer;
import particles.ParticleSystem;
import particles.SimulationException;
import particles.energy.EnergyHistory;
import particles.experiments.energy.EnergyDrift;
import particles.experiments.energy.EnergyDrift.Drift;
import particles.experiments.runs.EqualWork;
import particles.experiments.runs.EqualWork.Shares;
import particles.experiments.runs.ProgressListener;
import particles.experiments.runs.SceneRun;
import particles.experiments.runs.SceneRun.Outcome;
import particles.experiments.runs.SceneRun.Setting;
import particles.experiments.runs.SolverChoice;
import particles.law.Particles;
import particles.scene.Scene;
import particles.scene.format.SceneDescription;
import particles.view.Look;

/**
 * A race of solvers on one scene: all do the same work, and the solver that stays nearest to a very accurate run wins.
 * Work is counted in evaluations of the derivative, those for Jacobians included.
 *
 * @param scene   the scene, with the duration of the race; rk4 at its step sets the work of all
 * @param solvers the solvers that take part
 * @param frames  the number of parts into which the duration is divided, 1 or more
 */
public record Race(SceneDescription scene, List<SolverChoice> solvers, int frames) {
    private static final double REFERENCE_TOLERANCE = 1e-11;
    /** The reference in words. */
    public static final String REFERENCE = "dormand-prince with a tolerance of 1e-11";

    /** Makes the observers of each run, for example to draw pictures of it. */
    public interface ObserverFactory {
        /**
         * Called when a run begins; the first run is the reference's.
         *
         * @param scene  the scene, about to run
         * @param solver the solver of this run; empty for the reference
         * @return the observers of this run
         */
        List<Observer> of(Scene scene, Optional<SolverChoice> solver);
    }

    /**
     * The run of one solver.
     *
     * @param drift    its setting and its energy drift, up to its end
     * @param states   its states at the frames' times, up to its end: (x1, v1, x2, v2, ...)
     * @param distance its distance from the reference at these times, root mean square over the particles (m); NaN
     *                 if any are born or die, and between the steps of an adaptive solver
     */
    public record Lane(Drift drift, List<double[]> states, double[] distance) {
        /** @return the solver's name in charts */
        public String label() {
            return drift.label();
        }

        /** @return the solver's look in charts */
        public Look look() {
            return drift.look();
        }

        /** @return the time at which it left the race (s), if it failed */
        public OptionalDouble left() {
            return drift.outcome().whole() ? OptionalDouble.empty() : OptionalDouble.of(drift.outcome().endTime());
        }
    }

    /**
     * The race.
     *
     * @param scene     the scene's title
     * @param work      the evaluations that each solver was to cost
     * @param times     the times of the frames (s)
     * @param reference its states at the frames' times
     * @param lanes     the run of each solver
     */
    public record Result(String scene, long work, double[] times, List<double[]> reference, List<Lane> lanes) {
    }

    /**
     * Runs the reference and all solvers.
     *
     * @param factory  makes the observers of each run
     * @param progress receives the progress of the race
     * @return the result of every solver
     * @throws SimulationException if the reference cannot be computed
     */
    public Result run(ObserverFactory factory, ProgressListener progress) {
        progress.reached(0, "the reference");
        double rate = frames / scene.duration();
        FrameStates reference = new FrameStates(rate);
        EnergyHistory energy = new EnergyHistory();
        Scene built = SceneRun.build(scene, tight());
        List<Observer> observers = new ArrayList<>(List.of(energy, reference));
        observers.addAll(factory.of(built, Optional.empty()));
        Outcome outcome = SceneRun.run(built, observers);
        if (outcome.failure().isPresent()) {
            throw new SimulationException(outcome.endTime(), -1, "no race without a reference (" + REFERENCE + "): "
                    + outcome.failure().get(), null);
        }
        double scale = energy.getScaleOr(built.energyEstimate());
        long evaluations = 4 * Math.max(1, Math.round(scene.duration() / scene.deltaT()));
        // measured: the reference takes a quarter of the time, the search a third
        Shares shares = new EqualWork(scene, evaluations, frames).share(solvers, progress.part(0.25, 0.6));
        List<Supplier<Lane>> runs = shares.matches().stream().map(match ->
                lane(match.setting(), rate, scale, reference.states, factory)).toList();
        List<Lane> lanes = progress.part(0.6, 1).onAllCores(runs, run -> "the race", Supplier::get);
        double[] times = IntStream.range(0, reference.states.size()).mapToDouble(k -> k / rate).toArray();
        return new Result(scene.title(), shares.work(), times, reference.states, lanes);
    }

    /**
     * The reference's setting: steps about as long as the scene's that end at the frames, so that nothing compared is
     * interpolated.
     */
    private Setting tight() {
        double frame = scene.duration() / frames;
        return Setting.accurate(frame / Math.ceil(frame / scene.deltaT()), REFERENCE_TOLERANCE);
    }

    /** Prepares the run of a solver, to be done at any time. */
    private Supplier<Lane> lane(Setting setting, double rate, double scale, List<double[]> reference,
            ObserverFactory factory) {
        Scene built = SceneRun.build(scene, setting);
        FrameStates states = new FrameStates(rate);
        List<Observer> observers = new ArrayList<>(List.of(states));
        observers.addAll(factory.of(built, Optional.of(setting.solver())));
        return () -> {
            Drift drift = EnergyDrift.measure(built, setting, scale, observers);
            double[] distance = new double[states.states.size()];
            Arrays.fill(distance, Double.NaN);
            // where particles are born or die, an index may be that of another particle
            boolean same = Stream.concat(reference.stream(), states.states.stream()).mapToInt(state -> state.length)
                    .distinct().count() == 1;
            for (int k = 0; same && k < distance.length; k += framesAStep(setting)) {
                distance[k] = distance(states.states.get(k), reference.get(k));
            }
            return new Lane(drift, states.states, distance);
        };
    }

    /**
     * The frames from one step to the next. An adaptive solver is compared only at the ends of its steps: within them,
     * interpolation has errors that are not the solver's own.
     */
    private int framesAStep(Setting setting) {
        double a = setting.deltaT() * frames / scene.duration();
        return setting.solver().adaptive() ? Math.max(1, (int) Math.round(a)) : 1;
    }

    private static double distance(double[] state, double[] exact) {
        double sum = 0;
        for (int x = 0; x < state.length; x += Particles.STRIDE) {
            for (int c = x; c < x + 3; c++) {
                sum += (state[c] - exact[c]) * (state[c] - exact[c]);
            }
        }
        return Math.sqrt(sum / (state.length / Particles.STRIDE));
    }

    /**
     * Copies of the state at regular times, k / rate for k = 0, 1, 2 ...: the times of a film's frames, whatever the
     * steps are. Between two steps it uses the same cubic as the pictures.
     */
    static final class FrameStates implements Observer {
        /** A clock this part of a frame's time early is rounding. */
        private static final double ROUNDING = 1e-9;

        private final double rate;
        final List<double[]> states = new ArrayList<>();

        /** @param rate the number of copies per second of simulated time (1/s) */
        FrameStates(double rate) {
            this.rate = rate;
        }

        @Override
        public void started(ParticleSystem system) {
            states.add(system.getOwnState().clone());
        }

        @Override
        public double getNextTime() {
            return states.size() / rate;
        }

        @Override
        public void moved(Motion motion) {
            while (getNextTime() <= motion.getEndTime()) {
                double[] between = new double[motion.getEndState().length];
                motion.interpolate(getNextTime(), between);
                states.add(between);
            }
        }

        @Override
        public void finished(ParticleSystem system) {
            if (states.size() <= system.getTime() * rate + ROUNDING) {
                states.add(system.getOwnState().clone());
            }
        }
    }
}
