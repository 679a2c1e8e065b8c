package particles.teaching.figures;

import deSolvers.DESolver;
import deSolvers.catalog.SolverCatalog;
import deSolvers.text.Digits;
import java.util.ArrayList;
import java.util.Collections;
import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.DoubleBinaryOperator;
import java.util.function.DoubleUnaryOperator;
import java.util.function.Supplier;
import particles.experiments.stability.Amplification;
import particles.experiments.stability.StabilityLimit;
import particles.experiments.stability.StabilityMap;
import particles.experiments.stability.StabilityRegion;
import particles.experiments.stability.StabilityRegion.Window;
import particles.experiments.stability.StepTrial;
import particles.teaching.Formula;
import particles.view.ChartData;
import particles.view.ChartData.Mark;
import particles.view.ChartData.Series;
import particles.view.DataTable;

/**
 * The stability limits and the stability region of a solver, measured on its steps.
 *
 * @param rows   the limits, or why there are none: property, value, meaning
 * @param region the part of the plane where a step does not grow, beside the most similar built-in solver's
 * @param growth the factor by which a step multiplies the solution, beside the exact one and those of built-in solvers
 */
record StabilityFigures(List<List<Object>> rows, Optional<ChartData> region, Optional<DataTable> growth) {
    /** With more noise the coefficients of R are not known well enough to be named. */
    private static final double CLEAN = 1e-9;
    private static final double STABLE = 1 + 1e-8;
    private static final double LITTLE = 1e-3;
    private static final String REAL = "real limit: largest stable deltaT |lambda|";
    private static final String IMAGINARY = "imaginary limit: largest stable deltaT omega";
    private static final String DAMPED = "damped limit: largest stable deltaT omega";
    private static final List<String> FOR_ALL = List.of("euler", "midpoint", "rk4", "backward-euler",
            "implicit-midpoint");
    private static final List<String> FOR_SPRINGS = List.of("symplectic-euler", "verlet", "yoshida4");
    private static final double[][] PLACES = {{-0.5, 0}, {-1, 0}, {-2, 0}, {-4, 0}, {0, 0.5}, {0, 1}, {0, 2}, {0, 4},
            {-1, 1}};
    private static final double[][] DAMPED_PLACES = {{0.5, 0}, {1, 0}, {1.5, 0}, {2, 0}, {3, 0}, {0.5, 0.1},
            {1, 0.5}, {1, 2}, {0, 1}};

    /**
     * The plane in which a solver is measured: of deltaT lambda or, for a method that steps positions and velocities
     * apart, of deltaT omega and deltaT c/m.
     */
    private record Plane(Amplification amplification, double noise, boolean springs) {
        double growth(double x, double y) {
            return springs ? amplification.ofSpring(x * x, y) : amplification.at(x, y);
        }

        StabilityLimit limit(DoubleUnaryOperator along) {
            return StabilityLimit.measure(h -> along.applyAsDouble(h) - 10 * noise);
        }

        /** On springs, critical damping: c/m = 2 omega. */
        StabilityLimit ofDamping() {
            return limit(h -> springs ? growth(h, 2 * h) : growth(-h, 0));
        }

        StabilityLimit ofSpring() {
            return limit(h -> springs ? growth(h, 0) : growth(0, h));
        }
    }

    /**
     * @param name      the solver's name in charts
     * @param maker     makes a new solver
     * @param multistep whether it uses earlier steps
     * @return the figures
     */
    static StabilityFigures of(String name, Supplier<DESolver> maker, boolean multistep) {
        StepTrial trial = StepTrial.of(maker, multistep);
        boolean builtIn = SolverCatalog.names().contains(name);
        Optional<Amplification> own = builtIn ? Optional.of(Amplification.of(SolverCatalog.info(name)))
                : trial.amplification();
        if (own.isEmpty()) {
            return new StabilityFigures(List.of(List.of(REAL, "-", trial.objection()),
                    List.of(IMAGINARY, "-", "the same")),
                    Optional.empty(), Optional.empty());
        }
        boolean subStep = builtIn && SolverCatalog.info(name).adaptive();
        Plane plane = new Plane(own.get(), builtIn ? 0 : trial.noise(), own.get().isOfSprings());
        String nearest = nearest(name, plane);
        List<List<Object>> rows = new ArrayList<>();
        if (!subStep && !plane.springs && !multistep && trial.noise() < CLEAN) {
            StabilityFunction.of(maker, trial.noise())
                    .ifPresent(r -> rows.add(List.of("R(z), factor of a step in y' = lambda y, z = lambda deltaT",
                    r.text(), r.owner().isEmpty() ? "z is deltaT lambda" : r.owner())));
        }
        StabilityLimit damping = plane.ofDamping();
        StabilityLimit spring = plane.ofSpring();
        String how = own.get().isOfManySteps() ? ", from the growth over many steps" : subStep ? ", of one sub-step"
                : "";
        List<Object> damped = plane.springs ? List.of(DAMPED, text(damping), "of a critically damped spring" + how)
                : List.of(REAL, text(damping), "of drag alone: on the negative real axis" + how);
        List<Object> undamped = List.of(IMAGINARY, text(spring), "of an undamped spring"
                + (plane.springs ? "" : ": on the imaginary axis")
                + (spring.value() == 0 ? "; grows at any deltaT" : "")
                + how);
        rows.addAll(plane.springs ? List.of(undamped, damped) : List.of(damped, undamped));
        return new StabilityFigures(rows, Optional.of(chart(name, plane, nearest, damping, spring)),
                Optional.of(table(name, plane, nearest)));
    }

    private static String text(StabilityLimit limit) {
        return limit.value() == Double.POSITIVE_INFINITY ? "unbounded" : limit.value() == 0 ? "0"
                : Digits.format("%.8g", limit.value());
    }

    private static DoubleBinaryOperator builtIn(String other, Plane like) {
        Amplification amplification = like.springs ? new Amplification(() -> SolverCatalog.create(other), true, false)
                : Amplification.of(SolverCatalog.info(other));
        return new Plane(amplification, 0, like.springs)::growth;
    }

    /**
     * The built-in solver whose stability differs at the fewest places around 0; among equals, the one with the most
     * similar growth.
     */
    private static String nearest(String name, Plane plane) {
        List<String> others = new ArrayList<>(FOR_ALL);
        if (plane.springs) {
            others.addAll(FOR_SPRINGS);
        }
        if (plane.amplification.isOfManySteps()) {
            others.add("adams");
        }
        others.remove(name);
        List<double[]> places = new ArrayList<>();          // where, and the growth there
        for (double size = 0.3; size < 12; size *= 1.4) {
            for (int k = 0; k <= 8; k++) {
                double angle = Math.PI * k / (plane.springs ? 16 : 8);
                double x = size * StrictMath.cos(angle);
                double y = size * StrictMath.sin(angle);
                places.add(new double[] {x, y, plane.growth(x, y)});
            }
        }
        Map<String, Double> distances = new LinkedHashMap<>();
        for (String other : others) {
            DoubleBinaryOperator growth = builtIn(other, plane);
            for (double[] place : places) {
                double theirs = growth.applyAsDouble(place[0], place[1]);
                distances.merge(other, (place[2] <= STABLE == theirs <= STABLE ? 0 : 1)
                        + LITTLE * Math.abs(Math.min(2, place[2]) - Math.min(2, theirs)), Double::sum);
            }
        }
        return Collections.min(others, Comparator.comparing(distances::get));
    }

    private static ChartData chart(String name, Plane plane, String nearest, StabilityLimit damping,
            StabilityLimit spring) {
        DoubleBinaryOperator other = builtIn(nearest, plane);
        Window window = StabilityWindow.of(plane::growth, other, plane.amplification::getEvaluations, !plane.springs);
        StabilityMap own = new StabilityMap(plane::growth, window, !plane.springs);
        Series beside = new StabilityMap(other, window, !plane.springs).outline(nearest);
        // pale and wide, so that a line along which it runs is seen
        List<Series> series = new ArrayList<>(List.of(own.outline(name), own.filled("stable"),
                new Series(nearest, Mark.BAND, beside.x(), beside.y())));
        if (!plane.springs) {
            series.add(StabilityRegion.imaginaryAxis(-window.top(), window.top()));
        }
        String title = "Stable in the grey region: " + most(damping)
                + (plane.springs ? " for critical damping, " : " for damping, ") + most(spring)
                + " for undamped springs";
        return new ChartData(title, plane.springs ? "deltaT omega: stiffness"
                : "Re(deltaT lambda): decay to the left, growth to the right",
                plane.springs ? "deltaT c/m: damping" : "Im(deltaT lambda): oscillation", false, false, series);
    }

    private static String most(StabilityLimit limit) {
        return limit.value() == 0 ? "never" : limit.value() == Double.POSITIVE_INFINITY ? "always"
                : Digits.format("to %.4g", limit.value());
    }

    private static DataTable table(String name, Plane plane, String nearest) {
        List<String> others = new ArrayList<>(List.of("euler", "midpoint", "rk4"));
        others.remove(name);
        if (!others.contains(nearest)) {
            others.add(nearest);
        }
        List<String> columns = new ArrayList<>(plane.springs ? List.of("deltaT omega", "deltaT c/m")
                : List.of("deltaT lambda"));
        columns.addAll(List.of("exactly", name));
        columns.addAll(others);
        List<List<Object>> rows = new ArrayList<>();
        for (double[] at : plane.springs ? DAMPED_PLACES : PLACES) {
            List<Object> row = new ArrayList<>();
            if (plane.springs) {
                row.addAll(List.of(at[0], at[1]));
            } else {
                row.add(at[1] == 0 ? number(at[0]) : at[0] == 0 ? number(at[1]) + " i"
                        : number(at[0]) + " + " + number(at[1]) + " i");
            }
            row.add(digits(plane.springs ? damped(at[0], at[1]) : StrictMath.exp(at[0])));
            row.add(digits(plane.growth(at[0], at[1])));
            others.forEach(other -> row.add(digits(builtIn(other, plane).applyAsDouble(at[0], at[1]))));
            rows.add(row);
        }
        return new DataTable("growth", plane.springs ? "By how much a step multiplies the amplitude of a damped spring"
                : "By how much a step multiplies the size of y in y' = lambda y; exactly |exp(deltaT lambda)|",
                columns.stream().map(DataTable::column).toList(), rows);
    }

    private static double damped(double omega, double damping) {
        double discriminant = damping * damping / 4 - omega * omega;
        return StrictMath.exp(-damping / 2 + Math.sqrt(Math.max(0, discriminant)));
    }

    private static String number(double x) {
        return Formula.number(x).contains("/") ? Double.toString(x) : Formula.number(x);
    }

    private static String digits(double x) {
        return x == Double.POSITIVE_INFINITY ? "refused" : Digits.format("%.6f", x);
    }
}
