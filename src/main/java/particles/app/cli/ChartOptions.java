package particles.app.cli;

import particles.output.charts.ChartFormat;
import picocli.CommandLine.Option;

/** The options for the charts of runs and experiments. */
public final class ChartOptions {
    @Option(names = "--slide", arity = "0..1", paramLabel = "true|false",
            description = "Draws each chart as a slide: 16:9, large type, at most five curves; slides.pdf has all of"
            + " them (default: ${DEFAULT-VALUE}).")
    private boolean slide;

    @Option(names = "--svg", arity = "0..1", paramLabel = "true|false",
            description = "Writes each chart as an SVG file, too (default: ${DEFAULT-VALUE}).")
    private boolean svg;

    @Option(names = "--dark", arity = "0..1", paramLabel = "true|false",
            description = "Draws charts on black, for a dark room (default: ${DEFAULT-VALUE}).")
    private boolean dark;

    /** @return the format of the charts */
    public ChartFormat format() {
        return new ChartFormat(slide, svg, dark);
    }
}
