package hunts;

import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collection;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Random;
import net.jqwik.api.Arbitraries;
import net.jqwik.api.Arbitrary;
import net.jqwik.api.Combinators;
import net.jqwik.api.Tuple;
import org.snakeyaml.engine.v2.api.Dump;
import org.snakeyaml.engine.v2.api.DumpSettings;
import org.snakeyaml.engine.v2.api.Load;
import org.snakeyaml.engine.v2.api.LoadSettings;
import org.snakeyaml.engine.v2.common.FlowStyle;
import org.snakeyaml.engine.v2.schema.CoreSchema;
import particles.scene.SceneFiles;
import particles.scene.SceneReader;

/**
 * Draws scenes that are almost right: the tree of a shipped scene, or of an earlier draw that was kept, with a few
 * values and branches changed, or its text with a few bytes changed.
 */
final class BrokenText {
    private static final String SIGNS = "[]{}:,-#&*!|>'\"%@`? \n\t0123456789.eE+x~\\u\u00ff";
    private static final int MOST_BYTES = 20_000;
    private static final int MOST_COLUMNS = 12;

    /** A tree and the text that was written from it, or damaged since. */
    record Draw(Object tree, byte[] text) {
    }

    /** A change of the value at a path of places in a tree: what to do there, with which of the known values. */
    private record Edit(List<Integer> path, int what, int which, double factor) {
    }

    private record Damage(int at, int what, int length) {
    }

    private final List<Draw> seeds = new ArrayList<>();
    private final List<String> keys = new ArrayList<>();
    private final List<Object> values = new ArrayList<>(List.of(0, -1, 1e-3, 1e-30, 1e30, 1e31, -1e30, 5e-324, 1e308,
            1_000_000, Integer.MAX_VALUE, Long.MIN_VALUE, Double.NaN, Double.NEGATIVE_INFINITY, "", " ", "~", "a\nb",
            "java.lang.String", "cloth[99999999999]", List.of(), Map.of(), List.of(0, 0, 0), List.of(1e-200, 0, 0),
            List.of(1e30, -1e30, 1e30), List.of(1, 2), Map.of("gravity", Map.of())));

    BrokenText() {
        Load load = new Load(LoadSettings.builder().setSchema(new CoreSchema()).build());
        for (Path file : SceneFiles.list(Path.of("scenes"))) {
            Object tree = load.loadFromString(new String(SceneReader.bytes(file), StandardCharsets.UTF_8));
            seeds.add(written(known(tree)));
        }
    }

    /** Notes all keys and values of a tree, and keeps shapes small, as large ones only take time. */
    private Object known(Object value) {
        if (value instanceof Map<?, ?> map) {
            Map<Object, Object> copy = new LinkedHashMap<>();
            map.forEach((key, child) -> {
                keys.add((String) key);
                copy.put(key, List.of("columns", "rows", "layers").contains(key)
                        ? (Object) Math.min((Integer) child, MOST_COLUMNS) : known(child));
            });
            values.add(copy);
            return copy;
        }
        values.add(value);
        return value instanceof List<?> list ? list.stream().map(this::known).toList() : value;
    }

    private static Draw written(Object tree) {
        return new Draw(tree, text(tree).getBytes(StandardCharsets.UTF_8));
    }

    /** @return a tree of maps, lists, texts and numbers as YAML in one line */
    static String text(Object tree) {
        return new Dump(DumpSettings.builder().setSchema(new CoreSchema()).setDefaultFlowStyle(FlowStyle.FLOW)
                .setWidth(Integer.MAX_VALUE).setDereferenceAliases(true).build()).dumpToString(tree);
    }

    /** Keeps an interesting draw, to be changed further. */
    void keep(Draw draw) {
        if (draw.text.length < MOST_BYTES) {
            seeds.add(draw);
        }
    }

    Arbitrary<Draw> any() {
        Arbitrary<Integer> number = Arbitraries.randomValue(BrokenText::number);
        Arbitrary<Edit> edit = Arbitraries.randomValue(random -> new Edit(random.ints(1 + random.nextInt(6), 0,
                Integer.MAX_VALUE).boxed().toList(), number(random), number(random), random.nextDouble() - 0.2));
        Arbitrary<Damage> damage = Arbitraries.randomValue(random ->
                new Damage(number(random), number(random), number(random)));
        Arbitrary<List<Damage>> damages = Arbitraries.frequencyOf(Tuple.of(4, Arbitraries.just(List.of())),
                Tuple.of(1, damage.list().ofMinSize(1).ofMaxSize(4)));
        return Combinators.combine(number, edit.list().ofMaxSize(3), damages).as(this::draw);
    }

    private static int number(Random random) {
        return random.nextInt(Integer.MAX_VALUE);
    }

    private Draw draw(int seed, List<Edit> edits, List<Damage> damages) {
        Draw from = seeds.get(seed % seeds.size());
        Object tree = from.tree;
        for (Edit edit : edits) {
            tree = edited(tree, edit.path, edit);
        }
        Draw draw = edits.isEmpty() ? new Draw(tree, from.text.clone()) : written(tree);
        damages.forEach(damage -> damage(draw.text, damage));
        return draw;
    }

    private Object edited(Object value, List<Integer> path, Edit edit) {
        int size = value instanceof Collection<?> list ? list.size() : value instanceof Map<?, ?> map ? map.size() : 0;
        Object other = pick(values, edit.which);
        if (path.isEmpty() || size == 0) {
            return value instanceof Number number && edit.what % 3 > 0
                    ? number.doubleValue() * Math.scalb(edit.factor, edit.which % 60 - 30) : other;
        }
        int at = path.get(0) % size;
        List<Integer> rest = path.subList(1, path.size());
        int here = rest.isEmpty() ? edit.what % 8 : 8;
        if (value instanceof List<?> list) {
            List<Object> copy = new ArrayList<>(list);
            switch (here) {
                case 0 -> copy.remove(at);
                case 1 -> copy.add(copy.get(at));
                default -> copy.set(at, edited(copy.get(at), rest, edit));
            }
            return copy;
        }
        Map<Object, Object> copy = new LinkedHashMap<>((Map<?, ?>) value);
        Object key = List.copyOf(copy.keySet()).get(at);
        switch (here) {
            case 0 -> copy.remove(key);
            case 1 -> copy.put(pick(keys, edit.which), other);
            case 2 -> copy.put(key, branch(key, edit.which));
            default -> copy.put(key, edited(copy.get(key), rest, edit));
        }
        return copy;
    }

    /** Another scene's value of the same key, or any value if it has none. */
    private Object branch(Object key, int which) {
        Object value = pick(seeds, which).tree instanceof Map<?, ?> scene ? scene.get(key) : null;
        return value == null ? pick(values, which) : value;
    }

    private static <T> T pick(List<T> list, int which) {
        return list.get(which % list.size());
    }

    private static void damage(byte[] text, Damage damage) {
        int at = damage.at % text.length;
        int length = Math.min(damage.length % 12, text.length - at);
        switch (damage.what % 3) {
            case 0 -> text[at] = (byte) SIGNS.charAt(damage.length % SIGNS.length());
            case 1 -> text[at] = (byte) damage.length;
            default -> System.arraycopy(text, at, text, damage.length % (text.length - length + 1), length);
        }
    }
}
