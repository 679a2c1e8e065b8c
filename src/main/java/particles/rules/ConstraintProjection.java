package particles.rules;

import particles.ParticleSystem;
import particles.Rule;
import particles.reactions.RigidConstraints;

/**
 * Rods keep their lengths and beads their wires to rounding: after every step positions and velocities are moved onto
 * the constraints, what has less mass more, as little as possible.
 *
 * <p>The price: a step's end is changed almost every time, by about the error of the step, and a solver is told so. One
 * that builds on earlier steps - adams, the adaptive ones' next step - starts anew each time; that is right, for its
 * memory is of a motion that was not gone on with, but adams is then no better than what it starts with. Rods that only
 * need to be accurate to a solver's order do without, by the feedback of {@link RigidConstraints} alone.
 */
public final class ConstraintProjection implements Rule {
    private final RigidConstraints constraints;

    /** @param constraints what is to be kept */
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
