package deSolvers.implicit;

import deSolvers.DEStateSource;
import deSolvers.JacobianStateSource;
import deSolvers.StepTransaction;
import deSolvers.linear.Gmres;
import java.util.Arrays;

/**
 * The product J w at a given state: from the source where it offers one, otherwise by one difference of derivatives.
 */
final class DirectionalDerivative {
    /** Half the digits: the best balance of rounding against curvature in a forward difference. */
    private static final double ROOT_EPSILON = Math.sqrt(Math.ulp(1.0));

    private final ImplicitWork.Counter work;
    private StepTransaction source;
    private DEStateSource client;
    private double[] base = {};
    private double[] baseRate = {};
    private double[] varied = {};
    private double scale;

    DirectionalDerivative(ImplicitWork.Counter work) {
        this.work = work;
    }

    /**
     * Takes a state. The source's clock has to be at its time whenever a product is asked for.
     *
     * @param dSdt f there
     * @param h    a step (s) that tells how far the state may be expected to move
     */
    void setBase(StepTransaction source, double[] state, double[] dSdt, double h) {
        this.source = source;
        client = source.getClient();
        if (base.length != state.length) {
            base = new double[state.length];
            baseRate = new double[state.length];
            varied = new double[state.length];
        }
        System.arraycopy(state, 0, base, 0, state.length);
        System.arraycopy(dSdt, 0, baseRate, 0, state.length);
        scale = Math.max(Gmres.norm(base), Math.abs(h) * Gmres.norm(baseRate));
        if (scale == 0) {
            scale = 1;
        }
    }

    /** Computes J w; product is another array than w. */
    void multiply(double[] w, double[] product) {
        if (client instanceof JacobianStateSource) {
            work.products++;
            source.setState(base);
            ((JacobianStateSource) client).getJacobianProduct(w, product);
            return;
        }
        double length = Gmres.norm(w);
        if (length == 0) {
            Arrays.fill(product, 0);
            return;
        }
        double delta = ROOT_EPSILON * scale / length;
        for (int i = 0; i < w.length; i++) {
            varied[i] = base[i] + delta * w[i];
        }
        source.setState(varied);
        source.getStateDerivative(product);
        for (int i = 0; i < w.length; i++) {
            product[i] = (product[i] - baseRate[i]) / delta;
        }
    }
}
