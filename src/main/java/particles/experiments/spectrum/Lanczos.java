package particles.experiments.spectrum;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.stream.IntStream;
import org.ejml.data.DMatrixRMaj;
import org.ejml.dense.row.factory.DecompositionFactory_DDRM;
import org.ejml.interfaces.decomposition.EigenDecomposition_F64;

/**
 * The largest angular frequencies of an undamped system: Lanczos' iteration on the symmetric -da/dx, whose eigenvalues
 * are omega&sup2;. Each new direction is made orthogonal to all earlier ones, twice,
 * so that no eigenvalue appears again as a ghost.
 *
 * <p>Source: C. Lanczos, J. Res. Nat. Bur. Standards 45 (1950), 255.
 */
final class Lanczos {
    /** The relative residual at which the iteration stops; the error of an extreme eigenvalue is its square. */
    private static final double RESIDUAL = 1e-7;
    private static final int LOOK_EVERY = 10;
    private static final double BREAKDOWN = 1e-13;

    private final Linearisation linear;
    private final List<double[]> basis = new ArrayList<>();
    private final List<Double> alphas = new ArrayList<>();
    private final List<Double> betas = new ArrayList<>();
    private EigenDecomposition_F64<DMatrixRMaj> ritz;

    private Lanczos(Linearisation linear) {
        this.linear = linear;
    }

    static Spectrum spectrum(Linearisation linear) {
        Lanczos lanczos = new Lanczos(linear);
        lanczos.iterate();
        return lanczos.modes();
    }

    private void iterate() {
        int most = Spectrum.directions(linear.coordinates());
        double[] q = Linearisation.random(linear.coordinates());
        double largest = 0;
        for (int m = 1; m <= most; m++) {
            basis.add(q);
            double[] next = new double[q.length];
            linear.stiffness(q, next);
            alphas.add(Linearisation.dot(q, next));
            for (int twice = 0; twice < 2; twice++) {
                for (double[] earlier : basis) {
                    double part = Linearisation.dot(earlier, next);
                    for (int k = 0; k < next.length; k++) {
                        next[k] -= part * earlier[k];
                    }
                }
            }
            double beta = Linearisation.norm(next);
            betas.add(beta);
            largest = Math.max(largest, Math.abs(alphas.get(m - 1)) + beta);
            boolean last = m == most || beta <= BREAKDOWN * largest;
            if (last || m % LOOK_EVERY == 0) {
                solve();
                if (last || residual(top()) <= RESIDUAL * Math.abs(value(top()))) {
                    return;
                }
            }
            q = Linearisation.divided(next, beta);
        }
    }

    private void solve() {
        int m = basis.size();
        DMatrixRMaj tridiagonal = new DMatrixRMaj(m, m);
        for (int k = 0; k < m; k++) {
            tridiagonal.set(k, k, alphas.get(k));
            if (k + 1 < m) {
                tridiagonal.set(k, k + 1, betas.get(k));
                tridiagonal.set(k + 1, k, betas.get(k));
            }
        }
        ritz = DecompositionFactory_DDRM.eig(m, true, true);
        if (!ritz.decompose(tridiagonal)) {
            throw new ArithmeticException("the eigenvalues of a " + m + " x " + m
                    + " tridiagonal matrix did not converge");
        }
    }

    private double value(int k) {
        return ritz.getEigenvalue(k).getReal();
    }

    private int top() {
        return IntStream.range(0, basis.size()).boxed().max(Comparator.comparingDouble(k -> Math.abs(value(k))))
                .orElseThrow();
    }

    /** The residual |S y - theta y|, from the component of the next direction. */
    private double residual(int k) {
        int m = basis.size();
        return Math.abs(betas.get(m - 1) * ritz.getEigenVector(k).get(m - 1, 0));
    }

    private Spectrum modes() {
        double largest = Math.abs(value(top()));
        List<Mode> modes = new ArrayList<>();
        for (int k = 0; k < basis.size(); k++) {
            double square = value(k);
            if (residual(k) <= Spectrum.CONVERGED * largest && Math.abs(square) > Spectrum.ZERO * largest) {
                modes.add(mode(square, ritz.getEigenVector(k)));
            }
        }
        modes.sort(Comparator.comparingDouble(Mode::size).reversed());
        double error = largest == 0 ? 0 : residual(top()) / largest / 2;            // half, as omega is a root
        return new Spectrum(modes, "Lanczos on the symmetric da/dx", basis.size(), error);
    }

    private Mode mode(double square, DMatrixRMaj weights) {
        double[] q = new double[linear.coordinates()];
        for (int m = 0; m < basis.size(); m++) {
            double weight = weights.get(m, 0);
            for (int k = 0; k < q.length; k++) {
                q[k] += weight * basis.get(m)[k];
            }
        }
        double omega = Math.sqrt(Math.abs(square));
        return new Mode(square > 0 ? 0 : omega, square > 0 ? omega : 0, square, 0,
                linear.inState(q, new double[q.length]));
    }
}
