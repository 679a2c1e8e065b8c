package particles.teaching.compared;

import deSolvers.DESolver;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.function.Supplier;
import particles.teaching.declared.Equation;
import particles.teaching.declared.Method;
import particles.teaching.sources.Bodies;
import particles.teaching.sources.StudentSource;
import particles.teaching.sources.WindyOscillators;

/**
 * How well the step of a solver fulfils the equations of implicit and multistep methods, on a law that is not linear,
 * where the clock does not matter or where it does.
 *
 * @param earlier whether it uses earlier steps, so that its sixth one is looked at
 * @param source  makes the source
 * @param states  the states that its steps reached, the newest first; none if it refused one
 */
public record Fit(boolean earlier, Supplier<StudentSource> source, List<double[]> states) {
    /** The length of a step (s). */
    public static final double H = 1.0 / 16;
    /** What iterations leave, at most: those to 1e-6 leave 1e-6, and another method 1e-4 or more. */
    public static final double SOLVED = 1e-5;
    /** A formula of earlier steps leaves round-off or what an iteration leaves, and another one 1e-7 or more. */
    private static final double FITS = 5e-9;
    private static final double START = 0.5;
    private static final int STEPS = 6;

    /**
     * @param clock whether the law changes with the clock
     * @return how well the steps of this solver fit
     */
    public static Fit of(Supplier<DESolver> maker, boolean earlier, boolean clock) {
        Supplier<StudentSource> sources = clock ? () -> new WindyOscillators(2).from(START) : Bodies::new;
        StudentSource source = sources.get();
        List<double[]> states = new ArrayList<>(List.of(source.getState()));
        DESolver solver = maker.get();
        for (int step = 0; step < (earlier ? STEPS : 1); step++) {
            if (!source.accepts(solver, H)) {
                return new Fit(earlier, sources, List.of());
            }
            states.add(0, source.getState());
        }
        return new Fit(earlier, sources, states);
    }

    /** @return the method whose equation the steps fulfil best, if they fulfil it */
    public Optional<Method> known() {
        return Arrays.stream(Method.values()).filter(method -> method.equation().filter(one -> one.usesEarlier()
                == earlier).isPresent()).min(Comparator.comparingDouble(this::residual)).filter(method -> residual(
                method) < (earlier ? FITS : SOLVED));
    }

    /** @return the largest difference of the two sides of a method's equation; NaN if a step was refused */
    public double residual(Method method) {
        if (states.isEmpty()) {
            return Double.NaN;
        }
        Equation equation = method.equation().orElseThrow();
        double[] said = new double[states.get(0).length];
        for (int j = 0; j < equation.states().length; j++) {
            said = Changes.plus(said, states.get(1 + j), equation.states()[j]);
        }
        for (int j = 0; j < equation.rates().length; j++) {
            double place = equation.places()[j];
            double[] at = place > 0 ? Changes.plus(states.get(1), Changes.plus(states.get(0), states.get(1), -1),
                    place) : states.get((int) (1 - place));
            StudentSource there = source.get();
            there.setState(at);
            there.incTime((states.size() - 2 + place) * H);
            double[] rate = new double[at.length];
            there.getStateDerivative(rate);
            said = Changes.plus(said, rate, H * equation.rates()[j]);
        }
        return StudentSource.distance(said, states.get(0));
    }
}
