package particles.scene;

import java.util.ArrayList;
import java.util.List;
import java.util.function.UnaryOperator;
import particles.scene.format.SceneDescription;
import particles.scene.format.SceneFormat;
import particles.spec.Key;
import particles.spec.messages.Place;
import particles.spec.messages.Problems;

/** Options that replace values of a scene's file; each is read once, and checked as the file's own value is. */
public final class Overrides {
    private static final List<Key<?>> KEYS = List.of(SceneFormat.SOLVER, SceneFormat.DELTA_T, SceneFormat.DURATION,
            SceneFormat.THREADS);

    private final List<UnaryOperator<SceneDescription>> changes = new ArrayList<>();
    private final Problems problems = new Problems();
    private final UnaryOperator<String> option;

    /** @param option returns a name as it was typed, such as {@code -PdeltaT}, for messages */
    public Overrides(UnaryOperator<String> option) {
        this.option = option;
    }

    /**
     * Reads an option.
     *
     * @param name {@code solver}, {@code deltaT}, {@code duration} or {@code threads}
     * @param text the value as it was typed; null, as the command line's parser has it, if the option was not given
     * @return this
     */
    public Overrides with(String name, String text) {
        if (text == null) {
            return this;
        }
        read(KEYS.stream().filter(key -> key.name().equals(name)).findFirst().orElseThrow(), text,
                Place.of(option.apply(name)));
        return this;
    }

    private <T> void read(Key<T> key, String text, Place place) {
        key.type().readOption(text, place.toString(), problems).ifPresent(value ->
                changes.add(scene -> scene.with(key, value, place)));
    }

    /** @throws particles.spec.messages.InvalidInputException with a line for each wrong option */
    public void check() {
        problems.throwIfAny();
    }

    /**
     * @param scene a scene's description
     * @return the description with these values in place of its own
     * @throws particles.spec.messages.InvalidInputException with a line for each wrong option
     */
    public SceneDescription applyTo(SceneDescription scene) {
        check();
        SceneDescription changed = scene;
        for (UnaryOperator<SceneDescription> change : changes) {
            changed = change.apply(changed);
        }
        Problems together = new Problems();
        RunLimits.check(changed.values(), together);
        together.throwIfAny();
        return changed;
    }
}
