package particles.app;

import java.util.ArrayList;
import java.util.List;
import particles.output.Film;
import particles.output.GifAnimation;
import particles.output.OutputFolder;
import particles.output.RunSummaryWriter;
import particles.output.TrajectoryWriter;
import particles.scene.OutputDescription;
import particles.scene.OutputDescription.Video;

/** Which files a run writes, known before it begins. */
final class RunFiles {
    static final String ENERGY = "energy.png";
    static final String PHASE = "phase.png";

    private final List<String> names = new ArrayList<>();
    private final boolean frames;

    /**
     * @param output what the scene wants
     * @param frames whether pictures are wanted at all
     * @param video  which film is made of them
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

    /** @return the names, those to look at first */
    String[] names() {
        return names.toArray(String[]::new);
    }
}
