package particles.scene;

import deSolvers.text.Digits;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import particles.law.Vector3;
import particles.reactions.Curve;
import particles.scene.format.SceneFormat;
import particles.scene.parts.ParticleIndex;
import particles.scene.parts.RuleKind;
import particles.scene.parts.SpringDescription;
import particles.scene.parts.WireKind;
import particles.spec.Key;
import particles.spec.Kind.Chosen;
import particles.spec.Values;
import particles.spec.messages.Place;
import particles.spec.messages.Problems;
import particles.spec.messages.Wording;

/**
 * Checks a scene's springs, rods, lines, faces and wires: known and free ends, and initial velocities that respect
 * them.
 *
 * @param scene    the values in the file
 * @param problems receives the problems
 * @param known    the particles
 * @param index    those without mistakes
 */
record ConstraintChecks(Values scene, Problems problems, KnownParticles known, ParticleIndex index) {
    /** The largest initial distance of a bead from its wire (m): positions in files have few digits. */
    private static final double ON_WIRE = 1e-3;
    /** Turns in the search for velocities that fit: enough for a chain of 30 rods. */
    private static final int MOST_SWEEPS = 10_000;
    /** Speeds along a rod or off a wire below this are round-off (m/s). */
    private static final double STILL = 1e-9;
    /** Largest distance from the line of a rod that counts as on it, as a fraction of its length. */
    private static final double IN_LINE = 1e-5;
    private static final double MOST_FEEDBACK = 0.5;
    /** The number of Newton steps; far from a wire one step on each function may only halve the distance. */
    private static final int STEPS = 200;

    void check() {
        withKnownEnds(SceneFormat.SPRINGS).forEach(spring -> checkEnds("spring", spring));
        withKnownEnds(SceneFormat.LINES).forEach(line -> checkEnds("line", line));
        scene.list(SceneFormat.FACES).stream().filter(Values::isSound).forEach(this::checkFace);
        List<Values> rods = withKnownEnds(SceneFormat.RODS);
        rods.stream().filter(rod -> checkEnds("rod", rod)).forEach(this::checkMotion);
        checkLines(rods);
        List<Chosen<WireKind>> wires = scene.list(SceneFormat.WIRES).stream().filter(wire ->
                known.has(wire.values(), WireKind.BEAD) && wire.values().isSound()).toList();
        wires.forEach(this::check);
        Values settings = scene.mapping(SceneFormat.CONSTRAINTS);
        if (!(rods.isEmpty() && wires.isEmpty()) && settings.isSound()) {
            checkFeedback(settings.get(SpringDescription.FEEDBACK));
        }
    }

    private void checkFace(Values face) {
        List<String> corners = face.get(SceneFormat.CORNERS);
        Place place = face.place(SceneFormat.CORNERS);
        if (Set.copyOf(corners).size() < Math.max(3, corners.size())) {
            problems.add(place, "a face needs at least three corners, all different");
        }
        corners.forEach(id -> known.has(id, place));
    }

    private static String from(Values rod) {
        return rod.get(SpringDescription.FROM);
    }

    private static String to(Values rod) {
        return rod.get(SpringDescription.TO);
    }

    private List<Values> withKnownEnds(Key<List<Values>> list) {
        return scene.list(list).stream().filter(values -> known.has(values, SpringDescription.FROM)
                & known.has(values, SpringDescription.TO) && values.isSound()).toList();
    }

    /**
     * Whether a spring or rod has two ends at different places; if not, that is a problem, unless it is an undamped
     * spring of rest length 0, whose force there is 0.
     */
    private boolean checkEnds(String what, Values values) {
        String from = from(values);
        String to = to(values);
        Place place = values.place(SpringDescription.TO);
        boolean apart = !index.way(from, to).isZero();
        if (from.equals(to)) {
            problems.add(place, "a " + what + " from " + Wording.quote(from)
                    + " to itself; its ends must be two different particles");
        } else if (!apart && what.equals("rod")) {
            problems.add(place, samePlace(from, to) + "; a rod between them would have no length");
        } else if (!apart && !values.find(SpringDescription.REST_LENGTH).equals(Optional.of(0.0))) {
            problems.add(place, samePlace(from, to) + "; a spring between them would have no direction, unless it"
                    + " has restLength: 0");
        } else if (!apart && values.get(SpringDescription.DAMPING) > 0) {
            problems.add(place, samePlace(from, to) + "; the damping of a spring between them would have"
                    + " no direction");
        }
        return apart;
    }

    private static String samePlace(String from, String to) {
        return Wording.quote(from) + " and " + Wording.quote(to) + " are at the same place";
    }

    private void checkMotion(Values rod) {
        String from = from(rod);
        String to = to(rod);
        Place place = rod.place(SpringDescription.TO);
        Vector3 way = index.way(from, to);
        if (index.particle(from).fixed() && index.particle(to).fixed()) {
            problems.add(place, Wording.quote(from) + " and " + Wording.quote(to)
                    + " are fixed; a rod between them has no effect");
        } else {
            double rate = velocity(to).minus(velocity(from)).dot(way) / way.length();
            if (Math.abs(rate) > STILL) {
                problems.add(place, "the ends of the rod from " + Wording.quote(from) + " to " + Wording.quote(to)
                        + " move " + (rate > 0 ? "apart" : "together") + " at " + Digits.exact(Math.abs(rate))
                        + " m/s; their relative velocity must be across the rod" + moving(from, to)
                        + fitting(from, to));
            }
        }
    }

    /** The velocity of a particle at the start; for a moving anchor, that of its motion. */
    private Vector3 velocity(String id) {
        return motionOf(id).map(rule -> rule.kind().startVelocity(rule.values(), index))
                .orElse(index.particle(id).velocity());
    }

    private Optional<Chosen<RuleKind>> motionOf(String id) {
        return scene.list(SceneFormat.RULES).stream().filter(rule -> rule.values().isSound()
                && rule.values().find(RuleKind.ANCHOR).filter(id::equals).isPresent()).findFirst();
    }

    private String moving(String... ends) {
        return Stream.of(ends).filter(id -> motionOf(id).isPresent())
                .map(id -> "; " + Wording.quote(id) + " begins with " + components(velocity(id)) + " m/s").findFirst()
                .orElse("");
    }

    /** The velocities of these ends with which no rod's ends move apart or together, if there are any. */
    private String fitting(String... ends) {
        Map<String, Vector3> fitting = fittingVelocities();
        return Stream.of(ends).filter(fitting::containsKey).filter(id -> !fitting.get(id).equals(velocity(id)))
                .map(id -> "; " + Wording.quote(id) + " fits with velocity: " + exactly(fitting.get(id)))
                .collect(Collectors.joining());
    }

    /**
     * The nearest velocities with which all rods keep their lengths, by particle; empty if there are none. Each rod in
     * turn corrects those of its ends (S. Kaczmarz 1937).
     */
    private Map<String, Vector3> fittingVelocities() {
        Map<String, Vector3> velocities = new HashMap<>();
        List<Values> rods = withKnownEnds(SceneFormat.RODS).stream().filter(rod ->
                !index.way(from(rod), to(rod)).isZero()).toList();
        double worst = Double.POSITIVE_INFINITY;
        for (int sweep = 0; sweep < MOST_SWEEPS && worst > STILL / 2; sweep++) {
            worst = 0;
            for (Values rod : rods) {
                List<String> ends = List.of(from(rod), to(rod));
                ends.forEach(end -> velocities.computeIfAbsent(end, this::velocity));
                Vector3 along = index.way(from(rod), to(rod)).normalized();
                double rate = velocities.get(to(rod)).minus(velocities.get(from(rod))).dot(along);
                List<String> free = ends.stream().filter(end -> !index.particle(end).fixed()).toList();
                free.forEach(end -> velocities.merge(end, along.times((end.equals(from(rod)) ? rate : -rate)
                        / free.size()), Vector3::plus));
                worst = Math.max(worst, Math.abs(rate));
            }
        }
        return worst <= STILL / 2 ? velocities : Map.of();
    }

    private static String exactly(Vector3 v) {
        return "[" + Digits.exact(v.x()) + ", " + Digits.exact(v.y()) + ", " + Digits.exact(v.z()) + "]";
    }

    private static String components(Vector3 v) {
        return "[" + Digits.few(v.x()) + ", " + Digits.few(v.y()) + ", " + Digits.few(v.z()) + "]";
    }

    /**
     * Refuses rods that form a triangle or polygon without area. Their lengths forbid a motion across the line, but
     * forces along the line cannot prevent it.
     */
    private void checkLines(List<Values> rods) {
        Map<String, Set<String>> joined = new HashMap<>();
        for (Values rod : rods) {
            joined.computeIfAbsent(from(rod), id -> new LinkedHashSet<>()).add(to(rod));
            joined.computeIfAbsent(to(rod), id -> new LinkedHashSet<>()).add(from(rod));
        }
        for (Values rod : rods) {
            String from = from(rod);
            String to = to(rod);
            List<String> line = new ArrayList<>(List.of(from));
            for (int k = 0; k < line.size() && !line.contains(to); k++) {
                for (String next : joined.get(line.get(k))) {
                    if (!line.contains(next) && !(k == 0 && next.equals(to)) && isBetween(from, to, next)) {
                        line.add(next);
                    }
                }
            }
            if (line.size() > 1 && line.contains(to)) {
                problems.add(rod.getPlace(), "the rods between " + Wording.some(line)
                        + " lie in one line, which only infinite forces could keep straight; leave out the rod from "
                        + Wording.quote(from) + " to " + Wording.quote(to));
            }
        }
    }

    /** Whether a particle begins on the line between two others, or where the second does. */
    private boolean isBetween(String from, String to, String id) {
        Vector3 way = index.way(from, to);
        Vector3 there = index.way(from, id);
        double part = there.dot(way) / way.dot(way);
        return part > 0 && part <= 1 && there.minus(way.times(part)).length() <= IN_LINE * way.length();
    }

    private void check(Chosen<WireKind> wire) {
        String bead = wire.values().get(WireKind.BEAD);
        Vector3 x = index.position(bead);
        Vector3 v = index.particle(bead).velocity();
        if (index.particle(bead).fixed()) {
            problems.add(wire.values().place(WireKind.BEAD), Wording.quote(bead)
                    + " is fixed; a bead must be free to move");
        } else {
            Curve curve = wire.kind().curve(wire.values(), x);
            for (Curve.Surface surface : curve.surfaces()) {
                double off = Math.abs(surface.value(x));
                double leaving = Math.abs(surface.gradient(x).dot(v));
                if (off > ON_WIRE || leaving > STILL) {
                    problems.add(wire.values().place(WireKind.BEAD), Wording.quote(bead) + (off > ON_WIRE
                            ? " begins " + distance(curve, x) + " off its wire; place it on the wire"
                            : " leaves its wire at " + Digits.exact(leaving)
                                    + " m/s; its velocity must be along the wire"));
                    break;
                }
            }
        }
    }

    /** Describes the distance of a point from a wire, found by Newton's method on one of its surfaces at a time. */
    private static String distance(Curve curve, Vector3 from) {
        Vector3 at = from;
        for (int n = 0; n < STEPS; n++) {
            Curve.Surface surface = curve.surfaces().get(n % 2);
            Vector3 gradient = surface.gradient(at);
            at = at.minus(gradient.times(surface.value(at) / gradient.dot(gradient)));
        }
        double distance = at.minus(from).length();
        return Double.isFinite(distance) ? "about " + Digits.few(distance) + " m" : "far";
    }

    /**
     * Checks that the feedback is not too strong: then it causes larger errors than it removes and is unstable with
     * some solvers.
     */
    private void checkFeedback(double rate) {
        scene.find(SceneFormat.DELTA_T).filter(deltaT -> rate * deltaT > MOST_FEEDBACK).ifPresent(deltaT ->
                problems.add(scene.place(scene.isGiven(SceneFormat.CONSTRAINTS) ? SceneFormat.CONSTRAINTS
                        : SceneFormat.DELTA_T), "the feedback of rods and wires, " + Digits.exact(rate)
                        + " /s, is too strong for a deltaT of " + Digits.exact(deltaT)
                        + " s; feedback times deltaT must be " + Digits.exact(MOST_FEEDBACK) + " at most"));
    }
}
