package particles.teaching.exercises;

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
import particles.spec.messages.Problems;

/**
 * A file of a student's answers, in lines such as {@code 5: 3.42}: the number of the exercise and the answer.
 *
 * @param answers  the answers by the number of the exercise
 * @param problems the mistakes in the file, a line each
 */
public record AnswersFile(Map<Integer, String> answers, List<String> problems) {

    /** Copies both collections. */
    public AnswersFile {
        answers = Map.copyOf(answers);
        problems = List.copyOf(problems);
    }

    /**
     * @param file the file of the answers
     * @return the answers and problems
     */
    public static AnswersFile read(Path file) {
        Problems problems = new Problems();
        Reading in = new Reading(file.toString().replace('\\', '/'), problems);
        List<Key<String>> keys = IntStream.rangeClosed(1, Exercises.all().size()).mapToObj(number ->
                TextType.typed("the answer, a number or a path").optional(Integer.toString(number),
                "The answer to this exercise.")).toList();
        MappingType format = MappingType.of("the file of answers", keys.toArray(new Key<?>[0]));
        Optional<Values> values = SourceText.read(file, in).flatMap(bytes -> YamlText.compose(bytes,
                in)).map(root -> format.readRoot(root, in));
        Map<Integer, String> answers = new TreeMap<>();
        values.ifPresent(found -> keys.forEach(key -> found.find(key)
                .ifPresent(answer -> answers.put(Integer.valueOf(key.name()), answer))));
        return new AnswersFile(answers, problems.lines());
    }
}
