package particles.teaching.effects;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.Random;
import java.util.function.Function;
import java.util.stream.DoubleStream;
import java.util.stream.Stream;
import particles.ParticleSystem;
import particles.law.Effect;
import particles.law.Effect.Trait;
import particles.law.Particles;

/**
 * Says where a force points, as measured. A sign that force and energy share breaks no claim; a reader who knows what
 * the law should do sees it here.
 *
 * @param trial the law on some particles
 */
public record ForceDirection(EffectTrial trial) {
    private static final double[] FAR = {100, 10, 3, 1};
    private static final double FAST = 100;

    /** @return a sentence, such as "Measured: it points along -y, and brakes."; empty if nothing can be said */
    public static String of(Function<Particles, Effect> maker) {
        ParticleSystem system = EffectSample.system();
        ForceDirection direction = new ForceDirection(EffectTrial.random(system, maker.apply(system.getParticles()),
                new Random(17), 0));
        List<String> says = new ArrayList<>(direction.atRest());
        double power = direction.powerOfSpeed();
        if (power != 0) {
            says.add(power < 0 ? "brakes what moves" : "pushes along the velocity");
        }
        return says.isEmpty() ? "" : " Measured: it " + String.join(", and it ", says) + ".";
    }

    private double outwards(double scale) {
        double[] at = far(scale);
        double[] force = trial.force(at);
        return trial.velocities().filter(trial::isFree).mapToDouble(k -> force[k] * at[k - 3]).sum();
    }

    private double[] far(double scale) {
        double[] rest = trial.faster(0);
        return Arrays.stream(rest).map(x -> scale * x).toArray();
    }

    private List<String> atRest() {
        double[] near = trial.force(far(1));
        double[] away = trial.force(far(FAR[0]));
        if (EffectTrial.largest(near) > 1e-9 && trial.velocities().allMatch(k -> Math.abs(near[k] - away[k]) <= 1e-9
                * Math.abs(near[k]))) {
            double[] sum = new double[3];
            trial.velocities().forEach(k -> sum[k % 3] += near[k]);
            int axis = Stream.of(1, 0, 2).max(Comparator.comparingDouble(c -> Math.abs(sum[c]))).orElseThrow();
            return List.of("points along " + (sum[axis] < 0 ? "-" : "+") + "xyz".charAt(axis));
        }
        boolean pairs = trial.claims(Trait.INTERNAL);
        double out = DoubleStream.of(FAR).map(this::outwards).filter(sum -> sum != 0).findFirst().orElse(0);
        return out == 0 ? List.of() : List.of(out > 0 ? pairs ? "pushes particles apart" : "pushes away from the origin"
                : pairs ? "pulls particles together" : "pulls towards the origin");
    }

    /** The power of the velocity-dependent part of the force in fast motion. */
    private double powerOfSpeed() {
        double[] fast = trial.faster(FAST);
        double[] force = trial.force(fast);
        double[] rest = trial.force(trial.faster(0));
        return trial.velocities().mapToDouble(k -> (force[k] - rest[k]) * fast[k]).sum();
    }
}
