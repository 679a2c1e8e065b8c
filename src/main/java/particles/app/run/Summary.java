package particles.app.run;

import deSolvers.catalog.SolverCatalog;
import deSolvers.catalog.SolverInfo;
import deSolvers.text.Digits;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Stream;
import particles.Rule;
import particles.Simulation;
import particles.app.cli.Program;
import particles.energy.EnergyHistory;
import particles.energy.EnergyLedgerRecorder;
import particles.energy.EnergyRecorder;
import particles.law.Violation;
import particles.output.files.OutputException;
import particles.output.files.OutputFolder;
import particles.scene.Scene;
import particles.spec.JsonText;

/**
 * The summary of a run, for people and for run.json.
 *
 * @param name     the name of the scene
 * @param hash     SHA-256 of its file's bytes, in hexadecimal
 * @param set      values that were set in place of the file's, as they were typed; may be empty
 * @param scene    after its run
 * @param recorder its recorded energies
 * @param seconds  the wall-clock time of the run (s)
 */
record Summary(String name, String hash, String set, Scene scene, EnergyRecorder recorder, double seconds) {
    /** An error above this part of the energy scale gives a warning: a tenth shows in the motion. */
    private static final double LARGE_ERROR = 0.1;
    /** A larger violation of a rod, wire or contact, relative to its scale, gives a warning. */
    private static final double VIOLATION = 1e-3;
    /** Events per simulated second beyond which soft balls are cheaper. */
    private static final double MANY_EVENTS = 3000;
    /** Energies below this part of the energy scale are round-off. */
    private static final double ROUND_OFF = 1e-15;

    /** A smaller folder is not reported (bytes). */
    static final long LARGE = 50_000_000;
    private static final long MEGABYTE = 1_000_000;

    /** The file's name. */
    static final String FILE = "run.json";

    private Simulation simulation() {
        return scene.simulation();
    }

    private EnergyHistory energy() {
        return recorder.getHistory();
    }

    private EnergyLedgerRecorder books() {
        return recorder.getLedger();
    }

    /** @return the text of {@link #FILE}; energies in J, times in s, relative errors in units of the energy scale */
    String json() {
        Map<String, Object> energies = JsonText.map("start", energy().getStart(), "end", energy().getEnd(),
                "scale", recorder.getScale(), "relativeDrift", relative(energy().getEnd() - energy().getStart()),
                "largestRelativeDrift", relative(energy().getLargestDrift()),
                "numericalError", books().getNumericalError(),
                "relativeNumericalError", relative(books().getNumericalError()),
                "largestRelativeNumericalError", relative(books().getLargestNumericalError()),
                "work", books().getWork());
        return JsonText.of(JsonText.map("version", Program.VERSION, "scene", name, "sceneSha256", hash,
                "set", set,
                "solver", scene.description().solver(), "deltaT", simulation().getDeltaT(),
                "duration", simulation().getDuration(), "endTime", scene.system().getTime(),
                "steps", simulation().getSteps(), "evaluations", scene.system().getEvaluations(),
                "secondsTaken", seconds, "energy", energies, "java", JsonText.map(
                        "version", Runtime.version().toString(), "vendor", System.getProperty("java.vendor", ""),
                        "machine", System.getProperty("java.vm.name", ""))));
    }

    /** Divides an energy by the energy scale; 0 stays 0, also in a scene without energy. */
    private double relative(double joules) {
        return joules == 0 ? 0 : joules / recorder.getScale();
    }

    /**
     * @param failed whether the run ends with lines that say more of its error
     * @return the summary, a few lines
     */
    List<String> lines(boolean failed) {
        List<String> lines = new ArrayList<>();
        String solverName = scene.description().solver();
        double deltaT = scene.description().deltaT();
        double duration = simulation().getDuration();
        double time = scene.system().getTime();
        lines.add(scene.description().title() + ": " + solverName + ", deltaT = " + Digits.exact(deltaT) + " s");
        boolean endedEarly = time < duration * (1 - 1e-9);
        lines.add(Digits.few(time) + " s"
                + (endedEarly ? " of " + Digits.few(duration) + " s" : "") + " simulated in "
                + counted(simulation().getSteps(), "step") + " with "
                + counted(scene.system().getEvaluations(), "evaluation") + " of the derivative; run time "
                + Digits.few(Math.round(100 * seconds) / 100.0) + " s");
        long divisions = simulation().getDivisions();
        if (divisions > 0) {
            lines.add(solverName + " failed at steps in contact, which were halved " + counted(divisions, "time"));
        }
        if (deltaT > duration && simulation().getSteps() == 1) {
            lines.add("the run is shorter than deltaT: its only step was " + Digits.few(time) + " s long");
        }
        lines.add("energy: " + joules(energy().getStart()) + " at the start, " + joules(energy().getEnd())
                + " at the end; largest change " + joules(energy().getLargestDrift()));
        double error = relative(books().getLargestNumericalError());
        Optional<SolverInfo> solver = SolverCatalog.find(solverName);
        boolean damping = solver.filter(SolverInfo::damping).isPresent();
        boolean damped = damping && books().getNumericalError() < 0;
        boolean ledgers = books().getUncertainty() > books().getLargestNumericalError() / 2;
        boolean blownUp = failed && !(error <= LARGE_ERROR);    // then the scale is that of the error
        lines.add("numerical error: " + (Double.isNaN(error) ? "not a number"
                : "at most " + joules(books().getLargestNumericalError())) + (blownUp ? ""
                : " (" + Digits.few(error) + " of the energy scale, " + joules(recorder.getScale()) + ")")
                + (damped ? ", by numerical damping" : "")
                + (ledgers ? ", mostly that of the ledger's own integrals" : ""));
        if (error > LARGE_ERROR && !endedEarly && !failed && !damped) {
            boolean sure = books().getLargestNumericalError() - books().getUncertainty()
                    > LARGE_ERROR * recorder.getScale();
            lines.add(sure ? "warning: the numerical error is " + share(error)
                    + " the energy; do not trust this motion. Try a smaller deltaT or another solver."
                    : "note: the energy ledger cannot resolve this motion, as the sub-steps of " + solverName
                    + " are too long for it; the error may be the ledger's own. A smaller deltaT tells.");
        }
        if (error > LARGE_ERROR && damped) {
            lines.add("warning: numerical damping took " + share(error)
                    + " the energy scale; a smaller deltaT loses less.");
        }
        if (recorder.isTooCoarse() && !failed && !damping && solver.filter(SolverInfo::adaptive).isEmpty()) {
            lines.add("warning: not resolved: the fastest visible vibration has fewer than 6 steps per period; try a"
                    + " smaller deltaT, or a solver that chooses its own sub-steps.");
        }
        recorder.getBrief().filter(brief -> !failed).ifPresent(brief -> lines.add("warning: not resolved: "
                + brief.name() + " may come and go within " + Digits.few(brief.time()) + " s; try a deltaT of "
                + Digits.few(brief.longestStep())
                + " s, or a solver that chooses its own sub-steps."));
        Violation violation = simulation().getViolation();
        if (violation.part() > VIOLATION && !failed) {
            lines.add("warning: " + violation.what() + "; try a smaller deltaT or another solver.");
        }
        long waiting = simulation().getRules().stream().mapToLong(Rule::getWaiting).sum();
        if (waiting > 0) {
            lines.add(counted(waiting, "birth") + " of 'emitter' waited for room until the end");
        }
        if (scene.description().hasHardBalls() && simulation().getEvents() > MANY_EVENTS * time) {
            lines.add("warning: " + simulation().getEvents() + " impacts and changes of contact, each located by extra"
                    + " steps; for so many contacts the effect 'repulsion' (soft balls) is cheaper.");
        }
        return lines;
    }

    /** Formats an energy; round-off relative to the energy scale is shown as 0. */
    private String joules(double value) {
        return (Math.abs(value) < ROUND_OFF * recorder.getScale() ? "0" : Digits.few(value)) + " J";
    }

    /** An error beside the energy scale: a part of it, or from 100 % on an energy. */
    private String share(double error) {
        return error < 1 ? Math.round(100 * error) + " % of"
                : joules(books().getLargestNumericalError()) + ", " + Digits.few(error) + " times";
    }

    /** @return a number of things, in words */
    static String counted(long count, String thing) {
        return count + " " + thing + (count == 1 ? "" : "s");
    }

    /**
     * Measures the disk space of a run's results.
     *
     * @param folder the folder of the results
     * @param option the option that draws frames, as typed
     * @return a line if they are large
     * @throws OutputException if the folder cannot be read
     */
    static Optional<String> sizeNotice(Path folder, String option) {
        long all = bytes(folder);
        Path frames = folder.resolve(OutputFolder.FRAMES);
        long pictures = Files.isDirectory(frames) ? bytes(frames) : 0;
        return all < LARGE ? Optional.empty() : Optional.of("this run wrote " + all / MEGABYTE + " MB"
                + (pictures == 0 ? "" : ", " + pictures / MEGABYTE + " MB of it frames; " + option
                + "=false writes none"));
    }

    private static long bytes(Path folder) {
        try (Stream<Path> files = Files.walk(folder)) {
            return files.filter(Files::isRegularFile).mapToLong(file -> file.toFile().length()).sum();
        } catch (IOException e) {
            throw new OutputException(folder, "read", e);
        }
    }
}
