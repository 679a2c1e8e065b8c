package particles.experiments.lecture;

import static particles.view.DataTable.column;

import deSolvers.DESolver;
import deSolvers.catalog.SolverCatalog;
import deSolvers.problems.Oscillator;
import java.util.Arrays;
import java.util.List;
import java.util.stream.DoubleStream;
import java.util.stream.IntStream;
import org.hipparchus.complex.Complex;
import particles.view.Axis;
import particles.view.Chart;
import particles.view.DataTable;
import particles.view.Look;
import particles.view.Series;
import particles.view.Series.Mark;
import particles.view.VectorField;

/**
 * The figures of the slides on the Euler method, the midpoint method and Runge-Kutta: x'' = -x from (1, 0) in state
 * space, over its vector field, with the theory of amplitude and phase.
 *
 * <p>Source: COMPSCI 715 (2003), slides "Example IVP", "The Euler Method", "Mid-point Method", "RK4 Results".
 */
public final class LectureFigures {
    private static final int ARROWS = 17;
    private static final int CIRCLE = 361;
    private static final Axis POSITION = Axis.linear("position x", "m");
    private static final Axis VELOCITY = Axis.linear("velocity v", "m/s");
    private static final Series START = Series.point(Look.MARK.variant(1), "start", Mark.POINTS, 1, 0);

    /**
     * The figures of the slides, in their order, from the captions. These do not state Euler's step, only its result; 3
     * periods are 160.6 of these steps.
     */
    public static final List<Figure> ON_SLIDES = List.of(
            new Figure("euler", 0.11737, 161), new Figure("midpoint", 1, 11), new Figure("midpoint", 0.5, 100),
            new Figure("midpoint", 0.1, 5000), new Figure("rk4", 1, 8), new Figure("rk4", 1, 100),
            new Figure("rk4", 0.4, 1250));

    /**
     * The parameters of a run.
     *
     * @param solver the name of one of the slides' methods
     * @param deltaT the time step (s)
     * @param steps  the number of steps
     */
    public record Figure(String solver, double deltaT, int steps) {
    }

    /**
     * A run, measured against theory.
     *
     * @param figure      the run
     * @param amplitude   the distance of the last state from the origin, divided by that of the first
     * @param phaseError  the angle by which it is ahead of the exact solution (rad); negative if it lags
     * @param theory      the complex factor R(ih) of a step: |R|<sup>N</sup> and N (arg R - h) are the same
     * @param evaluations the number of evaluations of the derivative
     * @param x           positions after each step, with the start
     * @param v           velocities
     */
    public record Result(Figure figure, double amplitude, double phaseError, Complex theory,
            long evaluations, double[] x, double[] v) {
    }

    private LectureFigures() {
    }

    /**
     * @param figure a run
     * @return its result
     */
    public static Result run(Figure figure) {
        Oscillator oscillator = new Oscillator();
        DESolver solver = SolverCatalog.create(figure.solver());
        double[] x = new double[figure.steps() + 1];
        double[] v = new double[figure.steps() + 1];
        double[] state = {1, 0};
        double turned = 0;
        x[0] = 1;
        for (int n = 1; n <= figure.steps(); n++) {
            solver.stepState(oscillator, figure.deltaT());
            oscillator.getState(state);
            x[n] = state[0];
            v[n] = state[1];
            // clockwise; each step turns by less than half a circle, so that whole turns are not lost
            turned -= StrictMath.atan2(v[n] * x[n - 1] - x[n] * v[n - 1], x[n] * x[n - 1] + v[n] * v[n - 1]);
        }
        return new Result(figure, Math.sqrt(state[0] * state[0] + state[1] * state[1]),
                turned - figure.steps() * figure.deltaT(), factor(figure), oscillator.getEvaluations(), x, v);
    }

    /**
     * R(ih), by which a step of h on z' = iz multiplies z = x - iv, which turns as x'' = -x does. A method with as many
     * stages as its order has the Taylor series of e^(ih) up to that.
     */
    private static Complex factor(Figure figure) {
        Complex r = Complex.ONE;
        for (int k = SolverCatalog.info(figure.solver()).order(); k > 0; k--) {
            r = new Complex(0, figure.deltaT() / k).multiply(r).add(1);
        }
        return r;
    }

    /**
     * @param result a run
     * @return its path, the exact one, the start, and where both end
     */
    public static Chart chart(Result result) {
        int n = result.figure().steps();
        Mark mark = n <= 200 ? Mark.LINE_AND_POINTS : Mark.LINE;
        double[] end = new Oscillator().exactState(n * result.figure().deltaT());
        return new Chart(POSITION, VELOCITY, List.of(
                new Series(Look.of(SolverCatalog.info(result.figure().solver())), result.figure().solver(), mark,
                        result.x(), result.v()), exact(), START,
                Series.point(Look.MARK, "end", Mark.POINTS, result.x()[n], result.v()[n]),
                Series.point(Look.MARK, "exact end", Mark.OPEN_POINTS, end[0], end[1])));
    }

    /** @return the exact solution alone, which follows the vector field, drawn as beside a solver's path */
    public static Chart exactChart() {
        return new Chart(POSITION, VELOCITY, List.of(exact(), START));
    }

    private static Series exact() {
        return Series.of(Look.REFERENCE, "exact", Mark.LINE, IntStream.range(0, CIRCLE).mapToObj(k ->
                2 * Math.PI * k / (CIRCLE - 1)).toList(), StrictMath::cos, t -> -StrictMath.sin(t));
    }

    /**
     * @param reach the largest distance from the origin that is needed
     * @return the field (v, -x) on a square grid around the origin
     */
    public static VectorField field(double reach) {
        double[] axis = IntStream.range(0, ARROWS).mapToDouble(k -> reach * (2.0 * k / (ARROWS - 1) - 1)).toArray();
        VectorField field = new VectorField(axis, axis);
        Arrays.setAll(field.dv(), k -> -field.x(k));
        return field;
    }

    /** @return the largest distance of the path from the origin, with a margin */
    public static double reach(Result result) {
        return 1.1 * DoubleStream.concat(Arrays.stream(result.x()), Arrays.stream(result.v())).map(Math::abs)
                .reduce(1, Math::max);
    }

    /**
     * @param results runs
     * @return the table of measured and theoretical values
     */
    public static DataTable table(List<Result> results) {
        return DataTable.of("figures", """
                Amplitude, energy and phase error after N steps of h = deltaT, each measured and then from theory""",
                results,
                column("solver", result -> result.figure().solver()),
                column("deltaT (s)", 6, result -> result.figure().deltaT()),
                column("steps", result -> result.figure().steps()), column("evaluations", Result::evaluations),
                column("amplitude", 7, Result::amplitude), column("|R|^N", 7, result -> power(result, 1)),
                column("energy", 8, result -> result.amplitude() * result.amplitude()),
                column("|R|^(2N)", 8, result -> power(result, 2)),
                column("phase error (rad)", 6, Result::phaseError),
                column("N (arg R - h)", 6, result -> result.figure().steps() * (result.theory().getArgument()
                        - result.figure().deltaT())));
    }

    private static double power(Result result, int exponent) {
        return StrictMath.pow(result.theory().norm(), exponent * result.figure().steps());
    }
}
