package particles.scene.parts;

import java.util.List;
import java.util.Optional;
import particles.ParticleSystem;
import particles.Rule;
import particles.Simulation;
import particles.reactions.Curve;
import particles.reactions.RestingContacts;
import particles.reactions.RigidConstraints;
import particles.rules.Collisions;
import particles.rules.ConstraintProjection;
import particles.rules.ExactImpacts;
import particles.spec.FlagType;
import particles.spec.Key;
import particles.spec.Kind.Chosen;
import particles.spec.MappingType;
import particles.spec.NumberType;
import particles.spec.Values;

/**
 * The rods and wires of a scene and how they are enforced.
 *
 * @param rods   the two ends of each rod, whose length is their initial distance
 * @param wires  the wires, each with its bead
 * @param values how they are enforced
 */
public record ConstraintDescription(List<Values> rods, List<Chosen<WireKind>> wires, Values values) {
    public static final MappingType ROD = MappingType.of("a rod", SpringDescription.FROM, SpringDescription.TO);

    public static final Key<Double> FEEDBACK = NumberType.notNegative("1/s").withDefault("feedback",
            RigidConstraints.USUAL_FEEDBACK,
            "The rate at which errors of length decay (1/s); values far above 0.1/deltaT make the run less accurate.");
    static final Key<Boolean> PROJECTION = FlagType.FLAG.withDefault("projection", false,
            "true: after every step, particles are moved so that rods have their exact length and beads are"
            + " on their wires.");
    public static final MappingType TYPE = MappingType.of("'constraints'", FEEDBACK, PROJECTION);

    /** Adds the scene's rods, wires and collisions of balls, if there are any; they are solved with these contacts. */
    public void build(Simulation simulation, ParticleIndex index, SceneAssembly assembly,
            Optional<RestingContacts> contacts) {
        ParticleSystem system = simulation.getSystem();
        if (rods.isEmpty() && wires.isEmpty() && assembly.getBalls().isEmpty()) {
            return;
        }
        RigidConstraints constraints = new RigidConstraints(
                contacts.orElseGet(() -> new RestingContacts(system, List.of())), values.get(FEEDBACK));
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
        if (values.get(PROJECTION)) {
            simulation.addRule(new ConstraintProjection(constraints));
        }
    }
}
