package particles.teaching.compared;

import deSolvers.DESolver;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Supplier;
import java.util.stream.DoubleStream;
import java.util.stream.Stream;
import particles.teaching.declared.Equation;
import particles.teaching.declared.Method;
import particles.teaching.sources.StudentSource;
import particles.teaching.sources.WindyOscillators;

/**
 * How well the steps of a solver fulfil the equations of implicit and multistep methods, on a law that is neither
 * linear nor the same at all times.
 *
 * @param maker   makes a new solver
 * @param earlier whether it uses earlier steps, so that its sixth one is looked at
 * @param made    the states that its steps reached, by length and amplitude
 */
public record Fit(Supplier<DESolver> maker, boolean earlier, Map<List<Double>, List<double[]>> made) {
    /** A step this close to an equation, as a part of deltaT, is meant to solve it; an iteration leaves about 1e-10. */
    private static final double FITS = 1e-7;
    /** Newton iterations to 1e-10 leave 5e-14, simple ones to 1e-6 leave 1e-6. */
    private static final double SOLVED = 1e-5;
    /** In the longest step an accurate method is off these equations by 1e-3 or more. */
    private static final double NEAR = 1e-4;
    private static final double START = 0.5;
    private static final int STEPS = 6;
    /** An iteration may converge in short steps only. */
    private static final double[] LONG = {0.5, 0.25};
    private static final double[] LENGTHS = {1.0 / 8, 3.0 / 32, 1.0 / 16, 3.0 / 64, 1.0 / 32, 1.0 / 128};

    public Fit(Supplier<DESolver> maker, boolean earlier) {
        this(maker, earlier, new HashMap<>());
    }

    /**
     * An equation with what is left of it.
     *
     * @param method   of the method
     * @param equation its equation, or one with a typical mistake
     * @param deltaT   the length of the step (s)
     * @param residual the largest difference of its sides
     */
    public record Found(Method method, Equation equation, double deltaT, double residual) {
        boolean isRight() {
            return method.equations().contains(equation);
        }
    }

    private Stream<Method> methods(Optional<Method> declared) {
        return Stream.concat(declared.stream(), Arrays.stream(Method.values())).filter(method -> method.equations()
                .stream().anyMatch(equation -> equation.usesEarlier() == earlier));
    }

    /** @return the method whose equation the steps fulfil, or nearly, as after a loose iteration */
    public Optional<Found> known() {
        List<Found> all = methods(Optional.empty()).flatMap(method -> method.equations().stream().map(equation -> best(
                method, equation))).toList();
        return all.stream().filter(found -> found.residual < FITS * found.deltaT).findFirst().or(() -> all.stream()
                .filter(found -> !earlier && residual(found.equation, LENGTHS[0], 1) < NEAR).findFirst());
    }

    /** @return the equation with a typical mistake that they fulfil; the declared method's before others */
    public Optional<Found> mistake(Optional<Method> declared) {
        return methods(declared).flatMap(method -> Changes.ofEquation(method.equations().get(0)).map(equation ->
                best(method, equation))).filter(found -> found.residual < FITS * found.deltaT).findFirst();
    }

    /** @return what is left of the equation in the length in which the least is */
    public Found best(Method method, Equation equation) {
        Found best = new Found(method, equation, LENGTHS[0], Double.POSITIVE_INFINITY);
        for (double h : earlier ? new double[] {LENGTHS[2]} : LENGTHS) {
            double left = residual(equation, h, 1);
            best = left / h < best.residual / best.deltaT ? new Found(method, equation, h, left) : best;
        }
        return best;
    }

    /**
     * @param matrix whether it solves with a matrix, which is made for longer steps than other iterations
     * @return the equation where it is not solved; a diverging iteration is not told
     */
    public Optional<Found> loose(Found found, boolean matrix) {
        return DoubleStream.of(matrix ? LONG : new double[] {LENGTHS[2]}).mapToObj(h -> new Found(found.method,
                found.equation, h, residual(found.equation, h, matrix ? 3 : 1))).filter(one -> one.residual > SOLVED
                && one.residual < 1).findFirst();
    }

    private double residual(Equation equation, double h, double amplitude) {
        List<double[]> states = made.computeIfAbsent(List.of(h, amplitude), one -> states(h, amplitude));
        if (states.isEmpty()) {
            return Double.NaN;
        }
        double[] s = states.get(1);
        double[] said = new double[s.length];
        for (int j = 0; j < equation.states().length; j++) {
            said = Changes.plus(said, states.get(1 + j), equation.states()[j]);
        }
        for (int j = 0; j < equation.rates().length; j++) {
            double place = equation.places()[j];
            double[] at = place > 0 ? Changes.plus(Changes.scaled(s, 0, s.length, 1 - place), states.get(0), place)
                    : states.get((int) (1 - place));
            said = Changes.plus(said, rate(at, START + ((earlier ? STEPS : 1) - 1 + equation.clocks()[j]) * h), h
                    * equation.rates()[j]);
        }
        return StudentSource.distance(said, states.get(0));
    }

    /** The states that steps reach, the newest first; none if it refuses one. */
    private List<double[]> states(double h, double amplitude) {
        WindyOscillators source = WindyOscillators.nonlinear(2).from(START);
        double[] s = source.getState();
        Arrays.setAll(s, k -> amplitude * (1 + k / 64.0) * s[k]);       // off the exact solution
        source.setState(s);
        List<double[]> states = new ArrayList<>(List.of(s, s, s, s, s));
        DESolver solver = maker.get();
        for (int step = 0; step < (earlier ? STEPS : 1); step++) {
            if (!source.accepts(solver, h)) {
                return List.of();
            }
            states.add(0, source.getState());
        }
        return states;
    }

    private static double[] rate(double[] at, double time) {
        StudentSource source = WindyOscillators.nonlinear(2);
        source.setState(at);
        source.incTime(time - source.getTime());
        double[] dSdt = new double[at.length];
        source.getStateDerivative(dSdt);
        return dSdt;
    }
}
