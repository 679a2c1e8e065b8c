package particles.app.cli;

import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import java.util.function.Supplier;
import particles.scene.SceneException;

/** Collects what is wrong with the options of a command, so that all of it is reported together. */
public final class Mistakes {
    private final Set<String> lines = new LinkedHashSet<>();    // values that need the same scene report it once

    /**
     * Reads a value.
     *
     * @param reading throws a {@link Failure} or a {@link SceneException} if an option is wrong
     * @return the value that was read; of a wrong one it throws the same exception again
     */
    public <T> Supplier<T> value(Supplier<T> reading) {
        try {
            T value = reading.get();
            return () -> value;
        } catch (Failure | SceneException e) {
            lines.addAll(e instanceof Failure failure ? failure.getLines() : ((SceneException) e).getLines());
            return () -> {
                throw e;
            };
        }
    }

    /**
     * Checks a value.
     *
     * @param check throws a {@link Failure} or a {@link SceneException} if an option is wrong
     */
    public void check(Runnable check) {
        value(() -> {
            check.run();
            return true;
        });
    }

    List<String> lines() {
        return new ArrayList<>(lines);
    }
}
