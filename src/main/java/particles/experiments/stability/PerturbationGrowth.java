package particles.experiments.stability;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.SplittableRandom;
import java.util.stream.IntStream;
import particles.Motion;
import particles.Observer;
import particles.ParticleSystem;
import particles.experiments.runs.SceneRun;
import particles.experiments.runs.SceneRun.Setting;
import particles.experiments.stability.Spectrum.Mode;
import particles.law.Particles;
import particles.scene.Scene;
import particles.scene.format.SceneDescription;

/**
 * Measures the growth of a perturbation by two runs of a scene that begin next to each other: if their distance grows
 * from step to step, so does every error. The distance is that of a spring with the mode's frequency, (the sum of m
 * (dv&sup2; + |lambda|&sup2; dx&sup2;))<sup>1/2</sup>, which the motion itself keeps or damps.
 *
 * @param scene the scene
 */
record PerturbationGrowth(SceneDescription scene) {
    /** Steps of a run; its growth is that from the second quarter to the last. */
    static final int STEPS = 512;
    private static final int EVERY = 16;
    /** The first distance as a part of the scene's size, far above rounding and far below anything nonlinear. */
    private static final double NEAR = 1e-7;
    /** The share of all other modes in the first distance, so that any that grows shows. */
    private static final double OTHERS = 1e-3;
    /**
     * A run has left the motion when the distance is this many times that of the motion itself. Just below the limit of
     * verlet a distance swings by up to 1/(2 d)<sup>1/2</sup>, where d is the relative distance to the limit: by 16 at
     * two thousandths. Just above the limit, a growth of 0.6 % per step makes a factor of 20 in 512 steps; rk4 grows so
     * at 0.08 % beyond its limit, and euler at 0.3 % with critical damping, at 3 % with a third of that.
     */
    private static final double GROWN = 20;
    private static final double NO_LONGER_SMALL = 1e4;
    private static final long SEED = 715;

    /**
     * A pair of runs.
     *
     * @param deltaT    their step (s)
     * @param steps     the numbers of steps after which the distance was measured
     * @param distances the distances
     * @param failure   the reason if a run ended early
     */
    record Twins(double deltaT, List<Integer> steps, double[] distances, Optional<String> failure) {

        /** @return the duration of both runs (s) */
        double duration() {
            return distances.length == 0 ? 0 : steps.get(distances.length - 1) * deltaT;
        }

        /**
         * @param fine a pair that shows the effect of the motion itself on the distance, at least as long
         * @return whether the distance became much larger than it had been there until then
         */
        boolean leaves(Twins fine) {
            for (int k = 1; k < distances.length; k++) {
                if (!(distances[k] / distances[0] <= GROWN * fine.largest(0,
                        steps.get(k) * deltaT) / fine.distances[0])) {
                    return true;
                }
            }
            return false;
        }

        /**
         * @param motion a pair that shows the effect of the motion itself on the distance, at the same times
         * @return the factor by which one step of the solver multiplies the distance, from the second quarter to the
         *         last, over that of the motion itself; infinite if there is no distance
         */
        double factor(Twins motion) {
            int count = Math.min(distances.length, motion.distances.length);
            double[] ratios = new double[count];
            for (int k = 0; k < count; k++) {
                ratios[k] = distances[k] / motion.distances[k];
                if (distances[k] > NO_LONGER_SMALL * distances[0]) {
                    return StrictMath.pow(ratios[k], 1.0 / steps.get(k));
                }
            }
            if (count < 2) {
                return Double.POSITIVE_INFINITY;
            }
            Twins beside = new Twins(deltaT, steps, ratios, failure);
            double end = beside.duration();
            double growth = beside.largest(3 * end / 4, end) / beside.largest(end / 4, end / 2);
            return StrictMath.pow(growth, 2.0 / steps.get(count - 1));
        }

        private double largest(double from, double to) {
            return IntStream.range(0, distances.length).filter(k -> steps.get(k) * deltaT >= from
                    && steps.get(k) * deltaT <= to).mapToDouble(k -> distances[k]).max().orElse(0);
        }
    }

    /**
     * @param setting solver and step
     * @param mode    the mode along which the runs differ at the beginning
     * @param steps   the number of steps
     * @return the pair
     */
    Twins run(Setting setting, Mode mode, int steps) {
        Recorder first = run(setting, steps, Optional.empty());
        Recorder second = run(setting, steps, Optional.of(mode));
        double[] distances = IntStream.range(0, Math.min(first.states.size(), second.states.size())).mapToDouble(k ->
                distance(first.masses, first.states.get(k), second.states.get(k), mode.size())).toArray();
        return new Twins(setting.deltaT(), first.steps, distances, first.failure.or(() -> second.failure));
    }

    private Recorder run(Setting setting, int steps, Optional<Mode> mode) {
        Scene built = SceneRun.build(scene, setting, steps * setting.deltaT());
        mode.ifPresent(along -> displace(built.system(), along));
        Recorder recorder = new Recorder(built.system());
        recorder.failure = SceneRun.run(built, List.of(recorder)).failure();
        return recorder;
    }

    private static void displace(ParticleSystem system, Mode mode) {
        double[] state = system.getOwnState();
        double[] shape = mode.shape();
        double largest = 0;
        double size = 0;
        for (int x = 0; x < shape.length; x += Particles.STRIDE) {
            for (int c = x; c < x + 3; c++) {
                largest = Math.max(largest, Math.max(Math.abs(shape[c]), Math.abs(shape[c + 3]) / mode.size()));
                size = Math.max(size, Math.abs(state[c] - state[c - x]));
            }
        }
        double step = NEAR * (size > 0 ? size : 1);
        SplittableRandom random = new SplittableRandom(SEED);
        for (int i : system.getParticles().free().toArray()) {
            for (int c = Particles.STRIDE * i; c < Particles.STRIDE * i + 3; c++) {
                state[c] += step * (shape[c] / largest + OTHERS * (random.nextDouble() - 0.5));
                state[c + 3] += step * shape[c + 3] / largest;
            }
        }
    }

    private static double distance(double[] masses, double[] a, double[] b, double omega) {
        double sum = 0;
        for (int i = 0, x = 0; x < a.length; i++, x += Particles.STRIDE) {
            for (int c = x; c < x + 3; c++) {
                double dx = omega * (b[c] - a[c]);
                double dv = b[c + 3] - a[c + 3];
                sum += masses[i] * (dx * dx + dv * dv);
            }
        }
        return Math.sqrt(sum);
    }

    /** Keeps the first states and then every 16th, as long as there are as many particles as at the beginning. */
    private static final class Recorder implements Observer {
        private final List<double[]> states = new ArrayList<>();
        private final List<Integer> steps = new ArrayList<>();
        private final double[] masses;
        private Optional<String> failure = Optional.empty();
        private int step;
        private boolean comparable = true;

        Recorder(ParticleSystem system) {
            masses = system.getParticles().getMasses().clone();
            add(system, system.getOwnState());
        }

        @Override
        public void moved(Motion motion) {
            step++;
            comparable &= motion.getSystem().getStateSize() == states.get(0).length;
            if (comparable && (step < EVERY || step % EVERY == 0)) {
                add(motion.getSystem(), motion.getEndState());
            }
        }

        private void add(ParticleSystem system, double[] state) {
            states.add(Arrays.copyOf(state, system.getStateSize()));
            steps.add(step);
        }
    }
}
