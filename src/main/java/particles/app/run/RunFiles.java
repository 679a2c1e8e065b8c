package particles.app.run;

import java.util.ArrayList;
import java.util.List;
import particles.output.animation.Film;
import particles.output.animation.GifAnimation;
import particles.output.files.OutputFolder;
import particles.output.files.RunSummaryWriter;
import particles.output.files.TrajectoryWriter;
import particles.scene.format.OutputDescription;
import particles.scene.format.OutputDescription.Video;

/** The files that a run will write. */
final class RunFiles {
    static final String ENERGY = "energy.png";
    static final String PHASE = "phase.png";

    private final List<String> names = new ArrayList<>();
    private final boolean frames;

    /**
     * @param output the scene's output settings
     * @param frames whether to draw pictures
     * @param video  the film to make of them
     */
    RunFiles(OutputDescription output, boolean frames, Video video) {
        this.frames = frames;
        addIf(frames, OutputFolder.FRAMES);
        addIf(frames && output.animation(), GifAnimation.FILE);
        addIf(frames && video == Video.MP4, Film.FILE);
        addIf(output.energy(), ENERGY);
        addIf(output.phase().isPresent(), PHASE);
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

    /** @return the names, those to look at first at the front */
    String[] names() {
        return names.toArray(String[]::new);
    }
}
