package particles.view;

/**
 * An axis of a chart.
 *
 * @param quantity the quantity along it
 * @param unit     its unit; empty for a number without one
 * @param log      whether it is logarithmic; otherwise it is linear
 */
public record Axis(String quantity, String unit, boolean log) {
    /** Simulated time. */
    public static final Axis TIME = linear("time", "s");

    /** @return a linear axis */
    public static Axis linear(String quantity, String unit) {
        return new Axis(quantity, unit, false);
    }

    /** @return a logarithmic axis */
    public static Axis log(String quantity, String unit) {
        return new Axis(quantity, unit, true);
    }

    /** @return the text beside the axis, such as "time (s)" */
    public String label() {
        return unit.isEmpty() ? quantity : quantity + " (" + unit + ")";
    }
}
