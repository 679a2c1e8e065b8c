package benchmarks;

import java.util.Locale;

/**
 * A run: a workload, a method and its settings.
 *
 * @param workload the workload's name
 * @param method    a solver of our catalogue or an integrator of Hipparchus
 * @param duration  the simulated time (s)
 * @param steps     the number of steps; 1 for adaptive methods
 * @param tolerance relative and absolute tolerance; NaN for the default or none
 */
record Run(String workload, String method, double duration, int steps, double tolerance) {

    /**
     * The result of a run.
     *
     * @param evaluations of the derivative
     * @param error       the error at the end, relative to the largest entry of the state
     */
    record Outcome(long evaluations, double error) {
    }

    static Run steps(String workload, String method, double duration, int steps) {
        return new Run(workload, method, duration, steps, Double.NaN);
    }

    static Run tolerance(String workload, String method, double duration, double tolerance) {
        return new Run(workload, method, duration, 1, tolerance);
    }

    /** @param text as {@link #toString} makes it */
    static Run parse(String text) {
        String[] part = text.split(" ");
        return new Run(part[0], part[1], Double.parseDouble(part[2]), Integer.parseInt(part[3]),
                Double.parseDouble(part[4]));
    }

    /** For people; {@link #toString} is for programs. */
    String label() {
        return workload + " " + method + (Double.isNaN(tolerance) ? ", " + steps + " steps"
                : String.format(Locale.ROOT, ", tolerance %.1e", tolerance));
    }

    /** Solves it once. */
    Outcome outcome(Workload solved, double[] reference) {
        long before = solved.evaluations();
        Method.of(this).solve(solved);
        return new Outcome(solved.evaluations() - before, solved.error(reference));
    }

    @Override
    public String toString() {
        return workload + " " + method + " " + duration + " " + steps + " " + tolerance;
    }
}
