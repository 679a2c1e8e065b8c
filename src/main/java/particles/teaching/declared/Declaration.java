package particles.teaching.declared;

import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.Set;
import java.util.regex.Pattern;
import java.util.stream.Stream;

/**
 * What a solver is declared to be.
 *
 * @param method the method
 * @param asked  whether it was asked for, so that no other method will do
 * @param alone  whether the name of the class says nothing else; RichardsonEuler need not be Euler
 */
public record Declaration(Method method, boolean asked, boolean alone) {
    private static final Set<String> FILLERS = Set.of("my", "our", "the", "own", "new", "simple", "basic", "standard",
            "fixed", "step", "solver", "method", "integrator", "stepper", "scheme", "rule", "ode", "de", "student",
            "team", "group", "test", "classical", "classic", "explicit", "implicit", "order", "task",
            "exercise", "homework", "assignment");

    /** @return what the name of a class declares, by the longest name in it; empty if it has none of the words */
    public static Optional<Declaration> of(String className) {
        List<String> words = words(className);
        Optional<Declaration> found = Optional.empty();
        int longest = 0;
        for (int from = 0; from < words.size(); from++) {
            for (int to = from + 1; to <= words.size(); to++) {
                String name = String.join("", words.subList(from, to));
                Optional<Method> named = Arrays.stream(Method.values()).filter(method -> method.words().anyMatch(
                        name::equals)).findFirst();
                if (named.isPresent() && name.length() > longest) {
                    longest = name.length();
                    found = Optional.of(new Declaration(named.get(), false, Stream.concat(words.stream().limit(from),
                            words.stream().skip(to)).allMatch(word -> FILLERS.contains(word) || word.length() == 1
                            || Character.isDigit(word.charAt(0)))));
                }
            }
        }
        return found;
    }

    /** The words of a name, which begin at a capital letter or a digit: RK4Solver has rk, 4 and solver. */
    private static List<String> words(String name) {
        return Pattern.compile("\\d+|\\p{Lu}+(?!\\p{Ll})|\\p{Lu}?\\p{Ll}+").matcher(name).results().map(word ->
                word.group().toLowerCase(Locale.ROOT)).toList();
    }

    /** @return whether a known method is no other one than declared */
    public boolean allows(Method known) {
        return known == method || !asked && method.mayBe(known) || !asked && !alone || method.isFamily();
    }
}
