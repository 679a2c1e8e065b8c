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
    private final List<double[]> basis = new ArrayList<>();
    private final DMatrixRMaj hessenberg;
    private double next;

    private Arnoldi(Linearisation linear) {
        this.linear = linear;
        int most = Spectrum.directions(2 * linear.coordinates());
        hessenberg = new DMatrixRMaj(most, most);
    }

    static Spectrum spectrum(Linearisation linear) {
        Arnoldi arnoldi = new Arnoldi(linear);
        arnoldi.iterate();
        return arnoldi.modes(Spectrum.ZERO);
    }

    private void iterate() {
        double[] y = Linearisation.random(2 * linear.coordinates());
        double largest = 0;
        while (true) {
            int column = basis.size();
            basis.add(y);
            double[] image = new double[y.length];
            linear.derivative(y, image);
            double size = Linearisation.norm(image);
            for (int twice = 0; twice < 2; twice++) {
                for (int row = 0; row <= column; row++) {
                    double part = Linearisation.dot(basis.get(row), image);
                    hessenberg.add(row, column, part);
                    for (int k = 0; k < image.length; k++) {
                        image[k] -= part * basis.get(row)[k];
                    }
                }
            }
            next = Linearisation.norm(image);
            largest = Math.max(largest, size);
            boolean look = linear.isConservative() && basis.size() % LOOK_EVERY == 0;
            if (column + 1 == hessenberg.numRows || next <= BREAKDOWN * largest || look && modes(1).error() <= KNOWN) {
                return;
            }
            hessenberg.set(column + 1, column, next);
            y = Linearisation.divided(image, next);
        }
    }

    /** @param least the least |lambda| of interest, as a part of the largest */
    private Spectrum modes(double least) {
        int m = basis.size();
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
            double[] weights = vector(square, lambda, largest);
            double residual = next * Linearisation.norm(Arrays.copyOfRange(weights, 2 * m - 2, 2 * m));
            if (residual <= Spectrum.CONVERGED * largest) {
                modes.add(mode(lambda, weights));
            }
            error = lambda.getMagnitude() == largest ? residual / largest : error;
        }
        modes.sort(Comparator.comparingDouble(Mode::size).reversed());
        return new Spectrum(modes, m, error);
    }

    /** By inverse iteration: re and im in turn, of length 1. */
    private static double[] vector(DMatrixRMaj square, Complex_F64 lambda, double largest) {
        int m = square.numRows;
        ZMatrixRMaj shifted = new ZMatrixRMaj(m, m);
        for (int k = 0; k < m * m; k++) {
            shifted.data[2 * k] = square.data[k];
        }
        for (int k = 0; k < m; k++) {
            int diagonal = 2 * k * (m + 1);
            shifted.data[diagonal] -= lambda.real + SHIFT * largest;
            shifted.data[diagonal + 1] -= lambda.imaginary;
        }
        ZMatrixRMaj right = new ZMatrixRMaj(m, 1);
        ZMatrixRMaj solution = new ZMatrixRMaj(m, 1);
        double[] start = Linearisation.random(m);
        for (int k = 0; k < m; k++) {
            right.data[2 * k] = start[k];
        }
        for (int twice = 0; twice < 2; twice++) {
            if (!CommonOps_ZDRM.solve(shifted, right, solution)) {
                throw new ArithmeticException("no eigenvector for the eigenvalue " + lambda);
            }
            right.data = Linearisation.divided(solution.data, Linearisation.norm(solution.data));
        }
        return right.data;
    }

    private Mode mode(Complex_F64 lambda, double[] weights) {
        int n = linear.coordinates();
        double[] q = new double[n];
        double[] p = new double[n];
        for (int m = 0; m < basis.size(); m++) {
            for (int k = 0; k < n; k++) {
                q[k] += weights[2 * m] * basis.get(m)[k] / linear.getFrequency();
                p[k] += weights[2 * m] * basis.get(m)[n + k];
            }
        }
        // an undamped mode's lambda keeps a real part from rounding
        double re = Math.abs(lambda.real) <= Spectrum.ZERO * lambda.getMagnitude() ? 0 : lambda.real;
        double im = lambda.imaginary;
        if (im > 0) {
            return new Mode(re, im, re * re + im * im, -2 * re, linear.inState(q, p));
        }
        return realMode(re, q, p);
    }

    /**
     * The mode of a real eigenvalue, one of two of a damped spring; the Rayleigh quotients of its shape give the
     * spring.
     */
    private Mode realMode(double re, double[] q, double[] p) {
        double[] shape = Linearisation.norm(q) * linear.getFrequency() > Linearisation.norm(p) * Spectrum.ZERO ? q : p;
        double[] image = new double[shape.length];
        double square = Linearisation.dot(shape, shape);
        linear.stiffness(shape, image);
        double stiffness = Linearisation.dot(shape, image) / square;
        linear.damping(shape, image);
        double damping = Linearisation.dot(shape, image) / square;
        return new Mode(re, 0, stiffness, damping, linear.inState(q, p));
    }
}
