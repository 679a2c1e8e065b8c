package particles.engine;

import deSolvers.DEStateSource;
import deSolvers.ForceDerivatives;
import java.util.Arrays;
import java.util.List;
import particles.law.DifferentiableEffect;
import particles.law.Effect;
import particles.law.Particles;
import particles.law.Reaction;

/**
 * The Jacobian of a particle system: exact where effects and reactions know their derivatives, otherwise by finite
 * differences.
 */
public final class ParticleJacobian {
    private static final int STRIDE = Particles.STRIDE;
    /** Relative step of a forward difference: balances round-off against truncation error. */
    private static final double ROOT_EPSILON = Math.sqrt(Math.ulp(1.0));

    private final DEStateSource source;
    private final Particles particles;
    private final ForceSum forces;
    private final List<Effect> effects;
    private final List<Reaction> reactions;
    private double[] force = {};
    private double[] varied = {};
    private final Product productBlocks = new Product();
    private double[] direction = {};
    private double[] product = {};

    /** Keeps the lists of effects and reactions, which may grow later. */
    public ParticleJacobian(DEStateSource source, Particles particles, ForceSum forces, List<Effect> effects,
            List<Reaction> reactions) {
        this.source = source;
        this.particles = particles;
        this.forces = forces;
        this.effects = effects;
        this.reactions = reactions;
    }

    /** Whether all effects and active reactions know their derivatives. */
    public boolean isExact() {
        for (int e = 0; e < effects.size(); e++) {
            if (!(effects.get(e) instanceof DifferentiableEffect effect && effect.hasForceDerivatives())) {
                return false;
            }
        }
        for (int r = 0; r < reactions.size(); r++) {
            if (reactions.get(r).isActive() && !reactions.get(r).hasForceDerivatives()) {
                return false;
            }
        }
        return true;
    }

    /** Adds the blocks of all effects and reactions that know their derivatives. */
    public void addBlocks(double[] state, double time, ForceDerivatives blocks) {
        for (int e = 0; e < effects.size(); e++) {
            if (effects.get(e) instanceof DifferentiableEffect effect) {
                effect.addForceDerivatives(state, time, blocks);
            }
        }
        boolean forceKnown = false;
        for (int r = 0; r < reactions.size(); r++) {
            Reaction reaction = reactions.get(r);
            if (!reaction.isActive()) {
                continue;
            }
            if (!forceKnown) {
                fit();
                forces.effects(state, time, force);
                forceKnown = true;
            }
            if (reaction.hasForceDerivatives()) {
                reaction.addForceDerivatives(state, time, force, blocks);
            }
            reaction.addForces(state, time, force);
        }
    }

    /**
     * Computes J w from the blocks, or by one finite difference if an effect or reaction does not know its derivatives.
     */
    public void multiply(double[] state, double time, double[] w, double[] product) {
        if (!isExact()) {
            difference(state, w, product);
            return;
        }
        direction = w;
        this.product = product;
        Arrays.fill(product, 0);
        addBlocks(state, time, productBlocks);
        double[] inverseMasses = particles.getInverseMasses();
        for (int i = 0, x = 0; x < product.length; i++, x += STRIDE) {
            for (int c = x; c < x + 3; c++) {
                product[c] = w[c + 3];
                product[c + 3] *= inverseMasses[i];
            }
        }
    }

    /** Restores the system's state. Both evaluations are counted. */
    private void difference(double[] state, double[] w, double[] product) {
        fit();
        double size = 0;
        double length = 0;
        for (int i = 0; i < w.length; i++) {
            size += state[i] * state[i];
            length += w[i] * w[i];
        }
        if (length == 0) {
            Arrays.fill(product, 0);
            return;
        }
        double delta = ROOT_EPSILON * Math.sqrt((size == 0 ? 1 : size) / length);
        source.getStateDerivative(force);
        System.arraycopy(state, 0, varied, 0, w.length);
        for (int i = 0; i < w.length; i++) {
            state[i] += delta * w[i];
        }
        try {
            source.getStateDerivative(product);
        } finally {
            System.arraycopy(varied, 0, state, 0, w.length);
        }
        for (int i = 0; i < w.length; i++) {
            product[i] = (product[i] - force[i]) / delta;
        }
    }

    private void fit() {
        if (force.length != source.getStateSize()) {
            force = new double[source.getStateSize()];
            varied = new double[source.getStateSize()];
        }
    }

    /** Multiplies each block by the direction as it is added. */
    private final class Product implements ForceDerivatives {
        @Override
        public void add(int i, int j, double[] dFdX, double[] dFdV) {
            apply(i, j, dFdX, dFdV, 1);
        }

        @Override
        public void addPair(int i, int j, double[] dFdX, double[] dFdV) {
            apply(i, i, dFdX, dFdV, 1);
            apply(i, j, dFdX, dFdV, -1);
            apply(j, j, dFdX, dFdV, 1);
            apply(j, i, dFdX, dFdV, -1);
        }

        private void apply(int i, int j, double[] dFdX, double[] dFdV, double sign) {
            int to = STRIDE * i + 3;
            int from = STRIDE * j;
            for (int c = 0; c < 3; c++) {
                double sum = 0;
                for (int k = 0; k < 3; k++) {
                    sum += dFdX[3 * c + k] * direction[from + k] + dFdV[3 * c + k] * direction[from + 3 + k];
                }
                product[to + c] += sign * sum;
            }
        }

        @Override
        public void transformRow(int i, double[] matrix) {
            int f = STRIDE * i + 3;
            double x = product[f];
            double y = product[f + 1];
            double z = product[f + 2];
            for (int c = 0; c < 3; c++) {
                product[f + c] = matrix[3 * c] * x + matrix[3 * c + 1] * y + matrix[3 * c + 2] * z;
            }
        }
    }
}
