package particles.teaching.solvers;

import deSolvers.DESolver;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.function.Supplier;
import particles.teaching.Finding.Kind;
import particles.teaching.Finding;
import particles.teaching.Formula;
import particles.teaching.StudentFailure;
import particles.teaching.sources.WindyOscillators;

/**
 * Checks the rules that hold for every solver, whatever its formula: each step begins at the source's own state, and
 * one solver may step any number of sources.
 */
final class SolverContract {
    private static final double H = 1.0 / 16;
    /** Two runs of one method differ by rounding only: measured 0 for all of ours. */
    private static final double SAME = 1e-9;
    private static final double ALIKE = 1e-2;
    private static final int STEPS = 6;
    private static final int SOME = 40;
    private static final int MANY = 200;

    private static final String FORGET = ". What is remembered of earlier steps may be used only while source, time, "
            + "state and deltaT are what the"
            + " last step left, and has to be forgotten in reset()";

    private final Supplier<DESolver> maker;
    private final boolean multistep;
    private final List<Finding> findings = new ArrayList<>();

    private SolverContract(Supplier<DESolver> maker, boolean multistep) {
        this.maker = maker;
        this.multistep = multistep;
    }

    /**
     * @param maker     makes a new solver
     * @param multistep whether its steps use earlier ones
     * @return its mistakes, and advice
     */
    static List<Finding> check(Supplier<DESolver> maker, boolean multistep) {
        SolverContract contract = new SolverContract(maker, multistep);
        if (contract.checkOwnCopy()) {
            contract.checkSizes();
            contract.checkTurns();
            contract.checkObjects();
            contract.checkChangedDeltaT();
            contract.checkMany();
        }
        contract.checkZero();
        contract.checkNegative();
        contract.findings.addAll(SolverNotes.of(maker));
        return contract.findings;
    }

    private void note(String text) {
        findings.add(new Finding(Kind.ADVICE, text));
    }

    private void wrong(String text) {
        findings.add(new Finding(Kind.STATE, text));
    }

    /**
     * Checks that after a bounce or another change of the state the next step starts there, whether or not reset() is
     * called.
     */
    private boolean checkOwnCopy() {
        WindyOscillators source = new WindyOscillators(2);
        DESolver solver = maker.get();
        for (int step = 0; step < STEPS; step++) {
            solver.stepState(source, H);
        }
        double[] moved = source.state();
        Arrays.setAll(moved, k -> moved[k] + 1);
        source.setState(moved);
        double[] expected = fresh(source);
        source.startRecord();
        solver.stepState(source, H);
        if (distance(expected, source.state()) <= SAME) {
            return true;
        }
        String from = "the state was set from outside, as a collision does, and the step afterwards ";
        wrong(multistep ? from + "still uses the steps before it" + FORGET
                : source.readStates() == 0 ? from + "does not start there: an array is kept from the step before. "
                + "getState has to"
                + " be called in every step, and the arrays filled anew"
                : !source.hasEvaluated(moved) ? from + "begins with a derivative that was kept from the step before, "
                + "as none is"
                + " asked for at the new state. It may be kept only while state and time are what the last step left"
                : from + "is not the one that a new solver makes: something is kept from the step before" + FORGET);
        return false;
    }

    /** @return the state after a step that a new solver makes from the same place, on a copy of the source */
    private double[] fresh(WindyOscillators source) {
        WindyOscillators twin = source.copy();
        maker.get().stepState(twin, H);
        return twin.state();
    }

    /**
     * A source much larger than that of a first example; smaller where the work in a step grows with the square of the
     * size.
     */
    private void checkMany() {
        WindyOscillators small = new WindyOscillators(1);
        WindyOscillators larger = new WindyOscillators(4);
        maker.get().stepState(small, H);
        maker.get().stepState(larger, H);
        int particles = larger.evaluations() > 2 * small.evaluations() ? SOME : MANY;
        WindyOscillators source = new WindyOscillators(particles);
        String text = "with a source of " + particles + " particles, " + 6 * particles + " numbers, ";
        String cause = ": an array has a fixed length; source.getStateSize() has to be asked in every step";
        try {
            maker.get().stepState(source, H);
        } catch (RuntimeException e) {
            wrong(text + "stepState ends in " + StudentFailure.describe(e) + cause);
            return;
        }
        double[] expected = small.state();
        double[] found = source.state();
        for (int k = 0; k < found.length; k++) {
            if (!(Math.abs(found[k] - expected[k % 6]) <= ALIKE)) {     // an adaptive method may choose other steps
                wrong(text + "entry " + k + " becomes " + Formula.number(found[k])
                        + " where a source of one particle gives "
                        + Formula.number(expected[k % 6]) + cause);
                return;
            }
        }
    }

    /** Whether it steps backwards, or says that it does not. */
    private void checkNegative() {
        WindyOscillators source = new WindyOscillators(1);
        double[] before = source.state();
        try {
            maker.get().stepState(source, -H);
        } catch (RuntimeException e) {
            note("it refuses a negative deltaT (" + e.getMessage() + ")");
            return;
        }
        if (distance(before, source.state()) == 0) {
            wrong("a step of negative deltaT does nothing, and says nothing: step backwards, or throw an exception "
                    + "that says why not");
        }
    }

    private void checkSizes() {
        DESolver solver = maker.get();
        int last = 3;
        for (int pairs : new int[] {3, 6, 3, 1}) {
            WindyOscillators source = new WindyOscillators(pairs);
            double[] expected = fresh(source);
            String text = "the solver stepped a source of " + 6 * last + " numbers and then one of " + 6 * pairs
                    + ", and ";
            String cause = ": the size is cached from the first source. source.getStateSize() has to be asked in every "
                    + "step";
            try {
                solver.stepState(source, H);
            } catch (IndexOutOfBoundsException | NegativeArraySizeException e) {
                wrong(text + "ended in " + e + cause);
                return;
            }
            if (source.wrongLength() >= 0) {
                wrong(text + "handed it an array of " + source.wrongLength() + cause);
                return;
            }
            if (distance(expected, source.state()) > SAME) {
                wrong(text + "the second step is not what a new solver makes" + cause);
                return;
            }
            last = pairs;
        }
    }

    private void checkTurns() {
        DESolver solver = maker.get();
        WindyOscillators one = new WindyOscillators(2);
        WindyOscillators two = new WindyOscillators(2);
        two.incTime(3);
        for (int round = 0; round < 4; round++) {
            for (WindyOscillators source : List.of(one, two)) {
                double[] expected = fresh(source);
                solver.stepState(source, H);
                if (distance(expected, source.state()) > SAME) {
                    wrong("two sources of the same size are stepped in turn, and one disturbs the other: something is "
                            + "kept from the step"
                            + " before (an array that is not filled anew, a derivative that is not asked for again)");
                    return;
                }
            }
        }
    }

    /** A search for an impact steps with a solver of its own, in between. */
    private void checkObjects() {
        WindyOscillators alone = new WindyOscillators(1);
        WindyOscillators one = alone.copy();
        WindyOscillators two = alone.copy();
        two.incTime(3);
        DESolver solver = maker.get();
        DESolver first = maker.get();
        DESolver second = maker.get();
        for (int step = 0; step < STEPS; step++) {
            solver.stepState(alone, H);
        }
        for (int step = 0; step < STEPS; step++) {
            first.stepState(one, H);
            second.stepState(two, H);
        }
        if (distance(alone.state(), one.state()) > SAME) {
            wrong("two solvers of this class step in turn, each its own source, and one disturbs the other: something"
                    + " is static, and shared by all of them");
        }
    }

    /** The simulation shortens the last step before an event, so that deltaT changes from step to step. */
    private void checkChangedDeltaT() {
        DESolver solver = maker.get();
        WindyOscillators source = new WindyOscillators(1);
        for (double deltaT : new double[] {H, H, H / 4, H / 2}) {
            WindyOscillators twin = source.copy();
            maker.get().stepState(twin, deltaT);
            boolean changed = source.getTime() > H;
            solver.stepState(source, deltaT);
            if (changed && distance(twin.state(), source.state()) > SAME) {
                wrong("deltaT changes from one step to the next, and the step is not the one that a new solver makes "
                        + "with it"
                        + (multistep ? FORGET : ": deltaT of an earlier step is kept. It is an argument of each call, "
                        + "and may differ in each"));
                return;
            }
        }
    }

    private void checkZero() {
        WindyOscillators source = new WindyOscillators(1);
        double[] before = source.state();
        maker.get().stepState(source, 0);
        double change = distance(before, source.state());
        if (change > 1e-12 && Double.isFinite(change)) {
            wrong("a step of deltaT = 0 moves the state by " + Formula.number(change) + "; it has to change nothing");
        } else if (!Double.isFinite(change)) {
            wrong("a step of deltaT = 0 makes the state NaN or infinite; it has to change nothing. Is something "
                    + "divided by deltaT?");
        }
    }

    static double distance(double[] x, double[] y) {
        double distance = 0;
        for (int k = 0; k < x.length; k++) {
            double d = Math.abs(x[k] - y[k]);
            distance = d <= distance ? distance : d;    // NaN stays
        }
        return distance;
    }
}
