package particles.teaching.exercises;

import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import java.util.stream.IntStream;
import particles.spec.Key;
import particles.spec.MappingType;
import particles.spec.Reading;
import particles.spec.SourceText;
import particles.spec.TextType;
import particles.spec.Values;
import particles.spec.YamlText;
import particles.spec.messages.Place;
import particles.spec.messages.Problems;

/**
 * A file of a student's answers, in lines such as {@code 5: 3.42}: the number of the exercise and the answer.
 *
 * @param answers  the answers by the number of the exercise
 * @param problems the mistakes in the file, a line each
 */
public record AnswersFile(Map<Integer, String> answers, List<String> problems) {
    private static final int MOST_LINES = 1000;

    /** Copies both collections. */
    public AnswersFile {
        answers = Map.copyOf(answers);
        problems = List.copyOf(problems);
    }

    /**
     * Reads the file; if it is not YAML as a whole, line by line, so that a mistake costs no other answer.
     *
     * @param file the file of the answers, which is not to be a link
     * @return the answers and problems
     */
    public static AnswersFile read(Path file) {
        String name = file.toString().replace('\\', '/');
        if (Files.isSymbolicLink(file)) {
            return new AnswersFile(Map.of(), List.of(name + ": this is a link; hand in the file itself"));
        }
        Problems unread = new Problems();
        Optional<byte[]> bytes = SourceText.read(file, new Reading(name, unread));
        if (bytes.isEmpty()) {
            return new AnswersFile(Map.of(), unread.lines());
        }
        String text = new String(bytes.get(), StandardCharsets.ISO_8859_1);     // keeps each byte
        Problems problems = new Problems();
        Map<Integer, String> answers = new TreeMap<>();
        if (add(text, new Reading(name, problems), answers)) {
            return new AnswersFile(answers, problems.lines());
        }
        Problems each = new Problems();
        List<String> lines = text.replaceFirst("^\u00ef\u00bb\u00bf", "").lines().limit(MOST_LINES).toList();
        for (int n = 0; n < lines.size(); n++) {
            if (!lines.get(n).matches("\\s*(#.*|---.*|[.]{3})?")) {
                Map<Integer, String> found = new TreeMap<>();
                add("\n".repeat(n) + lines.get(n), new Reading(name, each), found);
                int line = n + 1;
                found.forEach((number, answer) -> {
                    if (answers.putIfAbsent(number, answer) != null) {      // null where there was none
                        each.add(new Place(name, line, 1), "'" + number + "' appears twice; the first one counts");
                    }
                });
            }
        }
        return new AnswersFile(answers, each.lines());
    }

    /** @return whether the text is YAML; if so, its answers are added */
    private static boolean add(String text, Reading in, Map<Integer, String> answers) {
        List<Key<String>> keys = IntStream.rangeClosed(1, Exercises.all().size()).mapToObj(number ->
                TextType.typed("the answer, a number or a path").optional(Integer.toString(number),
                "The answer to this exercise.")).toList();
        MappingType format = MappingType.of("the file of answers", keys.toArray(new Key<?>[0]));
        Optional<Values> values = YamlText.compose(text.getBytes(StandardCharsets.ISO_8859_1), in)
                .map(root -> format.readRoot(root, in));
        values.ifPresent(found -> keys.forEach(key -> found.find(key)
                .ifPresent(answer -> answers.put(Integer.valueOf(key.name()), answer))));
        return values.isPresent();
    }
}
