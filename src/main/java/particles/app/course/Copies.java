package particles.app.course;

import deSolvers.catalog.SolverCatalog;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.regex.MatchResult;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import particles.app.student.SolverSkeleton;
import particles.spec.Digest;

/** Finds sources for a human to look at: those that are alike, and those that only call the project's solvers. */
final class Copies {
    private static final String USES = "uses";
    private static final Pattern COMMENT = Pattern.compile("(?s)/[*].*?[*]/|//[^\n]*");
    private static final Pattern HEAD = Pattern.compile("\\b(package|import)\\b[^;]*;");
    private static final Pattern TOKEN = Pattern.compile("[A-Za-z_]\\w*|\\d[\\w.]*|\\S");

    private Copies() {
    }

    /** @return the source with each name replaced by a number, without comments, imports and layout */
    static String shape(String source) {
        Map<String, String> names = new HashMap<>();
        return TOKEN.matcher(HEAD.matcher(COMMENT.matcher(source).replaceAll(" ")).replaceAll(" ")).results()
                .map(MatchResult::group)
                .map(word -> Character.isLetter(word.charAt(0)) ? names.computeIfAbsent(word, w -> "n" + names.size())
                : word).collect(Collectors.joining(" "));
    }

    /**
     * @param sources the text of each class of a student
     * @return for each but skeletons: its name, a digest of its shape, and whether it uses a solver of the project
     */
    static List<String> of(Map<String, String> sources) {
        List<String> skeletons = SolverSkeleton.SOLVER_BASES.stream()
                .map(base -> shape(SolverSkeleton.solver("MySolver", base))).toList();
        Pattern ours = Pattern.compile(SolverCatalog.names().stream().map(name ->
                SolverCatalog.create(name).getClass().getSimpleName())
                .collect(Collectors.joining("|", "SolverCatalog|(new|extends)\\s+(deSolvers[\\w.]*[.])?(", ")\\b")));
        List<String> classes = new ArrayList<>();
        sources.forEach((name, text) -> {
            String shape = shape(text);
            if (!skeletons.contains(shape)) {
                classes.add(name + " " + Digest.of(shape)
                        + (ours.matcher(COMMENT.matcher(text).replaceAll(" ")).find() ? " " + USES : ""));
            }
        });
        return classes;
    }

    /**
     * @param classes what {@link #of} says of each student's classes
     * @return for each group of classes that are alike, and for each that uses our solvers, the students and the reason
     */
    static List<Map.Entry<String, String>> toLookAt(Map<String, List<String>> classes) {
        Map<String, Set<String>> alike = new TreeMap<>();
        List<Map.Entry<String, String>> reasons = new ArrayList<>();
        classes.forEach((student, all) -> all.forEach(each -> {
            String[] words = each.split(" ");
            alike.computeIfAbsent(words[1], shape -> new TreeSet<>()).add(student + " (" + words[0] + ")");
            if (each.endsWith(" " + USES)) {
                reasons.add(Map.entry(student, words[0] + " uses a solver of the project"));
            }
        }));
        alike.values().stream().filter(group -> group.size() > 1).forEach(group -> reasons.add(Map.entry(String.join(
                ", ", group), "the same but for names, comments and layout")));
        return reasons;
    }
}
