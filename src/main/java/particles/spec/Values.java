package particles.spec;

import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.NoSuchElementException;
import java.util.Optional;
import particles.spec.messages.Place;

/** The values of a mapping in a file, by key, with their places. */
public final class Values {
    private record Found(Optional<?> value, Place place, boolean intact) {
    }

    private final Place place;
    /** By the names of the keys, which differ in a mapping. */
    private final Map<String, Found> found = new HashMap<>();
    private boolean sound = true;

    /** @param place the place where the mapping begins */
    public Values(Place place) {
        this.place = place;
    }

    void setSound(boolean sound) {
        this.sound = sound;
    }

    /** @return whether the mapping has no mistake, so that {@link #get} works */
    public boolean isSound() {
        return sound;
    }

    /** @return the same values, but for another one of a key, which stands at another place */
    public <T> Values with(Key<T> key, T value, Place at) {
        Values changed = new Values(place);
        changed.found.putAll(found);
        changed.put(key, Optional.of(value), at, true);
        return changed;
    }

    void put(Key<?> key, Optional<?> value, Place at, boolean intact) {
        found.put(key.name(), new Found(value, at, intact));
    }

    /**
     * @param key a key of the mapping
     * @return its value, or its default; empty if it has neither or its value is wrong
     */
    @SuppressWarnings("unchecked")                      // a key's value was read by its type
    public <T> Optional<T> find(Key<T> key) {
        return given(key).map(one -> (Optional<T>) one.value()).orElse(key.defaultValue());
    }

    /** @return the value of a key for a mapping; that of an empty mapping if it has none */
    public Values mapping(Key<Values> key) {
        return find(key).orElse(new Values(place));
    }

    /** @return the value of a key for a list; no elements if it has none */
    public <T> List<T> list(Key<List<T>> key) {
        return find(key).orElse(List.of());
    }

    /**
     * @param key a key that is required or has a default, of a mapping without problems
     * @return its value
     */
    public <T> T get(Key<T> key) {
        return find(key).orElseThrow(() -> new NoSuchElementException("'" + key.name() + "' has no value at " + place));
    }

    private Optional<Found> given(Key<?> key) {
        return Optional.ofNullable(found.get(key.name()));
    }

    /** @return whether the key is in the file, with a right or wrong value */
    public boolean isGiven(Key<?> key) {
        return given(key).isPresent();
    }

    /** @return whether neither the key's value nor anything in it has a mistake */
    public boolean isIntact(Key<?> key) {
        return given(key).map(Found::intact).orElse(true);
    }

    /** @return the place of the key's value, or of the mapping if the key is not given */
    public Place place(Key<?> key) {
        return given(key).map(Found::place).orElse(place);
    }

    /** @return the place of the mapping's beginning */
    public Place getPlace() {
        return place;
    }
}
