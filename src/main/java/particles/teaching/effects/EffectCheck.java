package particles.teaching.effects;

import java.util.Arrays;
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
import particles.teaching.effects.EffectClaims.Claim;

/**
 * Checks a student's force law against the properties that it declares, by {@link EffectClaims}. If one does not hold,
 * it names the particle, the component and the probable mistake.
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
            int n = trial.size();
            return EffectWriting.wrong(Kind.FAILURE, Formula.text("it ends in an exception: %s. The state of %s"
                    + " particles has %s numbers, those of particle i from 6 i to 6 i + 5: a loop over particles goes"
                    + " while i < particles.count()", StudentFailure.describe(e), n / 6, n));
        }
    }

    /** A law that stores all of its energy neither takes energy out nor puts any in. */
    private Optional<Finding> contradiction() {
        Trait other = trial.claims(Trait.DISSIPATIVE) ? Trait.DISSIPATIVE : Trait.DRIVING;
        return !trial.claims(Trait.CONSERVATIVE) || !trial.claims(other) ? Optional.empty() : EffectWriting.wrong(
                Kind.METHOD, "it claims CONSERVATIVE and " + other + ", which contradict each other: a conservative"
                + " force keeps the energy that it stores");
    }

    /** The mistake behind a claim that does not hold. */
    private Finding explained(Broken broken) {
        if (broken.claim() == Claim.THIRD_LAW) {
            return method(wrongPair().orElse(broken.text()));
        }
        boolean accounted = Stream.of(Trait.CONSERVATIVE, Trait.DISSIPATIVE, Trait.DRIVING).anyMatch(trial::claims);
        if (broken.unaccounted() && !accounted) {
            return new Finding(Kind.STYLE, "it claims no account of its energy: a run lists its work, whether it"
                    + " is stored or lost, until it claims CONSERVATIVE with getPotentialEnergy, DISSIPATIVE with"
                    + " getDissipatedPower or DRIVING with getDrivenPower");
        }
        Optional<Finding> cause = potential().or(() -> new EffectPower(trial).wrong().map(EffectCheck::method)).or(() ->
                broken.claim() == Claim.VELOCITY ? EffectWriting.wrong(Kind.STATE,
                        "the force changes with the velocity,"
                + " and dependsOnVelocity() says false") : Optional.empty());
        return cause.map(symptom -> new EffectIndices(trial).cause().map(text -> new Finding(Kind.STATE, text)).orElse(
                symptom)).orElseGet(() -> method(claim(broken)));
    }

    private static Finding method(String text) {
        return new Finding(Kind.METHOD, text);
    }

    /**
     * Looks for a pair without opposite forces: the force on i has to change with the position of j as the force on j
     * does with that of i.
     */
    private Optional<String> wrongPair() {
        double[] force = trial.force();
        int count = force.length / 6;
        double[][] moved = IntStream.range(0, count).mapToObj(j -> trial.force(trial.moved(6 * j, STEP))).toArray(
                double[][]::new);
        if (trial.velocities().allMatch(k -> IntStream.range(0, count).allMatch(j -> k / 6 == j || moved[j][k]
                == force[k]))) {
            return Optional.of("it claims INTERNAL, but " + trial.effect().getName() + " is not: no particle's force"
                    + " changes with the place of another, so that there are no pairs that push each other");
        }
        boolean leftOut = EffectClaims.leavesFixedOut(trial);
        for (int i = 0; i < count; i++) {
            for (int j = 0; j < count; j++) {
                boolean pair = i != j && !(leftOut && !(trial.isFree(6 * i) && trial.isFree(6 * j)));
                double onI = moved[j][6 * i + 3] - force[6 * i + 3];
                double onJ = moved[i][6 * j + 3] - force[6 * j + 3];
                if (pair && onI != 0 && Math.abs(onI - onJ) > 1e-3 * Math.abs(onI)) {
                    return Optional.of("particle " + trial.id(j) + " pushes " + trial.id(i)
                            + (onJ == 0 ? ", and is not pushed itself: the partner's force F_ji = -F_ij is missing"
                            : Math.abs(onI + onJ) < 1e-3 * Math.abs(onI)
                            ? ", and gets the same force itself: it has to get the opposite one, F_ji = -F_ij"
                            : ", and their forces are not opposite: F_ji has to be -F_ij"));
                }
            }
        }
        return Optional.empty();
    }

    /** Checks that the force on particles that can move is -grad of the potential energy. */
    private Optional<Finding> potential() {
        if (!trial.claims(Trait.CONSERVATIVE)) {
            return Optional.empty();
        }
        ForceComparison compared = new ForceComparison(trial, trial.force(), trial.slopes());
        return compared.wrong().boxed().findFirst().map(k -> method(Formula.text("%s is %s where the slope of the"
                + " potential energy asks for %s%s", trial.entry(k), compared.force()[k], compared.expected()[k],
                compared.cause(!Arrays.equals(trial.force(), trial.force(trial.faster(2))), "the potential energy"))));
    }

    private String claim(Broken broken) {
        String name = trial.effect().getName();
        return switch (broken.claim()) {
            case TRANSLATION -> "it claims TRANSLATION_INVARIANT, but " + name
                    + " is not: with all particles moved alike"
                    + " the force changes, which uses places and not only differences of places";
            case ROTATION -> "it claims ROTATION_INVARIANT, but " + name + " is not: with everything turned alike the"
                    + " force is not the turned one, so that some direction is preferred";
            case DERIVATIVE -> "addForceDerivatives is not the derivative of addForces: " + broken.text();
            default -> "a claim does not hold: " + broken.text();
        };
    }
}
