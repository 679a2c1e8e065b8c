package hunts;

import static particles.spec.JsonText.map;

import deSolvers.catalog.SolverCatalog;
import java.util.ArrayList;
import java.util.DoubleSummaryStatistics;
import java.util.EnumSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Set;
import java.util.TreeSet;
import net.jqwik.api.Arbitraries;
import net.jqwik.api.Arbitrary;
import net.jqwik.api.Combinators;
import net.jqwik.api.RandomDistribution;
import net.jqwik.api.Tuple;
import particles.law.Vector3;

/**
 * A valid scene as plain numbers that jqwik can draw and shrink: balls on springs, rods and wires, a pivot that may
 * move, effects and surfaces, and a nozzle. Balls on rods move as one rigid body at first, as rods demand. Some masses
 * differ by up to 1e12, some balls fly through a soft post that is narrower than a step's way, and some are at one
 * place: that is refused if they are soft balls, too.
 */
record DrawnScene(List<Ball> balls, List<Link> links, Pivot pivot, List<Wire> wires,
        List<Map<String, Map<String, Object>>> effects, List<Surface> surfaces, List<Nozzle> nozzles,
        List<Post> posts, Start start, Run run) {
    private static final double TURN = 2 * Math.PI;
    private static final double UNEVEN = 1e6;

    /** What is hunted for by name; the fuzzer counts how often it was drawn. */
    enum Kind { FAST_PASSAGES, BIRTHS, UNEVEN_MASSES, ONE_PLACE }

    record Ball(double mass, Vector3 position, Vector3 velocity) {
    }

    /** @param stiffness 0 for a rod */
    record Link(int from, int to, double stiffness, double stretch, double damping) {
    }

    /** At the origin. */
    record Pivot(String kind, Vector3 way, double period) {
    }

    record Wire(String kind, int bead, Vector3 direction, double size) {
    }

    record Surface(String kind, Vector3 normal, double gap, double restitution, String law, double friction) {
    }

    /** @param perStep births in a step of the run */
    record Nozzle(Vector3 position, Vector3 direction, double speed, double perStep, double mass) {
    }

    /**
     * A soft sphere on the first ball's way; its scene has no rods, springs or wires, so that the balls fly there.
     *
     * @param when     when it would be passed, as a part of the run
     * @param size     its radius, as a part of the way in one step
     * @param hardness its stiffness is so many times m (v/r)&sup2;
     * @param aside    from the way, in radii
     */
    record Post(double when, double size, double hardness, Vector3 aside) {
    }

    record Start(Vector3 velocity, Vector3 spin) {
    }

    record Run(String solver, double deltaT, double steps, boolean exact, boolean projection) {
    }

    private record Rest(List<Post> posts, Start start, Run run) {
    }

    private static Arbitrary<Double> numbers(double least, double most) {
        return Arbitraries.doubles().between(least, most).ofScale(2).withDistribution(RandomDistribution.uniform());
    }

    private static Arbitrary<Double> orZero(Arbitrary<Double> number) {
        return Arbitraries.oneOf(Arbitraries.just(0.0), number);
    }

    /** Three digits, evenly over decades. */
    private static Arbitrary<Double> decades(double least, double most) {
        return numbers(least, most).map(e -> Double.valueOf(String.format(Locale.ROOT, "%.2e", Math.pow(10, e))));
    }

    private static Arbitrary<Vector3> vectors(double size) {
        Arbitrary<Double> number = numbers(-size, size);
        return Combinators.combine(number, number, number).as(Vector3::new);
    }

    private static Arbitrary<Vector3> directions() {
        return vectors(1).filter(v -> v.length() > 0.1);
    }

    private static Arbitrary<Integer> index() {
        return Arbitraries.integers().between(0, 5).withDistribution(RandomDistribution.uniform());
    }

    static Arbitrary<DrawnScene> any() {
        Arbitrary<Double> mass = frequent(4, decades(-1, 1), frequent(1, decades(-6, 6), Arbitraries.of(1e-6, 1e6)));
        Arbitrary<Vector3> place = frequent(4, vectors(1), Arbitraries.of(Vector3.ZERO, new Vector3(0, 0.5, 0)));
        Arbitrary<Vector3> fast = Combinators.combine(directions(), decades(1, 2)).as((way, speed) ->
                way.normalized().times(speed));
        Arbitrary<Ball> ball = Combinators.combine(mass, place, frequent(9, vectors(1), fast)).as(Ball::new);
        // from rest, a spring of half its length would shrink to a point, where its force has no direction
        Arbitrary<Link> link = Combinators.combine(index(), index(), orZero(decades(0, 4)), numbers(0.55, 1.5),
                orZero(decades(-2, 1))).as(Link::new);
        Arbitrary<Pivot> pivot = Combinators.combine(Arbitraries.of("none", "still", "shake", "circle", "glide"),
                directions(), decades(-1, 1)).as(Pivot::new);
        Arbitrary<Wire> wire = Combinators.combine(Arbitraries.of("line", "circle", "parabola", "sine"), index(),
                directions(), numbers(0.3, 2)).as(Wire::new);
        Arbitrary<Surface> surface = Combinators.combine(Arbitraries.of("ground", "plane", "ball", "bowl"),
                directions(), orZero(decades(-3, -0.3)), Arbitraries.oneOf(Arbitraries.of(0.0, 1.0), numbers(0, 1)),
                Arbitraries.of("none", "coulomb", "slide"), orZero(numbers(0, 1))).as(Surface::new);
        Arbitrary<Nozzle> nozzle = Combinators.combine(vectors(2), directions(), frequent(4, decades(-2, 1),
                Arbitraries.just(0.0)), decades(-1, 0.7), mass).as(Nozzle::new);
        Arbitrary<Post> post = Combinators.combine(numbers(0, 1), decades(-2, 0.5), decades(-1, 2), vectors(0.5))
                .as(Post::new);
        Arbitrary<Start> start = Combinators.combine(vectors(2), vectors(2)).as(Start::new);
        Arbitrary<Run> run = Combinators.combine(Arbitraries.of(SolverCatalog.names()), decades(-3.5, -0.3),
                numbers(3, 20), Arbitraries.of(true, false), Arbitraries.of(true, false)).as(Run::new);
        return Combinators.combine(ball.list().ofMinSize(1).ofMaxSize(5), link.list().ofMaxSize(6).withSizeDistribution(
                RandomDistribution.uniform()), pivot,
                wire.list().ofMaxSize(1), effect().list().ofMaxSize(3), surface.list().ofMaxSize(2), frequent(4,
                Arbitraries.just(List.<Nozzle>of()), nozzle.map(List::of)), Combinators.combine(frequent(4,
                Arbitraries.just(List.<Post>of()), post.map(List::of)), start, run).as(Rest::new))
                .as((balls, links, ends, bent, effects, surfaces, nozzles, rest) -> rest.posts.isEmpty()
                        ? new DrawnScene(balls, links, ends, bent, effects, surfaces, nozzles, List.of(), rest.start,
                                rest.run)
                        : new DrawnScene(balls, List.of(), ends, List.of(), effects, surfaces, nozzles, rest.posts,
                                rest.start, rest.run));
    }

    /** The first so many times as often as the other. */
    private static <T> Arbitrary<T> frequent(int times, Arbitrary<T> first, Arbitrary<T> other) {
        return Arbitraries.frequencyOf(Tuple.of(times, first), Tuple.of(1, other));
    }

    private static Arbitrary<Map<String, Map<String, Object>>> effect() {
        Arbitrary<Double> few = decades(-2, 1);
        Arbitrary<Map<String, Map<String, Object>>> wind = Combinators.combine(vectors(3), vectors(3), decades(-1, 1),
                few).as((mean, gust, period, c) -> Map.of("wind", Map.of("mean", list(mean), "gust", list(gust),
                        "period", period), "drag", Map.of("coefficient", c)));
        Arbitrary<Map<String, Map<String, Object>>> turbulence = Combinators.combine(few, few).as((speed, c) ->
                Map.of("turbulence", Map.of("strength", speed), "quadraticDrag", Map.of("coefficient", c)));
        Arbitrary<Map<String, Map<String, Object>>> cohesion = Combinators.combine(numbers(0.5, 2), few, orZero(few))
                .as((range, depth, c) -> Map.of("cohesion", Map.of("range", range, "depth", depth, "damping", c)));
        Arbitrary<Map<String, Map<String, Object>>> penalty = Combinators.combine(decades(1, 4), orZero(few),
                Arbitraries.of("penaltyPlane", "penaltySphere")).as((k, loss, name) -> Map.of(name,
                        name.endsWith("Plane") ? Map.of("stiffness", k, "loss", loss, "point", List.of(0, -1.2, 0))
                        : Map.of("stiffness", k, "loss", loss, "centre", List.of(0, -2, 0), "radius", 1)));
        Arbitrary<Map<String, Map<String, Object>>> post = Combinators.combine(decades(2, 5), vectors(1),
                decades(-2, -0.5)).as((k, centre, radius) -> Map.of("penaltySphere", Map.of("stiffness", k,
                        "centre", list(centre), "radius", radius)));
        Arbitrary<Map<String, Map<String, Object>>> soft = Combinators.combine(decades(2, 5), decades(-2, -0.5),
                orZero(few), Arbitraries.of("linear", "hertz")).as((k, radius, c, law) -> Map.of("repulsion",
                        Map.of("stiffness", k, "radius", radius, "loss", c, "law", law)));
        return Arbitraries.oneOf(Arbitraries.just(Map.of("gravity", Map.of())),
                vectors(10).map(g -> Map.of("gravity", Map.of("acceleration", list(g)))),
                few.map(c -> Map.of("drag", Map.of("coefficient", c))),
                few.map(c -> Map.of("quadraticDrag", Map.of("coefficient", c))),
                few.map(mu -> Map.of("attraction", Map.of("strength", mu, "centre", List.of(0, 0, 2)))),
                wind, turbulence, cohesion, penalty, post, soft);
    }

    private static List<Double> list(Vector3 v) {
        return List.of(v.x(), v.y(), v.z());
    }

    private boolean hasPivot() {
        return !pivot.kind.equals("none");
    }

    /** The scene's text, one line of YAML. */
    @Override
    public String toString() {
        List<Object> springs = new ArrayList<>();
        List<Object> rods = new ArrayList<>();
        addLinks(springs, rods);
        List<Object> bent = wires.stream().map(this::wire).toList();
        boolean tied = !rods.isEmpty() || !bent.isEmpty();
        List<Object> rules = new ArrayList<>();
        surfaces.forEach(surface -> rules.add(surface(surface)));
        for (Nozzle nozzle : nozzles) {
            // a ball's place is in no solid
            Vector3 place = surfaces.isEmpty() ? nozzle.position : balls.get(0).position;
            rules.add(map("emitter", map("id", "e", "position", list(place), "direction",
                    list(nozzle.direction), "speed", nozzle.speed, "rate", nozzle.perStep / run.deltaT, "mass",
                    nozzle.mass)));
        }
        Vector3 begin = move(rules, bent.isEmpty());
        List<Object> particles = new ArrayList<>();
        for (int i = 0; i < balls.size(); i++) {
            Ball ball = balls.get(i);
            Vector3 v = !bent.isEmpty() ? Vector3.ZERO : !tied ? ball.velocity
                    : (hasPivot() ? begin : start.velocity).plus(start.spin.cross(ball.position));
            particles.add(map("id", "b" + i, "mass", ball.mass, "position", list(ball.position), "velocity", list(v)));
        }
        if (hasPivot()) {
            particles.add(map("id", id(balls.size()), "position", List.of(0, 0, 0), "fixed", true));
        }
        Map<String, Map<String, Object>> laws = new LinkedHashMap<>();
        effects.forEach(laws::putAll);
        posts.forEach(post -> laws.put("penaltySphere", post(post)));
        if (!surfaces.isEmpty()) {
            laws.putIfAbsent("gravity", Map.of());          // or little would ever touch them
        }
        if (laws.containsKey("wind")) {
            laws.remove("turbulence");
        }
        Map<String, Object> scene = map("title", "drawn", "teaches", "nothing", "solver", run.solver, "deltaT",
                run.deltaT, "duration", run.deltaT * run.steps, "threads", 1, "impact", run.exact ? "exact" : "clamp",
                "particles", particles, "springs", springs, "rods", rods, "wires", bent, "effects",
                laws.entrySet().stream().map(law -> map(law.getKey(), law.getValue())).toList(), "rules", rules);
        if (tied) {
            scene.put("constraints", map("feedback", Math.min(5, 0.4 / run.deltaT), "projection", run.projection));
        }
        return BrokenText.text(scene);
    }

    private Map<String, Object> post(Post post) {
        Ball ball = balls.get(0);
        double radius = Math.max(1e-3, ball.velocity.length() * run.deltaT * post.size);
        double rate = ball.velocity.length() / radius;
        Vector3 passed = ball.position.plus(ball.velocity.times(run.deltaT * run.steps * post.when));
        return map("centre", list(passed.plus(post.aside.times(radius))), "radius", radius, "stiffness",
                post.hardness * ball.mass * rate * rate);
    }

    /** @return which of the hunted kinds it is of */
    Set<Kind> kinds() {
        Set<Kind> kinds = EnumSet.noneOf(Kind.class);
        DoubleSummaryStatistics masses = balls.stream().mapToDouble(Ball::mass).summaryStatistics();
        Map<Kind, Boolean> holds = Map.of(Kind.FAST_PASSAGES, posts.stream().anyMatch(post -> post.size < 1),
                Kind.BIRTHS, !nozzles.isEmpty(), Kind.UNEVEN_MASSES, masses.getMax() > UNEVEN * masses.getMin(),
                Kind.ONE_PLACE, balls.stream().map(Ball::position).distinct().count() < balls.size());
        holds.forEach((kind, held) -> {
            if (held) {
                kinds.add(kind);
            }
        });
        return kinds;
    }

    private String id(int i) {
        return i == balls.size() ? "pivot" : "b" + i;
    }

    /** Each pair has one link at most. */
    private void addLinks(List<Object> springs, List<Object> rods) {
        int ends = balls.size() + (hasPivot() ? 1 : 0);
        TreeSet<Integer> taken = new TreeSet<>();
        for (Link link : links) {
            int from = Math.min(link.from % ends, link.to % ends);
            int to = Math.max(link.from % ends, link.to % ends);
            double length = position(from).minus(position(to)).length();
            if (from != to && length == 0 && link.stiffness > 0 && taken.add(10 * from + to)) {
                springs.add(map("from", id(from), "to", id(to), "stiffness", link.stiffness, "restLength", 0));
            } else if (from != to && length > 0.1 && taken.add(10 * from + to)) {
                Map<String, Object> entry = map("from", id(from), "to", id(to));
                if (link.stiffness > 0) {
                    entry.putAll(map("stiffness", link.stiffness, "restLength", length * link.stretch, "damping",
                            link.damping));
                }
                (link.stiffness > 0 ? springs : rods).add(entry);
            }
        }
    }

    private Vector3 position(int i) {
        return i == balls.size() ? Vector3.ZERO : balls.get(i).position;
    }

    private Object wire(Wire wire) {
        int i = wire.bead % balls.size();
        Vector3 x = balls.get(i).position;
        Map<String, Object> keys = map("bead", id(i));
        keys.putAll(switch (wire.kind) {
            case "line" -> map("direction", list(wire.direction));
            case "circle" -> map("centre", list(x.plus(wire.direction.normalized().times(wire.size))), "radius",
                    wire.size, "axis", list(across(wire.direction)));
            case "parabola" -> map("origin", list(x), "curvature", wire.size);
            default -> map("origin", list(x), "amplitude", wire.size / 2, "wavelength", 1.5);
        });
        return map(wire.kind, keys);
    }

    private static Vector3 across(Vector3 v) {
        return v.cross(Math.abs(v.x()) < Math.abs(v.y()) ? new Vector3(1, 0, 0) : new Vector3(0, 1, 0));
    }

    /** Below all balls, or around them. */
    private Object surface(Surface surface) {
        Vector3 n = surface.kind.equals("ground") ? new Vector3(0, 1, 0) : surface.normal.normalized();
        double lowest = balls.stream().mapToDouble(ball -> ball.position.dot(n)).min().orElseThrow() - surface.gap;
        double far = balls.stream().mapToDouble(ball -> ball.position.length()).max().orElseThrow();
        Map<String, Object> keys = map("restitution", surface.restitution);
        keys.putAll(switch (surface.kind) {
            case "ground" -> map("height", lowest);
            case "plane" -> map("point", list(n.times(lowest)), "normal", list(n));
            case "ball" -> map("centre", list(n.times(lowest - 1)), "radius", 1);
            default -> map("centre", List.of(0, 0, 0), "radius", far + surface.gap + 0.1, "hollow", true);
        });
        if (!surface.law.equals("none")) {
            keys.put("friction", map("law", surface.law, "coefficient", surface.friction));
        }
        return map(surface.kind.startsWith("b") ? "sphere" : surface.kind, keys);
    }

    /** Adds the pivot's motion and returns its velocity at the start; beads begin at rest, and so must it. */
    private Vector3 move(List<Object> rules, boolean fast) {
        if (!hasPivot() || pivot.kind.equals("still")) {
            return Vector3.ZERO;
        }
        String kind = fast ? pivot.kind : "glide";
        Vector3 axis = across(pivot.way);
        Map<String, Object> motion = map("particle", "pivot", kind.equals("glide") ? "duration" : "period",
                pivot.period, Map.of("shake", "amplitude", "circle", "centre", "glide", "to").get(kind),
                list(pivot.way));
        if (kind.equals("circle")) {
            motion.put("axis", list(axis));
        }
        rules.add(map(kind, motion));
        Vector3 fastest = pivot.way.times(TURN / pivot.period);
        return switch (kind) {
            case "shake" -> fastest;
            case "circle" -> axis.normalized().cross(fastest.times(-1));
            default -> Vector3.ZERO;
        };
    }
}
