package deSolvers.implicit;

import deSolvers.DEStateSource;
import deSolvers.JacobianStateSource;
import deSolvers.StepTransaction;
import deSolvers.linear.Gmres;
import deSolvers.linear.ImplicitWork;
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
    private boolean fine;

    DirectionalDerivative(ImplicitWork.Counter work) {
        this.work = work;
    }

    /**
     * Takes up a state. The source's clock has to be at its time whenever a product is asked for.
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

    /**
     * How far a difference goes: as a rule by a part of the whole state; finely, of those entries that the direction
     * has (P. N. Brown, Y. Saad 1990, SIAM J. Sci. Stat. Comput. 11, 450), so that among small ones it stays near.
     */
    void setFine(boolean fine) {
        this.fine = fine;
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
        double delta = ROOT_EPSILON * (fine ? sizeAlong(w, length) : scale) / length;
        for (int i = 0; i < w.length; i++) {
            varied[i] = base[i] + delta * w[i];
        }
        source.setState(varied);
        source.getStateDerivative(product);
        for (int i = 0; i < w.length; i++) {
            product[i] = (product[i] - baseRate[i]) / delta;
        }
    }

    /**
     * The mean size of the entries, each weighed by its part in the direction; that of the whole state if all are 0.
     */
    private double sizeAlong(double[] w, double length) {
        double sum = 0;
        for (int i = 0; i < w.length; i++) {
            sum += Math.abs(w[i]) * Math.abs(base[i]);
        }
        return sum > 0 ? sum / length : scale;
    }
}
