package particles.reactions;

import static particles.Systems.GRAVITY;

import deSolvers.RK4Solver;
import java.util.ArrayList;
import java.util.List;
import particles.Observer;
import particles.ParticleSystem;
import particles.Rule;
import particles.Simulation;
import particles.effects.Gravity;
import particles.law.Plane;
import particles.law.Vector3;
import particles.reactions.contact.ContactSurface;
import particles.reactions.contact.Friction;
import particles.rules.ClampedImpacts;
import particles.rules.ExactImpacts;

/** Rods of masses 1 kg on planes, with gravity. */
final class JointCase {
    final ParticleSystem system = new ParticleSystem();
    final RigidConstraints rods = new RigidConstraints(system, 5);
    final RestingContacts contacts;

    JointCase(List<ContactSurface> planes, Vector3[] places, Vector3[] velocities, int[]... pairs) {
        this(false, planes, places, velocities, pairs);
    }

    JointCase(boolean firstIsFixed, List<ContactSurface> planes, Vector3[] places, Vector3[] velocities,
            int[]... pairs) {
        for (int i = 0; i < places.length; i++) {
            system.addParticle("p" + i, 1, places[i], velocities[i], firstIsFixed && i == 0);
        }
        system.addEffect(new Gravity(system.getParticles(), GRAVITY));
        contacts = new RestingContacts(system, planes);
        for (int[] pair : pairs) {
            rods.addRod(pair[0], pair[1], Pendulums.distance(system, pair[0], pair[1]));
        }
        rods.solveWith(contacts);
        system.addReaction(contacts);
        system.addReaction(rods);
    }

    Simulation exact(double deltaT, double duration) {
        Simulation simulation = new Simulation(system, RK4Solver::new, deltaT, duration);
        simulation.addRule(new ExactImpacts(contacts));
        return simulation;
    }

    Simulation clamped(double deltaT, double duration) {
        Simulation simulation = new Simulation(system, RK4Solver::new, deltaT, duration);
        simulation.addRule(new ClampedImpacts(contacts));
        return simulation;
    }

    double at(int i, int k) {
        return system.getOwnState()[6 * i + k];
    }

    double[] effects() {
        double[] force = new double[system.getStateSize()];
        system.addUpEffects(system.getOwnState(), system.getTime(), force);
        return force;
    }

    static ContactSurface plane(double nx, double ny, Friction friction) {
        return new ContactSurface("plane", new Plane(Vector3.ZERO, new Vector3(nx, ny, 0)), 0, friction, 1e-6);
    }

    static Friction coulomb(double mu) {
        return new Friction(Friction.Law.COULOMB, mu, mu, 0);
    }

    static Vector3[] at(double... xy) {
        Vector3[] places = new Vector3[xy.length / 2];
        for (int i = 0; i < places.length; i++) {
            places[i] = new Vector3(xy[2 * i], xy[2 * i + 1], 0);
        }
        return places;
    }

    /** Records when rules acted. */
    static final class Watch implements Observer {
        final List<Double> times = new ArrayList<>();
        final List<double[]> states = new ArrayList<>();

        @Override
        public void changed(ParticleSystem system, Rule rule) {
            times.add(system.getTime());
            states.add(system.getOwnState().clone());
        }
    }
}
