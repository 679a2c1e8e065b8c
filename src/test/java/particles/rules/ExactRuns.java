package particles.rules;

import static particles.Systems.GRAVITY;

import deSolvers.DESolver;
import java.util.ArrayList;
import java.util.List;
import java.util.function.Supplier;
import particles.Motion;
import particles.Observer;
import particles.ParticleSystem;
import particles.Rule;
import particles.Simulation;
import particles.effects.Gravity;
import particles.law.Plane;
import particles.reactions.RestingContacts;
import particles.reactions.contact.ContactSurface;
import particles.reactions.contact.Friction;

/** Set-up and observers for runs with exact impacts. */
final class ExactRuns {
    static final double G = 9.81;

    private ExactRuns() {
    }

    static ContactSurface ground(double restitution, Friction friction) {
        return new ContactSurface("ground", Plane.ground(0), restitution, friction, 1e-6);
    }

    static RestingContacts contacts(ParticleSystem system, ContactSurface... planes) {
        RestingContacts contacts = new RestingContacts(system, List.of(planes));
        system.addEffect(new Gravity(system.getParticles(), GRAVITY));
        system.addReaction(contacts);
        return contacts;
    }

    static Simulation simulation(ParticleSystem system, RestingContacts contacts, Supplier<DESolver> solver,
            double deltaT, double duration) {
        Simulation simulation = new Simulation(system, solver, deltaT, duration);
        simulation.addRule(new ExactImpacts(contacts));
        return simulation;
    }

    /** Records when rules acted, and the lowest position in between. */
    static final class Watch implements Observer {
        final List<Double> times = new ArrayList<>();
        double lowest = Double.POSITIVE_INFINITY;

        @Override
        public void moved(Motion motion) {
            double[] state = new double[motion.getEndState().length];
            for (int k = 0; k <= 16; k++) {
                double u = k / 16.0;
                motion.interpolate((1 - u) * motion.getStartTime() + u * motion.getEndTime(), state);
                lowest = Math.min(lowest, state[1]);
            }
        }

        @Override
        public void changed(ParticleSystem system, Rule rule) {
            times.add(system.getTime());
        }
    }
}
