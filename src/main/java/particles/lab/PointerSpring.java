package particles.lab;

import deSolvers.ForceDerivatives;
import java.util.Set;
import particles.ParticleSystem;
import particles.Rule;
import particles.law.DifferentiableEffect;
import particles.law.Particles;
import particles.law.Vector3;

/**
 * The spring by which somebody drags a particle: from the particle to the pointer, half critically damped. Its whole
 * force counts as work from outside. While nobody drags, it changes no bit of a run.
 */
final class PointerSpring implements DifferentiableEffect, Rule {
    /** How fast a particle follows (rad/s), if all other particles hang on it. */
    private static final double QUICKNESS = 12;

    private final Particles particles;
    private final double mostOmega;
    private int particle = -1;
    private Vector3 pointer;
    private double stiffness;
    private double damping;
    private boolean changed;
    private int next = -1;                              // what is dragged from the end of the present step on
    private Vector3 nextPointer;

    /**
     * @param particles the particles
     * @param mostOmega the fastest vibration that its steps bear (rad/s)
     */
    PointerSpring(Particles particles, double mostOmega) {
        this.particles = particles;
        this.mostOmega = mostOmega;
    }

    /** Drags a particle towards a point, from the end of the present step on; no particle if the index is -1. */
    void drag(int particle, Vector3 pointer) {
        next = particle >= 0 && particles.isFixed(particle) ? -1 : particle;
        nextPointer = pointer;
        changed = true;
    }

    private void change() {
        particle = next;
        pointer = nextPointer;
        if (particle >= 0) {
            double mass = particles.mass(particle);
            stiffness = Math.min(particles.freeMass() * QUICKNESS * QUICKNESS, mass * mostOmega * mostOmega);
            damping = Math.sqrt(stiffness * mass);
        }
    }

    @Override
    public String getName() {
        return "pointer";
    }

    @Override
    public Set<Trait> getTraits() {
        return Set.of(Trait.DRIVING);
    }

    @Override
    public boolean dependsOnVelocity() {
        return particle >= 0;
    }

    @Override
    public void addForces(double[] state, double time, double[] force) {
        if (particle >= 0) {
            int v = Particles.STRIDE * particle + 3;
            Vector3.at(force, v).plus(pull(state)).put(force, v);
        }
    }

    private Vector3 pull(double[] state) {
        return pointer.minus(Vector3.at(state, Particles.STRIDE * particle)).times(stiffness)
                .minus(velocity(state).times(damping));
    }

    private Vector3 velocity(double[] state) {
        return Vector3.at(state, Particles.STRIDE * particle + 3);
    }

    @Override
    public double getDrivenPower(double[] state, double time) {
        return particle < 0 ? 0 : pull(state).dot(velocity(state));
    }

    @Override
    public void addForceDerivatives(double[] state, double time, ForceDerivatives derivatives) {
        if (particle >= 0) {
            derivatives.add(particle, particle, new double[] {-stiffness, 0, 0, 0, -stiffness, 0, 0, 0, -stiffness},
                    new double[] {-damping, 0, 0, 0, -damping, 0, 0, 0, -damping});
        }
    }

    @Override
    public void reindex(int[] newIndex) {
        particle = particle < 0 ? -1 : newIndex[particle];
        next = next < 0 ? -1 : newIndex[next];
    }

    /** Changes the force between two steps, so that solvers forget earlier steps and the ledger earlier powers. */
    @Override
    public boolean afterStep(ParticleSystem system, double deltaT) {
        boolean change = changed;
        if (change) {
            change();
        }
        changed = false;
        return change;
    }
}
