package particles.hard;

import static deSolvers.problems.Bounds.assertBelow;

import deSolvers.catalog.SolverCatalog;
import deSolvers.problems.Steps;
import particles.EnergyLimit;
import particles.ParticleSystem;
import particles.Simulation;
import particles.SimulationException;
import particles.law.Particles;
import particles.law.Vector3;
import particles.scene.Scene;
import particles.scene.TestScenes;

/** Systems and runs shared by several hard cases. */
final class HardSystems {
    private HardSystems() {
    }

    /** @return a particle at a place, at rest */
    static int add(ParticleSystem system, String id, double mass, double x, double y, boolean fixed) {
        return system.addParticle(id, mass, new Vector3(x, y, 0), Vector3.ZERO, fixed);
    }

    /** @return a run that fails if the kinetic energy passes the limit */
    static Simulation simulation(ParticleSystem system, String solver, double deltaT, double duration,
            double energyLimit) {
        Simulation simulation = new Simulation(system, () -> SolverCatalog.create(solver), deltaT, duration);
        simulation.addRule(new EnergyLimit(energyLimit));
        return simulation;
    }

    /** Requires that a run fails before a time (s), with a message that has a part. */
    static void assertFailsBefore(double time, String part, Simulation run) {
        SimulationException e = Steps.assertFails(SimulationException.class, part, run::run);
        assertBelow(time, e.getTime(), e.getMessage());
    }

    /** @return a scene of this text, run in this way */
    static Scene scene(String yaml, String solver, double deltaT, double duration) {
        return TestScenes.build("title: Hard\nteaches: nothing\nsolver: %s\ndeltaT: %s\nduration: %s\n"
                .formatted(solver, deltaT, duration) + yaml);
    }

    /** @return the system of such a scene at its end */
    static ParticleSystem run(String yaml, String solver, double deltaT, double duration) {
        Scene scene = scene(yaml, solver, deltaT, duration);
        scene.simulation().run();
        return scene.system();
    }

    /** @return the largest speed of any particle (m/s) */
    static double fastest(ParticleSystem system) {
        double most = 0;
        double[] s = system.getOwnState();
        for (int v = 3; v < system.getStateSize(); v += Particles.STRIDE) {
            most = Math.max(most, s[v] * s[v] + s[v + 1] * s[v + 1] + s[v + 2] * s[v + 2]);
        }
        return Math.sqrt(most);
    }
}
