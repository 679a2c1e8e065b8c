package particles.effects;

import deSolvers.ForceDerivatives;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import particles.effects.springs.SpringForce;
import particles.law.BriefForce;
import particles.law.DifferentiableEffect;
import particles.law.Particles;
import particles.law.Require;
import particles.law.Vector3;
import particles.spec.Key;
import particles.spec.ListType;
import particles.spec.MappingType;
import particles.spec.NameType;
import particles.spec.NumberType;
import particles.spec.TextType;
import particles.spec.Values;
import particles.spec.VectorType;
import particles.spec.messages.InvalidInputException;

/**
 * Muscles: springs whose rest length varies,
 * <pre>
 *   l(t) = l (1 + a sin(2 pi (t/T + phase)))
 * </pre>
 * a the amplitude, T the period. Where the phase falls by s/lambda along a body, a wave of length lambda runs that way.
 * The amplitude may rise from 0 in the first periods, as u&sup3; (10 - 15 u + 6 u&sup2;), so that nothing jumps.
 *
 * <p>The springs' own force has l, so this law adds the difference: with the spring's direction u from its first end i
 * to the other, F_i = -k (l(t) - l) u and F_j = -F_i. A spring that tears, or dies with a particle, takes its muscle
 * with it. Both laws together store k (|r| - l(t))&sup2;/2; this law's share is what the springs' lacks. A muscle that
 * shortens under tension does work: its driven power is -k (|r| - l(t)) dl/dt.
 *
 * <p>Source: G. Miller, "The motion dynamics of snakes and worms", SIGGRAPH 1988.
 */
public final class Muscles implements DifferentiableEffect, BriefForce {
    private final SpringForce springs;
    private final double period;
    private final double rise;
    private Muscle[] muscles = {};

    /** A spring, a cos(2 pi phase) and a sin(2 pi phase). */
    private record Muscle(int spring, double cos, double sin) {
    }

    /** Two numbers that all muscles have in common; with a muscle's own they give its (l(t) - l)/l, or its rate. */
    private record Beat(double sin, double cos) {
        double of(Muscle muscle) {
            return sin * muscle.cos + cos * muscle.sin;
        }
    }

    /**
     * @param springs the springs
     * @param period  T (s), positive
     * @param rise    the number of periods in which the amplitude rises from 0; 0 for none
     * @throws IllegalArgumentException if a number is out of its range
     */
    public Muscles(SpringForce springs, double period, double rise) {
        this.springs = springs;
        this.period = Require.positive("a muscle's period", period);
        this.rise = period * Require.notNegative("the rise of a muscle's amplitude", rise);
        springs.onReorder(this::follow);
    }

    /**
     * Makes a spring a muscle.
     *
     * @param spring    its index
     * @param amplitude a, from 0 to 1
     * @param phase     in periods
     */
    public void add(int spring, double amplitude, double phase) {
        double angle = 2 * Math.PI * phase;
        Muscle muscle = new Muscle(spring, amplitude * StrictMath.cos(angle), amplitude * StrictMath.sin(angle));
        muscles = Stream.concat(Stream.of(muscles), Stream.of(muscle)).toArray(Muscle[]::new);
    }

    /** Follows the springs to their new places, {@code order[place]} being the old one. */
    private void follow(int[] order) {
        Map<Integer, Muscle> before = new HashMap<>();
        for (Muscle muscle : muscles) {
            before.put(muscle.spring, muscle);
        }
        muscles = IntStream.range(0, order.length).filter(place -> before.containsKey(order[place])).mapToObj(place -> {
            Muscle muscle = before.get(order[place]);
            return new Muscle(place, muscle.cos, muscle.sin);
        }).toArray(Muscle[]::new);
    }

    @Override
    public String getName() {
        return "muscles";
    }

    @Override
    public Set<Trait> getTraits() {
        return Set.of(Trait.INTERNAL, Trait.TRANSLATION_INVARIANT, Trait.ROTATION_INVARIANT, Trait.DRIVING);
    }

    @Override
    public boolean dependsOnVelocity() {
        return false;
    }

    /** {@inheritDoc} The period. */
    @Override
    public double getShortestTime(double[] state, double time) {
        return muscles.length > 0 ? period : Double.POSITIVE_INFINITY;
    }

    private Beat beat(double time) {
        double angle = 2 * Math.PI * time / period;
        double risen = risen(time);
        return new Beat(risen * StrictMath.sin(angle), risen * StrictMath.cos(angle));
    }

    /** d/dt of the beat (1/s). */
    private Beat rate(double time) {
        double omega = 2 * Math.PI / period;
        double sin = StrictMath.sin(omega * time);
        double cos = StrictMath.cos(omega * time);
        double risen = omega * risen(time);
        double u = time / rise;
        double rising = u > 0 && u < 1 ? 30 * u * u * (1 - u) * (1 - u) / rise : 0;
        return new Beat(rising * sin + risen * cos, rising * cos - risen * sin);
    }

    /** The part of its amplitude that a muscle has reached. */
    private double risen(double time) {
        double u = Math.max(0, time / rise);
        return u < 1 ? u * u * u * (10 + u * (6 * u - 15)) : 1;
    }

    /** k (l(t) - l) u, 0 where the spring has no direction. */
    private Vector3 push(Muscle muscle, Beat beat, double[] state) {
        int s = muscle.spring;
        double length = springs.length(state, s);
        return length == 0 ? Vector3.ZERO
                : Vector3.at(state, end(s)).minus(Vector3.at(state, start(s))).over(length)
                        .times(springs.stiffness(s) * springs.restLength(s) * beat.of(muscle));
    }

    private int start(int spring) {
        return Particles.STRIDE * springs.from(spring);
    }

    private int end(int spring) {
        return Particles.STRIDE * springs.to(spring);
    }

    @Override
    public void addForces(double[] state, double time, double[] force) {
        Beat beat = beat(time);
        for (Muscle muscle : muscles) {
            Vector3 push = push(muscle, beat, state);
            int i = start(muscle.spring) + 3;
            int j = end(muscle.spring) + 3;
            Vector3.at(force, i).minus(push).put(force, i);
            Vector3.at(force, j).plus(push).put(force, j);
        }
    }

    /** {@inheritDoc} dF_i/dx_i = k (l(t) - l)/|r| (1 - u u<sup>T</sup>). */
    @Override
    public void addForceDerivatives(double[] state, double time, ForceDerivatives derivatives) {
        Beat beat = beat(time);
        double[] dFdX = new double[9];
        double[] dFdV = new double[9];
        double[] u = new double[3];
        for (Muscle muscle : muscles) {
            int s = muscle.spring;
            double length = springs.length(state, s);
            if (length > 0) {
                Vector3.at(state, end(s)).minus(Vector3.at(state, start(s))).over(length).put(u, 0);
                double across = springs.stiffness(s) * springs.restLength(s) * beat.of(muscle) / length;
                for (int e = 0; e < 9; e++) {
                    dFdX[e] = across * ((e % 4 == 0 ? 1 : 0) - u[e / 3] * u[e % 3]);
                }
                derivatives.addPair(springs.from(s), springs.to(s), dFdX, dFdV);
            }
        }
    }

    /** {@inheritDoc} k (|r| - l(t))&sup2;/2 - k (|r| - l)&sup2;/2. */
    @Override
    public double getPotentialEnergy(double[] state, double time) {
        Beat beat = beat(time);
        double energy = 0;
        for (Muscle muscle : muscles) {
            int s = muscle.spring;
            double longer = springs.restLength(s) * beat.of(muscle);
            energy += springs.stiffness(s) * longer * (longer / 2 - springs.length(state, s) + springs.restLength(s));
        }
        return energy;
    }

    @Override
    public double getDrivenPower(double[] state, double time) {
        Beat beat = beat(time);
        Beat rate = rate(time);
        double power = 0;
        for (Muscle muscle : muscles) {
            int s = muscle.spring;
            double stretch = springs.length(state, s) - springs.restLength(s) * (1 + beat.of(muscle));
            power -= springs.stiffness(s) * stretch * springs.restLength(s) * rate.of(muscle);
        }
        return power;
    }

    /** Muscles in scenes. */
    public static final class Keys extends EffectKind {
        private static final Key<String> FROM = SharedKeys.PARTICLE.required("from", "The particle where it begins.");
        private static final Key<String> TO = SharedKeys.PARTICLE.required("to", "The particle where it ends.");
        private static final Key<Double> OWN_PHASE = NumberType.any("").withDefault("phase", 0.0,
                "How far it is ahead of the others, in periods.");
        private static final NumberType FRACTION = NumberType.between(0, 1, "");
        private static final Key<Double> OWN_AMPLITUDE = FRACTION.optional("amplitude",
                "Its own amplitude; by default that of all.");
        private static final Key<List<Values>> SPRINGS = ListType.of("a muscle", MappingType.of("a muscle", FROM, TO,
                OWN_PHASE, OWN_AMPLITUDE)).withDefault("springs", List.of(),
                "Single springs, by their ends. By default, and without 'shape', all springs are muscles.");
        private static final Key<String> SHAPE = TextType.of("the id of a shape", "\\S").optional("shape",
                "A shape of whose springs all of a family are muscles.");
        private static final Key<String> FAMILY = NameType.of("family", List.of("structural", "shear", "bend"))
                .withDefault("family", "structural", "The family of springs in this shape.");
        private static final Key<String> PART = TextType.of("the name of a part of the shape", "\\S").optional("part",
                "A part of this shape, as in 'fixed': only springs with both ends in it are muscles.");
        private static final Key<Double> AMPLITUDE = FRACTION.required("amplitude",
                "a: the rest length is l (1 + a sin(2 pi (t/period - s/wavelength + phase))).");
        private static final Key<Double> PERIOD = NumberType.positive("s").required("period", "T, the period (s).");
        private static final Key<Double> WAVELENGTH = NumberType.positive("m").optional("wavelength",
                "lambda, the length of a wave that runs along the body (m); without it all muscles work together.");
        private static final Key<Vector3> DIRECTION = VectorType.notZero("").withDefault("direction",
                new Vector3(1, 0, 0), "The direction in which the wave runs, and along which s is measured: from the"
                + " hindmost muscle to the middle of each, at the start.");
        private static final Key<Double> PHASE = NumberType.any("").withDefault("phase", 0.0,
                "How far all these muscles are ahead, in periods.");
        private static final Key<Double> RISE = NumberType.notNegative("").withDefault("rise", 1.0,
                "In how many periods the amplitude rises from 0; 0 for a start at once.");

        /** Called once, by {@link EffectCatalog}. */
        public Keys() {
            super("muscles", "Springs whose rest lengths swing.", AMPLITUDE, PERIOD, WAVELENGTH, DIRECTION, PHASE,
                    RISE, SPRINGS, SHAPE, FAMILY, PART);
        }

        /** Single springs come before those of a shape, so that their own numbers count. */
        @Override
        public void build(Values values, EffectContext scene) {
            SpringForce springs = scene.springs();
            Map<Integer, Values> chosen = new HashMap<>();
            for (Values single : values.get(SPRINGS)) {
                chosen.put(find(single, scene), single);
            }
            Optional<String> shape = values.find(SHAPE);
            IntStream others = shape.map(id -> scene.springs(id, values.get(FAMILY), values.find(PART))).orElseGet(() ->
                    IntStream.range(0, chosen.isEmpty() ? springs.springCount() : 0));
            others.forEach(s -> chosen.putIfAbsent(s, new Values(values.getPlace())));
            if (chosen.isEmpty()) {
                throw new InvalidInputException(values.place(SHAPE) + ": there are no "
                        + shape.map(id -> values.get(FAMILY) + " springs in '" + id + "'"
                        + values.find(PART).map(part -> ", part '" + part + "'").orElse("")).orElse("springs"));
            }
            Vector3 direction = values.get(DIRECTION).normalized();
            double[] along = IntStream.range(0, springs.springCount()).mapToDouble(s -> 0.5 * direction.dot(
                    scene.position(springs.from(s)).plus(scene.position(springs.to(s))))).toArray();
            double hindmost = chosen.keySet().stream().mapToDouble(s -> along[s]).min().orElseThrow();
            Muscles muscles = new Muscles(springs, values.get(PERIOD), values.get(RISE));
            chosen.forEach((s, own) -> {
                double amplitude = own.find(OWN_AMPLITUDE).orElse(values.get(AMPLITUDE));
                muscles.add(s, amplitude, values.get(PHASE) + own.find(OWN_PHASE).orElse(0.0)
                        - values.find(WAVELENGTH).map(length -> (along[s] - hindmost) / length).orElse(0.0));
                scene.noteSpeed(2 * Math.PI * amplitude * springs.restLength(s) / values.get(PERIOD));
            });
            scene.add(muscles);
        }

        private static int find(Values single, EffectContext scene) {
            List<String> ends = List.of(single.get(FROM), single.get(TO));
            SpringForce springs = scene.springs();
            return IntStream.range(0, springs.springCount()).filter(s -> Set.copyOf(ends).equals(Set.of(
                    scene.particles().id(springs.from(s)), scene.particles().id(springs.to(s))))).findFirst()
                    .orElseThrow(() -> new InvalidInputException(single.getPlace() + ": there is no spring between '"
                            + ends.get(0) + "' and '" + ends.get(1) + "'"));
        }

        @Override
        public List<String> particles(Values values) {
            return Stream.concat(values.find(SHAPE).stream(), values.list(SPRINGS).stream().flatMap(single ->
                    Stream.of(FROM, TO).flatMap(end -> single.find(end).stream()))).toList();
        }

        @Override
        public boolean isRepeatable() {
            return true;
        }
    }
}
