package particles.reactions;

import static particles.Systems.addGravity;

import deSolvers.DESolver;
import deSolvers.RK4Solver;
import particles.ParticleSystem;
import particles.law.Particles;
import particles.law.Vector3;

/** Hanging chains of rods, 1 m and 1 kg each, released at an angle. */
final class Pendulums {
    private Pendulums() {
    }

    static ParticleSystem chain(int rods, double degrees, double feedback) {
        ParticleSystem system = new ParticleSystem();
        double a = Math.toRadians(degrees);
        system.addParticle("nail", 1, Vector3.ZERO, Vector3.ZERO, true);
        for (int i = 1; i <= rods; i++) {
            system.addParticle("bob" + i, 1, new Vector3(i * Math.sin(a), -i * Math.cos(a), 0), Vector3.ZERO, false);
        }
        addGravity(system);
        RigidConstraints constraints = new RigidConstraints(system, feedback);
        for (int i = 0; i < rods; i++) {
            constraints.addRod(i, i + 1, 1);
        }
        system.addReaction(constraints);
        return system;
    }

    static RigidConstraints constraints(ParticleSystem system) {
        return (RigidConstraints) system.getReactions().get(system.getReactions().size() - 1);
    }

    static double distance(ParticleSystem system, int i, int j) {
        double[] s = system.getOwnState();
        int a = Particles.STRIDE * i;
        int b = Particles.STRIDE * j;
        return new Vector3(s[b] - s[a], s[b + 1] - s[a + 1], s[b + 2] - s[a + 2]).length();
    }

    static double lengthError(ParticleSystem system) {
        RigidConstraints rods = constraints(system);
        double worst = 0;
        for (int r = 0; r < rods.springCount(); r++) {
            worst = Math.max(worst, Math.abs(distance(system, rods.from(r), rods.to(r)) - rods.restLength(r)));
        }
        return worst;
    }

    /** Makes steps; returns the worst error of any length after any of them. */
    static double worstLength(ParticleSystem system, DESolver solver, double h, int steps) {
        double worst = 0;
        for (int k = 0; k < steps; k++) {
            solver.stepState(system, h);
            worst = Math.max(worst, lengthError(system));
        }
        return worst;
    }

    /** Shortens the last step so that x of the first bob has the given value, by the secant method. */
    static void refine(ParticleSystem system, double value, double h) {
        DESolver solver = new RK4Solver();
        for (int k = 0; k < 6; k++) {
            double[] state = system.getOwnState();
            solver.stepState(system, (value - state[6]) / state[9]);
        }
    }
}
