package particles.teaching.solvers;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.function.DoubleSupplier;
import particles.teaching.Finding.Kind;
import particles.teaching.Finding;
import particles.teaching.Formula;

/** Identifies a method that steps positions and velocities separately, and its mistakes. */
final class KicksDiagnosis {

    /** A known method and its coefficients as in {@link ExtractedKicks}. */
    private record Known(String name, String authority, int order, double[] x, double[] v, double[] pAt) {

        /** A method that drifts (x += v d deltaT) and kicks (v += a k deltaT) in turn, and begins with a drift. */
        Known(String name, String authority, int order, double[] drifts, double... kicks) {
            this(name, authority, order, new double[kicks.length], kicks, new double[kicks.length]);
            double place = 0;
            for (int j = 0; j < kicks.length; j++) {
                place += drifts[j];
                pAt[j] = place;
                x[j] = kicks[j] * (1 - place);
            }
        }
    }

    private static final double W = 1 / (2 - StrictMath.cbrt(2));
    /** Positions and velocities one after the other are worth it if the order is 2, or areas are kept. */
    private static final double SECOND_ORDER = 1.7;
    private static final double SAME_AREA = 1e-10;
    private static final double ALMOST = 0.3;
    private static final int FEW = 2;

    private static final List<Known> ALL = List.of(
            new Known(NamePromise.SYMPLECTIC, "the slide", 1, new double[] {0, 1}, 1),
            new Known(NamePromise.EULER, "the slide", 1, new double[] {0}, new double[] {1}, new double[] {0}),
            new Known(NamePromise.POSITION_FIRST, "the method", 1, new double[] {1, 0}, 1),
            new Known(NamePromise.VERLET, "the method", 2, new double[] {0, 1, 0}, 0.5, 0.5),
            new Known(NamePromise.POSITION_VERLET, "the method", 2, new double[] {0.5, 0.5}, 1),
            new Known("Ruth's method of order 3", "the method", 3, new double[] {1, -2.0 / 3, 2.0 / 3}, -1.0 / 24,
            3.0 / 4,
                    7.0 / 24),
            new Known("Ruth's method of order 3, the velocity first", "the method", 3,
                    new double[] {0, 2.0 / 3, -2.0 / 3, 1}, 7.0 / 24, 3.0 / 4, -1.0 / 24),
            new Known("Yoshida's method of order 4", "the method", 4, new double[] {0, W, 1 - 2 * W, W}, W / 2,
                    (1 - W) / 2,
                    (1 - W) / 2, W / 2),
            new Known("Yoshida's method of order 4, the position first", "the method", 4,
                    new double[] {W / 2, (1 - W) / 2, (1 - W) / 2, W / 2}, W, 1 - 2 * W, W));

    private KicksDiagnosis() {
    }

    /**
     * @param found     the coefficients
     * @param promise   the method that the class's name promises
     * @param measured  gives the measured order
     * @param keepsArea whether a step on a spring keeps areas
     * @return the diagnosis
     */
    static Diagnosis of(ExtractedKicks found, Optional<NamePromise> promise, DoubleSupplier measured,
            boolean keepsArea) {
        ExtractedKicks step = found.merged();
        List<Finding> findings = new ArrayList<>();
        if (!Formula.sameTime(step.end(), 1)) {
            findings.add(Formula.same(step.end(), step.p()) ? new Finding(Kind.METHOD, "the parts of the step add up"
                    + " to " + Formula.number(step.p()) + " deltaT, and have to add up to deltaT: compare their lengths"
                    + " and signs with those of the book") : new Finding(Kind.TIME, step.end() == 0
                    ? "the clock never moves: incTime(deltaT) is missing"
                    : "the clock ends at " + Formula.time(step.end()) + " and has to end at t + deltaT"));
        }
        if (!Formula.same(step.kept()[0], 1) || !Formula.same(step.kept()[1], 1)) {
            boolean position = Formula.same(step.kept()[1], 1);
            findings.add(new Finding(Kind.STATE, "the new " + (position ? "position has " : "velocity has ")
                    + Formula.number(step.kept()[position ? 0 : 1]) + (position ? " x in it instead of x" : " v in it"
                    + " instead of v: a factor is damping, which the equation does not have")));
        }
        Optional<Known> exact = ALL.stream().filter(known -> differences(known, step).isEmpty()).findFirst();
        if (exact.isPresent()) {
            Known known = exact.get();
            String identity = "This is " + known.name + (findings.isEmpty() ? "." : " but for what is wrong below.");
            if (promise.isPresent() && !promise.get().allows(known.name, known.order)
                    && (promise.get().whole() || known.order < promise.get().order())) {
                findings.add(instead(known, promise.get()));
            }
            return new Diagnosis(identity, findings, known.order);
        }
        double order = measured.getAsDouble();
        List<Known> meant = ALL.stream().filter(known -> promise.map(name -> name.allows(known.name, known.order))
                .orElse(true))
                .toList();
        Known nearest = (meant.isEmpty() ? ALL : meant).stream()
                .min(Comparator.comparingInt(known -> differences(known, step).size())).orElseThrow();
        List<Finding> differences = differences(nearest, step);
        boolean near = differences.size() <= FEW && nearest.order > order + ALMOST;
        int wanted = promise.map(NamePromise::order).orElse(near ? nearest.order : 1);
        boolean pays = order > SECOND_ORDER || order > 1 - ALMOST && keepsArea;
        if (findings.isEmpty() && order >= wanted - ALMOST && pays) {
            return new Diagnosis("This is a method of order " + Math.round(order)
                    + " that moves positions and velocities in turn,"
                    + (keepsArea ? " symplectic," : "") + " with " + step.v().length
                    + " accelerations a step; its coefficients are none that we know by name.", findings);
        }
        if (near || promise.isPresent() && promise.get().whole() && nearest.v.length == step.v().length) {
            findings.add(differences.get(0));
            return new Diagnosis("This is nearest to " + nearest.name + ", but for what is wrong below.", findings);
        }
        int count = step.v().length;
        findings.add(new Finding(Kind.METHOD, "the measured order is " + String.format(Locale.ROOT, "%.2f", order)
                + " with " + count + (count == 1 ? " acceleration" : " accelerations") + " a step"
                + promise.map(name -> "; the name promises " + name.saysWithOrder()).orElse("")
                + ": the new velocity is " + formula("v", step.v(), 1, " deltaT")
                + "; compare the coefficients with those of the book"));
        return new Diagnosis("This is a method of one's own, but for what is wrong below.", findings);
    }

    /** The message for a known method that has another method's name. */
    static Finding instead(Known known, NamePromise promise) {
        if (known.name.equals(NamePromise.EULER) && promise.methods().contains(NamePromise.SYMPLECTIC)) {
            return oldVelocity();
        }
        return new Finding(Kind.METHOD, promise.methods().contains(NamePromise.EULER) && known.v.length == 1
                ? "the position is updated with the new velocity; the slide's Euler method takes the old one:"
                + " all of the state moves along the derivative at its start. What is written is symplectic Euler, the "
                + "slides' simple"
                + " algorithm" : promise.contradicts(known.name));
    }

    /** @return the message for Euler's formula under the name of the simple algorithm */
    static Finding oldVelocity() {
        return new Finding(Kind.METHOD, "the position is updated with the old velocity, which is the Euler method; the "
                + "slides'"
                + " simple algorithm takes the new one: first v += a deltaT, then x += v deltaT with that v");
    }

    private static List<Finding> differences(Known known, ExtractedKicks step) {
        List<Finding> found = new ArrayList<>();
        int stages = Math.max(known.v.length, step.v().length);
        double[] v = Arrays.copyOf(step.v(), stages);
        double[] x = Arrays.copyOf(step.x(), stages);
        if (step.v().length != known.v.length) {
            found.add(new Finding(Kind.METHOD, "evaluations of the acceleration in a step: " + step.v().length + "; "
                    + known.name + " needs "
                    + known.v.length + ": " + (step.v().length < known.v.length
                    ? "the one at the new position is missing"
                    : "one is too many")));
        }
        for (int j = 0; j < Math.min(step.v().length, known.v.length); j++) {
            if (!Formula.same(step.pAt()[j], known.pAt[j])) {
                found.add(new Finding(Kind.METHOD, "acceleration a" + (j + 1)
                        + " is taken at a position that has moved "
                        + Formula.number(step.pAt()[j]) + " v deltaT; " + known.authority + " says "
                        + Formula.number(known.pAt[j]) + (step.pAt()[j] == 0
                        ? ": set the state with the new position before getStateDerivative" : "")));
            }
            if (!Formula.sameTime(step.c()[j], known.pAt[j]) && step.end() != 0) {
                found.add(new Finding(Kind.TIME, "acceleration a" + (j + 1) + " is evaluated at "
                        + Formula.time(step.c()[j])
                        + "; "
                        + known.authority + " says " + Formula.time(known.pAt[j])));
            }
        }
        compare("velocity", "v", v, Arrays.copyOf(known.v, stages), 1, known, found, " deltaT");
        compare("position", "x", x, Arrays.copyOf(known.x, stages), step.p(), known, found, " deltaT^2");
        return found;
    }

    private static void compare(String what, String letter, double[] found, double[] expected, double p, Known known,
            List<Finding> findings,
                                String unit) {
        boolean position = letter.equals("x");
        if (MethodDifferences.same(found, expected) && (!position || Formula.same(p, 1))) {
            return;
        }
        findings.add(new Finding(Kind.METHOD, "the new " + what + " is " + formula(letter, found, p, unit) + "; "
                + known.authority + " says "
                + formula(letter, expected, 1, unit) + hint(position, found, expected, p)));
    }

    private static String hint(boolean position, double[] found, double[] expected, double p) {
        if (position && !Formula.same(p, 1)) {
            return ": the old velocity moves the position by " + Formula.number(p) + " v deltaT";
        }
        double sum = MethodDifferences.sum(expected);
        if (position && sum != 0 && MethodDifferences.same(found, new double[found.length])) {
            return ": 1/2 is 0 in Java, as both are whole numbers, and 0.5 is meant";
        }
        if (Formula.same(MethodDifferences.sum(found), -sum)) {
            return ": the sign is wrong";
        }
        return Formula.same(MethodDifferences.sum(found), 2 * sum) ? ": the half is missing" : "";
    }

    private static String formula(String letter, double[] weights, double p, String unit) {
        List<String> names = new ArrayList<>();
        for (int j = 1; j <= weights.length; j++) {
            names.add("a" + j + unit);
        }
        String accelerations = Formula.state(0, weights, names);
        String start = letter.equals("x") ? "x" + (Formula.same(p, 1) ? " + v deltaT" : p == 0 ? ""
                : " + " + Formula.number(p) + " v deltaT") : "v";
        return accelerations.equals("0") ? start : start + (accelerations.startsWith(" - ") ? "" : " + ")
                + accelerations;
    }
}
