package particles.app.run;

import java.util.ArrayList;
import java.util.List;
import particles.output.animation.Film;
import particles.output.animation.GifAnimation;
import particles.output.charts.ChartFormat;
import particles.output.charts.ChartWriter;
import particles.output.files.OutputFolder;
import particles.output.files.RunSummaryWriter;
import particles.output.files.TrajectoryWriter;
import particles.scene.format.OutputDescription;
import particles.scene.format.OutputDescription.Video;

/** The list of files that a run will write. */
final class RunFiles {
    static final String ENERGY = "energy.png";
    static final String PHASE = "phase.png";

    private final List<String> names = new ArrayList<>();
    private final boolean frames;

    /**
     * @param output the scene's output settings
     * @param frames whether to draw pictures
     * @param video  the film to make of them
     * @param charts the format of charts
     */
    RunFiles(OutputDescription output, boolean frames, Video video, ChartFormat charts) {
        this.frames = frames;
        addIf(frames, OutputFolder.FRAMES);
        addIf(frames && output.animation(), GifAnimation.FILE);
        addIf(frames && video == Video.MP4, Film.FILE);
        for (String end : charts.svg() ? List.of(ChartWriter.PNG, ChartWriter.SVG) : List.of(ChartWriter.PNG)) {
            addIf(output.energy(), ENERGY.replace(ChartWriter.PNG, end));
            addIf(output.phase().isPresent(), PHASE.replace(ChartWriter.PNG, end));
        }
        names.add(TrajectoryWriter.FILE);
        names.add(RunSummaryWriter.FILE);
    }

    private void addIf(boolean wanted, String name) {
        if (wanted) {
            names.add(name);
        }
    }

    boolean haveFrames() {
        return frames;
    }

    /** @return the names, the most interesting first */
    String[] names() {
        return names.toArray(String[]::new);
    }
}
