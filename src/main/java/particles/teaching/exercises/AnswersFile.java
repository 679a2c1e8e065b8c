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
import particles.spec.messages.Problems;

/**
 * A file of a student's answers, in lines such as {@code 5: 3.42}: the number of the exercise and the answer.
 *
 * @param answers  the answers by the number of the exercise
 * @param problems the mistakes in the file, a line each
 */
public record AnswersFile(Map<Integer, String> answers, List<String> problems) {
    private static final int MOST_LINES = 1000;
    private static final List<Key<String>> KEYS = IntStream.rangeClosed(1, Exercises.ALL.size()).mapToObj(number ->
            TextType.typed("the answer, a number or a path").optional(Integer.toString(number),
            "The answer to this exercise.")).toList();
    private static final MappingType FORMAT = MappingType.of("the file of answers", KEYS.toArray(new Key<?>[0]));

    /**
     * Reads the file line by line, so that a mistake costs no other answer.
     *
     * @param file the file of the answers, which is not to be a link
     * @return the answers and problems
     */
    public static AnswersFile read(Path file) {
        String name = file.toString().replace('\\', '/');
        if (Files.isSymbolicLink(file)) {
            return new AnswersFile(Map.of(), List.of(name + ": this is a link; hand in the file itself"));
        }
        Problems problems = new Problems();
        Optional<byte[]> bytes = SourceText.read(file, new Reading(name, problems));
        String text = new String(bytes.orElse(new byte[0]), StandardCharsets.ISO_8859_1);       // keeps each byte
        Map<Integer, String> answers = new TreeMap<>();
        List<String> lines = text.replaceFirst("^\u00ef\u00bb\u00bf", "").lines().limit(MOST_LINES).toList();
        for (int n = 0; n < lines.size(); n++) {
            if (!lines.get(n).matches("\\s*(#.*|---.*|[.]{3})?")) {
                add("\n".repeat(n) + lines.get(n), new Reading(name, problems), answers);
            }
        }
        return new AnswersFile(answers, problems.lines());
    }

    private static void add(String text, Reading in, Map<Integer, String> answers) {
        FORMAT.read(text.getBytes(StandardCharsets.ISO_8859_1), in).ifPresent(found -> KEYS.forEach(key ->
                found.find(key).ifPresent(answer -> {
                    if (answers.putIfAbsent(Integer.valueOf(key.name()), answer) != null) {     // null: the first one
                        in.problems().add(found.place(key), "'" + key.name() + "' appears twice; the first one counts");
                    }
                })));
    }
}
