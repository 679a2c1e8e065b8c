package particles.teaching.sources;

import deSolvers.problems.ReferenceProblem;
import java.util.ArrayList;
import java.util.List;

/** A source for a student's solver: it writes down arrays of a wrong length, and uses what fits of them. */
public abstract class StudentSource extends ReferenceProblem {
    private final List<Integer> wrongLengths = new ArrayList<>();

    /** @param start the state at t = 0 */
    public StudentSource(double... start) {
        super(start);
    }

    /** @return the lengths of arrays that were not as long as the state */
    public final List<Integer> wrongLengths() {
        return wrongLengths;
    }

    @Override
    protected final int checkLength(double[] array) {
        if (array.length != getStateSize()) {
            wrongLengths.add(array.length);
        }
        return Math.min(array.length, getStateSize());
    }
}
