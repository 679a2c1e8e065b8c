package particles.app.experiments;

import static java.util.stream.Collectors.groupingBy;
import static java.util.stream.Collectors.toList;

import deSolvers.text.DidYouMean;
import deSolvers.text.Digits;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.function.Supplier;
import java.util.stream.IntStream;
import particles.experiments.phase.Coordinate;
import particles.experiments.phase.PhasePortraits;
import particles.experiments.phase.PhasePortraits.Portrait;
import particles.experiments.phase.PhasePortraits.Portrait.Subject;
import particles.experiments.phase.PhasePortraits.Portraits;
import particles.experiments.runs.ProgressListener;
import particles.law.Particles;
import particles.output.files.OutputFolder;
import particles.output.report.Picture;
import particles.output.report.ResultPage;
import particles.scene.Scene;
import particles.scene.SceneBuilder;
import particles.scene.format.OutputDescription.Phase;
import particles.view.Chart;
import particles.view.Panel;
import particles.view.Series;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;

/** {@code gradle phasePlots}: phase portraits of a scene by several solvers. */
@Command(name = "phasePlots",
        description = "Draws phase portraits of a scene: several solvers over a reference solution.")
public final class PhasePlotsCommand extends ExperimentCommand {
    @Mixin
    private final SceneOptions options = new SceneOptions();

    @Option(names = "--particles", paramLabel = "IDS", split = ";",
            description = "Particles, separated by semicolons (default: the one of the scene's own phase plot).")
    private List<String> particles = List.of();

    @Option(names = "--axes", paramLabel = "AXES",
            description = "Of x, y and z, as xy (default: that of the scene's own phase plot).")
    private String axes;

    @Option(names = "--about", paramLabel = "ID",
            description = "Draws angles about this particle, not positions along"
                    + " axes (default: that of the scene's own phase plot).")
    private String about;

    private Supplier<List<String>> chosenParticles;
    private Supplier<List<Coordinate>> chosenAxes;
    private Supplier<Optional<String>> pivot;

    @Override
    protected void read(Mistakes mistakes) {
        options.read(mistakes, this, "euler-spiral", "euler,symplectic-euler,rk4");
        Supplier<Scene> scene = mistakes.value(() -> SceneBuilder.build(options.scene()));
        chosenParticles = mistakes.value(() -> ids(scene.get()));
        chosenAxes = mistakes.value(() -> axes(phase()));
        pivot = mistakes.value(() -> readAbout(scene.get()));
        super.read(mistakes);
    }

    private Optional<String> readAbout(Scene scene) {
        if (about != null) {                            // picocli leaves an option null that was not given
            checkKnown("about", about, scene);
            if (axes != null) {
                throw wrong("about", "an angle has no axis; leave " + getStyle().option("axes") + " out");
            }
        }
        Optional<String> id = chosenAxes.get().contains(Coordinate.ANGLE) && about == null
                ? phase().flatMap(Phase::about) : Optional.ofNullable(about);
        if (id.filter(chosenParticles.get()::contains).isPresent()) {
            throw wrong("about", "'" + id.get() + "' has no angle about itself; choose another particle");
        }
        return id;
    }

    private Optional<Phase> phase() {
        return options.scene().output().phase();
    }

    private void checkKnown(String option, String id, Scene scene) {
        Particles all = scene.system().getParticles();
        List<String> known = IntStream.range(0, all.count()).mapToObj(all::id).toList();
        if (!known.contains(id)) {
            throw wrong(option, "the scene has no particle '" + id + "'" + DidYouMean.hint(id, known,
                    "'%s'"::formatted)
                    + " it has " + known.size() + ", from '" + known.get(0) + "' to '"
                    + known.get(known.size() - 1) + "'");
        }
    }

    private List<String> ids(Scene scene) {
        Particles all = scene.system().getParticles();
        particles.forEach(id -> checkKnown("particles", id, scene));
        return particles.isEmpty()
                ? List.of(phase().map(Phase::particle).orElseGet(() -> all.id(lastFree(all))))
                : particles;
    }

    /** The last free particle at the start; particles that are born later have no complete path. */
    private int lastFree(Particles all) {
        return all.free().max().orElseThrow(() ->
                wrong("scene", "at its start this scene has no free particle, so there is no path to draw"));
    }

    /** The axes wanted; none for the axis along which a particle goes farthest. */
    private List<Coordinate> axes(Optional<Phase> plot) {
        if (about != null) {
            return List.of(Coordinate.ANGLE);
        }
        if (axes == null) {
            return plot.map(phase -> List.of(Coordinate.values()[phase.axis()])).orElse(List.of());
        }
        if (!axes.matches("[xyz]+")) {
            throw wrong("axes", "'" + axes + "' has to be made of the letters x, y and z");
        }
        return Arrays.stream(axes.split("")).distinct().map(letter ->
                Coordinate.valueOf(letter.toUpperCase(Locale.ROOT))).toList();
    }

    @Override
    protected ResultPage measure(OutputFolder folder, ProgressListener progress) {
        Portraits portraits = PhasePortraits.compare(options.scene(), options.solvers(), chosenParticles.get(),
                chosenAxes.get(), pivot.get(), progress);
        boolean angle = chosenAxes.get().contains(Coordinate.ANGLE);
        String caption = (angle ? "Angular velocity over angle." : "Velocity over position.")
                + " The pale band is the reference, dormand-prince with a tolerance of 1e-10. A cross is the"
                + " end of a run that stopped, or the place where a path leaves the picture.";
        String step = ", deltaT = " + Digits.exact(options.scene().deltaT()) + " s";
        String title = options.scene().title() + ": phase portraits" + step;
        Map<Subject, List<Portrait>> subjects = portraits.portraits().stream().collect(groupingBy(Portrait::subject,
                LinkedHashMap::new, toList()));
        List<Panel> panels = new ArrayList<>();
        for (List<Portrait> same : subjects.values()) {     // one particle's portraits are compared
            List<Chart> charts = same.stream().map(Portrait::chart).toList();
            List<Series> all = charts.stream().flatMap(chart -> chart.series().stream()).toList();
            for (int k = 0; k < same.size(); k++) {
                panels.add(Panel.phase(same.get(k).solver() + step, charts.get(k).scaledTo(all), Optional.empty())
                        .answered(same.get(k).answer()).named(subjects.size() == 1 ? same.get(k).solver()
                        : same.get(k).solver() + "-" + (panels.size() / same.size() + 1)));
            }
        }
        Picture picture = panels.size() == 1 ? Picture.of("phase-plots", caption, panels.get(0).named(""))
                : Picture.panels("phase-plots", caption, title, panels);
        return new ResultPage(name(), title, List.of("""
                A path in state space shows what a plot over time hides: a closed curve keeps its energy, a spiral \
                outwards gains it, a spiral inwards loses it, and a path that ends away from the hollow mark, but on \
                the curve, has a wrong phase only. Distances off the curve are in halves of its width and height."""),
                List.of(picture), List.of(portraits.table()));
    }
}
