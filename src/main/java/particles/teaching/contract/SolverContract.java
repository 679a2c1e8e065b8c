package particles.teaching.contract;

import deSolvers.DESolver;
import java.util.ArrayList;
import java.util.List;
import java.util.OptionalDouble;
import java.util.function.Supplier;
import particles.teaching.EndlessLoop;
import particles.teaching.Finding;
import particles.teaching.Finding.Kind;
import particles.teaching.Formula;
import particles.teaching.StudentFailure;
import particles.teaching.sources.Probe;
import particles.teaching.sources.WindyOscillators;

/**
 * Checks the rules that hold for every solver, whatever its formula: each step begins at the source's own state, and
 * one solver may step any number of sources.
 */
public final class SolverContract {
    private static final double H = 1.0 / 16;
    private static final double ALIKE = 1e-2;
    private static final int MOST = 2000;
    private static final double TINY = 1e-12;
    private static final int SOME = 40;
    private static final int MANY = 200;

    private final Supplier<DESolver> maker;
    private final List<Finding> findings = new ArrayList<>();

    private SolverContract(Supplier<DESolver> maker) {
        this.maker = maker;
    }

    /**
     * @param memory its memory
     * @return its mistakes, and advice
     */
    public static List<Finding> check(SolverMemory memory) {
        SolverContract contract = new SolverContract(memory.maker());
        memory.mistake().ifPresentOrElse(contract.findings::add, contract::checkMany);
        if (contract.findings.isEmpty() && memory.ignoresTheClock()) {
            contract.note("what is remembered of earlier steps is used although the clock was set from outside: compare"
                    + " source.getTime() as well, since forces may depend on the time");
        }
        contract.checkNegative();
        contract.checkZero();
        if (isForParticles(memory.maker())) {
            contract.note("it works on systems of positions and velocities only, such as particles,"
                    + " and refuses others");
        }
        contract.checkFailure();
        contract.checkNaN();
        return contract.findings;
    }

    private void note(String text) {
        findings.add(new Finding(Kind.STYLE, text));
    }

    private void wrong(String text) {
        findings.add(new Finding(Kind.STATE, text));
    }

    /**
     * A source much larger than that of a first example, of equal particles; smaller where the work in a step grows
     * with the square of the size.
     */
    private void checkMany() {
        WindyOscillators small = new WindyOscillators(1);
        WindyOscillators larger = new WindyOscillators(4);
        maker.get().stepState(small, H);
        maker.get().stepState(larger, H);
        int particles = larger.getEvaluations() > 2 * small.getEvaluations() ? SOME : MANY;
        WindyOscillators source = new WindyOscillators(particles);
        String text = "with a source of " + particles + " particles, " + 6 * particles + " numbers, ";
        String cause = ": an array or a loop has a fixed length; source.getStateSize() has to be asked in every step";
        source.startRecord();
        try {
            maker.get().stepState(source, H);
        } catch (RuntimeException e) {
            wrong(text + "stepState ends in " + StudentFailure.describe(e) + cause);
            return;
        }
        List<double[]> states = new ArrayList<>(source.evaluatedAt());
        states.add(source.getState());
        for (double[] state : states) {
            for (int k = 0; k < state.length; k++) {
                if (!(Math.abs(state[k] - state[k % 6]) <= ALIKE)) {    // differences for a Jacobian are smaller
                    wrong(text + Formula.text("entry %s of a state is %s and entry %s is %s, though all particles are"
                            + " alike", k, state[k], k % 6, state[k % 6]) + cause);
                    return;
                }
            }
        }
    }

    /** @return how far a step moves the state; empty for a refusal, which is noted */
    private OptionalDouble moved(double deltaT, String refused, String more) {
        WindyOscillators source = new WindyOscillators(1);
        double[] before = source.getState();
        try {
            maker.get().stepState(source, deltaT);
            return OptionalDouble.of(distance(before, source.getState()));
        } catch (RuntimeException e) {
            if (!StudentFailure.isRefusal(e)) {
                throw e;
            }
            note("it refuses " + refused + " (" + e.getMessage() + ")" + more);
            return OptionalDouble.empty();
        }
    }

    /** Whether it steps backwards, or says that it does not. */
    private void checkNegative() {
        String or = ": step backwards, or throw an exception that says why not";
        try {
            moved(-H, "a negative deltaT", "").ifPresent(distance -> {
                if (distance == 0) {
                    wrong("a step of negative deltaT does nothing, and says nothing" + or);
                }
            });
        } catch (EndlessLoop e) {
            findings.add(new Finding(Kind.FAILURE, "a step of negative deltaT does not come back, an endless loop" + or
                    + StudentFailure.place(e.getStackTrace())));
        }
    }

    private void checkZero() {
        moved(0, "deltaT = 0", "; the built-in solvers change nothing then").ifPresent(distance -> {
            if (!(distance <= TINY)) {
                boolean finite = Double.isFinite(distance);
                wrong("a step of deltaT = 0 " + (finite ? "moves the state by " + Formula.number(distance)
                        : "makes the state NaN or infinite") + "; it has to change nothing"
                        + (finite ? "" : ". Is something divided by deltaT?"));
            }
        });
    }

    /** @return whether a solver refuses sources without positions and velocities */
    public static boolean isForParticles(Supplier<DESolver> maker) {
        try {
            maker.get().stepState(new Probe(new double[6], 0, (evaluation, dSdt) -> dSdt[0] = TINY, MOST), H);
            return false;
        } catch (RuntimeException e) {
            return !(e instanceof Probe.TooManyEvaluations);    // it works on it, for long
        }
    }

    /** A source that fails has to be heard of. */
    private void checkFailure() {
        for (int evaluation = 0; evaluation < 2; evaluation++) {
            WindyOscillators source = new WindyOscillators(1);
            double[] before = source.getState();
            source.failFromEvaluation(evaluation);
            try {
                maker.get().stepState(source, H);
                if (source.hasFailed()) {
                    wrong("the source threw an exception, and stepState returned as if nothing had happened: do not"
                            + " catch it, so that the caller learns of it");
                    return;
                }
            } catch (RuntimeException expected) {
                if (evaluation > 0 && source.hasFailed()
                        && (distance(before, source.getState()) != 0 || source.getTime() != 0)) {
                    note("when the source fails within a step, state and time stay where they were then;"
                            + " deSolvers.FixedStepSolver puts them back");
                }
            }
        }
    }

    /** The check puts a NaN in, and says so. */
    private void checkNaN() {
        WindyOscillators source = new WindyOscillators(1);
        source.spoilDerivative(MOST);
        String from = "this check made the derivative NaN on purpose, and ";
        try {
            maker.get().stepState(source, H);
            note(from + "the NaN goes unnoticed into the state; deSolvers.FixedStepSolver reports it");
        } catch (EndlessLoop e) {
            note(from + "the step did not come back: end a loop that waits for a small error when the error is NaN");
        } catch (RuntimeException e) {
            if (String.valueOf(e.getMessage()).matches("\\s*|null")) {
                note(from + "the exception that the solver throws says nothing");
            }
        }
    }

    /** @return the largest difference of two entries; NaN if there is one */
    public static double distance(double[] x, double[] y) {
        double distance = 0;
        for (int k = 0; k < x.length; k++) {
            double d = Math.abs(x[k] - y[k]);
            distance = d <= distance ? distance : d;    // NaN stays
        }
        return distance;
    }
}
