package particles.scene;

import static particles.spec.messages.Wording.quote;

import deSolvers.text.Digits;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
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
    /** Speeds along a rod or off a wire below this are round-off (m/s). */
    private static final double STILL = 1e-9;
    /** Largest distance from the line of a rod that counts as on it, as a fraction of its length. */
    private static final double IN_LINE = 1e-5;
    private static final double MOST_FEEDBACK = 0.5;
    /** The number of Newton steps; far from a wire one step on each function may only halve the distance. */
    private static final int STEPS = 200;

    /** A spring, rod or line with known ends; way leads from one to the other at the start (m). */
    private record Link(Values values, String from, String to, Vector3 way) {
        boolean isApart() {
            return !way.isZero();
        }
    }

    void check() {
        links(SceneFormat.SPRINGS).forEach(spring -> checkEnds("spring", spring));
        links(SceneFormat.LINES).forEach(line -> checkEnds("line", line));
        scene.list(SceneFormat.FACES).stream().filter(Values::isSound).forEach(this::checkFace);
        List<Link> rods = links(SceneFormat.RODS);
        rods.forEach(rod -> checkEnds("rod", rod));
        rods.stream().filter(Link::isApart).forEach(this::checkMotion);
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

    private List<Link> links(Key<List<Values>> list) {
        return scene.list(list).stream().filter(values -> known.has(values, SpringDescription.FROM)
                & known.has(values, SpringDescription.TO) && values.isSound()).map(values -> {
                    String from = values.get(SpringDescription.FROM);
                    String to = values.get(SpringDescription.TO);
                    return new Link(values, from, to, index.way(from, to));
                }).toList();
    }

    /**
     * Reports a spring, rod or line without two ends at different places, unless it is an undamped spring of rest
     * length 0, whose force there is 0.
     */
    private void checkEnds(String what, Link link) {
        Place place = link.values.place(SpringDescription.TO);
        String samePlace = quote(link.from) + " and " + quote(link.to) + " are at the same place; ";
        if (link.from.equals(link.to)) {
            problems.add(place, "a " + what + " from " + quote(link.from)
                    + " to itself; its ends must be two different particles");
        } else if (link.isApart()) {
            return;
        } else if (!what.equals("spring")) {
            problems.add(place, samePlace + "a " + what + " between them would have no length");
        } else if (!link.values.find(SpringDescription.REST_LENGTH).equals(Optional.of(0.0))) {
            problems.add(place, samePlace + "a spring between them would have no direction, unless it has"
                    + " restLength: 0");
        } else if (link.values.get(SpringDescription.DAMPING) > 0) {
            problems.add(place, samePlace + "the damping of a spring between them would have no direction");
        }
    }

    private void checkMotion(Link rod) {
        Place place = rod.values.place(SpringDescription.TO);
        double from = alongRod(rod, rod.from);
        double to = alongRod(rod, rod.to);
        if (index.particle(rod.from).fixed() && index.particle(rod.to).fixed()) {
            problems.add(place, quote(rod.from) + " and " + quote(rod.to)
                    + " are fixed; a rod between them has no effect");
        } else if (Math.abs(to - from) > STILL) {
            problems.add(place, "the rod from " + quote(rod.from) + " to " + quote(rod.to)
                    + " cannot keep its length: along it, " + quote(rod.from) + " moves at " + Digits.exact(from)
                    + " m/s and " + quote(rod.to) + " at " + Digits.exact(to) + " m/s; these speeds must be equal");
        }
    }

    /** The speed of one end in the direction from the rod's first end to its second one (m/s). */
    private double alongRod(Link rod, String end) {
        return velocity(end).dot(rod.way) / rod.way.length();
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

    /**
     * Refuses rods that form a triangle or polygon without area. Their lengths forbid a motion across the line, but
     * forces along the line cannot prevent it.
     */
    private void checkLines(List<Link> rods) {
        Map<String, Set<String>> joined = new HashMap<>();
        for (Link rod : rods) {
            joined.computeIfAbsent(rod.from, id -> new LinkedHashSet<>()).add(rod.to);
            joined.computeIfAbsent(rod.to, id -> new LinkedHashSet<>()).add(rod.from);
        }
        for (Link rod : rods) {
            List<String> line = new ArrayList<>(List.of(rod.from));
            for (int k = 0; k < line.size() && !line.contains(rod.to); k++) {
                for (String next : joined.get(line.get(k))) {
                    if (!line.contains(next) && !(k == 0 && next.equals(rod.to)) && isOn(rod, next)) {
                        line.add(next);
                    }
                }
            }
            if (line.size() > 1 && line.contains(rod.to)) {
                problems.add(rod.values.getPlace(), "the rods between " + Wording.some(line)
                        + " lie in one line, which only infinite forces could keep straight; leave out the rod from "
                        + quote(rod.from) + " to " + quote(rod.to));
            }
        }
    }

    /** Whether a particle begins on the line between the ends of a rod, or where it ends. */
    private boolean isOn(Link rod, String id) {
        Vector3 there = index.way(rod.from, id);
        double part = there.dot(rod.way) / rod.way.dot(rod.way);
        return part > 0 && part <= 1 && there.minus(rod.way.times(part)).length() <= IN_LINE * rod.way.length();
    }

    private void check(Chosen<WireKind> wire) {
        String bead = wire.values().get(WireKind.BEAD);
        Vector3 x = index.position(bead);
        Vector3 v = index.particle(bead).velocity();
        if (index.particle(bead).fixed()) {
            problems.add(wire.values().place(WireKind.BEAD), quote(bead)
                    + " is fixed; a bead must be free to move");
        } else {
            Curve curve = wire.kind().curve(wire.values(), x);
            for (Curve.Surface surface : curve.surfaces()) {
                double off = Math.abs(surface.value(x));
                double leaving = Math.abs(surface.gradient(x).dot(v));
                if (off > ON_WIRE || leaving > STILL) {
                    problems.add(wire.values().place(WireKind.BEAD), quote(bead) + (off > ON_WIRE
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
