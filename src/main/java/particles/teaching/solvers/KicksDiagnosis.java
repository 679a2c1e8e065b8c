package particles.teaching.solvers;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import particles.teaching.Finding.Kind;
import particles.teaching.Finding;
import particles.teaching.Formula;

/** Names a method that steps positions and velocities apart, and what is wrong with it. */
final class KicksDiagnosis {

    /** A known method: the name, words in class names, and its coefficients as in {@link ExtractedKicks}. */
    private record Known(String name, String authority, List<String> spoken, double[] x, double[] v, double[] pAt, double[] c) {
    }

    private static final double YOSHIDA = 1 / (2 - StrictMath.cbrt(2));

    private static final Known SYMPLECTIC = new Known("symplectic Euler, the slides' simple particle system algorithm",
            "the slide",
            List.of("symplectic", "semiimplicit", "simple", "cromer"), new double[] {1}, new double[] {1}, new double[] {0},
                    new double[] {0});

    private static final Known EULER = new Known("the Euler method", "the slide", List.of(), new double[] {0}, new double[] {1},
            new double[] {0}, new double[] {0});

    private static final List<Known> ALL = List.of(SYMPLECTIC, EULER,
            new Known("symplectic Euler with the position first", "the method", List.of("positionfirst"), new double[] {0},
                    new double[] {1},
                    new double[] {1}, new double[] {1}),
            new Known("velocity Verlet (leapfrog: kick, drift, kick)", "the method",
                    List.of("verlet", "leapfrog", "kickdriftkick"),
                    new double[] {0.5, 0}, new double[] {0.5, 0.5}, new double[] {0, 1}, new double[] {0, 1}),
            new Known("position Verlet (drift, kick, drift)", "the method", List.of("positionverlet", "driftkickdrift"),
                    new double[] {0.5},
                    new double[] {1}, new double[] {0.5}, new double[] {0.5}),
            yoshida());

    private KicksDiagnosis() {
    }

    /** Three leapfrogs of lengths w, 1 - 2 w and w. */
    private static Known yoshida() {
        double w = YOSHIDA;
        double[] c = {0, w, 1 - w, 1};
        double[] v = {w / 2, (1 - w) / 2, (1 - w) / 2, w / 2};
        double[] x = new double[4];
        for (int j = 0; j < 4; j++) {
            x[j] = v[j] * (1 - c[j]);
        }
        return new Known("Yoshida's method of order 4", "the method", List.of("yoshida"), x, v, c, c);
    }

    /**
     * @param className a simple class name
     * @return whether it promises a method that is here
     */
    static boolean isPromisedBy(String className) {
        return promised(className).isPresent();
    }

    private static Optional<Known> promised(String className) {
        String lower = className.toLowerCase(Locale.ROOT);
        return ALL.stream().filter(known -> known.spoken.stream().anyMatch(lower::contains))
                .max(Comparator.comparingInt(known -> known.spoken.stream().filter(lower::contains).mapToInt(String::length)
                .max().orElse(0)));
    }

    /**
     * @return what stands in the way of calling Euler's formula by the name that its class has, if that is another method's
     */
    static Optional<Finding> eulerInstead(String className) {
        return promised(className).filter(known -> known == SYMPLECTIC).map(known -> new Finding(Kind.METHOD,
                "the position is updated with the old velocity, which is the Euler method; the slides' simple algorithm takes the new one:"
                        + " first v += a deltaT, then x += v deltaT with that v"));
    }

    /**
     * @param step      what was read off
     * @param className the simple name of the solver's class
     * @return what it is
     */
    static Diagnosis of(ExtractedKicks step, String className) {
        List<Finding> findings = new ArrayList<>();
        if (!Formula.same(step.end(), 1)) {
            findings.add(new Finding(Kind.TIME, step.end() == 0 ? "the clock never moves: incTime(deltaT) is missing"
                    : "the clock ends at " + Formula.time(step.end()) + " and has to end at t + deltaT"));
        }
        boolean promisesEuler = promised(className).isEmpty()
                && KnownMethod.promisedBy(className).filter(m -> m.stages() == 1).isPresent();
        Optional<Known> exact = ALL.stream().filter(known -> differences(known, step).isEmpty()).findFirst();
        if (exact.isPresent() && exact.get() == EULER && promised(className).isPresent() && promised(className).get()
                == SYMPLECTIC) {
            findings.addAll(eulerInstead(className).stream().toList());
            return new Diagnosis("This is the Euler method.", findings);
        }
        if (exact.isPresent() && promisesEuler && exact.get() != EULER && exact.get().v.length == 1) {
            findings.add(new Finding(Kind.METHOD, "the position is updated with the new velocity; the slide's Euler method takes the old one:"
                    + " all of the state moves along the derivative at its start. What is written is symplectic Euler, the slides' simple"
                    + " algorithm"));
        }
        Known promised = promised(className).or(() -> exact).orElseGet(() -> ALL.stream()
                .min(Comparator.comparingInt(known -> differences(known, step).size())).orElseThrow());
        List<Finding> differences = differences(promised, step);
        if (!differences.isEmpty() && exact.isPresent()) {
            findings.add(new Finding(Kind.METHOD, "this is " + exact.get().name + " and not " + promised.name
                    + ", as its name says"));
        }
        findings.addAll(differences);
        String identity = exact.isPresent() ? "This is " + exact.get().name + "."
                : "This is nearest to " + promised.name + ", but for what is wrong below.";
        return new Diagnosis(identity, findings);
    }

    private static List<Finding> differences(Known known, ExtractedKicks step) {
        List<Finding> found = new ArrayList<>();
        int stages = Math.max(known.v.length, step.v().length);
        double[] v = Arrays.copyOf(step.v(), stages);
        double[] x = Arrays.copyOf(step.x(), stages);
        if (step.v().length != known.v.length) {
            found.add(new Finding(Kind.METHOD, "evaluations of the acceleration in a step: " + step.v().length + "; "
                    + known.name + " needs "
                    + known.v.length + ": " + (step.v().length < known.v.length ? "the one at the new position is missing"
                    : "one is too many")));
        }
        for (int j = 0; j < Math.min(step.v().length, known.v.length); j++) {
            if (!Formula.same(step.pAt()[j], known.pAt[j])) {
                found.add(new Finding(Kind.METHOD, "acceleration a" + (j + 1) + " is taken at a position that has moved "
                        + Formula.number(step.pAt()[j]) + " v deltaT; " + known.authority + " says "
                        + Formula.number(known.pAt[j])));
            }
            if (!Formula.same(step.c()[j], known.c[j]) && step.end() != 0) {
                found.add(new Finding(Kind.TIME, "acceleration a" + (j + 1) + " is evaluated at " + Formula.time(step.c()[j])
                        + "; "
                        + known.authority + " says " + Formula.time(known.c[j])));
            }
        }
        compare("velocity", "v", v, Arrays.copyOf(known.v, stages), 1, known, found, " deltaT");
        compare("position", "x", x, Arrays.copyOf(known.x, stages), step.p(), known, found, " deltaT^2");
        if (!Formula.same(step.kept()[0], 1) || !Formula.same(step.kept()[1], 1)) {
            found.add(new Finding(Kind.STATE, "the new position and velocity have " + Formula.number(step.kept()[0]) + " x and "
                    + Formula.number(step.kept()[1]) + " v in them instead of x and v"));
        }
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
        return accelerations.equals("0") ? start : start + (accelerations.startsWith(" - ") ? "" : " + ") + accelerations;
    }
}
