package particles.app.cli;

import java.util.List;
import particles.output.charts.ChartFormat;
import picocli.CommandLine.Option;

/** The options for the charts of runs and experiments. */
public final class ChartOptions {
    private static final String SLIDE = "--slide";
    private static final String SVG = "--svg";
    private static final String DARK = "--dark";

    @Option(names = SLIDE, arity = "0..1", paramLabel = "true|false",
            description = "Draws each chart as a slide: 16:9, large type, at most five curves; slides.pdf has all of"
            + " them (default: ${DEFAULT-VALUE}).")
    private boolean slide;

    @Option(names = SVG, arity = "0..1", paramLabel = "true|false",
            description = "Writes each chart as an SVG file, too (default: ${DEFAULT-VALUE}).")
    private boolean svg;

    @Option(names = DARK, arity = "0..1", paramLabel = "true|false",
            description = "Draws charts on black, for a dark room (default: ${DEFAULT-VALUE}).")
    private boolean dark;

    /** @return the format of the charts */
    public ChartFormat format() {
        return new ChartFormat(slide, svg, dark);
    }

    /** @return the options as they are typed for another command */
    public List<String> arguments() {
        return List.of(SLIDE + "=" + slide, SVG + "=" + svg, DARK + "=" + dark);
    }
}
