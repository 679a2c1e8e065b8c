package particles.scene.format;

import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import particles.spec.Key;
import particles.spec.messages.Place;
import particles.spec.messages.Problems;

/** Options that override values of a scene file; they are checked in the same way. */
public final class Overrides {
    /** The keys of a scene that an option can override. */
    public static final List<String> NAMES = List.of(SceneFormat.SOLVER.name(), SceneFormat.DELTA_T.name(),
            SceneFormat.DURATION.name(), SceneFormat.THREADS.name());

    private record Given(String text, String option) {
    }

    private final Map<String, Given> given = new HashMap<>();

    /**
     * @param name   one of {@link #NAMES}
     * @param text   the value as it was typed
     * @param option the option as it was typed, such as {@code -PdeltaT}, for messages
     * @return this
     */
    public Overrides with(String name, String text, String option) {
        if (!NAMES.contains(name)) {
            throw new IllegalArgumentException("'" + name + "' cannot be overridden; allowed: " + NAMES);
        }
        given.put(name, new Given(text, option));
        return this;
    }

    /**
     * Checks each option by itself, without a scene.
     *
     * @param problems gets a line for each wrong one
     */
    public void check(Problems problems) {
        Map<Key<?>, Place> places = new HashMap<>();
        apply(SceneFormat.SOLVER, SolverFormat.NAME, "", places, problems);
        apply(SceneFormat.DELTA_T, SceneFormat.DELTA_T, 1.0, places, problems);
        apply(SceneFormat.DURATION, SceneFormat.DURATION, 1.0, places, problems);
        apply(SceneFormat.THREADS, SceneFormat.THREADS, 1, places, problems);
    }

    /** @return the description with all valid options applied */
    public SceneDescription applyTo(SceneDescription scene, Problems problems) {
        Map<Key<?>, Place> places = new HashMap<>(scene.places());
        boolean sameSolver = !given.containsKey(SceneFormat.SOLVER.name());
        String solver = apply(SceneFormat.SOLVER, SolverFormat.NAME, scene.solver(), places, problems);
        double deltaT = apply(SceneFormat.DELTA_T, SceneFormat.DELTA_T, scene.deltaT(), places, problems);
        double duration = apply(SceneFormat.DURATION, SceneFormat.DURATION, scene.duration(), places, problems);
        Optional<Integer> threads = given.containsKey(SceneFormat.THREADS.name())
                ? Optional.of(apply(SceneFormat.THREADS, SceneFormat.THREADS, 1, places, problems)) : scene.threads();
        return scene.with(solver, sameSolver ? scene.tolerances() : Optional.empty(), deltaT, duration, threads,
                Map.copyOf(places));
    }

    /** @param type the key whose type the option has */
    private <T> T apply(Key<?> key, Key<T> type, T inFile, Map<Key<?>, Place> places, Problems problems) {
        Given value = given.get(key.name());
        if (value == null) {
            return inFile;
        }
        places.put(key, Place.of(value.option()));
        return type.type().readOption(value.text(), value.option(), problems).orElse(inFile);
    }
}
