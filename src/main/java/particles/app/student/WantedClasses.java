package particles.app.student;

import java.util.List;
import java.util.Set;
import java.util.stream.Stream;
import picocli.CommandLine.Option;

/** The options that name the classes to hand in. */
final class WantedClasses {
    @Option(names = "--solvers", paramLabel = "NAMES", description = "Solver classes that have to pass, separated by"
            + " commas (default: every ...Solver that is there).")
    private String solvers;

    @Option(names = "--effects", paramLabel = "NAMES", defaultValue = "",
            description = "Force laws that have to pass, separated by commas (default: none).")
    private String effects;

    /** @return the names of the solvers to mark, if a student has these classes */
    List<String> solvers(Set<String> there) {
        return solvers == null ? there.stream().filter(name -> name.endsWith("Solver")).toList()   // null: not given
                : names(solvers);
    }

    /** @return the names of the effects to mark */
    List<String> effects() {
        return names(effects);
    }

    private static List<String> names(String list) {
        return Stream.of(list.split(",")).map(name -> name.strip().replaceFirst("^exercises[.]", ""))
                .filter(name -> !name.isEmpty()).distinct().toList();
    }
}
