package particles.teaching.effects;

import deSolvers.ForceDerivatives;
import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import particles.ParticleSystem;
import particles.law.DifferentiableEffect;
import particles.law.Effect;
import particles.law.Effect.Trait;
import particles.teaching.Formula;

/**
 * Tests the properties that an effect declares, on random states of a system.
 *
 * @param trial  the effect in one state
 * @param force  its forces there
 * @param broken receives every declared property that does not hold
 */
public record EffectClaims(EffectTrial trial, double[] force, List<Broken> broken) {
    /** What an effect declares, of itself and by its methods. */
    public enum Claim {
        THIRD_LAW, DISSIPATED_POWER, DRIVEN_POWER, POWER, TRANSLATION, ROTATION, VELOCITY, DERIVATIVE
    }

    /**
     * A declared property that does not hold.
     *
     * @param claim       the property
     * @param unaccounted whether nothing is said of a power that the force has
     * @param text        what was measured
     */
    public record Broken(Claim claim, boolean unaccounted, String text) {
    }

    private static final double STEP = 1e-5;
    private static final double BOUND = 1e-6;
    private static final double ROUNDING = 1e-12;
    private static final int TRIALS = 20;

    /**
     * @param system the particles; about a unit apart, so that the random states make sense
     * @param effect the effect that acts on them
     * @param seed   the seed of the random states
     * @return every declared property that does not hold
     */
    public static List<Broken> broken(ParticleSystem system, Effect effect, long seed) {
        List<Broken> broken = new ArrayList<>();
        Random random = new Random(seed);
        for (int j = 0; j < TRIALS; j++) {
            // later than 0, where a force may begin so gently that differences have no digits of it
            EffectTrial trial = EffectTrial.random(system, effect, random, 1 + 3 * random.nextDouble());
            new EffectClaims(trial, trial.force(), broken).check();
        }
        return broken;
    }

    private double size() {
        return EffectTrial.largest(force);
    }

    private void check() {
        if (trial.claims(Trait.INTERNAL)) {
            checkThirdLaw();
        }
        checkPower();
        if (trial.claims(Trait.TRANSLATION_INVARIANT)) {
            double[] shift = {1.5, -0.5, 2.5};
            double[] shifted = trial.state().clone();
            trial.velocities().forEach(k -> shifted[k - 3] += shift[k % 3]);
            expectSame(Claim.TRANSLATION, "it claims TRANSLATION_INVARIANT, and with all particles moved alike", force,
                    trial.force(shifted));
        }
        if (trial.claims(Trait.ROTATION_INVARIANT)) {
            expectSame(Claim.ROTATION, "it claims ROTATION_INVARIANT, and with everything turned alike", rotated(force),
                    trial.force(rotated(trial.state())));
        }
        if (!trial.effect().dependsOnVelocity()) {
            expectSame(Claim.VELOCITY, "dependsOnVelocity() says false, and with other velocities", force, trial.force(
                    trial.changed(k -> k % 6 > 2, v -> v + 1)));
        }
        if (trial.effect() instanceof DifferentiableEffect differentiable) {
            checkDerivatives(differentiable);
        }
    }

    /** F . v = -dV/dt - dissipated + driven, of the particles that can move. */
    private void checkPower() {
        int n = trial.size();
        double[] state = trial.state();
        double power = trial.work(state);
        double stored = trial.stored(state);
        double dissipated = trial.heat(state);
        double driven = trial.effect().getDrivenPower(state, trial.time());
        expect(Claim.DISSIPATED_POWER, !(dissipated < 0), "the dissipated power is %s W, and heat is never negative",
                dissipated);
        expect(Claim.DISSIPATED_POWER, !(dissipated > 0) || trial.claims(Trait.DISSIPATIVE),
                "the dissipated power is %s W; claim DISSIPATIVE, or return 0", dissipated);
        expect(Claim.DRIVEN_POWER, driven == 0 || trial.claims(Trait.DRIVING),
                "the driven power is %s W; claim DRIVING, or"
                + " return 0", driven);
        double speed = trial.velocities().mapToDouble(k -> Math.abs(state[k])).reduce(1, Math::max);
        boolean none = stored == 0 && dissipated == 0 && driven == 0;
        if (!(Math.abs(power - trial.account(state)) <= BOUND * Math.max(size() * speed * n, Math.abs(stored)))) {
            broken.add(new Broken(Claim.POWER, none, Formula.text("the force does work at %s W, and getPotentialEnergy"
                    + " gives %s W, getDissipatedPower takes %s W and getDrivenPower adds %s W", power, -stored,
                    dissipated, driven)));
        }
    }

    private void expect(Claim claim, boolean holds, String otherwise, Object... values) {
        if (!holds) {
            broken.add(new Broken(claim, false, Formula.text(otherwise, values)));
        }
    }

    /** Every entry of the force's derivative by positions and velocities; differences of 1e-5. */
    private void checkDerivatives(DifferentiableEffect differentiable) {
        int n = trial.size();
        double[][] exact = new double[n][n];
        differentiable.addForceDerivatives(trial.state(), trial.time(), new ForceDerivatives() {
            @Override
            public void add(int i, int j, double[] dFdX, double[] dFdV) {
                put(i, j, dFdX, dFdV, 1);
            }

            @Override
            public void addPair(int i, int j, double[] dFdX, double[] dFdV) {
                put(i, i, dFdX, dFdV, 1);
                put(i, j, dFdX, dFdV, -1);
                put(j, j, dFdX, dFdV, 1);
                put(j, i, dFdX, dFdV, -1);
            }

            private void put(int i, int j, double[] dFdX, double[] dFdV, double sign) {
                for (int e = 0; e < 9; e++) {
                    exact[6 * i + 3 + e / 3][6 * j + e % 3] += sign * dFdX[e];
                    exact[6 * i + 3 + e / 3][6 * j + 3 + e % 3] += sign * dFdV[e];
                }
            }

            @Override
            public void transformRow(int i, double[] matrix) {
                broken.add(new Broken(Claim.DERIVATIVE, false, "only a reaction answers the forces of others"));
            }
        });
        for (int column = 0; column < n; column++) {
            if (!trial.isFree(column)) {
                continue;                               // it never moves, and |v| v has a kink of second order at rest
            }
            double[] ahead = trial.force(trial.moved(column, STEP));
            double[] behind = trial.force(trial.moved(column, -STEP));
            for (int row = 0; row < n; row++) {
                double slope = (ahead[row] - behind[row]) / (2 * STEP);
                expect(Claim.DERIVATIVE, Math.abs(exact[row][column] - slope) <= BOUND * Math.max(size(),
                        Math.abs(slope)),
                        "addForceDerivatives is not the derivative of addForces: entry %s, %s is %s where differences"
                        + " give %s", row, column, exact[row][column], slope);
            }
        }
    }

    private void checkThirdLaw() {
        double[] sum = new double[3];
        trial.velocities().forEach(k -> sum[k % 3] += force[k]);
        for (double total : sum) {
            expect(Claim.THIRD_LAW, Math.abs(total) <= ROUNDING * size() * trial.size() || leavesFixedOut(trial), "it"
                    + " claims INTERNAL, and the forces on all particles add up to %s N", total);
        }
    }

    /** @return whether the particles without a force are exactly the fixed ones, which no force moves */
    static boolean leavesFixedOut(EffectTrial trial) {
        double[] force = trial.force();
        return trial.velocities().noneMatch(k -> !trial.isFree(k) && force[k] != 0) && trial.velocities().filter(k ->
                k % 6 == 3 && trial.isFree(k)).allMatch(k -> force[k] != 0 || force[k + 1] != 0 || force[k + 2] != 0)
                && !trial.velocities().allMatch(trial::isFree);
    }

    /** A turn about all three axes: a cyclic exchange of the axes, then 0.6, 0.8 about z. */
    private double[] rotated(double[] values) {
        double[] turned = new double[values.length];
        for (int k = 0; k < turned.length; k += 3) {
            double a = values[k + 1];
            double b = values[k + 2];
            turned[k] = 0.6 * a - 0.8 * b;
            turned[k + 1] = 0.8 * a + 0.6 * b;
            turned[k + 2] = values[k];
        }
        return turned;
    }

    private void expectSame(Claim claim, String claimed, double[] expected, double[] actual) {
        trial.velocities().forEach(k -> expect(claim, Math.abs(expected[k] - actual[k]) <= ROUNDING * trial.size()
                * size(), "%s %s is %s N in place of %s N", claimed, trial.entry(k), actual[k], expected[k]));
    }
}
