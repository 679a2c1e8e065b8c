package particles.scene.parts;

import java.util.List;
import java.util.Optional;
import particles.ParticleSystem;
import particles.Rule;
import particles.Simulation;
import particles.reactions.RestingContacts;
import particles.reactions.RigidConstraints;
import particles.reactions.wires.Curve;
import particles.rules.Collisions;
import particles.rules.ConstraintProjection;
import particles.rules.ExactImpacts;
import particles.spec.Chosen;
import particles.spec.FlagType;
import particles.spec.Key;
import particles.spec.MappingType;
import particles.spec.NumberType;
import particles.spec.Values;

/**
 * The rods and wires of a scene and how they are enforced.
 *
 * @param rods       the rods
 * @param wires      the wires, each with its bead
 * @param feedback   the rate at which errors decay (1/s)
 * @param projection whether particles are projected onto rods and wires after every step
 */
public record ConstraintDescription(List<RodDescription> rods, List<Chosen<WireKind>> wires, double feedback,
        boolean projection) {
    public static final Key<Double> FEEDBACK = NumberType.notNegative("1/s").withDefault("feedback",
            RigidConstraints.USUAL_FEEDBACK,
            "The rate at which errors of length decay (1/s); values far above 0.1/deltaT make the run less accurate.");
    static final Key<Boolean> PROJECTION = FlagType.FLAG.withDefault("projection", false,
            "true: after every step, particles are moved so that rods have their exact length and beads are"
            + " on their wires.");
    public static final MappingType TYPE = MappingType.of("'constraints'", FEEDBACK, PROJECTION);

    /** @return the rods and wires with these values */
    public static ConstraintDescription of(List<RodDescription> rods, List<Chosen<WireKind>> wires, Values values) {
        return new ConstraintDescription(List.copyOf(rods), List.copyOf(wires), values.get(FEEDBACK),
                values.get(PROJECTION));
    }

    /** Adds the scene's rods, wires and collisions of balls, if there are any; they are solved with these contacts. */
    public void build(Simulation simulation, ParticleIndex index, SceneAssembly assembly,
            Optional<RestingContacts> contacts) {
        ParticleSystem system = simulation.getSystem();
        if (rods.isEmpty() && wires.isEmpty() && assembly.getBalls().isEmpty()) {
            return;
        }
        RigidConstraints constraints = new RigidConstraints(system, feedback);
        for (RodDescription rod : rods) {
            constraints.addRod(index.find(rod.from()).orElseThrow(), index.find(rod.to()).orElseThrow(),
                    index.way(rod.from(), rod.to()).length());
        }
        for (Chosen<WireKind> wire : wires) {
            String bead = wire.values().get(WireKind.BEAD);
            Curve curve = wire.kind().curve(wire.values(), index.position(bead));
            constraints.addBead(index.find(bead).orElseThrow(), curve);
            assembly.show(curve);
        }
        contacts.ifPresent(constraints::solveWith);
        for (Rule rule : List.copyOf(simulation.getRules())) {
            if (rule instanceof ExactImpacts impacts) {
                assembly.getBalls().ifPresent(balls -> simulation.addRule(new Collisions(impacts, constraints,
                        balls)));
            }
        }
        system.addReaction(constraints);
        constraints.project(system.getOwnState(), system.getTime());        // positions in files have few digits
        if (projection) {
            simulation.addRule(new ConstraintProjection(constraints));
        }
    }
}
