package particles.app.experiments;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import deSolvers.catalog.SolverCatalog;
import java.awt.Graphics2D;
import java.awt.geom.Line2D;
import java.awt.geom.Path2D;
import java.util.ArrayList;
import java.util.List;
import java.util.function.Consumer;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.MethodSource;
import particles.app.Main;
import particles.app.cli.OptionStyle;
import particles.app.run.StopRequest;
import particles.experiments.work.EffectCost;
import particles.experiments.work.EffectCost.Cost;
import particles.output.charts.ChartFormat;
import particles.output.charts.ChartPage;
import particles.output.charts.Layout;
import particles.output.charts.PageRecorder;
import particles.output.files.OutputFolder;
import particles.output.report.Picture;
import particles.output.report.ResultPage;
import particles.view.Axis;
import particles.view.Chart;
import particles.view.Look;
import particles.view.Panel;
import particles.view.Series;
import particles.view.Series.Mark;
import picocli.CommandLine;

/** What is wrong with the layout of a chart is seen: boxes, type, labels and titles, as data. */
class ChartLayoutTest {
    private static final ChartFormat SLIDE = new ChartFormat(true, false, false);
    private static final Look RK4 = Look.of(SolverCatalog.info("rk4"));
    private static final Axis HEIGHT = Axis.linear("height", "m");
    private static final Panel LINE = Panel.of("A stone", List.of(new Chart(Axis.TIME, HEIGHT,
            List.of(new Series(RK4, "rk4", Mark.LINE, new double[] {0, 1}, new double[] {0, 1}).ending(HEIGHT)))));

    /** @return what is wrong with the charts of a page, as page and as slide; empty if nothing is */
    static List<String> faults(ResultPage page) {
        List<String> faults = new ArrayList<>();
        for (ChartFormat format : List.of(ChartFormat.PAGE, SLIDE)) {
            for (Picture picture : page.laidOut(format).pictures()) {
                String where = (format.slide() ? "slide " : "page ") + picture.name() + ": ";
                picture.page(format).ifPresent(drawn -> Layout.faults(drawn, picture.panels(), format)
                        .forEach(fault -> faults.add(where + fault)));
            }
        }
        return faults;
    }

    static ResultPage measured(String task, OutputFolder folder) {
        List<String> words = List.of(task.split(" "));
        ExperimentCommand command = (ExperimentCommand) Main.commands(new StopRequest()).stream().filter(one ->
                new CommandLine(one).getCommandName().equals(words.get(0))).findFirst().orElseThrow();
        new CommandLine(command).parseArgs(words.subList(1, words.size()).toArray(String[]::new));
        assertEquals(List.of(), command.mistakes(OptionStyle.GRADLE));
        return command.measure(folder, (part, what) -> { });
    }

    static Stream<Arguments> broken() {
        Line2D leader = new PageRecorder(ChartPage.of(LINE, SLIDE)).leaders().get(0);
        return Stream.of(
                Arguments.of("covers the end of a curve", (Consumer<Graphics2D>) g -> {
                    g.draw(new Path2D.Double(new Line2D.Double(300, 200, 400, 250)));
                    g.drawString("on the point", 370, 253);
                }),
                Arguments.of("covers the line to a name", (Consumer<Graphics2D>) g ->
                        g.drawString("o", (float) leader.getX2() - 7, (float) leader.getY2() + 3)),
                Arguments.of("runs into", (Consumer<Graphics2D>) g -> g.drawString("of the rows", 300, 20)),
                Arguments.of("leaves the page", (Consumer<Graphics2D>) g -> g.drawString("far out", 620, 300)),
                Arguments.of("crosses the frame", (Consumer<Graphics2D>) g -> g.drawString("in the way", 520, 150)),
                Arguments.of("type of", (Consumer<Graphics2D>) g -> {
                    g.scale(0.5, 0.5);
                    g.drawString("tiny", 1000, 700);
                }));
    }

    @ParameterizedTest
    @MethodSource("broken")
    void whatIsInTheWayIsSeen(String fault, Consumer<Graphics2D> besides) {
        ChartPage page = ChartPage.of(LINE, SLIDE);
        assertEquals(List.of(), Layout.faults(page, List.of(LINE), SLIDE));
        List<String> faults = Layout.faults(new ChartPage(page.width(), page.height(),
                page.drawing().andThen(besides)), List.of(LINE), SLIDE);
        assertTrue(faults.size() > 0 && faults.stream().allMatch(line -> line.contains(fault)), faults.toString());
    }

    /**
     * From 1.2 to 1.8 a logarithmic axis has no power of ten, and 5e-3 to 5e-2 one; both get labels between. Beside the
     * long name there is no room for 0.0002 after 0.0001.
     */
    @ParameterizedTest
    @CsvSource(textBlock = """
            rk4, 1.2, 1.8
            rk4, 5e-3, 5e-2
            rk4, 1e-17, 1e3
            rk4, 0.9, 110
            linearised-euler, 1.2e-5, 9e-3
            """)
    void logarithmicAxesHaveThreeLabels(String solver, double low, double high) {
        Panel panel = Panel.of("A stone", List.of(new Chart(Axis.log("time", "s"), Axis.log("height", "m"),
                List.of(new Series(RK4, solver, Mark.LINE, new double[] {low, high}, new double[] {low, high},
                        "1.02 (1)")))));
        assertEquals(List.of(), Layout.faults(ChartPage.of(panel, SLIDE), List.of(panel), SLIDE));
    }

    /** As in the stiff gallery: the label of the third chart is longer than the chart's share of a page. */
    @Test
    void labelsOfChartsAboveEachOtherDoNotMeet() {
        List<Chart> charts = Stream.of("evaluations for 1 % error of the swing", "evaluations to be stable",
                "fast-mode energy, end / start (\u2265 1e-16)").map(quantity -> new Chart(
                Axis.log("stiffness", "N/m"), Axis.log(quantity, ""), List.of(new Series(RK4, "rk4", Mark.LINE,
                new double[] {1, 1e8}, new double[] {1, 1e8})))).toList();
        Panel panel = Panel.of("A spring", charts);
        assertEquals(List.of(), Layout.faults(ChartPage.of(panel, ChartFormat.PAGE), List.of(panel),
                ChartFormat.PAGE));
    }

    /** From 0.95 to 2.6 there were labels at 0.95, 0.96 ... 1, one over the other. */
    @ParameterizedTest
    @CsvSource({"0.5, 1", "0.95, 1", "0.955, 2.6", "0.97, 1.3", "0.9925, 1.002", "0.999, 40", "1.001, 1.003"})
    void costsNearOneHaveLabelsApart(double cheap, double dear) {
        Panel panel = EffectCost.panel(List.of(new Cost("springs", 1, 1), new Cost("gravity", cheap, cheap),
                new Cost("drag in turbulence", dear, dear)));
        for (ChartFormat format : List.of(ChartFormat.PAGE, SLIDE)) {
            assertEquals(List.of(), Layout.faults(ChartPage.of(panel, format), List.of(panel), format));
        }
    }
}
