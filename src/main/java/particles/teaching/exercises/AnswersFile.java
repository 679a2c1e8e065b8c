package particles.teaching.exercises;

import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.stream.IntStream;
import particles.spec.Key;
import particles.spec.MappingType;
import particles.spec.Reading;
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
     * @param name the file's name, for the problems
     * @param text its contents
     * @return the answers and problems
     */
    public static AnswersFile read(String name, String text) {
        Problems problems = new Problems();
        Map<Integer, String> answers = new TreeMap<>();
        List<String> lines = text.lines().limit(MOST_LINES).toList();
        for (int n = 0; n < lines.size(); n++) {
            if (!lines.get(n).matches("\\s*(#.*|---.*|[.]{3})?")) {
                add("\n".repeat(n) + lines.get(n), new Reading(name, problems), answers);
            }
        }
        return new AnswersFile(answers, problems.lines());
    }

    private static void add(String text, Reading in, Map<Integer, String> answers) {
        FORMAT.read(text.getBytes(StandardCharsets.UTF_8), in).ifPresent(found -> KEYS.forEach(key ->
                found.find(key).ifPresent(answer -> {
                    if (answers.putIfAbsent(Integer.valueOf(key.name()), answer) != null) {     // null: the first one
                        in.problems().add(found.place(key), "'" + key.name() + "' appears twice; the first one counts");
                    }
                })));
    }
}
