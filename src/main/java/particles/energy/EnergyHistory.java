package particles.energy;

import java.util.ArrayList;
import java.util.DoubleSummaryStatistics;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.DoubleUnaryOperator;
import java.util.stream.Collectors;
import particles.ParticleSystem;
import particles.StridedRecorder;
import particles.law.Effect;
import particles.law.Effect.Trait;
import particles.law.Particles;
import particles.law.Vector3;
import particles.view.Axis;
import particles.view.Chart;
import particles.view.Look;
import particles.view.Series;

/**
 * Records the energies of a run over time: kinetic energy, the potential energy of each effect, and their sum. It
 * records after each step and again after a rule changed something, so that the loss in a bounce is a vertical line.
 * Curves are thinned to some thousand points, with every extreme kept.
 */
public final class EnergyHistory extends StridedRecorder {
    private static final int BUCKETS = 1024;
    /** Below this part of the estimated energy nothing moves by 1e-12 of what was expected. */
    private static final double NOTHING = 1e-24;
    /** Energies below this part of weight times height are the rounding of a scene at rest. */
    private static final double AT_REST = 1e-12;

    /** If energies grow beyond this factor, earlier ones look like 0 on a linear axis. */
    private static final double MUCH = 1000;
    /** Relative to coordinates: particles at one level may differ by this in height. */
    private static final double SAME_LEVEL = 1e-12;
    /** Of the largest energy. */
    private static final double ROUND_OFF = 1e-16;

    private final MinMaxThinning kinetic = new MinMaxThinning(BUCKETS);
    private final MinMaxThinning total = new MinMaxThinning(BUCKETS);
    private final List<Part> parts = new ArrayList<>();
    /** What all effects of a name store together. */
    private final Map<String, MinMaxThinning> kinds = new LinkedHashMap<>();
    private double internal;                            // kinetic plus stored energy, latest
    private double largestInternal = Double.NEGATIVE_INFINITY;
    private double lowestInternal;                      // the sum of the lowest energies of bonds
    private double restScale;

    /** What one effect stores. */
    private static final class Part {
        private final Effect effect;
        private double smallest = Double.POSITIVE_INFINITY;
        private double lowest;                          // of its bonds, 0 or less

        Part(Effect effect) {
            this.effect = effect;
        }

        /**
         * A uniform field such as gravity has its zero at its lowest value in the run, so that the choice of the origin
         * does not matter. An attraction has its own zero, far away: an orbit that cannot escape has a negative energy.
         */
        double zero() {
            return Trait.isUniform(effect) ? smallest : 0;
        }
    }

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
        system.getEffects().forEach(effect -> parts.add(new Part(effect)));
        restScale = restScale(system);
        super.started(system);
        restScale -= lowestInternal;
    }

    /**
     * The energy scale of a scene in which nothing moves, weight times height (J): the length of the sum of all
     * effects' forces on the particles that can move, times the extent of all particles along it, or times 1 m where
     * they have none beyond round-off; 0 without force.
     */
    private static double restScale(ParticleSystem system) {
        Particles particles = system.getParticles();
        double[] state = system.getOwnState();
        double[] force = new double[system.getStateSize()];
        system.addUpEffects(state, system.getTime(), force);
        Vector3 sum = particles.free().mapToObj(i -> Vector3.at(force, Particles.STRIDE * i + 3))
                .reduce(Vector3.ZERO, Vector3::plus);
        double weight = Math.sqrt(sum.dot(sum));
        if (!(weight > 0)) {
            return 0;
        }
        DoubleSummaryStatistics along = particles.along(state, sum);
        double most = along.getMax() / weight;
        double least = along.getMin() / weight;
        return weight * (most - least > SAME_LEVEL * Math.max(most, -least) ? most - least : 1);
    }

    @Override
    protected void record(ParticleSystem system, double[] state, double time) {
        double motion = system.getKineticEnergy(state);
        double sum = 0;
        internal = motion;
        lowestInternal = 0;
        Map<String, Double> stored = new LinkedHashMap<>();
        for (Part part : parts) {
            double energy = part.effect.getPotentialEnergy(state, time);
            sum += energy;
            if (part.effect.getTraits().contains(Trait.INTERNAL)) {
                internal += energy;
                part.lowest = Math.min(part.lowest, energy);
                lowestInternal += part.lowest;
            }
            part.smallest = Math.min(part.smallest, energy);
            stored.merge(part.effect.getName(), energy, (known, more) -> known + more);
        }
        stored.forEach((name, energy) ->
                kinds.computeIfAbsent(name, unknown -> new MinMaxThinning(BUCKETS)).add(time, energy));
        kinetic.add(time, motion);
        total.add(time, motion + sum);
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

    /** The sum of the zeros of all parts. */
    private double zero() {
        return parts.stream().mapToDouble(Part::zero).reduce(0, (sum, zero) -> sum + zero);
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
        return scaleOf(largestInternal);
    }

    /** The energy scale of a run with this as its largest kinetic plus stored energy (J). */
    double scaleOf(double mostInternal) {
        double largest = mostInternal - lowestInternal;
        return largest > AT_REST * restScale ? largest : restScale;
    }

    /**
     * @param estimate the scene's estimated energy (J)
     * @return the energy scale; the estimate if that is 0, or round-off of a scene at rest
     */
    public double getScaleOr(double estimate) {
        return scaleOf(largestInternal, estimate);
    }

    /** The energy scale of a run with this as its largest kinetic plus stored energy, or the estimate (J). */
    double scaleOf(double mostInternal, double estimate) {
        double scale = scaleOf(mostInternal);
        return scale > NOTHING * estimate ? scale : estimate;
    }

    /** The latest kinetic plus stored energy (J). */
    double getInternal() {
        return internal;
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
     * The energies. The total is the first series. Gravity's potential has its zero at the lowest value of the run, and
     * the axis says so. An energy that goes up and down so often that its line would fill an area is drawn as its mean.
     *
     * @return the chart
     * @throws IllegalStateException before the run
     */
    public Chart chart() {
        if (total.isEmpty()) {
            throw new IllegalStateException("no run was observed");
        }
        boolean log = hasGrown();
        Map<String, Double> zeros = parts.stream().collect(Collectors.groupingBy(part -> part.effect.getName(),
                LinkedHashMap::new, Collectors.summingDouble(Part::zero)));
        String shifted = zeros.keySet().stream().filter(name -> zeros.get(name) != 0)
                .collect(Collectors.joining(" and "));
        Axis axis = new Axis("energy" + (shifted.isEmpty() ? "" : ", " + shifted + " from its lowest"), "J", log);
        List<Series> series = new ArrayList<>();
        series.add(total.line(Look.number(0), "total", from(zero(), log), axis));
        series.add(kinetic.lineOrMean(Look.number(1), "kinetic", from(0, log), axis));
        kinds.forEach((name, stored) -> {
            if (stored.largestSize() != 0) {
                series.add(stored.lineOrMean(Look.number(series.size()), name, from(zeros.get(name), log), axis));
            }
        });
        return new Chart(Axis.TIME, axis, List.copyOf(series));
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
