package particles.rules;

import particles.ParticleSystem;
import particles.Rule;
import particles.reactions.RigidConstraints;

/**
 * Projection onto the constraints: after every step, positions and velocities are corrected so that rods keep their
 * lengths and beads stay on their wires up to round-off. The corrections are the smallest, weighted by mass.
 *
 * <p>The price: the state changes after almost every step, and a solver that uses earlier steps (adams, the step size
 * of adaptive solvers) must restart each time, so that adams is no better than its starting method. Rods that only need
 * the accuracy of the solver can use the feedback of {@link RigidConstraints} without projection.
 */
public final class ConstraintProjection implements Rule {
    private final RigidConstraints constraints;

    /** @param constraints the rods and wires */
    public ConstraintProjection(RigidConstraints constraints) {
        this.constraints = constraints;
    }

    @Override
    public String getName() {
        return "projection";
    }

    @Override
    public boolean isCorrection() {
        return true;
    }

    @Override
    public void start(ParticleSystem system) {
        constraints.project(system.getOwnState(), system.getTime());
    }

    @Override
    public boolean afterStep(ParticleSystem system, double deltaT) {
        return constraints.project(system.getOwnState(), system.getTime());
    }
}
