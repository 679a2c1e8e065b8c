package particles.scene;

import static particles.spec.messages.Wording.quote;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import particles.scene.format.SceneFormat;
import particles.scene.parts.NamedFiles;
import particles.scene.parts.NamedFiles.NamedFile;
import particles.scene.parts.ParticleDescription;
import particles.scene.parts.ParticleIndex;
import particles.scene.parts.RuleKind;
import particles.scene.parts.ShapeDescription;
import particles.scene.parts.ShapeKind;
import particles.spec.Key;
import particles.spec.Kind.Chosen;
import particles.spec.Values;
import particles.spec.messages.Place;
import particles.spec.messages.Problems;
import particles.spec.messages.Wording;

/** A scene's particles and shapes without mistakes, and the ids of all of them, which other parts of it name. */
final class KnownParticles {
    private static final int MOST_CANDIDATES = 1000;
    private static final long MOST_SPRINGS = 10_000_000;

    private final Values scene;
    private final NamedFiles files;
    private final Problems problems;
    private final Map<String, Place> ids = new HashMap<>();
    private final List<String> broken = new ArrayList<>();
    private final ParticleIndex index;

    /**
     * @param scene    the values in the file
     * @param others   finds the files that are not in the scene itself
     * @param problems receives the problems of particles and shapes
     */
    KnownParticles(Values scene, NamedFiles others, Problems problems) {
        this.scene = scene;
        files = scene.find(SceneFormat.FILES).map(KnownParticles::within).orElse(others);
        this.problems = problems;
        List<ParticleDescription> particles = readParticles();
        index = new ParticleIndex(particles, readShapes(particles.size()));
        for (Chosen<RuleKind> rule : scene.list(SceneFormat.RULES)) {
            rule.kind().newIds().ifPresent(key -> rule.values().find(key).ifPresent(id ->
                    take(id, rule.values().isGiven(key) ? rule.values().place(key) : rule.place())));
        }
    }

    private static NamedFiles within(Map<String, String> files) {
        return (name, place, problems) -> files.containsKey(name) ? Optional.of(new NamedFile(name, files.get(name)))
                : problems.add(place, "the file " + quote(name) + " is not in 'files', which has "
                        + Wording.some(List.copyOf(files.keySet())));
    }

    private List<ParticleDescription> readParticles() {
        List<ParticleDescription> particles = new ArrayList<>();
        for (Values values : scene.list(SceneFormat.PARTICLES)) {
            Optional<String> id = values.find(ParticleDescription.ID);
            id.ifPresent(name -> take(name, values.place(ParticleDescription.ID)));
            if (!values.isSound()) {
                id.ifPresent(broken::add);
                continue;
            }
            ParticleDescription particle = ParticleDescription.of(values);
            if (particle.fixed() && !values.get(ParticleDescription.VELOCITY).isZero()) {
                problems.add(values.place(ParticleDescription.VELOCITY), "'" + particle.id()
                        + "' is fixed and has a velocity; remove one of the two");
            }
            particles.add(particle);
        }
        return particles;
    }

    /** Reads shapes until there are too many particles or springs. */
    private List<ShapeDescription> readShapes(long count) {
        List<ShapeDescription> shapes = new ArrayList<>();
        long springs = scene.list(SceneFormat.SPRINGS).size();
        for (Chosen<ShapeKind> chosen : scene.list(SceneFormat.SHAPES)) {
            Key<String> key = chosen.kind().getId();
            Optional<String> id = chosen.values().find(key);
            id.ifPresent(name -> take(name, chosen.values().place(key)));
            boolean few = count <= ShapeDescription.MOST_PARTICLES && springs <= MOST_SPRINGS;
            Optional<ShapeDescription> read = few && chosen.values().isSound()
                    ? ShapeDescription.of(chosen, files, problems) : Optional.empty();
            if (read.isEmpty()) {
                id.ifPresent(broken::add);
                continue;
            }
            shapes.add(read.get());
            count += read.get().layout().size();
            springs += read.get().springCount();
            if (count > ShapeDescription.MOST_PARTICLES || springs > MOST_SPRINGS) {
                problems.add(chosen.place(), "with this shape there are " + count + " particles and " + springs
                        + " springs; a scene may have at most " + ShapeDescription.MOST_PARTICLES + " and "
                        + MOST_SPRINGS);
            }
        }
        return shapes;
    }

    private void take(String id, Place place) {
        Place first = ids.putIfAbsent(id, place);
        if (first != null) {
            problems.add(place, "the id " + quote(id)
                    + " is already used at line " + first.line() + "; give another");
        }
    }

    /** @return the particles and shapes without mistakes */
    ParticleIndex getIndex() {
        return index;
    }

    /**
     * Tests whether a key names a particle, and adds a problem if not. An id of a faulty particle or shape is known,
     * but nothing more can be checked of it.
     *
     * @return whether it names a particle without mistakes
     */
    boolean has(Values values, Key<String> key) {
        return values.find(key).isPresent() && has(values.get(key), values.place(key));
    }

    /** Tests whether an id names a particle, and adds a problem if not. */
    boolean has(String id, Place place) {
        boolean found = index.find(id).isPresent();
        String shape = ParticleIndex.shapeOf(id);
        if (found || broken.contains(id) || broken.contains(shape)) {
            return found && !broken.contains(shape);
        }
        if (areAllIdsKnown()) {
            List<String> known = ids.keySet().stream().sorted().toList();
            // the last problems are counted only
            problems.add(place, problems.isFull() ? "" : "unknown particle " + quote(id) + index.shape(shape)
                    .map(named -> "; known in this shape: " + named.layout().range())
                    .orElseGet(() -> (known.size() > MOST_CANDIDATES ? ";" : Wording.hint(shape, known)) + " known: "
                            + Wording.some(known)));
        }
        return false;
    }

    /** If the id of a particle or shape could not be read, an unknown id may be theirs. */
    private boolean areAllIdsKnown() {
        return scene.isIntact(SceneFormat.SHAPES) && scene.find(SceneFormat.PARTICLES).filter(alone ->
                alone.stream().allMatch(values -> values.find(ParticleDescription.ID).isPresent())).isPresent();
    }
}
