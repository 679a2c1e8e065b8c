package particles.scene;

import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Random;
import org.snakeyaml.engine.v2.api.Load;
import org.snakeyaml.engine.v2.api.LoadSettings;
import org.snakeyaml.engine.v2.exceptions.YamlEngineException;
import org.snakeyaml.engine.v2.schema.CoreSchema;

/**
 * Mutates scenes: changes, removes, duplicates or replaces values, keys and branches of a scene's tree, or a few bytes
 * of its text.
 */
final class SceneMutator {
    private static final List<Object> VALUES = List.of(0, 1, -1, 2, 3, 0.5, 1e-3, 1e-30, 1e30, 1e31, -1e30, 5e-324,
            1e308, 1_000_000,
            Integer.MAX_VALUE, Long.MIN_VALUE, Double.NaN, Double.NEGATIVE_INFINITY, true, false, "", " ", "~", "a\nb",
            "rk4", "radau", "verlet", "adams", "backward-euler", "java.lang.String", "particles.scene.Nothing",
            "cloth[1,2]",
            "cloth[99999999999]", "left", "top-left", "corners", "#00ff00", "coulomb", "slide", "gravity", "ground",
            "exact", "clamp",
            List.of(), List.of(0, 0, 0), List.of(1, 2, 3), List.of(1e-200, 0, 0), List.of(1e30, -1e30, 1e30),
            List.of(1, 2),
            Map.of(), Map.of("gravity", Map.of()), Map.of("name", "rk4"), Map.of("law", "coulomb", "coefficient", 0.3));
    private static final List<String> KEYS = List.of("mass", "totalMass", "fixed", "velocity", "id", "position",
            "friction", "static",
            "coefficient", "name", "surface", "restLength", "camera", "drag", "plane", "impact", "rods", "wires",
            "feedback",
            "columns", "rows", "layers", "lifetime", "rate", "relativeTolerance", "frameRate", "width", "phase",
            "axis");
    private static final String SIGNS = "[]{}:,-#&*!|>'\"%@`? \n\t0123456789.eE+x~";
    private static final int MOST_BYTES = 20_000;
    private static final int MOST_COLUMNS = 12;

    private final Random random;
    private final List<Seed> seeds;
    private final int right;
    private final Load load =
            new Load(LoadSettings.builder().setSchema(new CoreSchema()).setMaxAliasesForCollections(0).build());

    /** A scene's text and its tree, parsed lazily and never changed. */
    private final class Seed {
        private final byte[] text;
        private Optional<Object> tree = Optional.empty();

        Seed(byte[] text) {
            this.text = text;
        }

        Object tree() {
            if (tree.isEmpty()) {
                tree = Optional.of(parse(text));
            }
            return tree.get();
        }
    }

    /** @param seeds initial scenes; interesting ones can be added */
    SceneMutator(List<byte[]> seeds, Random random) {
        this.seeds = new ArrayList<>(seeds.stream().map(scene -> new Seed(shrunk(scene))).toList());
        this.random = random;
        right = this.seeds.size();
    }

    /** Adds an interesting scene, to be mutated too. */
    void keep(byte[] scene) {
        if (scene.length < MOST_BYTES) {
            seeds.add(new Seed(scene));
        }
    }

    int seeds() {
        return seeds.size();
    }

    byte[] next() {
        Seed seed = seeds.get(random.nextInt(random.nextInt(4) > 0 ? right : seeds.size()));
        if (random.nextInt(5) == 0) {
            return damaged(seed.text);
        }
        Object tree = seed.tree();
        for (int n = random.nextInt(3); n >= 0; n--) {
            tree = changed(tree, 0);
        }
        return write(tree);
    }

    private static byte[] write(Object tree) {
        StringBuilder text = new StringBuilder();
        FlowText.append(tree, text);
        return text.append('\n').toString().getBytes(StandardCharsets.UTF_8);
    }

    /** The YAML parser rejects texts with several exceptions: an invalid escape ends in a NumberFormatException. */
    private Object parse(byte[] scene) {
        try {
            Object tree = load.loadFromString(new String(scene, StandardCharsets.UTF_8));
            return tree == null ? Map.of() : tree;
        } catch (YamlEngineException | ArithmeticException | IllegalArgumentException e) {
            return Map.of("title", "no YAML any more");
        }
    }

    /** Keeps shapes small, as large ones only take time. */
    private byte[] shrunk(byte[] scene) {
        return write(smaller(parse(scene)));
    }

    private static Object smaller(Object value) {
        if (value instanceof List<?> list) {
            return list.stream().map(SceneMutator::smaller).toList();
        }
        if (!(value instanceof Map<?, ?> map)) {
            return value;
        }
        Map<Object, Object> copy = new LinkedHashMap<>();
        map.forEach((key, child) -> copy.put(key, List.of("columns", "rows", "layers", "count").contains(key)
                && child instanceof Integer many ? (Object) Math.min(many, MOST_COLUMNS) : smaller(child)));
        return copy;
    }

    private Object changed(Object value, int depth) {
        boolean here = depth > 0 && random.nextInt(5) == 0;
        if (!here && value instanceof Map<?, ?> map && !map.isEmpty()) {
            Map<Object, Object> copy = new LinkedHashMap<>(map);
            Object key = pick(List.copyOf(map.keySet()));
            switch (random.nextInt(12)) {
                case 0 -> copy.remove(key);
                case 1 -> copy.put(pick(KEYS), pick(VALUES));
                case 2 -> copy.put(key, branch(key));
                default -> copy.put(key, changed(map.get(key), depth + 1));
            }
            return copy;
        }
        if (!here && value instanceof List<?> list && !list.isEmpty()) {
            List<Object> copy = new ArrayList<>(list);
            int at = random.nextInt(list.size());
            switch (random.nextInt(8)) {
                case 0 -> copy.remove(at);
                case 1 -> copy.add(copy.get(at));
                default -> copy.set(at, changed(list.get(at), depth + 1));
            }
            return copy;
        }
        if (value instanceof Number number && random.nextInt(3) > 0) {
            return number.doubleValue() * Math.scalb(random.nextDouble() - 0.2, random.nextInt(60) - 30);
        }
        return pick(VALUES);
    }

    /** Another scene's value of the same key, or any value if it has none. */
    private Object branch(Object key) {
        Object other = pick(seeds).tree();
        return other instanceof Map<?, ?> map && map.get(key) != null ? map.get(key) : pick(VALUES);
    }

    private <T> T pick(List<T> list) {
        return list.get(random.nextInt(list.size()));
    }

    private byte[] damaged(byte[] seed) {
        byte[] bytes = seed.clone();
        for (int n = random.nextInt(4); n >= 0 && bytes.length > 0; n--) {
            int at = random.nextInt(bytes.length);
            int length = Math.min(random.nextInt(12), bytes.length - at);
            switch (random.nextInt(3)) {
                case 0 -> bytes[at] = (byte) SIGNS.charAt(random.nextInt(SIGNS.length()));
                case 1 -> bytes[at] = (byte) random.nextInt(256);
                default -> System.arraycopy(bytes, at, bytes, random.nextInt(bytes.length - length + 1), length);
            }
        }
        return bytes;
    }
}
