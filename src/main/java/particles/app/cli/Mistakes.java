package particles.app.cli;

import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import java.util.function.Supplier;
import particles.spec.messages.InvalidInputException;

/** Collects what is wrong with the options of a command, so that all of it is reported together. */
public final class Mistakes {
    private final Set<String> lines = new LinkedHashSet<>();    // values that need the same scene report it once

    /**
     * Reads a value.
     *
     * @param reading throws an {@link InvalidInputException} if an option is wrong
     * @return the value that was read; of a wrong one it throws the same exception again
     */
    public <T> Supplier<T> value(Supplier<T> reading) {
        try {
            T value = reading.get();
            return () -> value;
        } catch (InvalidInputException e) {
            lines.addAll(e.getLines());
            return () -> {
                throw e;
            };
        }
    }

    /**
     * Checks a value.
     *
     * @param check throws an {@link InvalidInputException} if an option is wrong
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
