package particles.effects;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeMap;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import particles.effects.springs.SpringForce;
import particles.law.Vector3;
import particles.spec.Key;
import particles.spec.MappingType;
import particles.spec.NameType;
import particles.spec.NumberType;
import particles.spec.TextType;
import particles.spec.Values;
import particles.spec.VectorType;
import particles.spec.messages.InvalidInputException;

/**
 * How scenes name {@link Muscles}, with the wave that runs along a body:
 * <pre>
 *   l(t) = l (1 + a sin(2 pi (t/T - s/lambda + phase)))
 * </pre>
 */
final class MuscleKeys extends EffectKind {
    private static final Key<String> FROM = SharedKeys.PARTICLE.required("from", "The particle where it begins.");
    private static final Key<String> TO = SharedKeys.PARTICLE.required("to", "The particle where it ends.");
    private static final Key<Double> OWN_PHASE = NumberType.any("").withDefault("phase", 0.0,
            "How far it is ahead of the others, in periods.");
    private static final NumberType FRACTION = NumberType.between(0, 1, "");
    private static final Key<Double> OWN_AMPLITUDE = FRACTION.optional("amplitude",
            "Its own amplitude; by default that of all.");
    private static final Key<List<Values>> SPRINGS = MappingType.of("a muscle", FROM, TO, OWN_PHASE,
            OWN_AMPLITUDE).list("springs",
            "Single springs, by their ends. Without 'springs' and 'shape', all springs are muscles.");
    private static final Key<String> SHAPE = TextType.of("the id of a shape", "\\S").optional("shape",
            "A shape of whose springs all of a family are muscles.");
    private static final Key<String> FAMILY = NameType.of("family", List.of("structural", "shear", "bend"))
            .withDefault("family", "structural", "The family of springs in this shape.");
    private static final Key<String> PART = TextType.of("the name of a part of the shape", "\\S").optional("part",
            "A part of this shape, as in 'fixed': only springs with both ends in it are muscles.");
    private static final Key<Double> AMPLITUDE = FRACTION.required("amplitude",
            "a: the rest length is l (1 + a sin(2 pi (t/period - s/wavelength + phase))). Strain, by which springs"
            + " tear and are coloured, is measured from l.");
    private static final Key<Double> PERIOD = NumberType.positive("s").required("period", "T, the period (s).");
    private static final Key<Double> WAVELENGTH = NumberType.positive("m").optional("wavelength",
            "lambda, the length of a wave that runs along the body (m); without it all muscles work together.");
    private static final Key<Vector3> DIRECTION = VectorType.notZero("").withDefault("direction",
            new Vector3(1, 0, 0), "The direction in which the wave runs. Along it s is measured, at the start, from"
            + " the middle of this effect's hindmost muscle to the middle of each.");
    private static final Key<Double> PHASE = NumberType.any("").withDefault("phase", 0.0,
            "How far all these muscles are ahead, in periods.");
    private static final Key<Double> RISE = NumberType.notNegative("").withDefault("rise", 1.0,
            "In how many periods the amplitude rises from 0; 0 for a start at once.");

    MuscleKeys() {
        super("muscles", "Springs whose rest lengths swing.", AMPLITUDE, PERIOD, WAVELENGTH, DIRECTION, PHASE,
                RISE, SPRINGS, SHAPE, FAMILY, PART);
    }

    /** Single springs come before those of a shape, so that their own numbers count. */
    @Override
    public void build(Values values, EffectContext scene) {
        requireUse(values, SHAPE, FAMILY, PART);
        requireUse(values, WAVELENGTH, DIRECTION);
        SpringForce springs = scene.springs();
        Map<Integer, Values> chosen = new TreeMap<>();
        for (Values single : values.get(SPRINGS)) {
            for (int spring : find(single, scene)) {
                if (chosen.put(spring, single) != null) {
                    throw new InvalidInputException(single.getPlace() + ": " + between(single)
                            + " appears twice in 'springs'");
                }
            }
        }
        Optional<String> shape = values.find(SHAPE);
        IntStream others = shape.map(id -> scene.springs(id, values.get(FAMILY), values.find(PART))).orElseGet(() ->
                IntStream.range(0, values.isGiven(SPRINGS) ? 0 : springs.springCount()));
        others.forEach(s -> chosen.putIfAbsent(s, new Values(values.getPlace())));
        if (chosen.isEmpty()) {
            throw new InvalidInputException(values.place(values.isGiven(PART) ? PART : SHAPE) + ": there are no "
                    + shape.map(id -> values.get(FAMILY) + " springs in "
                    + values.find(PART).map(part -> "part '" + part + "' of ").orElse("") + "'" + id + "'")
                    .orElse("springs"));
        }
        scene.effects().filter(Muscles.class::isInstance).map(other -> (Muscles) other).forEach(other ->
                chosen.forEach((s, own) -> {
                    if (other.hasMuscle(s)) {
                        throw new InvalidInputException(own.getPlace() + ": the spring between '"
                                + scene.particles().id(springs.from(s)) + "' and '"
                                + scene.particles().id(springs.to(s)) + "' is a muscle of an earlier 'muscles'"
                                + " already; it can be one of one effect only");
                    }
                }));
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

    /** Refuses keys that say nothing without another one. */
    private static void requireUse(Values values, Key<?> needed, Key<?>... keys) {
        for (Key<?> key : keys) {
            if (values.isGiven(key) && !values.isGiven(needed)) {
                throw new InvalidInputException(values.place(key) + ": '" + key.name() + "' needs '"
                        + needed.name() + "'");
            }
        }
    }

    private static String between(Values single) {
        return "the spring between '" + single.get(FROM) + "' and '" + single.get(TO) + "'";
    }

    /** The springs between two particles. */
    private static int[] find(Values single, EffectContext scene) {
        Set<String> ends = Set.copyOf(List.of(single.get(FROM), single.get(TO)));
        SpringForce springs = scene.springs();
        int[] found = IntStream.range(0, springs.springCount()).filter(s -> ends.equals(Set.of(
                scene.particles().id(springs.from(s)), scene.particles().id(springs.to(s))))).toArray();
        if (found.length == 0) {
            throw new InvalidInputException(single.getPlace() + ": " + between(single) + " does not exist");
        }
        return found;
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
