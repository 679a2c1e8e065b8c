package particles.scene;

import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import particles.scene.format.SceneDescription;
import particles.scene.format.SceneFormat;

/** Follows the advice of a message, as somebody would who reads it. */
public final class Advised {
    private static final Pattern OPTION = Pattern.compile("--(solver|deltaT)=([^\\s,]+)");

    private Advised() {
    }

    /**
     * @param lines the message, with options such as --solver
     * @param scene the scene that could not be run
     * @return the same scene as advised; empty if the message names no option and no value of the scene
     */
    public static Optional<SceneDescription> by(String lines, SceneDescription scene) {
        SceneDescription changed = scene;
        for (Matcher option = OPTION.matcher(lines); option.find();) {
            changed = option.group(1).equals("solver") ? changed.withSolver(option.group(2))
                    : changed.withDeltaT(Double.parseDouble(option.group(2)));
        }
        boolean clamp = lines.contains("impact: clamp in the scene");
        return clamp || OPTION.matcher(lines).find() ? Optional.of(clamp ? changed.with(SceneFormat.IMPACT, "clamp")
                : changed) : Optional.empty();
    }
}
