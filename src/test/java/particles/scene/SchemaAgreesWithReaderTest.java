package particles.scene;

import static deSolvers.problems.Bounds.assertBetween;
import static org.junit.jupiter.api.Assertions.assertEquals;

import dev.harrel.jsonschema.Dialects;
import dev.harrel.jsonschema.Validator;
import dev.harrel.jsonschema.ValidatorFactory;
import dev.harrel.jsonschema.providers.GsonNode;
import java.io.IOException;
import java.net.URI;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.snakeyaml.engine.v2.api.Dump;
import org.snakeyaml.engine.v2.api.DumpSettings;
import org.snakeyaml.engine.v2.api.Load;
import org.snakeyaml.engine.v2.api.LoadSettings;
import org.snakeyaml.engine.v2.schema.CoreSchema;
import particles.scene.format.SceneFormat;
import particles.spec.JsonSchema;
import particles.spec.JsonText;
import particles.spec.Reading;
import particles.spec.messages.Problems;

/**
 * The schema, used by editors, and the reader agree on randomly changed scenes, as far as a schema can express the
 * rules. (Only the reader checks conditions between parts, such as unknown ids and classes.)
 */
class SchemaAgreesWithReaderTest {
    private static final int CHANGES = 300;
    /** Replacement values, which are valid for some keys and invalid for others. */
    private static final List<Object> OTHERS = List.of(0, 1, -1, 2.0, 2.5, 1e-3, 1e31, true, false, "", " ", "rk4",
            "my.Solver",
            "a b", "cloth[1,2]", "left", "top-left", "#00ff00", "x", "coulomb", "gravity", "ground", List.of(),
                    List.of(1, 2, 3),
            List.of(0, 0, 0), List.of(1, "a", 3), List.of("left", "corners"), Map.of(), Map.of("gravity", Map.of()),
            Map.of("name", "rk4"), Map.of("stiffness", 3));
    private static final List<String> NAMES = List.of("mass", "totalMass", "fixed", "velocity", "gravty", "id",
            "position",
            "friction", "coefficient", "name", "surface", "restLength", "camera", "drag", "plane");

    private final Validator validator = new ValidatorFactory().withDefaultDialect(new Dialects.Draft7Dialect())
            .withJsonNodeFactory(new GsonNode.Factory()).createValidator();
    private final URI schema = validator.registerSchema(JsonSchema.ofScenes(SceneFormat.SCENE));

    private static List<Object> scenes() throws IOException {
        List<Object> scenes = new ArrayList<>();
        for (Path file : SceneFiles.list(Path.of("scenes"))) {
            scenes.add(parse(Files.readString(file)));
        }
        return scenes;
    }

    private static Object parse(String text) {
        return new Load(LoadSettings.builder().setSchema(new CoreSchema()).build()).loadFromString(text);
    }

    private static String write(Object scene) {
        return new Dump(DumpSettings.builder().setDereferenceAliases(true).build()).dumpToString(scene);
    }

    private static List<String> problems(String text) {
        Problems problems = new Problems();
        SceneFormat.SCENE.read(text.getBytes(StandardCharsets.UTF_8), new Reading("x.yaml", problems));
        return problems.lines().stream().filter(line -> !line.contains("class 'my.Solver' cannot be used")).toList();
    }

    @Test
    void theScenesPassTheSchema() throws IOException {
        for (Object scene : scenes()) {
            assertEquals(List.of(), validator.validate(schema, JsonText.of(scene)).getErrors().stream()
                    .map(e -> e.getError()).toList());
        }
    }

    @Test
    void schemaAndReaderAgreeOnChangedScenes() throws IOException {
        List<Object> scenes = scenes();
        Random random = new Random(715);
        int right = 0;
        for (int n = 0; n < CHANGES; n++) {
            Object changed = changed(scenes.get(random.nextInt(scenes.size())), random, 0);
            String text = write(changed);
            List<String> problems = problems(text);
            boolean valid = validator.validate(schema, JsonText.of(parse(text))).isValid();
            assertEquals(problems.isEmpty(), valid, () -> "the schema says " + valid + ", the reader "
                    + problems + ", of\n"
                    + text);
            right += valid ? 1 : 0;
        }
        assertBetween(CHANGES / 10, CHANGES * 9 / 10, right);
    }

    /** Returns a copy with one value replaced, at a random depth. */
    private static Object changed(Object value, Random random, int depth) {
        boolean here = depth > 0 && random.nextInt(4) == 0;
        if (!here && value instanceof Map<?, ?> map && !map.isEmpty()) {
            Map<Object, Object> copy = new LinkedHashMap<>(map);
            Object key = List.copyOf(map.keySet()).get(random.nextInt(map.size()));
            switch (random.nextInt(10)) {
                case 0 -> copy.remove(key);
                case 1 -> copy.put(NAMES.get(random.nextInt(NAMES.size())), OTHERS.get(random.nextInt(OTHERS.size())));
                default -> copy.put(key, changed(map.get(key), random, depth + 1));
            }
            return copy;
        }
        if (!here && value instanceof List<?> list && !list.isEmpty()) {
            List<Object> copy = new ArrayList<>(list);
            int at = random.nextInt(list.size());
            switch (random.nextInt(8)) {
                case 0 -> copy.remove(at);
                case 1 -> copy.add(copy.get(at));
                default -> copy.set(at, changed(list.get(at), random, depth + 1));
            }
            return copy;
        }
        return OTHERS.get(random.nextInt(OTHERS.size()));
    }
}
