package particles.teaching.solvers;

import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.function.DoubleSupplier;
import java.util.stream.IntStream;
import particles.teaching.Finding;
import particles.teaching.Finding.Kind;
import particles.teaching.Formula;

/**
 * Compares coefficients with those of known methods. An unknown method is judged by its order, and compared with the
 * nearest known method only if few stages differ.
 */
final class TableauComparison {
    /** Up to this number of evaluations a method should have full order; one with more may aim at stability instead. */
    private static final int MANY = 4;
    /** A method is nearest to a known one where no more stages and weights differ. */
    private static final int FEW = 2;

    private static final Comparator<MethodDifferences> FEWEST = Comparator.comparingInt(MethodDifferences::count)
            .thenComparingInt(MethodDifferences::wrongWeights);

    private final ExtractedTableau step;
    private final Optional<NamePromise> promise;
    private final DoubleSupplier measured;
    private final List<Finding> findings;
    private double[][] a;
    private double[] b;
    private double[] c;
    private int order;

    /**
     * @param step     the step from which all was read
     * @param a        the rows, in units of deltaT
     * @param b        the weights, in units of deltaT
     * @param c        the clocks, in units of deltaT
     * @param promise  the method that the class's name promises
     * @param measured gives the measured order
     * @param findings receives the mistakes
     */
    TableauComparison(ExtractedTableau step, double[][] a, double[] b, double[] c, Optional<NamePromise> promise,
            DoubleSupplier measured, List<Finding> findings) {
        this.step = step;
        this.a = a;
        this.b = b;
        this.c = c;
        this.promise = promise;
        this.measured = measured;
        this.findings = findings;
    }

    private void wrong(Kind kind, String text) {
        findings.add(new Finding(kind, text));
    }

    private List<String> names() {
        return KnownMethod.meantBy(promise, b.length).map(KnownMethod::slopes).orElseGet(()
                -> KnownMethod.numbered(b.length));
    }

    private List<String> stepNames() {
        return KnownMethod.meantBy(promise, b.length).map(KnownMethod::steps).orElseGet(()
                -> KnownMethod.numbered(b.length));
    }

    /**
     * @param end   whether the new state can be compared
     * @param clock whether the clock can be compared
     * @return the method, in a sentence
     */
    String identity(boolean end, boolean clock) {
        dropUnused(end);
        if (KnownMethod.meantBy(promise, b.length).isEmpty()) {
            dropRepeated();
        }
        double[] weights = end ? b : new double[0];
        double[] clocks = clock ? c : new double[0];
        List<MethodDifferences> all = KnownMethod.all().stream()
                .map(method -> MethodDifferences.of(method, a, weights, clocks, step)).toList();
        Optional<KnownMethod> exact = all.stream().filter(MethodDifferences::isEmpty).map(MethodDifferences::method)
                .findFirst();
        String but = findings.stream().anyMatch(Finding::isWrong) ? " but for what is wrong below." : ".";
        if (exact.isPresent()) {
            KnownMethod method = exact.get();
            order = method.order();
            boolean fits = promise.map(name -> name.allows(method.name(), method.order())
                    || !name.whole() && method.order() >= name.order()).orElse(true);
            if (!fits && end && clock) {
                findings.add(0, new Finding(Kind.METHOD, promise.get().contradicts(method.name())));
            }
            return "This is " + method.name() + but;
        }
        if (promise.isPresent() && promise.get().isImplicit() && end && clock) {
            findings.add(0, new Finding(Kind.METHOD, promise.get().contradicts("an explicit method with " + b.length
                    + " evaluations a step")));
            return "This is an explicit method.";
        }
        if (isTwoEulerSteps()) {
            findings.clear();
            wrong(Kind.METHOD, "two Euler steps of deltaT are made, and the clock moves by 2 deltaT; one is wanted");
            return "This is the Euler method, twice.";
        }
        if (!but.equals(".") && !(end && clock)) {
            return "Its step is not that of a method yet.";
        }
        return unknown(all, but);
    }

    /** @return the order of the coefficients; 0 before they were compared */
    int order() {
        return order;
    }

    /** Judges coefficients that are those of no known method by their order, and then looks for the nearest one. */
    private String unknown(List<MethodDifferences> all, String but) {
        int conditions = OrderConditions.order(a, b, c);
        order = conditions;
        double full = conditions == 4 ? Math.max(4, Math.rint(measured.getAsDouble())) : conditions;
        String name = "This is a Runge-Kutta method of order " + Formula.number(full) + " with " + b.length
                + " evaluations a step; its coefficients are none that we know by name";
        MethodDifferences nearest = all.stream().filter(of -> promise.map(p -> p.allows(of.method().name(), of.method()
                .order()))
                .orElse(true)).min(FEWEST)
                .orElseGet(() -> all.stream().min(FEWEST).orElseThrow());
        boolean near = nearest.count() <= FEW || nearest.first().kind() == Kind.STATE;
        boolean better = near && nearest.method().order() > full;
        int wanted = promise.map(NamePromise::order).orElse(better ? nearest.method().order() : 1);
        boolean pays = full >= 2 || full == 1 && isStableBeyondEuler();
        if (full >= wanted && pays) {
            return name + but;
        }
        if (near || promise.isPresent() && promise.get().whole() && nearest.method().stages() == b.length && b.length <=
                MANY) {
            findings.add(nearest.first());
            return "This is nearest to " + nearest.method().name() + ", but for what is wrong below.";
        }
        for (int i = 0; i < b.length; i++) {
            double sum = MethodDifferences.sum(a[i]);
            if (!Formula.same(sum, c[i])) {
                wrong(Kind.TIME, names().get(i) + " is evaluated at " + Formula.state(1, a[i], stepNames()) + " and "
                        + Formula.time(c[i]) + ": the coefficients of a stage have to add up to that of its time, and "
                        + "make "
                        + Formula.number(sum) + " instead of " + Formula.number(c[i]));
                return "This is a method of one's own, but for what is wrong below.";
            }
        }
        double sum = MethodDifferences.sum(b);
        wrong(Kind.METHOD, Formula.same(sum, 1) ? "the order is " + Formula.number(full) + " with " + b.length
                + " evaluations a step" + promise.map(p -> "; the name promises " + p.saysWithOrder()).orElse("")
                + ": compare the coefficients and the weights with those of the book"
                : "the weights of the new state add up to " + Formula.number(sum) + "; they have to add up to 1");
        return "This is a method of one's own, but for what is wrong below.";
    }

    /** On the negative real axis s Euler steps are stable to 2 s; a method of order 1 has to do as well to pay. */
    private boolean isStableBeyondEuler() {
        for (double z = -0.1; z > -2 * b.length + 0.05; z -= 0.1) {
            double[] k = new double[b.length];
            double r = 1;
            for (int i = 0; i < b.length; i++) {
                k[i] = 1;
                for (int j = 0; j < i; j++) {
                    k[i] += z * a[i][j] * k[j];
                }
                r += z * b[i] * k[i];
            }
            if (!(Math.abs(r) <= 1 + 1e-9)) {
                return false;
            }
        }
        return true;
    }

    private boolean isTwoEulerSteps() {
        return b.length == 2 && Formula.same(step.end(), 2 * step.h()) && Formula.same(b[0], 1) && Formula.same(b[1], 1)
                && Formula.same(a[1][0], 1)
                && Formula.same(c[1], 1);
    }

    /** An evaluation that enters nothing, where another one is made as well, is a look at the derivative. */
    private void dropRepeated() {
        for (int i = 0; i + 1 < b.length; i++) {
            int unused = i;
            boolean enters = b[i] != 0 || Arrays.stream(a).anyMatch(row -> row[unused] != 0);
            if (!enters && MethodDifferences.same(a[i], a[i + 1]) && c[i] == c[i + 1]) {
                findings.add(new Finding(Kind.ADVICE, "the derivative is asked for twice at the same state and time, "
                        + "at "
                        + Formula.time(c[i])));
                int[] left = IntStream.range(0, b.length).filter(j -> j != unused).toArray();
                a = Arrays.stream(left).mapToObj(j -> pick(a[j], left)).toArray(double[][]::new);
                b = pick(b, left);
                c = pick(c, left);
                return;
            }
        }
    }

    private static double[] pick(double[] from, int[] places) {
        return Arrays.stream(places).mapToDouble(j -> from[j]).toArray();
    }

    /** An evaluation at the end that enters nothing is a waste, but no mistake. */
    private void dropUnused(boolean end) {
        int used = b.length;
        while (end && used > 1 && b[used - 1] == 0 && !KnownMethod.isRowsOfAny(a)
                && Arrays.stream(b).anyMatch(w -> w != 0)) {
            used--;
        }
        if (used < b.length) {
            findings.add(new Finding(Kind.ADVICE, "the last " + (b.length - used == 1 ? "evaluation enters"
                    : b.length - used + " evaluations enter")
                    + " nothing, and could be left out"));
            int stages = used;
            a = Arrays.stream(Arrays.copyOf(a, stages)).map(row -> Arrays.copyOf(row, stages)).toArray(double[][]::new);
            b = Arrays.copyOf(b, stages);
            c = Arrays.copyOf(c, stages);
        }
    }
}
