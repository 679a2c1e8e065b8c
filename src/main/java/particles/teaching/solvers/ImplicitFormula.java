package particles.teaching.solvers;

import deSolvers.DESolver;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.function.Supplier;
import particles.teaching.Finding;
import particles.teaching.Finding.Kind;
import particles.teaching.Formula;
import particles.teaching.sources.NonlinearOscillators;

/**
 * Identifies the implicit equation that the steps of a solver solve, and its residual. The equation is new = s + deltaT
 * (now f(s, t + n deltaT) + end f(s + place (new - s), t + e deltaT)), on a law that is neither linear nor the same at
 * all times.
 */
final class ImplicitFormula {
    /** Solved: newton iterations to 1e-6 leave 1e-11, simple ones to 1e-6 leave up to 1e-6. */
    private static final double SOLVED = 1e-5;
    /** A step this close to an equation, and closer than to any other, is meant to solve it. */
    private static final double EXACT = 1e-7;
    private static final double[] STEPS = {1.0 / 4, 1.0 / 8, 1.0 / 16, 1.0 / 32, 1.0 / 64, 1.0 / 128};
    private static final double START = 0.5;

    /** An equation and its mistake; the name is that of the right method. */
    private record Equation(String name, double now, double place, double nowTime, double endTime, String fault) {
        double end() {
            return 1 - now;
        }
    }

    private static final List<Equation> ALL = List.of(
            new Equation(NamePromise.BACKWARD_EULER, 0, 1, 0, 1, ""),
            new Equation(NamePromise.BACKWARD_EULER, 0, 1, 0, 0, "the derivative at the end of the step is taken at "
            + "the clock t;"
                    + " move the clock to t + deltaT before it"),
            new Equation(NamePromise.IMPLICIT_MIDPOINT, 0, 0.5, 0, 0.5, ""),
            new Equation(NamePromise.IMPLICIT_MIDPOINT, 0, 0.5, 0, 0, "the derivative half way is taken at the clock t;"
                    + " move the clock to t + deltaT/2 before it"),
            new Equation(NamePromise.IMPLICIT_MIDPOINT, 0, 0.5, 0, 1, "the derivative half way is taken at the clock t "
                    + "+ deltaT;"
                    + " the clock has to stand at t + deltaT/2"),
            new Equation(NamePromise.TRAPEZOID, 0.5, 1, 0, 1, ""),
            new Equation(NamePromise.TRAPEZOID, 0.5, 1, 0, 0, "both derivatives are taken at the clock t;"
                    + " move the clock to t + deltaT before the one at the end"),
            new Equation(NamePromise.TRAPEZOID, 0.5, 1, 1, 1, "both derivatives are taken at the clock t + deltaT;"
                    + " take the one at the start before the clock moves"));

    private ImplicitFormula() {
    }

    /**
     * @param maker   makes solvers that have no tableau
     * @param promise the method that the class's name promises
     * @return the diagnosis; empty if its steps solve no equation that is known here
     */
    static Optional<Diagnosis> of(Supplier<DESolver> maker, Optional<NamePromise> promise) {
        Equation closest = null;
        double least = Double.POSITIVE_INFINITY;
        for (Equation equation : ALL) {
            double best = Double.POSITIVE_INFINITY;
            for (double h : STEPS) {
                best = Math.min(best, residual(equation, maker.get(), h) / h);
            }
            if (best < least) {
                least = best;
                closest = equation;
            }
        }
        Equation meant = closest;
        boolean promised = promise.isPresent() && meant != null && promise.get().methods().contains(meant.name)
                && !promise.get().methods().contains(NamePromise.HEUN);
        if (meant == null || least > EXACT && !promised) {
            return Optional.empty();
        }
        List<Finding> findings = new ArrayList<>();
        if (promise.isPresent() && promise.get().whole() && !promise.get().allows(meant.name, 0)) {
            findings.add(new Finding(Kind.METHOD, promise.get().contradicts(meant.name)));
        } else if (!meant.fault.isEmpty()) {
            findings.add(new Finding(Kind.TIME, meant.fault));
        }
        new UnreadMethod(maker).unstable().or(() -> loose(meant, maker)).ifPresent(findings::add);
        return Optional.of(new Diagnosis("This is " + meant.name + (findings.isEmpty() ? "."
                : " but for what is wrong below."),
                findings));
    }

    private static Optional<Finding> loose(Equation equation, Supplier<DESolver> maker) {
        record Trial(double h, double residual) {
        }
        Trial worst = Arrays.stream(STEPS).mapToObj(h -> new Trial(h, residual(equation, maker.get(), h)))
                .filter(trial -> Double.isFinite(trial.residual)).max(Comparator.comparingDouble(Trial::residual))
                .orElseThrow();
        return worst.residual <= SOLVED ? Optional.empty() : Optional.of(new Finding(Kind.METHOD,
                "the iteration ends too early: with"
                + " a nonlinear law and deltaT = " + worst.h + " s the equation of the step is off by "
                + Formula.number(worst.residual) + "; iterate until the change is below about 1e-10"));
    }

    /** The residual of the equation after a step; infinite if the solver gives up. */
    private static double residual(Equation equation, DESolver solver, double h) {
        NonlinearOscillators source = new NonlinearOscillators(2);
        source.startAt(START);
        double[] s = source.state();
        try {
            solver.stepState(source, h);
        } catch (RuntimeException e) {
            return Double.POSITIVE_INFINITY;
        }
        double[] next = source.state();
        double[] now = rate(source, s, START + equation.nowTime * h);
        double[] trial = s.clone();
        for (int i = 0; i < s.length; i++) {
            trial[i] += equation.place * (next[i] - s[i]);
        }
        double[] end = rate(source, trial, START + equation.endTime * h);
        double largest = 0;
        for (int i = 0; i < s.length; i++) {
            double off = Math.abs(next[i] - s[i] - h * (equation.now * now[i] + equation.end() * end[i]));
            largest = off <= largest ? largest : off;
        }
        return Double.isNaN(largest) ? Double.POSITIVE_INFINITY : largest;
    }

    private static double[] rate(NonlinearOscillators source, double[] s, double t) {
        source.setState(s);
        source.incTime(t - source.getTime());
        double[] dSdt = new double[s.length];
        source.getStateDerivative(dSdt);
        return dSdt;
    }
}
