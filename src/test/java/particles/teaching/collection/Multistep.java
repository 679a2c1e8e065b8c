package particles.teaching.collection;

import static particles.teaching.solvers.PlantedSolvers.slope;
import static particles.teaching.solvers.PlantedSolvers.slopeAt;
import static particles.teaching.solvers.PlantedSolvers.state;

import deSolvers.DESolver;
import deSolvers.DEStateSource;
import java.util.Arrays;
import java.util.List;
import particles.teaching.solvers.PlantedSolvers.Step;

/**
 * Adams-Bashforth, alone or as predictor, or the BDF formula of order 2, which begins again whenever it does not go on
 * from its own last step; and slips.
 */
final class Multistep extends DESolver {
    /** From two steps on. */
    private static final double[][] WEIGHTS = SolverTable.rows(
            "3/2 -1/2; 23/12 -16/12 5/12; 55/24 -59/24 37/24 -9/24");
    private static final double[] MOULTON = SolverTable.numbers("9/24 19/24 -5/24 1/24");
    private static final double[][] SHARED = new double[1][];
    private static final double[][] RK4 = SolverTable.rows("; 1/2; 0 1/2; 0 0 1");

    private final int steps;
    private final double bdf;
    private final double[] weights;
    private final List<String> slips;
    private final Step beginning;
    private final double[][] before;
    private int known;
    private DEStateSource last;
    private double[] left = {};
    private double time;
    private double length;

    /**
     * @param begins order of the first steps, 1 or 4
     * @param bdf    the weight of the new derivative in the BDF formula; 0 for Adams
     * @param slips  words; from "weights" on, the weights
     */
    Multistep(int steps, int begins, double bdf, List<String> slips) {
        this.steps = steps;
        this.bdf = bdf;
        this.slips = slips;
        int own = slips.indexOf("weights");
        weights = own < 0 ? WEIGHTS[steps - 2] : slips.stream().skip(own + 1).mapToDouble(Double::parseDouble)
                .toArray();
        before = slips.contains("static") ? SHARED : new double[steps - 1][];
        beginning = begins == 1 ? Methods.rungeKutta(new double[1][0], new double[] {1}, new double[0],
                (stage, old, next) -> next) : Methods.rungeKutta(RK4, SolverTable.numbers("1/6 1/3 1/3 1/6"),
                slips.contains("start-clock") ? new double[] {0, 0, 0, 1} : new double[0], (stage, old, next) -> next);
    }

    private boolean goesOn(DEStateSource source, double deltaT) {
        return slips.contains("never-again") || source == last && (slips.contains("any-time") || time
                == source.getTime()) && (slips.contains("any-deltaT") || length == deltaT)
                && (slips.contains("any-state") || Arrays.equals(left, state(source)));
    }

    @Override
    public void stepState(DEStateSource source, double deltaT) {
        double[] s = state(source);
        known = goesOn(source, deltaT) ? known : 0;
        boolean full = known >= steps - 1;
        double[] kept = bdf > 0 ? s : slope(source);
        if (bdf > 0) {
            double[] base = full ? Methods.plus(Methods.plus(s, 1.0 / 3, s), -1.0 / 3, before[0]) : s;
            source.incTime(deltaT);
            source.setState(Methods.newton(x -> Methods.plus(Methods.plus(x, -1, base), full ? -bdf * deltaT : -deltaT,
                    slopeAt(source, x)), s, 1e-12, 100));
        } else if (full) {
            double half = deltaT / length / 2;
            double[] used = slips.contains("adapts") ? new double[] {1 + half, -half} : weights;
            source.setState(next(s, deltaT, used[0], kept, Arrays.copyOfRange(used, 1, steps)));
            source.incTime(slips.contains("clock-stays") ? 0 : deltaT);
            if (slips.contains("corrects")) {
                double[] corrected = Methods.plus(s, deltaT * MOULTON[0], slope(source));
                source.setState(next(corrected, deltaT, MOULTON[1], kept, Arrays.copyOfRange(MOULTON, 2, 4)));
            }
        } else {
            beginning.make(source, deltaT);
        }
        if (!full || !slips.contains("newest-dropped")) {
            keep(kept);
        }
        known++;
        last = source;
        left = state(source);
        time = source.getTime();
        length = deltaT;
    }

    private double[] next(double[] s, double deltaT, double weight, double[] f, double[] older) {
        return Methods.trial(Methods.plus(s, deltaT * weight, f), deltaT, older, before);
    }

    private void keep(double[] f) {
        if (slips.contains("all-the-same") && known >= steps - 1) {
            Arrays.fill(before, f);
            return;
        }
        System.arraycopy(before, 0, before, 1, before.length - 1);
        before[0] = f;
    }

    @Override
    public void reset() {
        known = slips.contains("no-reset") ? known : 0;
        last = slips.contains("no-reset") ? last : null;
    }
}
