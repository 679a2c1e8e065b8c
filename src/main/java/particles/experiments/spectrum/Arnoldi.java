package particles.experiments.spectrum;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.stream.IntStream;
import org.ejml.data.Complex_F64;
import org.ejml.data.DMatrixRMaj;
import org.ejml.data.ZMatrixRMaj;
import org.ejml.dense.row.CommonOps_DDRM;
import org.ejml.dense.row.CommonOps_ZDRM;
import org.ejml.dense.row.NormOps_DDRM;
import org.ejml.dense.row.NormOps_ZDRM;
import org.ejml.dense.row.factory.DecompositionFactory_DDRM;
import org.ejml.interfaces.decomposition.EigenDecomposition_F64;

/**
 * The eigenvalues of a system: Arnoldi's iteration on the whole Jacobian. It finds the outermost eigenvalues first, and
 * all of a small system. Without damping, drag or reactions the fastest vibration limits all steps, and the iteration
 * ends when it is known.
 *
 * <p>Source: W. E. Arnoldi, Quart. Appl. Math. 9 (1951), 17.
 */
final class Arnoldi {
    private static final double BREAKDOWN = 1e-13;
    /** The relative shift from the eigenvalue in inverse iteration, so that the matrix is not singular. */
    private static final double SHIFT = 1e-10;
    /** The relative residual at which the fastest vibration is known. */
    private static final double KNOWN = 1e-9;
    private static final int LOOK_EVERY = 10;

    private final Linearisation linear;
    /** A direction in each row. */
    private final DMatrixRMaj basis;
    private final DMatrixRMaj hessenberg;
    private double next;

    private Arnoldi(Linearisation linear) {
        this.linear = linear;
        int size = 2 * linear.coordinates();
        int most = Spectrum.directions(size);
        hessenberg = new DMatrixRMaj(most, most);
        basis = new DMatrixRMaj(most, size);
        basis.reshape(0, size, true);
    }

    static Spectrum spectrum(Linearisation linear) {
        Arnoldi arnoldi = new Arnoldi(linear);
        arnoldi.iterate();
        return arnoldi.modes(Spectrum.ZERO);
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
                CommonOps_DDRM.multAddTransA(-1, basis, parts, image);
                for (int row = 0; row <= column; row++) {
                    hessenberg.add(row, column, parts.get(row));
                }
            }
            next = NormOps_DDRM.normF(image);
            boolean look = linear.isConservative() && basis.numRows % LOOK_EVERY == 0;
            if (column + 1 == hessenberg.numRows || next <= BREAKDOWN * largest || look && modes(1).error() <= KNOWN) {
                return;
            }
            hessenberg.set(column + 1, column, next);
            y = Linearisation.divided(image.data, next);
        }
    }

    /** @param least the least |lambda| of interest, as a part of the largest */
    private Spectrum modes(double least) {
        int m = basis.numRows;
        DMatrixRMaj square = CommonOps_DDRM.extract(hessenberg, 0, m, 0, m);
        EigenDecomposition_F64<DMatrixRMaj> ritz = DecompositionFactory_DDRM.eig(m, false);
        if (!ritz.decompose(square)) {
            throw new ArithmeticException("the eigenvalues of a " + m + " x " + m + " matrix did not converge");
        }
        double largest = IntStream.range(0, m).mapToDouble(k -> ritz.getEigenvalue(k).getMagnitude()).max().orElse(0);
        List<Mode> modes = new ArrayList<>();
        double error = 0;
        for (int k = 0; k < m; k++) {
            Complex_F64 lambda = ritz.getEigenvalue(k);
            boolean pair = lambda.imaginary < 0         // and the way back to a saddle, of which only growth counts
                    || lambda.imaginary == 0 && lambda.real < 0 && linear.isConservative();
            if (pair || lambda.getMagnitude() < least * largest) {
                continue;
            }
            ZMatrixRMaj weights = vector(square, lambda, largest);
            double residual = next * Math.hypot(weights.getReal(m - 1, 0), weights.getImag(m - 1, 0));
            if (residual <= Spectrum.CONVERGED * largest) {
                modes.add(mode(lambda, weights));
            }
            error = lambda.getMagnitude() == largest ? residual / largest : error;
        }
        modes.sort(Comparator.comparingDouble(Mode::size).reversed());
        return new Spectrum(modes, m, error);
    }

    /** By inverse iteration, of length 1. */
    private static ZMatrixRMaj vector(DMatrixRMaj square, Complex_F64 lambda, double largest) {
        int m = square.numRows;
        ZMatrixRMaj shifted = new ZMatrixRMaj(m, m);
        CommonOps_ZDRM.convert(square, shifted);
        for (int k = 0; k < m; k++) {
            shifted.set(k, k, square.get(k, k) - lambda.real - SHIFT * largest, -lambda.imaginary);
        }
        ZMatrixRMaj vector = new ZMatrixRMaj(m, 1);
        CommonOps_ZDRM.convert(DMatrixRMaj.wrap(m, 1, Linearisation.random(m)), vector);
        for (int twice = 0; twice < 2; twice++) {
            if (!CommonOps_ZDRM.solve(shifted, vector.copy(), vector)) {
                throw new ArithmeticException("no eigenvector for the eigenvalue " + lambda);
            }
            CommonOps_ZDRM.elementDivide(vector, NormOps_ZDRM.normF(vector), 0, vector);
        }
        return vector;
    }

    private Mode mode(Complex_F64 lambda, ZMatrixRMaj weights) {
        DMatrixRMaj real = new DMatrixRMaj(weights.numRows, 1);
        CommonOps_ZDRM.real(weights, real);
        DMatrixRMaj y = new DMatrixRMaj(basis.numCols, 1);
        CommonOps_DDRM.multTransA(basis, real, y);
        // an undamped mode's lambda keeps a real part from rounding
        double re = Math.abs(lambda.real) <= Spectrum.ZERO * lambda.getMagnitude() ? 0 : lambda.real;
        double im = lambda.imaginary;
        double[] state = linear.inState(y.data);
        if (im > 0) {
            return new Mode(re, im, re * re + im * im, -2 * re, state);
        }
        // of a real eigenvalue, one of two of a damped spring, the shape gives the spring
        int n = linear.coordinates();
        double[] q = Arrays.copyOf(y.data, n);
        double[] p = Arrays.copyOfRange(y.data, n, 2 * n);
        double[] shape = Linearisation.norm(q) > Linearisation.norm(p) * Spectrum.ZERO ? q : p;
        return new Mode(re, 0, linear.stiffness(shape), linear.damping(shape), state);
    }
}
