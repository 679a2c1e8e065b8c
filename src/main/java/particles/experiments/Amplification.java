package particles.experiments;

import deSolvers.DESolver;
import deSolvers.DESolverException;
import deSolvers.catalog.SolverCatalog;
import deSolvers.catalog.SolverInfo;

/**
 * By how much one step of a solver's real code multiplies the solution of the test equation y' = lambda y. What is measured:
 * <ul>
 * <li>of a method that steps by deltaT, its step, as the larger eigenvalue's modulus of the step's 2 x 2 matrix;</li>
 * <li>of a multistep method, what is left of the growth over many steps;</li>
 * <li>of an adaptive method, one sub-step as long as deltaT, which a tolerance that allows everything makes it take.
 *     {@code bulirsch-stoer} then uses as many lines of its table as its usual tolerance demands at first;</li>
 * <li>of a symplectic method, a damped spring whose two eigenvalues are lambda and its conjugate: on the negative real axis the
 *     critically damped one.</li>
 * </ul>
 * A step that the solver refuses counts as infinite growth.
 */
final class Amplification {
    /** What rounding and Newton's tolerance leave of "does not grow". */
    static final double ROUNDING = 1e-8;
    /** Steps of a multistep method before its growth is measured, and as many again while it is. */
    private static final int STEPS = 300;
    private static final double RELATIVE = 1e-6;
    private static final double EVERYTHING = 1e30;

    private final DESolver solver;
    private final boolean secondOrder;
    private final boolean multistep;

    /** @param info a solver of the catalogue */
    Amplification(SolverInfo info) {
        solver = info.adaptive() ? SolverCatalog.create(info.name(), RELATIVE, EVERYTHING) : SolverCatalog.create(info.name());
        secondOrder = info.secondOrder();
        multistep = info.family().equals("multistep");
    }

    /**
     * @param re real part of deltaT lambda
     * @param im its imaginary part
     * @return |R|; infinite if there is no such step
     */
    double at(double re, double im) {
        return of(secondOrder ? LinearPair.spring(re * re + im * im, -2 * re) : LinearPair.testEquation(re, im));
    }

    /**
     * For second-order systems whose two eigenvalues are no conjugates.
     *
     * @param stiffness deltaT&sup2; omega&sup2;
     * @param damping   deltaT c
     * @return the larger eigenvalue's modulus of a step on x'' = -omega&sup2; x - c x'
     */
    double ofSpring(double stiffness, double damping) {
        return of(LinearPair.spring(stiffness, damping));
    }

    private double of(LinearPair source) {
        try {
            return multistep ? rate(source) : radius(source);
        } catch (DESolverException e) {
            return Double.POSITIVE_INFINITY;            // refused, or overflown: no step that anyone could take
        }
    }

    private double radius(LinearPair source) {
        solver.reset();
        source.start(1, 0);
        solver.stepState(source, 1);
        double a = source.first();
        double c = source.second();
        solver.reset();
        source.start(0, 1);
        solver.stepState(source, 1);
        double half = (a + source.second()) / 2;
        double determinant = a * source.second() - source.first() * c;
        double discriminant = half * half - determinant;
        return discriminant < 0 ? Math.sqrt(determinant) : Math.abs(half) + Math.sqrt(discriminant);
    }

    private double rate(LinearPair source) {
        solver.reset();
        source.start(1, 0);
        double middle = 0;
        for (int i = 0; i < 2 * STEPS; i++) {
            if (i == STEPS) {
                middle = size(source);
            }
            solver.stepState(source, 1);
            if (size(source) > 1e100) {
                return StrictMath.pow(size(source), 1.0 / (i + 1));
            }
            if (size(source) < 1e-100) {
                return StrictMath.pow(size(source), 1.0 / (i + 1));
            }
        }
        return StrictMath.pow(size(source) / middle, 1.0 / STEPS);
    }

    private static double size(LinearPair source) {
        return Math.sqrt(source.first() * source.first() + source.second() * source.second());
    }
}
