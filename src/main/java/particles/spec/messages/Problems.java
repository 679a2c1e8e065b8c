package particles.spec.messages;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;

/** Collects the problems of one source, so that all are reported together. */
public final class Problems {
    /** The largest number reported. */
    static final int LIMIT = 50;

    private record Problem(Place place, String message) {
    }

    private final List<Problem> problems = new ArrayList<>();
    private int count;

    /**
     * @param place   the place of the problem
     * @param message the value found and the values allowed; made one line
     * @return nothing, which a reader may return in place of a value
     */
    public <T> Optional<T> add(Place place, String message) {
        count++;
        if (problems.size() < LIMIT) {
            problems.add(new Problem(place, Wording.oneLine(message)));
        }
        return Optional.empty();
    }

    /** @return whether no further problem is reported, so that nobody needs to look for any */
    public boolean isFull() {
        return problems.size() >= LIMIT;
    }

    /** @return the number of problems, or more than are reported if reading ended there */
    public int count() {
        return count;
    }

    /** @throws InvalidInputException with all problems, if there are any */
    public void throwIfAny() {
        if (count > 0) {
            throw new InvalidInputException(lines());
        }
    }

    /** @return the problems in the order of their places, one line each: place, colon, message */
    public List<String> lines() {
        List<String> lines = new ArrayList<>();
        problems.stream().sorted(Comparator.comparing(Problem::place))
                .forEach(problem -> lines.add(problem.place() + ": " + problem.message()));
        if (count > problems.size()) {
            lines.add(problems.get(0).place().source() + ": and more; these are the first " + LIMIT);
        }
        return lines;
    }
}
