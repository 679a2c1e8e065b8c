package particles.teaching.effects;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Optional;
import java.util.Random;
import java.util.Set;
import particles.ParticleSystem;
import particles.law.Effect.Trait;
import particles.law.Effect;
import particles.teaching.Finding.Kind;
import particles.teaching.Finding;
import particles.teaching.Formula;

/**
 * Holds an effect to what it claims of itself, by {@link EffectClaims}, and says where a claim fails: at which
 * particle, in
 * which component, and what is probably the mistake.
 */
public final class EffectCheck {
    private static final double STEP = 1e-5;
    private static final double SAME = 1e-5;

    private final ParticleSystem system;
    private final Effect effect;
    private final int n;
    private final double[] state;
    private final List<Finding> findings = new ArrayList<>();

    private EffectCheck(ParticleSystem system, Effect effect) {
        this.system = system;
        this.effect = effect;
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
     * Checks an effect.
     *
     * @param system the particles that the effect was made for
     * @param effect the effect
     * @return what is wrong; empty if it keeps what it claims
     */
    public static List<Finding> check(ParticleSystem system, Effect effect) {
        EffectCheck check = new EffectCheck(system, effect);
        new EffectWriting(system, effect, check.state).finding().ifPresent(check.findings::add);
        if (check.findings.isEmpty()) {
            check.partners();
            check.potential();
            check.power();
            check.velocities();
        }
        if (check.findings.isEmpty()) {
            check.otherClaims();
        }
        return check.findings;
    }

    private void wrong(Kind kind, String text) {
        findings.add(new Finding(kind, text));
    }

    private double[] force(double[] at) {
        double[] force = new double[n];
        effect.addForces(at, 0, force);
        return force;
    }

    private String entry(int k) {
        return EffectWriting.entry(system, k);
    }

    /**
     * Newton's third law: the forces add up to 0. Where they do not, it looks for a pair of particles that breaks the
     * law.
     */
    private void partners() {
        if (!effect.getTraits().contains(Trait.INTERNAL)) {
            return;
        }
        double[] force = force(state);
        double[] sum = new double[3];
        double size = 0;
        for (int k = 0; k < n; k++) {
            sum[k % 3] += force[k];
            size = Math.max(size, Math.abs(force[k]));
        }
        double rest = Math.max(Math.abs(sum[0]), Math.max(Math.abs(sum[1]), Math.abs(sum[2])));
        if (rest > 1e-10 * size) {
            int axis = rest == Math.abs(sum[0]) ? 0 : rest == Math.abs(sum[1]) ? 1 : 2;
            wrong(Kind.METHOD, wrongPair(force).orElse("the forces on all particles add up to " + Formula.number(rest)
                    + " along "
                    + EffectWriting.axis(axis) + " and not to 0: F_ji has to be -F_ij"));
        }
    }

    /** The force on i changes with the place of j as the force on j does with that of i, if they are opposite. */
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
        for (int i = 0; i < change.length; i++) {
            for (int j = 0; j < change.length; j++) {
                double onI = change[j][6 * i + 3];
                double onJ = change[i][6 * j + 3];
                if (i != j && onI != 0 && Math.abs(onI - onJ) > 1e-3 * Math.abs(onI)) {
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

    private String name(int i) {
        return "'" + system.getParticles().id(i) + "'";
    }

    /** Force = -grad of the potential energy, of the particles that can move. */
    private void potential() {
        if (!effect.getTraits().contains(Trait.CONSERVATIVE) || !findings.isEmpty()) {
            return;
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
        compare(force, expected, "the slope of the potential energy asks for", "the potential energy");
    }

    /** Compares forces of free particles component by component, and looks for what is common to all differences. */
    private void compare(double[] force, double[] expected, String authority, String other) {
        double size = Math.max(Arrays.stream(force).map(Math::abs).max().orElse(0),
                Arrays.stream(expected).map(Math::abs).max().orElse(0));
        for (int k = 3; k < n; k += k % 6 == 5 ? 4 : 1) {
            if (system.getParticles().isFixed(k / 6) || Math.abs(force[k] - expected[k]) <= SAME * size) {
                continue;
            }
            wrong(Kind.METHOD, entry(k) + " is " + Formula.number(force[k]) + " where " + authority + " "
                    + Formula.number(expected[k])
                    + new ForceComparison(system, force, expected, size).cause(effect.dependsOnVelocity(), other));
            return;
        }
    }

    /** What damps takes as much power as it says. */
    private void power() {
        double dissipated = effect.getDissipatedPower(state, 0);
        if (!effect.getTraits().contains(Trait.DISSIPATIVE) || effect.getTraits().contains(Trait.DRIVING)
                || !findings.isEmpty()) {
            return;
        }
        double[] force = force(state);
        double power = 0;
        double[] ahead = state.clone();
        double[] behind = state.clone();
        for (int k = 3; k < n; k += k % 6 == 5 ? 4 : 1) {
            power += force[k] * state[k];
            ahead[k - 3] += STEP * state[k];
            behind[k - 3] -= STEP * state[k];
        }
        power += (effect.getPotentialEnergy(ahead, 0) - effect.getPotentialEnergy(behind, 0)) / (2 * STEP);
        if (Math.abs(power + dissipated) <= SAME * Math.max(1e-3, Math.abs(power))) {
            return;
        }
        String start = "the forces do the work " + Formula.number(power) + " W and the effect says that it turns "
                + Formula.number(dissipated)
                + " W into heat";
        double ratio = -power / dissipated;
        wrong(Kind.METHOD, start + (dissipated == 0 ? ": getDissipatedPower is missing"
                : Math.abs(ratio + 1) < 1e-4 && dissipated < 0
                ? ": the sign of the dissipated power is wrong; what becomes heat counts as positive"
                : Math.abs(ratio + 1) < 1e-4 ? ": the sign is wrong; damping has to push against the velocity"
                : Math.abs(ratio - 2) < 1e-4 ? ": twice as much; a half stands in the dissipated power that does not "
                + "belong there"
                : Math.abs(ratio - 0.5) < 1e-4 ? ": half as much; a half is missing in the dissipated power, or is too "
                + "much in the force" : ""));
    }

    private void velocities() {
        if (effect.dependsOnVelocity()) {
            return;
        }
        double[] other = state.clone();
        for (int k = 3; k < n; k += k % 6 == 5 ? 4 : 1) {
            other[k] += 1;
        }
        double[] force = force(state);
        double[] changed = force(other);
        for (int k = 0; k < n; k++) {
            if (Math.abs(force[k] - changed[k]) > 1e-12 * Math.max(1, Math.abs(force[k]))) {
                wrong(Kind.STATE, entry(k) + " changes with the velocity, and dependsOnVelocity() says false");
                return;
            }
        }
    }

    /** What is left: symmetries and derivatives; one line of each kind. */
    private void otherClaims() {
        Set<String> seen = new LinkedHashSet<>();
        for (String line : EffectClaims.broken(system, effect, 2003)) {
            if (seen.add(line.replaceFirst("[ :].*", ""))) {
                wrong(Kind.METHOD, "a claim does not hold: " + line + hint(line));
            }
        }
    }

    private boolean claimsItsPower() {
        return effect.getTraits().stream()
                .anyMatch(trait -> trait == Trait.CONSERVATIVE || trait == Trait.DISSIPATIVE || trait == Trait.DRIVING);
    }

    private String hint(String line) {
        if (line.startsWith("power") && !claimsItsPower()) {
            return ". Claim CONSERVATIVE with getPotentialEnergy, DISSIPATIVE with"
                    + " getDissipatedPower or DRIVING with getDrivenPower";
        }
        if (line.startsWith("translation")) {
            return "; the force uses places and not differences of places, though it claims TRANSLATION_INVARIANT";
        }
        return line.startsWith("derivative") ? "; addForceDerivatives is not the derivative of addForces" : "";
    }
}
