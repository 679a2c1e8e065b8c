package particles.app.experiments;

import deSolvers.text.Digits;
import java.util.ArrayList;
import java.util.List;
import particles.app.experiments.Experiment.Run;
import particles.experiments.energy.DriftCharts;
import particles.experiments.energy.EnergyDrift;
import particles.experiments.energy.EnergyDrift.Comparison;
import particles.experiments.runs.CpuClock;
import particles.experiments.runs.SolverChoice;
import particles.experiments.work.CostExercise;
import particles.experiments.work.EffectCost;
import particles.experiments.work.StiffCloth;
import particles.experiments.work.StiffGallery;
import particles.experiments.work.StiffGallery.Cost;
import particles.experiments.work.WorkPrecision;
import particles.experiments.work.WorkProblem;
import particles.output.report.Picture;
import particles.view.DataTable;
import particles.view.Panel;

/** Plans of experiments on solvers and effects. */
final class Experiments {
    /** Decades of stiffness above 1 N/m. */
    private static final int DECADES = 8;
    /** Columns, and rows, of the cloth whose steps are timed, the steps of a round, and the rounds. */
    private static final int COLUMNS = 40;
    private static final int STEPS = 20;
    private static final int ROUNDS = 10;

    private Experiments() {
    }

    static Run energyDrift(DeclaredCommand asked) {
        List<String> first = List.of("euler", "midpoint", "rk4", "verlet", "implicit-midpoint");
        return (folder, progress) -> {
            Comparison comparison = EnergyDrift.compare(asked.scene(), asked.solvers(), progress);
            String title = asked.scene().title() + ": energy error";
            return asked.page(title, List.of(
                    Picture.of("energy-drift", """
                            The size of the energy error over time. At the curves: the largest error. A cross marks \
                            a run that ended early.""",
                            Panel.of(title, List.of(DriftCharts.sizes(comparison.drifts())))).first(first),
                    Picture.of("energy-drift-signed", """
                            The energy error with its sign, as long as it is below 10 %. Solvers whose error leaves \
                            this axis at once, or is too small to be seen on it, are left out. At the curves: the \
                            largest error of the whole run.""",
                            Panel.of(title + ", with its sign", List.of(DriftCharts.small(comparison.drifts()))))
                            .first(first)),
                    List.of(DriftCharts.table(comparison)));
        };
    }

    static Run workPrecision(DeclaredCommand asked) {
        List<String> first = List.of("euler", "midpoint", "rk4", "dormand-prince", "radau");
        return (folder, progress) -> {
            progress.reached(0, "the references");
            List<WorkProblem> problems = asked.problems().stream().map(WorkProblem::of).toList();
            List<WorkPrecision.Run> all = WorkPrecision.measure(problems, asked.solvers(), progress);
            List<Picture> pictures = new ArrayList<>();
            for (WorkProblem solved : problems) {
                List<WorkPrecision.Run> runs = all.stream().filter(run -> run.problem() == solved).toList();
                String caption = solved.title() + " over " + Digits.few(solved.duration()) + " s; reference: "
                        + solved.origin() + ". At the curves: ";
                pictures.add(Picture.of(solved.name() + "-evaluations", caption + "the slope of the three finest runs"
                        + " above round-off, if they are on a line, and in brackets that of theory."
                        + (solved.isStiff() ? " Implicit solvers: of the finest with deltaT over "
                        + Digits.few(solved.stiffDeltaT()) + " s, where the springs are stiff." : ""),
                        WorkPrecision.byEvaluations(runs)).first(first));
                pictures.add(Picture.of(solved.name() + "-time", caption + "the last error.",
                        WorkPrecision.byTime(runs)).first(first));
            }
            List<DataTable> tables = new ArrayList<>(List.of(WorkPrecision.slopeTable(all), WorkPrecision.table(all)));
            if (asked.problems().contains("oscillator")) {
                tables.add(0, CostExercise.table(CostExercise.solve()));
            }
            return asked.page("The error of solvers against their cost", pictures, tables);
        };
    }

    static Run stiffGallery(DeclaredCommand asked) {
        String title = "Two masses on an ever stiffer spring";
        return (folder, progress) -> {
            List<List<Cost>> sweeps = progress.each(asked.solvers(), SolverChoice::label, solver ->
                    StiffGallery.sweep(solver, DECADES));
            return asked.page(title, List.of(Picture.of("stiff-gallery", """
                    Evaluations for an error of 1 % of the swing after 10 s, evaluations of the cheapest stable run, \
                    and what is left of the energy of the stiff vibration, at most in the last tenth of the run. At \
                    the curves: the exponent with which evaluations grow, from k = 1000 on, if three or more runs \
                    have a result. Below: solvers that are never stable, or do not reach 1 % with a million steps.""",
                    Panel.of(title, StiffGallery.charts(sweeps.stream().flatMap(List::stream).toList())))
                    .first(List.of("rk4", "verlet", "backward-euler", "implicit-midpoint", "radau"))),
                    List.of(StiffGallery.table(sweeps)));
        };
    }

    static Run effectCost(DeclaredCommand asked) {
        return (folder, progress) -> {
            List<EffectCost.Cost> costs = EffectCost.measure(COLUMNS, STEPS, ROUNDS, CpuClock::seconds, progress);
            Panel panel = EffectCost.panel(costs);
            return asked.page(panel.title(), List.of(Picture.of("effect-cost", "Time for a step of " + COLUMNS + " x "
                    + COLUMNS + " particles, relative to springs alone, each from the fastest of " + ROUNDS
                    + " rounds: the " + EffectCost.ROWS + " that cost most.", panel)),
                    List.of(EffectCost.table(costs)));
        };
    }

    static Run stiffCloth(DeclaredCommand asked) {
        return (folder, progress) -> {
            List<StiffCloth.Row> rows = StiffCloth.measure(StiffCloth.SWEEP, progress);
            return asked.page("One frame of stiff cloth: rk4 against one implicit step", List.of(Picture.of(
                    "stiff-cloth", "CPU time of a frame, on logarithmic axes; that of linearised-euler is the"
                    + " fastest of four steps.", StiffCloth.panel(rows))), List.of(StiffCloth.table(rows)));
        };
    }
}
