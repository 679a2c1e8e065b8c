package particles.experiments.stability;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import org.ejml.data.DMatrixRMaj;
import org.ejml.dense.row.CommonOps_DDRM;
import org.ejml.dense.row.NormOps_DDRM;
import org.hipparchus.complex.Complex;
import org.hipparchus.linear.EigenDecompositionNonSymmetric;
import org.hipparchus.linear.MatrixUtils;
import particles.experiments.stability.Spectrum.Mode;

/**
 * The eigenvalues of a system: Arnoldi's iteration on the whole Jacobian. It finds the outermost eigenvalues first, and
 * all of a small system.
 *
 * <p>Source: W. E. Arnoldi, Quart. Appl. Math. 9 (1951), 17.
 */
final class Arnoldi {
    /** Values whose residual is larger than this part of the largest one are not yet eigenvalues. */
    private static final double CONVERGED = 1e-3;
    /**
     * A lambda below this part of the largest is a free motion or round-off. It is the square root of the precision, as
     * 0 is a double eigenvalue.
     */
    private static final double ZERO = 1e-6;
    /** The largest memory for directions, 256 MB. */
    private static final long MOST_DOUBLES = 1L << 25;
    private static final int MOST_DIRECTIONS = 300;
    private static final int FEWEST_DIRECTIONS = 12;
    private static final double BREAKDOWN = 1e-13;

    private final Linearisation linear;
    /** A direction in each row. */
    private final DMatrixRMaj basis;
    private final DMatrixRMaj hessenberg;
    private double next;

    private Arnoldi(Linearisation linear) {
        this.linear = linear;
        int size = 2 * linear.coordinates();
        int most = (int) Math.min(Math.min(size, MOST_DIRECTIONS),
                Math.max(FEWEST_DIRECTIONS, MOST_DOUBLES / size));
        hessenberg = new DMatrixRMaj(most, most);
        basis = new DMatrixRMaj(most, size);
        basis.reshape(0, size, true);
    }

    /** @return the modes of a system in which something can move, by falling |lambda| */
    static List<Mode> modes(Linearisation linear) {
        Arnoldi arnoldi = new Arnoldi(linear);
        arnoldi.iterate();
        return arnoldi.modes();
    }

    private void iterate() {
        double[] y = Linearisation.random(basis.numCols);
        DMatrixRMaj parts = new DMatrixRMaj(1, 1);
        double largest = 0;
        while (true) {
            int column = basis.numRows;
            basis.reshape(column + 1, y.length, true);
            System.arraycopy(y, 0, basis.data, column * y.length, y.length);
            DMatrixRMaj image = DMatrixRMaj.wrap(y.length, 1, linear.derivative(y));
            largest = Math.max(largest, NormOps_DDRM.normF(image));
            for (int twice = 0; twice < 2; twice++) {           // Gram-Schmidt; once leaves round-off
                CommonOps_DDRM.mult(basis, image, parts);
                CommonOps_DDRM.changeSign(parts);
                CommonOps_DDRM.multAddTransA(basis, parts, image);
                for (int row = 0; row <= column; row++) {
                    hessenberg.add(row, column, -parts.get(row));
                }
            }
            next = NormOps_DDRM.normF(image);
            if (column + 1 == hessenberg.numRows || next <= BREAKDOWN * largest) {
                return;
            }
            hessenberg.set(column + 1, column, next);
            CommonOps_DDRM.divide(image, next);
            y = image.data;
        }
    }

    private List<Mode> modes() {
        int m = basis.numRows;
        double scale = NormOps_DDRM.normF(hessenberg);          // the decomposition tells zeros by their size
        DMatrixRMaj square = CommonOps_DDRM.extract(hessenberg, 0, m, 0, m);
        CommonOps_DDRM.divide(square, scale);
        EigenDecompositionNonSymmetric ritz = new EigenDecompositionNonSymmetric(
                MatrixUtils.createRealMatrix(square.get2DData()));
        List<Complex> values = Arrays.stream(ritz.getEigenvalues()).map(value -> value.multiply(scale)).toList();
        double largest = values.stream().mapToDouble(Complex::norm).max().orElse(0);
        List<Mode> modes = new ArrayList<>();
        for (int k = 0; k < m; k++) {
            Complex lambda = values.get(k);
            if (lambda.getImaginary() < 0 || lambda.norm() < ZERO * largest) {      // of a pair, the other one is kept
                continue;
            }
            Complex[] weights = ritz.getEigenvector(k).toArray();
            double length = Math.sqrt(Arrays.stream(weights).mapToDouble(w -> w.norm() * w.norm()).sum());
            if (next * weights[m - 1].norm() <= CONVERGED * largest * length) {
                modes.add(mode(lambda, Arrays.stream(weights).mapToDouble(w -> w.getReal() / length).toArray()));
            }
        }
        modes.sort(Comparator.comparingDouble(Mode::size).reversed());
        return modes;
    }

    private Mode mode(Complex lambda, double[] weights) {
        DMatrixRMaj y = new DMatrixRMaj(basis.numCols, 1);
        CommonOps_DDRM.multTransA(basis, DMatrixRMaj.wrap(weights.length, 1, weights), y);
        // an undamped mode's lambda keeps a real part from rounding
        double re = Math.abs(lambda.getReal()) <= ZERO * lambda.norm() ? 0 : lambda.getReal();
        double im = lambda.getImaginary();
        // a real lambda is one of two of a damped spring; that of a spring that pushes outwards moves as by drag alone
        double damping = im > 0 ? -2 * re
                : Math.max(-re, linear.damping(Arrays.copyOfRange(y.data, linear.coordinates(), y.numRows)));
        double stiffness = im > 0 ? re * re + im * im : -re * (re + damping);
        return new Mode(re, im, stiffness, damping, linear.farthest(y.data));
    }
}
