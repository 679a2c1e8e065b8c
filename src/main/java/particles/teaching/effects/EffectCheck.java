package particles.teaching.effects;

import java.util.List;
import java.util.Optional;
import java.util.Random;
import java.util.function.Function;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import particles.law.Effect;
import particles.law.Effect.Trait;
import particles.law.Particles;
import particles.teaching.Finding;
import particles.teaching.Finding.Kind;
import particles.teaching.Formula;
import particles.teaching.StudentFailure;
import particles.teaching.effects.EffectClaims.Broken;

/**
 * Checks a student's force law against the properties that it declares, by {@link EffectClaims}. If one does not hold,
 * it names the particle and the component, and the numbers.
 *
 * @param trial the law on some particles
 */
public record EffectCheck(EffectTrial trial) {
    private static final double STEP = 1e-5;

    /**
     * Checks a law on six particles, one of them fixed, and on nine that are all free.
     *
     * @param maker creates it for some particles
     * @return the first mistake, or a note; empty if all declared properties hold
     */
    public static List<Finding> check(Function<Particles, Effect> maker) {
        return Stream.of(EffectSample.system(), EffectSample.larger()).map(system -> new EffectCheck(EffectTrial.random(
                system, maker.apply(system.getParticles()), new Random(17), 0)).first()).flatMap(Optional::stream)
                .limit(1).toList();
    }

    private Optional<Finding> first() {
        try {
            return new EffectWriting(trial).finding().or(this::contradiction).or(() -> EffectClaims.broken(
                    trial.system(), trial.effect(), 2003).stream().findFirst().map(this::explained));
        } catch (IndexOutOfBoundsException e) {
            return EffectWriting.wrong(Kind.FAILURE, "it ends in an exception: " + StudentFailure.describe(e) + "; loop"
                    + " over particles with i < particles.count()");
        }
    }

    /** A law that stores all of its energy neither takes energy out nor puts any in. */
    private Optional<Finding> contradiction() {
        Trait other = trial.claims(Trait.DISSIPATIVE) ? Trait.DISSIPATIVE : Trait.DRIVING;
        return !trial.claims(Trait.CONSERVATIVE) || !trial.claims(other) ? Optional.empty() : EffectWriting.wrong(
                Kind.METHOD, "it claims CONSERVATIVE and " + other + ", which contradict each other");
    }

    /** The claim that does not hold, and the place where it shows. */
    private Finding explained(Broken broken) {
        if (broken.unaccounted() && Trait.OF_ENERGY.stream().noneMatch(trial::claims)) {
            return new Finding(Kind.STYLE, "it claims no account of its energy: CONSERVATIVE with"
                    + " getPotentialEnergy, DISSIPATIVE with getDissipatedPower or DRIVING with getDrivenPower");
        }
        Optional<String> where = switch (broken.claim()) {
            case THIRD_LAW -> wrongPair();
            case POWER -> Stream.of(1.0, -1.0).flatMap(velocity -> ForceComparison.of(trial, velocity).difference()
                    .stream()).findFirst();
            default -> Optional.empty();
        };
        return new Finding(Kind.METHOD, where.orElse(broken.text()));
    }

    /** A pair without opposite forces: the force on i has to change with x of j as the force on j does with x of i. */
    private Optional<String> wrongPair() {
        double[] force = trial.force();
        int count = force.length / 6;
        double[][] moved = IntStream.range(0, count).mapToObj(j -> trial.force(trial.moved(6 * j, STEP))).toArray(
                double[][]::new);
        boolean leftOut = EffectClaims.leavesFixedOut(trial);
        return IntStream.range(0, count * count).boxed().flatMap(pair -> {
            int i = pair / count;
            int j = pair % count;
            double onI = (moved[j][6 * i + 3] - force[6 * i + 3]) / STEP;
            double onJ = (moved[i][6 * j + 3] - force[6 * j + 3]) / STEP;
            return i == j || leftOut && !(trial.isFree(6 * i) && trial.isFree(6 * j)) || !(Math.abs(onI - onJ) > 1e-3
                    * Math.abs(onI)) ? Stream.empty() : Stream.of(Formula.text("it claims INTERNAL, and the force on"
                    + " %s along x changes by %s N for each m that %s moves, and the one on %s by %s N for each m that"
                    + " %s moves: F_ji has to be -F_ij", trial.id(i), onI, trial.id(j), trial.id(j), onJ, trial.id(i)));
        }).findFirst();
    }
}
