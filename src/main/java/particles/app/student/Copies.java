package particles.app.student;

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

/** Finds sources for a human to look at: those that are alike, and those that only call the project's solvers. */
final class Copies {
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
     * @param classes the text of each class by student and name
     * @return a line for each group of students whose classes are the same but for names, comments and layout, and for
     *         each class that creates or extends a solver of the project
     */
    static List<String> toLookAt(Map<String, Map<String, String>> classes) {
        Set<String> skeletons = new TreeSet<>();
        SolverSkeleton.SOLVER_BASES.forEach(base -> List.of("MySolver", "MidpointSolver", "RK4Solver",
                "SymplecticEulerSolver").forEach(name -> skeletons.add(shape(SolverSkeleton.solver(name, base)))));
        String ours = SolverCatalog.names().stream().map(name -> SolverCatalog.create(name).getClass().getSimpleName())
                .collect(Collectors.joining("|", "SolverCatalog|(new|extends)\\s+(deSolvers[\\w.]*[.])?(", ")\\b"));
        Map<String, Set<String>> alike = new TreeMap<>();
        List<String> lines = new ArrayList<>();
        classes.forEach((student, sources) -> sources.forEach((name, text) -> {
            String shape = shape(text);
            if (!skeletons.contains(shape)) {
                alike.computeIfAbsent(shape, s -> new TreeSet<>()).add(student + " (" + name + ")");
            }
            if (Pattern.compile(ours).matcher(COMMENT.matcher(text).replaceAll(" ")).find()) {
                lines.add("uses a solver of the project: " + student + " (" + name + ")");
            }
        }));
        alike.values().stream().filter(group -> group.size() > 1)
                .forEach(group -> lines.add("the same but for names, comments and layout: "
                + String.join(", ", group)));
        return lines;
    }
}
