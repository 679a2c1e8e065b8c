package particles.experiments.stability;

import deSolvers.DESolver;
import deSolvers.catalog.SolverCatalog;
import deSolvers.catalog.SolverInfo;
import deSolvers.catalog.SolverInfo.Family;
import deSolvers.problems.LinearPair;
import deSolvers.problems.StepMatrix;
import java.util.function.Supplier;
import particles.experiments.runs.SolverChoice;
import particles.experiments.stability.Spectrum.Mode;

/**
 * Measures the amplification of a solver's real code: the factor |R| by which one step multiplies the solution of the
 * test equation s' = lambda s. It measures
 * <ul>
 * <li>for a method that steps by deltaT, one step: the larger modulus of the two eigenvalues of its 2 x 2 matrix;</li>
 * <li>for a multistep method, the growth over many steps, after the first ones;</li>
 * <li>for an adaptive method of the catalogue, one sub-step as long as deltaT; the tolerance is so loose that it is not
 *     divided. {@code bulirsch-stoer} then uses as many lines of its table as its usual tolerance demands at
 *     first;</li>
 * <li>for a method that steps positions and velocities separately, a damped spring whose two eigenvalues are lambda and
 *     its conjugate; on the negative real axis it is critically damped.</li>
 * </ul>
 * A step that the solver refuses counts as infinite growth.
 *
 * @param maker     creates solvers without memory
 * @param ofSprings whether the method needs positions and velocities, and is tried on springs
 * @param manySteps whether it uses earlier steps, so that the growth over many is measured
 * @param noise     growth that is none: what a measurement may be off
 */
public record Amplification(Supplier<DESolver> maker, boolean ofSprings, boolean manySteps, double noise) {
    /** A step of deltaT omega = 0.1, which any iteration can do. */
    private static final double SOFT = 0.01;
    /** Growth below this is round-off or Newton's tolerance. */
    static final double ROUNDING = 1e-8;
    /** Steps of a multistep method before its growth is measured, and as many again while it is. */
    private static final int STEPS = 300;
    /** An oscillation from step to step is measured by its largest value in this many steps. */
    private static final int WINDOW = 60;
    private static final double RELATIVE = 1e-6;
    private static final double EVERYTHING = 1e30;
    private static final double OVERFLOW = 1e100;

    /**
     * @param info a solver of the catalogue
     * @return its amplification
     */
    public static Amplification of(SolverInfo info) {
        DESolver solver = info.adaptive() ? SolverCatalog.create(info.name(), RELATIVE, EVERYTHING)
                : SolverCatalog.create(info.name());
        return new Amplification(() -> {
            solver.reset();
            return solver;
        }, info.secondOrder(), info.family() == Family.MULTISTEP, 0);
    }

    /** @return the amplification of a solver, of your own on springs */
    public static Amplification of(SolverChoice solver) {
        return solver.info().map(Amplification::of).orElseGet(() -> ofOwn(() -> solver.create(Double.NaN)));
    }

    /**
     * @param maker creates solvers without memory
     * @return the amplification of a solver of your own, on springs
     * @throws RuntimeException the solver's own, if it refuses a short step, too
     */
    public static Amplification ofOwn(Supplier<DESolver> maker) {
        maker.get().stepState(LinearPair.spring(SOFT, 0), 1);
        return new Amplification(maker, true, false, 0);
    }

    /**
     * @param re real part of deltaT lambda
     * @param im its imaginary part
     * @return |R|; infinite if there is no such step
     */
    public double at(double re, double im) {
        return of(ofSprings ? LinearPair.spring(re * re + im * im, -2 * re) : LinearPair.testEquation(re, im));
    }

    /**
     * @param mode   a mode
     * @param deltaT the time step (s)
     * @return the factor by which a step multiplies it; on springs, of two real modes of one spring the larger factor
     */
    double of(Mode mode, double deltaT) {
        return ofSprings ? of(LinearPair.spring(deltaT * deltaT * mode.stiffness(), deltaT * mode.damping()))
                : at(deltaT * mode.re(), deltaT * mode.im());
    }

    private double of(LinearPair source) {
        try {
            double growth = manySteps ? rate(source) : StepMatrix.of(maker.get(), source, 1, 1, 1).radius();
            return Double.isNaN(growth) ? Double.POSITIVE_INFINITY : growth - noise;
        } catch (NullPointerException | IndexOutOfBoundsException e) {
            throw e;                                    // a mistake, and no refusal
        } catch (RuntimeException e) {                  // by whatever the solver refuses the step
            return Double.POSITIVE_INFINITY;
        }
    }

    private double rate(LinearPair source) {
        DESolver solver = maker.get();
        source.start(1);
        double middle = 0;
        double end = 0;
        for (int i = 0; i < 2 * STEPS; i++) {
            solver.stepState(source, 1);
            if (i >= STEPS - WINDOW && i < STEPS) {
                middle = Math.max(middle, source.stepMatrix().radius());
            } else if (i >= 2 * STEPS - WINDOW) {
                end = Math.max(end, source.stepMatrix().radius());
            }
            double size = source.size();
            if (!(size <= OVERFLOW && size >= 1 / OVERFLOW)) {
                return StrictMath.pow(size, 1.0 / (i + 1));
            }
        }
        return StrictMath.pow(end / middle, 1.0 / STEPS);
    }
}
