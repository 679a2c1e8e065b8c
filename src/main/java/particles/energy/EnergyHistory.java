package particles.energy;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.function.DoubleUnaryOperator;
import particles.ParticleSystem;
import particles.law.Effect;
import particles.view.ChartData;
import particles.view.ChartData.Series;

/**
 * Records the energies of a run over time: kinetic energy, the potential energy of each effect, and their sum. It
 * records after each step and again after a rule changed something, so that the loss in a bounce is a vertical line.
 * Curves are thinned to some thousand points, with every extreme kept.
 */
public final class EnergyHistory extends StridedRecorder {
    private static final int BUCKETS = 1024;
    /** Energies below this part of weight times height are the rounding of a scene at rest. */
    private static final double AT_REST = 1e-12;

    /** If energies grow beyond this factor, earlier ones look like 0 on a linear axis. */
    private static final double MUCH = 1000;
    /** Of the largest energy. */
    private static final double ROUND_OFF = 1e-16;

    private final MinMaxThinning kinetic = new MinMaxThinning(BUCKETS);
    private final MinMaxThinning total = new MinMaxThinning(BUCKETS);
    private final MinMaxThinning potential = new MinMaxThinning(BUCKETS);
    private final List<Effect> effects = new ArrayList<>();
    private final List<MinMaxThinning> stored = new ArrayList<>();
    private double internal;                            // kinetic plus stored energy, latest
    private double largestInternal = Double.NEGATIVE_INFINITY;
    private double[] lowest = {};                       // the lowest energy of each effect's bonds, 0 or less
    private double lowestInternal;                      // their sum
    private double restScale;

    /** Creates a history that records every step. */
    public EnergyHistory() {
        this(1);
    }

    /**
     * @param stride the number of steps from one record to the next, 1 or more; a record costs as much as half an
     *               evaluation
     */
    public EnergyHistory(long stride) {
        super(stride);
    }

    @Override
    public void started(ParticleSystem system) {
        effects.addAll(system.getEffects());
        effects.forEach(effect -> stored.add(new MinMaxThinning(BUCKETS)));
        lowest = new double[effects.size()];
        restScale = RestScale.of(system);
        super.started(system);
        restScale -= lowestInternal;
    }

    @Override
    void record(ParticleSystem system, double[] state, double time) {
        double motion = system.getKineticEnergy(state);
        double sum = 0;
        internal = motion;
        for (int e = 0; e < lowest.length; e++) {
            Effect effect = effects.get(e);
            double energy = effect.getPotentialEnergy(state, time);
            sum += energy;
            if (effect.getTraits().contains(Effect.Trait.INTERNAL)) {
                internal += energy;
                lowest[e] = Math.min(lowest[e], energy);
            }
            stored.get(e).add(time, energy);
        }
        kinetic.add(time, motion);
        potential.add(time, sum);
        total.add(time, motion + sum);
        lowestInternal = Arrays.stream(lowest).sum();
        largestInternal = Math.max(largestInternal, internal);
    }

    /** @return the total energy at the start, with the chart's zero (J) */
    public double getStart() {
        return total.getFirst() - zero();
    }

    /** @return the total energy at the end, with the chart's zero (J) */
    public double getEnd() {
        return total.getLast() - zero();
    }

    /** The sum of all zeros that {@link #lowest} subtracts. */
    private double zero() {
        double sum = 0;
        for (int e = 0; e < effects.size(); e++) {
            sum += lowest(e);
        }
        return sum;
    }

    /**
     * A uniform field such as gravity has its zero at its lowest value in the run, so that the choice of the origin
     * does not matter. An attraction has its own zero, far away: an orbit that cannot escape has a negative energy.
     */
    private double lowest(int effect) {
        return Effect.Trait.isUniform(effects.get(effect)) ? stored.get(effect).smallest() : 0;
    }

    /** @return the largest |E(t) - E(0)| of the run (J) */
    public double getLargestDrift() {
        return Math.max(total.largest() - total.getFirst(), total.getFirst() - total.smallest());
    }

    /**
     * The energy scale: the largest kinetic plus stored energy of the run. What springs and bonds store counts from the
     * lowest value in the run where that is negative, as it is for particles that attract each other: of a bound pair,
     * which swings, the scale is its largest kinetic energy. A scene at rest has its weight times its height and the
     * energy of its bonds instead. The zero of gravity's potential does not matter.
     *
     * @return the energy by which errors are divided (J)
     */
    public double getScale() {
        double largest = largestInternal - lowestInternal;
        return largest > AT_REST * restScale ? largest : restScale;
    }

    /**
     * @param estimate the scene's estimated energy (J)
     * @return the energy scale; the estimate if that is 0
     */
    public double getScaleOr(double estimate) {
        return getScale() > 0 ? getScale() : estimate;
    }

    /** The latest kinetic plus stored energy, counted as in the energy scale (J). */
    double getLatest() {
        return internal - lowestInternal;
    }

    /** The energy scale of the scene if nothing moved (J). */
    double getRestScale() {
        return restScale;
    }

    /**
     * The energies. The total is the first series. Gravity's potential has its zero at the lowest value of the run,
     * and the axis says so.
     *
     * @param title the title of the chart, such as the scene and its solver
     * @return the chart
     * @throws IllegalStateException before the run
     */
    public ChartData chart(String title) {
        if (total.isEmpty()) {
            throw new IllegalStateException("no run was observed");
        }
        List<Series> series = new ArrayList<>();
        double zero = zero();
        boolean log = hasGrown();
        List<Series> parts = new ArrayList<>();
        List<String> shifted = new ArrayList<>();
        for (int e = 0; e < effects.size(); e++) {
            MinMaxThinning energy = stored.get(e);
            if (energy.smallest() == 0 && energy.largest() == 0) {
                continue;
            }
            double lowest = lowest(e);
            if (lowest != 0) {
                shifted.add(effects.get(e).getName());
            }
            parts.add(energy.line("potential: " + effects.get(e).getName(), from(lowest, log)));
        }
        series.add(total.line("total", from(zero, log)));
        series.add(kinetic.line("kinetic", from(0, log)));
        if (parts.size() > 1) {
            series.add(potential.line("potential", from(zero, log)));
        }
        series.addAll(parts);
        String axis = "energy (J)" + (shifted.isEmpty() ? ""
                : "; " + String.join(" and ", shifted) + " is 0 at its lowest");
        return new ChartData(title, "time (s)", axis, false, log, List.copyOf(series));
    }

    /** @return whether the energy grew by more than a factor of a thousand since the run's first tenth */
    public boolean hasGrown() {
        double[] energies = total.points()[1];
        double before = 0;
        for (int k = 0; k <= energies.length / 10; k++) {
            before = Math.max(before, energies[k] - zero());
        }
        double largest = total.largest() - zero();
        return before > ROUND_OFF * largest && largest > MUCH * before;
    }

    /**
     * Energies above a zero. On a logarithmic axis round-off, which would stretch it to 1e-30, becomes 0, which is not
     * drawn.
     */
    private DoubleUnaryOperator from(double zero, boolean log) {
        double largest = total.largest() - zero();
        return joules -> log && !(joules - zero > ROUND_OFF * largest) ? 0 : joules - zero;
    }
}
