package particles.teaching.effects;

import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.Random;
import java.util.Set;
import particles.ParticleSystem;
import particles.law.Effect;
import particles.law.Effect.Trait;
import particles.teaching.Finding;
import particles.teaching.Finding.Kind;
import particles.teaching.Formula;
import particles.teaching.StudentFailure;

/**
 * Checks a student's force law against the properties that it declares, by {@link EffectClaims}. If one does not hold,
 * it names the particle, the component and the probable mistake.
 */
public final class EffectCheck {
    private static final double STEP = 1e-5;
    private static final double SAME = 1e-5;

    private final ParticleSystem system;
    private final Effect effect;
    private final EffectLaw law;
    private final int n;
    private final double[] state;

    private EffectCheck(ParticleSystem system, EffectLaw law) {
        this.system = system;
        this.law = law;
        effect = law.maker().apply(system.getParticles());
        n = system.getStateSize();
        state = new double[n];
        system.getState(state);
        Random random = new Random(17);
        for (int k = 0; k < n; k++) {
            boolean rests = k % 6 >= 3 && system.getParticles().isFixed(k / 6);
            state[k] += rests ? 0 : 0.6 * random.nextDouble() - 0.3;
        }
    }

    /**
     * Checks a law on six particles, one of them fixed, and on nine that are all free.
     *
     * @param law the law
     * @return the first mistake; empty if all declared properties hold
     */
    public static List<Finding> check(EffectLaw law) {
        return new EffectCheck(EffectSample.system(), law).first()
                .or(() -> new EffectCheck(EffectSample.larger(), law).first()).stream().toList();
    }

    private Optional<Finding> first() {
        try {
            return new EffectWriting(system, effect, state).finding().or(this::contradiction).or(this::partners)
                    .or(() -> potential().or(this::power).or(this::velocities).map(this::orWrongIndex))
                    .or(this::otherClaims).or(() -> NamedDirection.finding(system, effect, law, state));
        } catch (IndexOutOfBoundsException e) {
            return wrong(Kind.FAILURE, "it ends in an exception: " + StudentFailure.describe(e) + ". The state of "
                    + n / 6 + " particles has " + n + " numbers, those of particle i from 6 i to 6 i + 5: a loop over"
                    + " particles goes while i < particles.count()");
        }
    }

    private static Optional<Finding> wrong(Kind kind, String text) {
        return Optional.of(new Finding(kind, text));
    }

    private Finding orWrongIndex(Finding symptom) {
        return new EffectIndices(system, effect, state).cause().map(text -> new Finding(Kind.STATE, text))
                .orElse(symptom);
    }

    private double[] force(double[] at) {
        double[] force = new double[n];
        effect.addForces(at, 0, force);
        return force;
    }

    private String entry(int k) {
        return EffectWriting.entry(system, k);
    }

    /** A law that stores all of its energy neither takes energy out nor puts any in. */
    private Optional<Finding> contradiction() {
        Set<Trait> claims = effect.getTraits();
        return claims.contains(Trait.CONSERVATIVE) && (claims.contains(Trait.DISSIPATIVE)
                || claims.contains(Trait.DRIVING)) ? wrong(Kind.METHOD, "it claims CONSERVATIVE and "
                + (claims.contains(Trait.DISSIPATIVE) ? "DISSIPATIVE" : "DRIVING")
                + ", which contradict each other: a conservative force keeps the energy that it stores")
                : Optional.empty();
    }

    /**
     * Newton's third law: the forces add up to 0. Where they do not, it looks for a pair of particles that breaks the
     * law.
     */
    private Optional<Finding> partners() {
        if (!effect.getTraits().contains(Trait.INTERNAL)) {
            return Optional.empty();
        }
        double[] force = force(state);
        double[] sum = new double[3];
        double size = 0;
        for (int k = 0; k < n; k++) {
            sum[k % 3] += force[k];
            size = Math.max(size, Math.abs(force[k]));
        }
        double rest = Math.max(Math.abs(sum[0]), Math.max(Math.abs(sum[1]), Math.abs(sum[2])));
        if (rest <= 1e-10 * size) {
            return Optional.empty();
        }
        int axis = rest == Math.abs(sum[0]) ? 0 : rest == Math.abs(sum[1]) ? 1 : 2;
        Optional<Finding> pair = wrongPair(force).map(text -> new Finding(Kind.METHOD, text));
        return pair.isPresent() || EffectClaims.leavesFixedOut(system, force) ? pair : wrong(Kind.METHOD,
                "the forces on all particles add up to " + Formula.number(rest) + " along " + EffectWriting.axis(axis)
                + " and not to 0: F_ji has to be -F_ij");
    }

    /**
     * Looks for a pair without opposite forces: the force on i has to change with the position of j as the force on j
     * does with that of i.
     */
    private Optional<String> wrongPair(double[] force) {
        double[][] change = new double[n / 6][];
        for (int j = 0; j < change.length; j++) {
            double[] moved = state.clone();
            moved[6 * j] += STEP;
            change[j] = force(moved);
            for (int k = 0; k < n; k++) {
                change[j][k] -= force[k];
            }
        }
        if (pushesNoPartner(change)) {
            return Optional.of("it claims INTERNAL, but " + effect.getName() + " is not: no particle's force changes "
                    + "with the place of another, so that there are no pairs that push each other");
        }
        boolean leftOut = EffectClaims.leavesFixedOut(system, force);
        for (int i = 0; i < change.length; i++) {
            for (int j = 0; j < change.length; j++) {
                boolean noPair = i == j || leftOut && (isFixed(i) || isFixed(j));
                double onI = change[j][6 * i + 3];
                double onJ = change[i][6 * j + 3];
                if (!noPair && onI != 0 && Math.abs(onI - onJ) > 1e-3 * Math.abs(onI)) {
                    return Optional.of("particle " + name(j) + " pushes " + name(i)
                            + (onJ == 0 ? ", and is not pushed itself: the partner's force F_ji = -F_ij is missing"
                            : Math.abs(onI + onJ) < 1e-3 * Math.abs(onI)
                            ? ", and gets the same force itself: it has to get the opposite one, F_ji = -F_ij"
                            : ", and their forces are not opposite: F_ji has to be -F_ij"));
                }
            }
        }
        return Optional.empty();
    }

    private static boolean pushesNoPartner(double[][] change) {
        for (int j = 0; j < change.length; j++) {
            for (int k = 0; k < change[j].length; k++) {
                if (k / 6 != j && change[j][k] != 0) {
                    return false;
                }
            }
        }
        return true;
    }

    private boolean isFixed(int i) {
        return system.getParticles().isFixed(i);
    }

    private String name(int i) {
        return "'" + system.getParticles().id(i) + "'";
    }

    /** Checks that the force on particles that can move is -grad of the potential energy. */
    private Optional<Finding> potential() {
        if (!effect.getTraits().contains(Trait.CONSERVATIVE)) {
            return Optional.empty();
        }
        double[] force = force(state);
        double[] expected = new double[n];
        for (int k = 3; k < n; k += k % 6 == 5 ? 4 : 1) {
            double[] moved = state.clone();
            moved[k - 3] += STEP;
            double ahead = effect.getPotentialEnergy(moved, 0);
            moved[k - 3] = state[k - 3] - STEP;
            expected[k] = -(ahead - effect.getPotentialEnergy(moved, 0)) / (2 * STEP);
        }
        return compare(force, expected);
    }

    /**
     * Compares the forces on free particles component by component, and looks for a common pattern of the differences.
     */
    private Optional<Finding> compare(double[] force, double[] expected) {
        double size = Math.max(Arrays.stream(force).map(Math::abs).max().orElse(0),
                Arrays.stream(expected).map(Math::abs).max().orElse(0));
        for (int k = 3; k < n; k += k % 6 == 5 ? 4 : 1) {
            if (!isFixed(k / 6) && Math.abs(force[k] - expected[k]) > SAME * size) {
                return wrong(Kind.METHOD, entry(k) + " is " + Formula.number(force[k])
                        + " where the slope of the potential energy asks for " + Formula.number(expected[k])
                        + new ForceComparison(system, force, expected, size).cause(effect.dependsOnVelocity(),
                        "the potential energy"));
            }
        }
        return Optional.empty();
    }

    private Optional<Finding> power() {
        return new EffectPower(system, effect, state).wrong().map(text -> new Finding(Kind.METHOD, text));
    }

    private Optional<Finding> velocities() {
        if (effect.dependsOnVelocity()) {
            return Optional.empty();
        }
        double[] other = state.clone();
        for (int k = 3; k < n; k += k % 6 == 5 ? 4 : 1) {
            other[k] += 1;
        }
        double[] force = force(state);
        double[] changed = force(other);
        for (int k = 0; k < n; k++) {
            if (Math.abs(force[k] - changed[k]) > 1e-12 * Math.max(1, Math.abs(force[k]))) {
                return wrong(Kind.STATE, entry(k) + " changes with the velocity, and dependsOnVelocity() says false");
            }
        }
        return Optional.empty();
    }

    /** Checks the other properties: power, symmetries and derivatives. */
    private Optional<Finding> otherClaims() {
        return EffectClaims.broken(system, effect, 2003).stream().findFirst()
                .map(line -> new Finding(Kind.METHOD, claim(line)));
    }

    private boolean claimsItsPower() {
        return effect.getTraits().stream()
                .anyMatch(trait -> trait == Trait.CONSERVATIVE || trait == Trait.DISSIPATIVE || trait == Trait.DRIVING);
    }

    private String claim(String line) {
        if (line.startsWith("translation")) {
            return "it claims TRANSLATION_INVARIANT, but " + effect.getName() + " is not: with all particles moved "
                    + "alike the force changes, which uses places and not only differences of places";
        }
        if (line.startsWith("rotation")) {
            return "it claims ROTATION_INVARIANT, but " + effect.getName() + " is not: with everything turned alike "
                    + "the force is not the turned one, so that some direction is preferred";
        }
        String hint = line.startsWith("derivative") ? "; addForceDerivatives is not the derivative of addForces" : "";
        return "a claim does not hold: " + line + (line.startsWith("power") && !claimsItsPower()
                ? ". Claim CONSERVATIVE with getPotentialEnergy, DISSIPATIVE with getDissipatedPower or DRIVING with"
                + " getDrivenPower" : hint);
    }
}
