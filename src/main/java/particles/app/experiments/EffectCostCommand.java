package particles.app.experiments;

import java.util.List;
import particles.experiments.runs.CpuClock;
import particles.experiments.runs.ProgressListener;
import particles.experiments.work.EffectCost;
import particles.experiments.work.EffectCost.Cost;
import particles.output.files.OutputFolder;
import particles.output.report.Picture;
import particles.output.report.ResultPage;
import particles.view.Panel;
import picocli.CommandLine.Command;
import picocli.CommandLine.Option;

/** {@code gradle effectCost}: measures the time that each effect and rule adds to a step. */
@Command(name = "effectCost",
        description = "Measures what each effect adds to the time of a step.")
public final class EffectCostCommand extends ExperimentCommand {
    private static final int MOST_COLUMNS = 500;
    private static final int STEPS = 20;

    @Option(names = "--columns", paramLabel = "NUMBER",
            description = "The number of columns and of rows of the cloth (default: ${DEFAULT-VALUE}).")
    private int columns = 40;

    @Option(names = "--rounds", paramLabel = "NUMBER",
            description = "The number of rounds, each with 20 steps of every variant (default: ${DEFAULT-VALUE}).")
    private int rounds = 40;

    @Override
    protected void read(Mistakes mistakes) {
        mistakes.check(() -> requireWithin("columns", columns, 2, MOST_COLUMNS));
        mistakes.check(() -> requireWithin("rounds", rounds, 1, Integer.MAX_VALUE));
        super.read(mistakes);
    }

    @Override
    protected ResultPage measure(OutputFolder folder, ProgressListener progress) {
        List<Cost> costs = EffectCost.measure(columns, STEPS, rounds,
                () -> Math.round(1e9 * CpuClock.seconds()), progress);
        Panel panel = EffectCost.panel(costs);
        return new ResultPage(name(), panel.title(),
                List.of("A scene pays for what it names and for nothing else: this is a cloth of "
                        + columns + " x " + columns + " particles, rk4, with one thing more at a time.",
                        "Springs alone take " + EffectCost.overLoop(costs) + " times as long as four passes of a"
                        + " plain loop, one for each evaluation of rk4. Each bar is the fastest of " + rounds
                        + " rounds of " + STEPS + " steps, in CPU time; all variants take turns."),
                List.of(Picture.of("effect-cost",
                        "Time of a step, relative to springs alone, on a logarithmic axis.", panel)),
                List.of(EffectCost.table(costs)));
    }
}
