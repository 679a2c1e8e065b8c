package particles.app.course;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeMap;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import particles.app.student.AskedMethods;
import particles.spec.Key;
import particles.spec.MapType;
import particles.spec.MappingType;
import particles.spec.NameType;
import particles.spec.NumberType;
import particles.spec.Reading;
import particles.spec.SourceText;
import particles.spec.TextType;
import particles.spec.Type;
import particles.spec.Values;
import particles.spec.messages.Place;
import particles.spec.messages.Problems;
import particles.teaching.exercises.Exercises;

/**
 * What counts, and how much: the file {@code assignment.yaml} of a lecturer. All of its keys may be left out:
 *
 * <pre>
 * numbers: id                               # numbers from the id; sheet: those of the key file
 * exercises: {1: 1, 5: 2}                   # number and weight; without this key, all count 1
 * solvers:                                  # without this key, every ...Solver counts 1
 *   HeunSolver: heun                        # any other right method does not pass
 *   MySolver: {method: any, weight: 2}
 * effects: {MyForce: 2}                     # class and weight; without this key, none
 * </pre>
 *
 * @param numbers   where the numbers of exercises come from
 * @param exercises the weight of each exercise that counts
 * @param solvers   each solver that counts; empty for every class with such a name
 * @param effects   the weight of each effect that counts
 */
record Assignment(Numbers numbers, Map<Integer, Double> exercises, Optional<Map<String, Asked>> solvers,
        Map<String, Double> effects) {
    static final String FILE = "assignment.yaml";
    private static final Type<String> CLASS = TextType.of("the name of a class", "^[A-Za-z_][A-Za-z0-9_]*$");
    private static final NumberType POINTS = NumberType.notNegative("");

    private static final Key<Numbers> NUMBERS = NameType.of("choice", Numbers.class).withDefault("numbers", Numbers.ID,
            "Where the numbers of exercises come from.");
    private static final Key<Map<Integer, Double>> EXERCISES = new MapType<>(new NumberType.Whole(1,
            Exercises.ALL.size()), POINTS).withDefault("exercises", IntStream.rangeClosed(1, Exercises.ALL.size())
            .boxed().collect(Collectors.toMap(n -> n, n -> 1.0)), "The weight of each exercise that counts.");
    private static final Key<String> METHOD = NameType.of("method", AskedMethods.NAMES).withDefault("method",
            AskedMethods.ANY, "The method that it has to be.");
    private static final Key<Double> WEIGHT = POINTS.withDefault("weight", 1.0, "What it counts.");
    private static final Key<Map<String, Values>> SOLVERS = new MapType<>(CLASS,
            MappingType.of("a solver", METHOD, WEIGHT).shortFor(METHOD)).optional("solvers", "The solvers that count.");
    private static final Key<Map<String, Double>> EFFECTS = new MapType<>(CLASS, POINTS)
            .withDefault("effects", Map.of(), "The effects that count.");
    private static final MappingType FORMAT = MappingType.of("the assignment", NUMBERS, EXERCISES, SOLVERS, EFFECTS);

    /** Where the numbers of exercises come from: the student's id, or a key file. */
    enum Numbers { ID, SHEET }

    /**
     * A solver that counts.
     *
     * @param method the method that it has to be
     * @param weight what it counts
     */
    record Asked(String method, double weight) {
    }

    /**
     * @param file the file, or assignment.yaml in this folder, which may be missing
     * @return the assignment
     * @throws particles.spec.messages.InvalidInputException with a line for each mistake
     */
    static Assignment read(Optional<Path> file) {
        Path path = file.orElse(Path.of(FILE));
        Problems problems = new Problems();
        Reading in = new Reading(path.toString().replace('\\', '/'), problems);
        Optional<Values> values = file.isEmpty() && !Files.exists(path) ? Optional.of(new Values(Place.of(FILE)))
                : SourceText.read(path, in).flatMap(text -> FORMAT.read(text, in));
        problems.throwIfAny();
        Values all = values.orElseThrow();
        return new Assignment(all.get(NUMBERS), new TreeMap<>(all.get(EXERCISES)), all.find(SOLVERS).map(asked -> {
            Map<String, Asked> solvers = new TreeMap<>();
            asked.forEach((name, solver) -> solvers.put(name, new Asked(solver.get(METHOD), solver.get(WEIGHT))));
            return solvers;
        }), new TreeMap<>(all.get(EFFECTS)));
    }

    /** @return the solvers that count, if a student has these classes */
    Map<String, Asked> solvers(Set<String> there) {
        return solvers.orElseGet(() -> there.stream().filter(name -> name.endsWith("Solver")).collect(Collectors.toMap(
                name -> name, name -> new Asked(AskedMethods.ANY, 1), (a, b) -> a, TreeMap::new)));
    }
}
