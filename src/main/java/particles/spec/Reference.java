package particles.spec;

import deSolvers.text.Digits;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.stream.Collectors;

/**
 * Writes the reference of a file format as Markdown tables: one for each mapping, with key, values, default and
 * meaning.
 */
public final class Reference {
    private Reference() {
    }

    /**
     * @param root    the type of a whole file
     * @param heading the beginning of each heading, such as {@code ###}
     * @return the tables, ending with a line feed; the same text for the same type, always
     */
    public static String of(MappingType root, String heading) {
        // several shapes have springs of the same sort
        return root.mappings().map(mapping -> heading + " " + section(mapping)).distinct()
                .collect(Collectors.joining("\n\n", "", "\n"));
    }

    private static String section(MappingType mapping) {
        List<String> lines = new ArrayList<>(List.of(heading(mapping)));
        if (!mapping.getSentence().isEmpty()) {
            lines.add(mapping.getSentence());
        }
        lines.addAll(List.of("", "| key | value | default | meaning |", "| --- | --- | --- | --- |"));
        for (Key<?> key : mapping.getKeys()) {
            String standard = key.required() ? "*required*" : key.defaultJson().map(Reference::written).orElse("");
            String meaning = key.sentence().replace("|", "\\|");
            lines.add("| `" + key.name() + "` | " + values(key.type()) + " | " + standard + " | " + meaning + " |");
        }
        return String.join("\n", lines);
    }

    private static String values(Type<?> type) {
        if (type instanceof MappingType mapping) {
            Optional<Key<?>> brief = mapping.getShortForm();
            return brief.map(key -> values(key.type()) + "; or with keys of its own, ").orElse("") + "see "
                    + link(mapping);
        } else if (type instanceof ListType<?> list && list.element() instanceof MappingType mapping) {
            return "a list, see " + link(mapping);
        } else if (type instanceof ListType<?> list && !(list.element() instanceof NameType<?>)) {
            return "a list of: " + values(list.element());
        } else if (type instanceof KindType<?> kinds) {
            return String.join(", ", kinds.kinds().stream().map(kind -> "`" + kind.getName() + "`").toList())
                    + kinds.orClass();
        }
        return type.describe();
    }

    private static String heading(MappingType mapping) {
        return capital(mapping.getLabel().replace('\'', '`'));
    }

    /** A link to the table of a mapping, as Markdown viewers name the places of headings. */
    private static String link(MappingType mapping) {
        String place = heading(mapping).toLowerCase(Locale.ROOT).replace("`", "").replace(' ', '-');
        return "[" + heading(mapping) + "](#" + place + ")";
    }

    private static String written(Object json) {
        if (json instanceof List<?> list) {
            return list.isEmpty() ? "none"
                    : list.stream().map(Reference::written).collect(Collectors.joining(", ", "[", "]"));
        }
        return json instanceof Number number ? Digits.exact(number.doubleValue()) : json.toString();
    }

    private static String capital(String text) {
        return text.substring(0, 1).toUpperCase(Locale.ROOT) + text.substring(1);
    }
}
