package particles.app.run;

import deSolvers.catalog.SolverCatalog;
import deSolvers.catalog.SolverInfo;
import deSolvers.text.Digits;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import particles.Simulation;
import particles.app.cli.Version;
import particles.energy.EnergyHistory;
import particles.energy.EnergyLedgerRecorder;
import particles.energy.EnergyRecorder;
import particles.law.Violation;
import particles.output.files.RunSummary;
import particles.scene.Scene;

/** The summary of a run, for people and for run.json. */
final class Summary {
    /** An error above this part of the energy scale gives a warning: a tenth shows in the motion. */
    private static final double LARGE_ERROR = 0.1;
    /** A larger violation of a rod, wire or contact, relative to its scale, gives a warning. */
    private static final double VIOLATION = 1e-3;
    /** Energies below this part of the energy scale are round-off. */
    private static final double ROUND_OFF = 1e-15;

    private final Scene scene;
    private final RunSummary record;
    private final boolean tooCoarse;
    private final double uncertainty;

    /**
     * @param name     the name of the scene
     * @param hash    the hash of its file
     * @param scene   after its run
     * @param recorder its recorded energies
     * @param seconds the wall-clock time of the run (s)
     */
    Summary(String name, String hash, Scene scene, EnergyRecorder recorder, double seconds) {
        this.scene = scene;
        tooCoarse = recorder.isTooCoarse();
        EnergyHistory energy = recorder.getHistory();
        EnergyLedgerRecorder books = recorder.getLedger();
        uncertainty = books.getUncertainty();
        Simulation simulation = scene.simulation();
        record = new RunSummary(name, hash, scene.description().solver(), simulation.getDeltaT(),
                simulation.getDuration(), scene.system().getTime(), Version.CURRENT, simulation.getSteps(),
                scene.system().getEvaluations(), seconds, energy.getStart(), energy.getEnd(), energy.getScale(),
                energy.getLargestDrift(), books.getWork(), books.getNumericalError(), books.getLargestNumericalError());
    }

    RunSummary record() {
        return record;
    }

    /**
     * @param failed whether the run ends with lines that say more of its error
     * @return the summary, a few lines
     */
    List<String> lines(boolean failed) {
        List<String> lines = new ArrayList<>();
        lines.add(scene.description().title() + ": " + record.solver() + ", deltaT = "
                + Digits.exact(record.deltaT()) + " s");
        boolean endedEarly = record.endTime() < record.duration() * (1 - 1e-9);
        lines.add(Digits.few(record.endTime()) + " s"
                + (endedEarly ? " of " + Digits.few(record.duration()) + " s" : "") + " simulated in "
                + counted(record.steps(), "step") + " with " + counted(record.evaluations(), "evaluation")
                + " of the derivative; run time "
                + Digits.few(Math.round(100 * record.secondsTaken()) / 100.0) + " s");
        if (record.deltaT() > record.duration() && record.steps() == 1) {
            lines.add("the run is shorter than deltaT: its only step was " + Digits.few(record.endTime()) + " s long");
        }
        lines.add("energy: " + joules(record.startEnergy()) + " at the start, " + joules(record.endEnergy())
                + " at the end; largest change " + joules(record.largestEnergyDrift()));
        double error = record.largestRelativeNumericalError();
        Optional<SolverInfo> solver = SolverCatalog.find(record.solver());
        boolean damping = solver.filter(SolverInfo::damping).isPresent();
        boolean damped = damping && record.numericalError() < 0;
        boolean blownUp = failed && !(error <= LARGE_ERROR);    // then the scale is that of the error
        lines.add("numerical error: " + (Double.isNaN(error) ? "not a number"
                : "at most " + joules(record.largestNumericalError())) + (blownUp ? ""
                : " (" + Digits.few(error) + " of the energy scale, " + joules(record.energyScale()) + ")")
                + (damped ? ", by numerical damping" : ""));
        if (error > LARGE_ERROR && !endedEarly && !failed && !damped) {
            boolean sure = record.largestNumericalError() - uncertainty > LARGE_ERROR * record.energyScale();
            lines.add(sure ? "warning: the numerical error is " + share(error)
                    + " the energy; do not trust this motion. Try a smaller deltaT or another solver."
                    : "note: the energy ledger cannot resolve this motion, as the sub-steps of " + record.solver()
                    + " are too long for it; the error may be the ledger's own. A smaller deltaT tells.");
        }
        if (error > LARGE_ERROR && damped) {
            lines.add("warning: numerical damping took " + share(error)
                    + " the energy scale; a smaller deltaT loses less.");
        }
        if (tooCoarse && !failed && !damping && solver.filter(SolverInfo::adaptive).isEmpty()) {
            lines.add("warning: not resolved: the fastest visible vibration has fewer than 6 steps per period; try a"
                    + " smaller deltaT, or a solver that chooses its own sub-steps.");
        }
        Violation violation = scene.simulation().getViolation();
        if (violation.part() > VIOLATION && !failed) {
            lines.add("warning: " + violation.what() + "; a smaller deltaT or another solver keeps it better.");
        }
        return lines;
    }

    /** Formats an energy; round-off relative to the energy scale is shown as 0. */
    private String joules(double energy) {
        return (Math.abs(energy) < ROUND_OFF * record.energyScale() ? "0" : Digits.few(energy)) + " J";
    }

    /** An error beside the energy scale: a part of it, or from 100 % on an energy. */
    private String share(double error) {
        return error < 1 ? Math.round(100 * error) + " % of"
                : joules(record.largestNumericalError()) + ", " + Digits.few(error) + " times";
    }

    private static String counted(long count, String thing) {
        return count + " " + thing + (count == 1 ? "" : "s");
    }
}
