package particles.teaching.effects;

import java.util.Arrays;
import java.util.Optional;
import particles.ParticleSystem;
import particles.law.Effect;
import particles.law.Effect.Trait;
import particles.teaching.Formula;

/**
 * Compares the work of a damping law with the dissipated power that it reports, and finds the cause of a difference.
 */
final class EffectPower {
    private static final double STEP = 1e-5;
    private static final double SAME = 1e-5;

    private final ParticleSystem system;
    private final Effect effect;
    private final double[] state;
    private final int n;

    EffectPower(ParticleSystem system, Effect effect, double[] state) {
        this.system = system;
        this.effect = effect;
        this.state = state;
        n = state.length;
    }

    /** @return the mistake of a law that declares DISSIPATIVE and not DRIVING; empty if there is none */
    Optional<String> wrong() {
        if (!effect.getTraits().contains(Trait.DISSIPATIVE) || effect.getTraits().contains(Trait.DRIVING)) {
            return Optional.empty();
        }
        double dissipated = effect.getDissipatedPower(state, 0);
        double power = power(state);
        if (Math.abs(power + dissipated) <= SAME * Math.max(1e-3, Math.abs(power))) {
            return dissipated < -SAME ? Optional.of("getDissipatedPower is " + Formula.number(dissipated) + " W, and"
                    + " heat is never negative: the sign is wrong in the force too, which has to push against the"
                    + " velocity") : Optional.empty();
        }
        if (dissipated == 0 && !dependsOnVelocity()) {
            return Optional.of("it claims DISSIPATIVE, but " + effect.getName() + " is not: its force is the same at"
                    + " all velocities. Claim CONSERVATIVE with getPotentialEnergy, or DRIVING with getDrivenPower");
        }
        return Optional.of("the forces do the work " + Formula.number(power) + " W and the effect says that it turns "
                + Formula.number(dissipated) + " W into heat" + cause(power, dissipated));
    }

    /** F . v plus the rate of the potential energy. */
    private double power(double[] at) {
        double[] force = force(at);
        double power = 0;
        double[] ahead = at.clone();
        double[] behind = at.clone();
        for (int k = 3; k < n; k += k % 6 == 5 ? 4 : 1) {
            power += force[k] * at[k];
            ahead[k - 3] += STEP * at[k];
            behind[k - 3] -= STEP * at[k];
        }
        return power + (effect.getPotentialEnergy(ahead, 0) - effect.getPotentialEnergy(behind, 0)) / (2 * STEP);
    }

    private double[] force(double[] at) {
        double[] force = new double[n];
        effect.addForces(at, 0, force);
        return force;
    }

    private double[] atRest() {
        double[] rest = state.clone();
        for (int k = 3; k < n; k += k % 6 == 5 ? 4 : 1) {
            rest[k] = 0;
        }
        return rest;
    }

    private boolean dependsOnVelocity() {
        return !Arrays.equals(force(state), force(atRest()));
    }

    private boolean turnsNotRound() {
        double[] back = state.clone();
        for (int k = 3; k < n; k += k % 6 == 5 ? 4 : 1) {
            back[k] = -back[k];
        }
        return Arrays.equals(force(back), force(state)) && dependsOnVelocity();
    }

    private String cause(double power, double dissipated) {
        if (dissipated == 0) {
            return ": getDissipatedPower is missing";
        }
        double ratio = -power / dissipated;
        if (Math.abs(ratio + 1) < 1e-4) {
            return dissipated < 0 ? ": the sign of the dissipated power is wrong; what becomes heat counts as positive"
                    : ": the sign is wrong; damping has to push against the velocity";
        }
        if (Math.abs(ratio - 2) < 1e-4) {
            return ": twice as much; a half stands in the dissipated power that does not belong there";
        }
        return Math.abs(ratio - 0.5) < 1e-4 ? ": half as much; a half is missing in the dissipated power, or is too "
                + "much in the force" : atRestOrInMotion();
    }

    private String atRestOrInMotion() {
        double[] rest = atRest();
        if (turnsNotRound()) {
            return ": the force is the same when all velocities are turned round, and has to be turned round with them;"
                    + " |v| v is meant, and not v v";
        }
        double[] force = force(rest);
        double size = Arrays.stream(force).map(Math::abs).max().orElse(0);
        boolean stores = false;
        boolean moves = false;
        double[] elsewhere = rest.clone();
        for (int k = 0; k < n; k += k % 6 == 2 ? 4 : 1) {
            elsewhere[k] += 1;
            stores |= effect.getPotentialEnergy(elsewhere, 0) != effect.getPotentialEnergy(rest, 0);
            moves |= Math.abs(force(elsewhere)[k + 3] - force[k + 3]) > SAME * size;
        }
        if (size > 0 && !stores) {
            return moves ? ": there is a force at rest too, which stores energy; getPotentialEnergy is missing"
                    : ": there is a force at rest too, which drives; claim DRIVING and return its power in"
                    + " getDrivenPower";
        }
        return entryByEntry(rest);
    }

    /** Checks one velocity at a time: the dissipated power determines the force along it. */
    private String entryByEntry(double[] rest) {
        double[] force = new double[n];
        double[] expected = new double[n];
        double size = 0;
        for (int k = 3; k < n; k += k % 6 == 5 ? 4 : 1) {
            double[] moving = rest.clone();
            moving[k] = 1;
            double heat = effect.getDissipatedPower(moving, 0);
            force[k] = force(moving)[k];
            expected[k] = force[k] - power(moving) - heat;
            size = Math.max(size, Math.max(Math.abs(force[k]), Math.abs(expected[k])));
        }
        return new ForceComparison(system, force, expected, size).cause(true, "the dissipated power");
    }
}
