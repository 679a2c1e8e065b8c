package particles.spec;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import particles.spec.NumberType.Whole;

/** Makes the JSON Schema of a file format, by which editors complete and check files: scenes/scene.schema.json. */
public final class JsonSchema {
    private JsonSchema() {
    }

    /** The schema of scene files, as text. */
    public static String ofScenes(MappingType scene) {
        Map<String, Object> schema = JsonText.map("$schema", "http://json-schema.org/draft-07/schema#", "title",
                "A scene of DESolver", "description",
                "Generated from particles.scene.format.SceneFormat; a test keeps the two equal.");
        schema.putAll(of(scene));
        return JsonText.of(schema);
    }

    private static Map<String, Object> of(Type<?> type) {
        if (type instanceof NumberType number) {
            return JsonText.map("type", "number", "minimum", number.least(), "maximum", number.most());
        } else if (type instanceof Whole number) {
            return JsonText.map("type", "integer", "minimum", number.least(), "maximum", number.most());
        } else if (type instanceof TextType text) {
            return JsonText.map("type", "string", "pattern", text.pattern().pattern(), "maxLength", text.longest());
        } else if (type instanceof NameType<?> names) {
            Map<String, Object> choice = JsonText.map("enum", names.names());
            return names.other().isEmpty() ? choice : anyOf(choice, of(names.other().get()));
        } else if (type instanceof VectorType vector) {
            Map<String, Object> schema = JsonText.map("type", "array", "items", of(vector.component()), "minItems", 3,
                    "maxItems", 3);
            if (!vector.zeroAllowed()) {
                schema.put("contains", Map.of("not", Map.of("const", 0)));
            }
            return schema;
        } else if (type instanceof ListType<?> list) {
            Map<String, Object> schema = JsonText.map("type", "array", "items", of(list.element()));
            return list.bareAllowed() ? anyOf(of(list.element()), schema) : schema;
        } else if (type instanceof MappingType mapping) {
            return ofMapping(mapping);
        } else if (type instanceof MapType<?, ?> map) {
            return JsonText.map("type", "object", "propertyNames", of(map.key()), "additionalProperties",
                    of(map.value()));
        }
        return type instanceof KindType<?> kinds ? ofKinds(kinds) : JsonText.map("type", "boolean");
    }

    private static Map<String, Object> anyOf(Object... choices) {
        return JsonText.map("anyOf", List.of(choices));
    }

    private static Map<String, Object> described(String sentence, Type<?> type) {
        Map<String, Object> schema = JsonText.map("description", sentence);
        schema.putAll(of(type));
        return schema;
    }

    private static Map<String, Object> ofMapping(MappingType mapping) {
        Map<String, Object> properties = JsonText.map();
        for (Key<?> key : mapping.getKeys()) {
            Map<String, Object> property = described(key.sentence(), key.type());
            key.defaultJson().ifPresent(value -> property.put("default", value));
            properties.put(key.name(), property);
        }
        Map<String, Object> schema = JsonText.map("type", "object", "properties", properties,
                "additionalProperties", false);
        List<String> required = mapping.getKeys().stream().filter(Key::required).map(Key::name).toList();
        if (!required.isEmpty()) {
            schema.put("required", required);
        }
        if (!mapping.exactlyOneOf.isEmpty()) {
            schema.put("oneOf", mapping.exactlyOneOf.stream().map(key -> Map.of("required", List.of(key.name())))
                    .toList());
        }
        return mapping.getShortForm().isEmpty() ? schema : anyOf(of(mapping.getShortForm().get().type()), schema);
    }

    private static Map<String, Object> ofKinds(KindType<?> kinds) {
        Map<String, Object> properties = JsonText.map();
        kinds.kinds().forEach(kind -> properties.put(kind.getName(), described(kind.getSentence(), kind)));
        Map<String, Object> mapping = JsonText.map("type", "object", "properties", properties);
        kinds.own().ifPresent(type -> mapping.put("patternProperties",
                Map.of(KindType.CLASS.pattern().pattern(), Map.of("type", "object"))));
        mapping.putAll(JsonText.map("additionalProperties", false, "minProperties", 1, "maxProperties", 1));
        List<String> bare = kinds.kinds().stream().filter(Kind::mayBeEmpty).map(Kind::getName).toList();
        if (bare.isEmpty()) {
            return mapping;
        }
        List<Object> choices = new ArrayList<>(List.of(Map.of("enum", bare), mapping));
        kinds.own().ifPresent(type -> choices.add(of(KindType.CLASS)));
        return anyOf(choices.toArray());
    }
}
