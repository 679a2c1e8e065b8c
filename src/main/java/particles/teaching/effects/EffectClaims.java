package particles.teaching.effects;

import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import particles.ParticleSystem;
import particles.law.DifferentiableEffect;
import particles.law.Effect;
import particles.law.Effect.Trait;
import particles.law.ForceDerivatives;
import particles.teaching.Formula;

/**
 * Tests the properties that an effect declares, on random states of a system. Finite differences are central, with
 * steps of 1e-5 on numbers of order 1, so their own error is about 1e-10.
 */
public final class EffectClaims {
    private static final double STEP = 1e-5;
    private static final double BOUND = 1e-6;

    private final ParticleSystem system;
    private final Effect effect;
    private final Random random;
    private final List<String> broken = new ArrayList<>();
    private final int n;

    private EffectClaims(ParticleSystem system, Effect effect, long seed) {
        this.system = system;
        this.effect = effect;
        this.random = new Random(seed);
        this.n = system.getStateSize();
    }

    /**
     * @param system the particles; about a unit apart, so that the random states make sense
     * @param effect the effect that acts on them
     * @param seed   the seed of the random states
     * @return a line for every declared property that does not hold; the first word is the property
     */
    public static List<String> broken(ParticleSystem system, Effect effect, long seed) {
        EffectClaims claims = new EffectClaims(system, effect, seed);
        for (int trial = 0; trial < 20; trial++) {
            claims.check(claims.randomState(), 3 * claims.random.nextDouble());
        }
        return claims.broken;
    }

    private double[] randomState() {
        double[] state = new double[n];
        system.getState(state);
        for (int k = 0; k < n; k++) {
            state[k] += 0.6 * random.nextDouble() - 0.3;
        }
        for (int i = 0; i < system.getParticles().count(); i++) {
            for (int c = 3; c < 6 && system.getParticles().isFixed(i); c++) {
                state[6 * i + c] = 0;
            }
        }
        return state;
    }

    private double[] force(double[] state, double time) {
        double[] force = new double[n];
        effect.addForces(state, time, force);
        return force;
    }

    private void check(double[] state, double time) {
        double[] force = force(state, time);
        double size = 1e-300;
        for (double f : force) {
            size = Math.max(size, Math.abs(f));
        }
        checkRanges(state, time, force, size);
        if (effect instanceof DifferentiableEffect differentiable && differentiable.hasForceDerivatives()) {
            checkDerivatives(differentiable, state, time, size);
        }
        checkPower(state, time, force, size);
        if (effect.getTraits().contains(Trait.CONSERVATIVE)) {
            checkGradient(state, time, force, size);
        }
        if (effect.getTraits().contains(Trait.INTERNAL)) {
            checkThirdLaw(force, size);
        }
        if (effect.getTraits().contains(Trait.TRANSLATION_INVARIANT)) {
            double[] shifted = state.clone();
            for (int x = 0; x < n; x += 6) {
                shifted[x] += 1.5;
                shifted[x + 1] -= 0.5;
                shifted[x + 2] += 2.5;
            }
            expectSame("translation", force, force(shifted, time), size);
        }
        if (effect.getTraits().contains(Trait.ROTATION_INVARIANT)) {
            expectSame("rotation", rotated(force), force(rotated(state), time), size);
        }
        if (!effect.dependsOnVelocity()) {
            double[] other = state.clone();
            for (int v = 3; v < n; v += 6) {
                other[v] += 1;
            }
            expectSame("no dependence on velocity", force, force(other, time), size);
        }
    }

    private void checkRanges(double[] state, double time, double[] force, double size) {
        double[] parts = EffectWriting.inTwoRanges(effect, state, time).orElse(force);
        for (int k = 0; k < n; k++) {
            if (!(Math.abs(parts[k] - force[k]) <= 1e-14 * size)) {
                broken.add("ranges: entry " + k + " is " + parts[k] + " in two ranges and " + force[k] + " at once");
            }
            if (k % 6 < 3 && force[k] != 0) {
                broken.add("force written to position entry " + k);
            }
        }
    }

    /** F . v = -dV/dt - dissipated + driven, of the particles that can move. */
    private void checkPower(double[] state, double time, double[] force, double size) {
        double power = 0;
        double speed = 1;
        double[] ahead = state.clone();
        double[] behind = state.clone();
        for (int i = 0; i < n / 6; i++) {
            for (int c = 0; c < 3; c++) {
                double v = state[6 * i + 3 + c];
                power += force[6 * i + 3 + c] * v;
                ahead[6 * i + c] += STEP * v;
                behind[6 * i + c] -= STEP * v;
                speed = Math.max(speed, Math.abs(v));
            }
        }
        double stored = (effect.getPotentialEnergy(ahead, time) - effect.getPotentialEnergy(behind, time)) / (2 * STEP);
        double dissipated = effect.getDissipatedPower(state, time);
        double driven = effect.getDrivenPower(state, time);
        if (dissipated < 0) {
            broken.add("dissipated power: it is " + Formula.number(dissipated) + " W, and heat is never negative");
        }
        if (dissipated > 0 && !effect.getTraits().contains(Trait.DISSIPATIVE)) {
            broken.add("dissipated power: it is " + Formula.number(dissipated) + " W; claim DISSIPATIVE, or return 0");
        }
        if (driven != 0 && !effect.getTraits().contains(Trait.DRIVING)) {
            broken.add("driven power: it is " + Formula.number(driven)
                    + " W; claim DRIVING, or return 0");
        }
        double scale = Math.max(size * speed * n, Math.abs(stored));
        if (!(Math.abs(power + stored + dissipated - driven) <= BOUND * scale)) {
            broken.add("power: the force does work at " + Formula.number(power) + " W; " + (stored == 0 && dissipated ==
                    0
                    && driven == 0 ? "none of getPotentialEnergy, getDissipatedPower and getDrivenPower accounts for it"
                    : "accounted for are " + Formula.number(driven - stored - dissipated)
                    + " W: getPotentialEnergy gives "
                            + Formula.number(-stored) + " W, getDissipatedPower takes " + Formula.number(dissipated)
                            + " W and getDrivenPower adds " + Formula.number(driven) + " W"));
        }
    }

    private void checkGradient(double[] state, double time, double[] force, double size) {
        for (int i = 0; i < n / 6; i++) {
            for (int c = 0; c < 3 && !system.getParticles().isFixed(i); c++) {
                double[] moved = state.clone();
                moved[6 * i + c] = state[6 * i + c] + STEP;
                double ahead = effect.getPotentialEnergy(moved, time);
                moved[6 * i + c] = state[6 * i + c] - STEP;
                double slope = (ahead - effect.getPotentialEnergy(moved, time)) / (2 * STEP);
                if (!(Math.abs(force[6 * i + 3 + c] + slope) <= BOUND * size)) {
                    broken.add("gradient: force " + force[6 * i + 3 + c] + " where the potential's slope is " + slope);
                }
            }
        }
    }

    /**
     * Every entry of the force's derivative by positions and velocities; differences of positions and velocities of
     * 1e-5.
     */
    private void checkDerivatives(DifferentiableEffect differentiable, double[] state, double time, double size) {
        double[][] exact = new double[n][n];
        differentiable.addForceDerivatives(state, time, new ForceDerivatives() {
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
                broken.add("derivative: only a reaction answers the forces of others");
            }
        });
        for (int column = 0; column < n; column++) {
            if (system.getParticles().isFixed(column / 6)) {
                continue;                               // it never moves, and |v| v has a kink of second order at rest
            }
            double[] moved = state.clone();
            moved[column] = state[column] + STEP;
            double[] ahead = force(moved, time);
            moved[column] = state[column] - STEP;
            double[] behind = force(moved, time);
            for (int row = 0; row < n; row++) {
                double slope = (ahead[row] - behind[row]) / (2 * STEP);
                if (!(Math.abs(exact[row][column] - slope) <= BOUND * Math.max(size, Math.abs(slope)))) {
                    broken.add("derivative: entry " + row + ", " + column + " is " + exact[row][column]
                            + " where differences give " + slope);
                }
            }
        }
    }

    private void checkThirdLaw(double[] force, double size) {
        double[] sum = new double[3];
        for (int k = 3; k < n; k += k % 6 == 5 ? 4 : 1) {
            sum[k % 3] += force[k];
        }
        for (double total : sum) {
            if (!(Math.abs(total) <= 1e-12 * size * n) && !leavesFixedOut(system, force)) {
                broken.add("third law: forces add up to " + Formula.number(total) + " N");
            }
        }
    }

    /** @return whether the particles without a force are exactly the fixed ones, which no force moves */
    static boolean leavesFixedOut(ParticleSystem system, double[] force) {
        boolean any = false;
        for (int i = 0; i < force.length / 6; i++) {
            boolean none = force[6 * i + 3] == 0 && force[6 * i + 4] == 0 && force[6 * i + 5] == 0;
            if (none != system.getParticles().isFixed(i)) {
                return false;
            }
            any |= none;
        }
        return any;
    }

    /** A turn about all three axes: a cyclic exchange of the axes, then 0.6, 0.8 about z. */
    private double[] rotated(double[] values) {
        double[] turned = new double[n];
        for (int k = 0; k < n; k += 3) {
            double a = values[k + 1];
            double b = values[k + 2];
            turned[k] = 0.6 * a - 0.8 * b;
            turned[k + 1] = 0.8 * a + 0.6 * b;
            turned[k + 2] = values[k];
        }
        return turned;
    }

    private void expectSame(String claim, double[] expected, double[] actual, double size) {
        for (int k = 0; k < n; k++) {
            if (!(Math.abs(expected[k] - actual[k]) <= 1e-12 * size * n)) {
                broken.add(claim + ": entry " + k + " is " + actual[k] + " instead of " + expected[k]);
            }
        }
    }
}
