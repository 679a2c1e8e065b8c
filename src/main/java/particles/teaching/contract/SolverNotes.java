package particles.teaching.contract;

import deSolvers.DESolver;
import java.util.ArrayList;
import java.util.List;
import java.util.function.Supplier;
import particles.teaching.EndlessLoop;
import particles.teaching.Finding;
import particles.teaching.Finding.Kind;
import particles.teaching.sources.Probe;
import particles.teaching.sources.WindyOscillators;

/** Notes on the sources that a solver refuses, and on its behaviour when the source fails. */
final class SolverNotes {
    private static final double H = 1.0 / 16;
    private static final int MOST = 2000;
    private static final double TINY = 1e-12;

    private final Supplier<DESolver> maker;
    private final List<Finding> findings = new ArrayList<>();

    private SolverNotes(Supplier<DESolver> maker) {
        this.maker = maker;
    }

    /** @return the notes on solvers of this kind */
    static List<Finding> of(Supplier<DESolver> maker) {
        SolverNotes notes = new SolverNotes(maker);
        notes.checkPlain();
        notes.checkFailure();
        notes.checkNaN();
        return notes.findings;
    }

    private void note(String text) {
        findings.add(new Finding(Kind.STYLE, text));
    }

    /** Whether sources without positions and velocities will do. */
    private void checkPlain() {
        try {
            maker.get().stepState(new Probe(new double[6], 0, (evaluation, dSdt) -> dSdt[0] = TINY, MOST), H);
        } catch (Probe.TooManyEvaluations e) {
            return;                                     // it works on it, for long
        } catch (RuntimeException e) {
            note("it works on systems of positions and velocities only, such as particles, and refuses others");
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
                    findings.add(new Finding(Kind.STATE, "the source threw an exception, and stepState returned as if"
                            + " nothing had happened: do not catch it, so that the caller learns of it"));
                    return;
                }
            } catch (RuntimeException expected) {
                if (evaluation > 0 && source.hasFailed()
                        && (SolverContract.distance(before, source.getState()) != 0 || source.getTime() != 0)) {
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
}
