package particles.app;

import java.util.ArrayList;
import java.util.List;
import particles.Simulation;
import particles.experiments.EnergyBooks;
import particles.experiments.EnergyHistory;
import particles.output.RunSummary;
import particles.scene.Scene;

/** What a run was and how it went, for people and for run.json. */
final class Summary {
    private final Scene scene;
    private final RunSummary record;

    /**
     * @param name    of the scene
     * @param scene   after its run
     * @param energy  what was seen of its energy
     * @param books   its ledger
     * @param seconds how long the run took (s)
     */
    Summary(String name, Scene scene, EnergyHistory energy, EnergyBooks books, double seconds) {
        this.scene = scene;
        Simulation simulation = scene.simulation();
        record = new RunSummary(name, scene.description().sha256(), scene.description().solver(), simulation.getDeltaT(),
                simulation.getDuration(), scene.system().getTime(), Version.CURRENT, simulation.getSteps(),
                scene.system().getEvaluations(), seconds, energy.getStart(), energy.getEnd(), energy.getScale(),
                energy.getLargestDrift(), books.getWork(), books.getNumericalError(), books.getLargestNumericalError());
    }

    RunSummary record() {
        return record;
    }

    /** @return a few lines */
    List<String> lines() {
        List<String> lines = new ArrayList<>();
        lines.add(scene.description().title() + ": " + record.solver() + ", deltaT = " + Digits.exact(record.deltaT()) + " s");
        lines.add(Digits.few(record.endTime()) + " s" + (record.endTime() < record.duration() * (1 - 1e-9)
                ? " of " + Digits.few(record.duration()) + " s" : "") + " in " + counted(record.steps(), "step") + " with "
                + counted(record.evaluations(), "evaluation") + " of the derivative; it took "
                + Digits.few(Math.round(100 * record.secondsTaken()) / 100.0) + " s");
        lines.add("energy " + Digits.few(record.startEnergy()) + " J at the start, " + Digits.few(record.endEnergy())
                + " J at the end; its largest drift is " + Digits.few(record.largestRelativeDrift()) + " of the energy scale, "
                + Digits.few(record.energyScale()) + " J");
        lines.add("of that, physics explains all but " + Digits.few(record.largestRelativeNumericalError())
                + " of the energy scale at most: the numerical error");
        return lines;
    }

    private static String counted(long count, String thing) {
        return count + " " + thing + (count == 1 ? "" : "s");
    }
}
