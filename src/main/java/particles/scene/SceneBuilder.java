package particles.scene;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import particles.EnergyLimit;
import particles.ParticleSystem;
import particles.Rule;
import particles.Simulation;
import particles.effects.EffectCatalog;
import particles.effects.EffectKind;
import particles.effects.springs.SpringForce;
import particles.law.CentralForce;
import particles.law.Effect;
import particles.law.Violation;
import particles.reactions.Curve;
import particles.reactions.RestingContacts;
import particles.reactions.RigidConstraints;
import particles.rules.ClampedImpacts;
import particles.rules.Collisions;
import particles.rules.ConstraintProjection;
import particles.rules.ExactImpacts;
import particles.scene.format.SceneDescription;
import particles.scene.format.SceneFormat;
import particles.scene.format.SolverDescription;
import particles.scene.parts.ParticleDescription;
import particles.scene.parts.ParticleIndex;
import particles.scene.parts.ParticleLayout;
import particles.scene.parts.RuleKind;
import particles.scene.parts.SceneAssembly;
import particles.scene.parts.ShapeDescription;
import particles.scene.parts.SpringDescription;
import particles.scene.parts.SpringFamily;
import particles.scene.parts.WireKind;
import particles.spec.Kind.Chosen;
import particles.spec.Values;
import particles.spec.messages.InvalidInputException;
import particles.spec.messages.Problems;
import particles.view.Scenery.Surface;

/**
 * Builds a simulation from a scene description. It creates only the effects and rules that the description names, and
 * what these need: a surface, such as the ground, brings a reaction for contacts and a rule for impacts.
 */
public final class SceneBuilder {
    private SceneBuilder() {
    }

    /**
     * Builds the simulation that a scene describes.
     *
     * @param scene the scene's description
     * @return the scene, ready to run
     * @throws InvalidInputException if the solver cannot be created, or the run would be too long or too large
     */
    public static Scene build(SceneDescription scene) {
        Problems problems = new Problems();
        SolverDescription.check(scene, problems);
        RunLimits.check(scene.values(), problems);
        RunLimits.checkMemory(scene, Runtime.getRuntime().maxMemory(), problems);
        problems.throwIfAny();
        return assemble(scene);
    }

    /** Builds an effect; a student's own class may throw anything. */
    private static void build(Chosen<EffectKind> effect, SceneAssembly assembly) {
        try {
            effect.kind().build(effect.values(), assembly);
        } catch (RuntimeException | LinkageError e) {
            if (EffectCatalog.ALL.contains(effect.kind())) {
                throw e;
            }
            throw new InvalidInputException(effect.place() + ": " + effect.kind().getName()
                    + " cannot be built: " + e);
        }
    }

    private static Scene assemble(SceneDescription scene) {
        ParticleSystem system = new ParticleSystem();
        SpringForce springs = new SpringForce(system.getParticles());
        ParticleIndex index = scene.particles();
        List<Surface> cloths = addParticles(index, system, springs);
        surface(scene).ifPresent(cloths::add);
        for (Values spring : Stream.of(SceneFormat.SPRINGS, SceneFormat.LINES).flatMap(key ->
                scene.values().get(key).stream()).toList()) {
            String from = spring.get(SpringDescription.FROM);
            String to = spring.get(SpringDescription.TO);
            springs.addSpring(index.find(from).orElseThrow(), index.find(to).orElseThrow(),
                    spring.find(SpringDescription.STIFFNESS).orElse(0.0),
                    spring.find(SpringDescription.REST_LENGTH).orElse(index.way(from, to).length()),
                    spring.get(SpringDescription.DAMPING));
        }
        if (springs.springCount() > 0) {
            system.addEffect(springs);
        }
        SceneAssembly assembly = new SceneAssembly(system, springs, index);
        scene.values().get(SceneFormat.EFFECTS).stream().sorted(Comparator.comparingInt(SceneBuilder::order))
                .forEach(effect -> build(effect, assembly));
        scene.rules().forEach(rule -> rule.kind().build(rule.values(), assembly));

        double estimate = assembly.energyEstimate(Math.max(scene.duration(), scene.deltaT()));
        Simulation simulation = new Simulation(system, scene.solving()::create, scene.deltaT(),
                scene.duration());
        Optional<RestingContacts> contacts = Optional.empty();
        if (!assembly.getSurfaces().isEmpty() || scene.hasHardBalls()) {       // the ground and others to collide with
            contacts = Optional.of(new RestingContacts(system, assembly.getSurfaces()));
            contacts.get().getContacts().setScales(index.scales());
            system.addReaction(contacts.get());
            // no conditional expression: compiled by JDK 25, it has both classes loaded in every scene
            if (scene.exactImpacts()) {
                simulation.addRule(new ExactImpacts(contacts.get()));
            } else {
                simulation.addRule(new ClampedImpacts(contacts.get()));
            }
        }
        addConstraints(scene, simulation, assembly, contacts);
        if (scene.hasHardBalls()) {
            simulation.getRules().forEach(rule -> checkOverlap(rule.getViolation(system), scene));
        }
        checkDirections(system, scene);
        assembly.rules().forEach(simulation::addRule);
        Scene built = new Scene(scene, simulation, springs, assembly.scenery(cloths), estimate);
        simulation.addRule(new EnergyLimit(built.energyLimit()));
        return built;
    }

    /** Adds rods, wires and collisions of balls, if there are any; they are solved together with these contacts. */
    private static void addConstraints(SceneDescription scene, Simulation simulation, SceneAssembly assembly,
            Optional<RestingContacts> contacts) {
        List<Values> rods = scene.values().get(SceneFormat.RODS);
        List<Chosen<WireKind>> wires = scene.values().get(SceneFormat.WIRES);
        if (rods.isEmpty() && wires.isEmpty() && assembly.getBalls().isEmpty()) {
            return;
        }
        ParticleSystem system = simulation.getSystem();
        ParticleIndex index = scene.particles();
        Values settings = scene.values().mapping(SceneFormat.CONSTRAINTS);
        RigidConstraints constraints = new RigidConstraints(
                contacts.orElseGet(() -> new RestingContacts(system, List.of())),
                settings.get(SpringDescription.FEEDBACK));
        for (Values rod : rods) {
            String from = rod.get(SpringDescription.FROM);
            String to = rod.get(SpringDescription.TO);
            constraints.addRod(index.find(from).orElseThrow(), index.find(to).orElseThrow(),
                    index.way(from, to).length());
        }
        for (Chosen<WireKind> wire : wires) {
            String bead = wire.values().get(WireKind.BEAD);
            Curve curve = wire.kind().curve(wire.values(), index.position(bead));
            constraints.addBead(index.find(bead).orElseThrow(), curve);
            assembly.show(curve);
        }
        for (Rule rule : List.copyOf(simulation.getRules())) {
            if (rule instanceof ExactImpacts impacts) {
                assembly.getBalls().map(balls -> new Collisions(impacts, constraints, balls)).ifPresent(collisions -> {
                    simulation.addRule(collisions);
                    assembly.set(collisions);
                });
            }
        }
        system.addReaction(constraints);
        constraints.project(system.getOwnState(), system.getTime());        // positions in files have few digits
        if (settings.get(SpringDescription.PROJECTION)) {
            simulation.addRule(new ConstraintProjection(constraints));
        }
    }

    private static void checkDirections(ParticleSystem system, SceneDescription scene) {
        for (Effect effect : system.getEffects()) {
            if (effect instanceof CentralForce central) {
                central.findUndirected(system.getOwnState(), 0).ifPresent(where -> {
                    throw new InvalidInputException(scene.values().get(SceneFormat.EFFECTS).stream()
                            .filter(chosen -> chosen.kind().getName().equals(central.getName())).findFirst()
                            .orElseThrow().place() + ": " + where);
                });
            }
        }
    }

    /** The surface of the faces that the scene lists. */
    private static Optional<Surface> surface(SceneDescription scene) {
        int[] triangles = scene.values().get(SceneFormat.FACES).stream().map(face -> face.get(SceneFormat.CORNERS)
                .stream().mapToInt(id -> scene.particles().find(id).orElseThrow()).toArray())
                .flatMapToInt(Surface::triangles).toArray();
        return triangles.length == 0 ? Optional.empty() : Optional.of(new Surface(triangles, false));
    }

    private static void checkOverlap(Violation overlap, SceneDescription scene) {
        if (overlap.part() > 0) {
            throw new InvalidInputException(scene.rules().stream().filter(RuleKind::hasBalls).findFirst()
                    .orElseThrow().place() + ": " + overlap.what()
                    + " at the start; hard balls may touch, but not overlap");
        }
    }

    /** Effects are built in the order of the catalogue, students' own ones last. */
    private static int order(Chosen<EffectKind> effect) {
        int index = EffectCatalog.ALL.indexOf(effect.kind());
        return index < 0 ? EffectCatalog.ALL.size() : index;
    }

    /** Adds particles, then shapes, and returns the shapes' surfaces. */
    private static List<Surface> addParticles(ParticleIndex index, ParticleSystem system, SpringForce springs) {
        index.getParticles().forEach(particle -> add(particle, system));
        List<Surface> cloths = new ArrayList<>();
        for (ShapeDescription shape : index.getShapes()) {
            int first = system.getParticles().count();
            ParticleLayout layout = shape.layout();
            shape.particles().forEach(particle -> add(particle, system));
            for (SpringFamily family : shape.springs()) {
                layout.forEachPair(family.sort(), (from, to) -> springs.addSpring(first + from, first + to,
                        family.stiffness(), layout.position(to).minus(layout.position(from)).length(),
                        family.damping()));
            }
            shape.surface(first).ifPresent(cloths::add);
        }
        return cloths;
    }

    private static void add(ParticleDescription particle, ParticleSystem system) {
        system.addParticle(particle.id(), particle.mass(), particle.position(), particle.velocity(),
                particle.fixed());
    }
}
