package particles.scene;

import java.util.ArrayList;
import java.util.List;
import particles.Motion;
import particles.Observer;
import particles.ParticleSystem;
import particles.Rule;
import particles.Simulation;
import particles.energy.EnergyLedger;
import particles.reactions.ContactModes.Mode;
import particles.reactions.RestingContacts;
import particles.reactions.RigidConstraints;

/** A small scene as text, run by any solver, and what its rules did. */
public final class ShortRun implements Observer {
    /** Gravity's acceleration unless the scene says otherwise (m/s&sup2;). */
    public static final double G = 9.81;
    private final Scene scene;
    private final EnergyLedger ledger = new EnergyLedger();
    private final List<Double> times = new ArrayList<>();
    private final List<double[]> states = new ArrayList<>();
    private final List<Double> energies = new ArrayList<>();
    private double lowest = Double.POSITIVE_INFINITY;

    /**
     * Builds a scene, with gravity unless its text has effects.
     *
     * @param steps solver, impact, deltaT and duration, with spaces between
     */
    public ShortRun(String steps, String text) {
        String[] words = steps.split(" ");
        scene = TestScenes.build("""
                title: A test
                teaches: One law.
                solver: %s
                impact: %s
                deltaT: %s
                duration: %s
                %s
                """.formatted(words[0], words[1], words[2], words[3],
                text.contains("effects:") ? text : text + "\neffects: [gravity]"));
        getSimulation().addObserver(ledger);
        getSimulation().addObserver(this);
    }

    /** @return a scene that was run to its end */
    public static ShortRun of(String steps, String text) {
        return new ShortRun(steps, text).run();
    }

    /** Runs it to its end. */
    public ShortRun run() {
        getSimulation().run();
        return this;
    }

    /** Watches also how low the first particle comes between the ends of steps. */
    @Override
    public void moved(Motion motion) {
        double[] state = motion.getEndState().clone();
        for (int k = 0; k <= 16; k++) {
            double u = k / 16.0;
            motion.interpolate((1 - u) * motion.getStartTime() + u * motion.getEndTime(), state);
            lowest = Math.min(lowest, state[1]);
        }
    }

    @Override
    public void changed(ParticleSystem system, Rule rule) {
        times.add(system.getTime());
        states.add(system.getOwnState().clone());
        energies.add(system.getEnergy(system.getOwnState(), system.getTime()));
    }

    /** @return entry k of the state: 0, 1, 2 position of the first particle, 3, 4, 5 its velocity */
    public double at(int k) {
        return getState()[k];
    }

    /** @return the distance between two particles (m) */
    public double distance(int i, int j) {
        int a = 6 * i;
        int b = 6 * j;
        return Math.hypot(at(a) - at(b), Math.hypot(at(a + 1) - at(b + 1), at(a + 2) - at(b + 2)));
    }

    /** @return the work of one source (J), 0 if it did none */
    public double work(String source) {
        return ledger.getWork().getOrDefault(source, 0.0);
    }

    /** @return the largest relative change of the initial energy, right after a rule acted */
    public double worstEnergy() {
        return energies.stream().mapToDouble(e -> Math.abs(e / ledger.getStartEnergy() - 1)).max().orElse(0);
    }

    /** @return the forces of contact */
    public RestingContacts contacts() {
        return (RestingContacts) getSystem().getReactions().stream().filter(RestingContacts.class::isInstance)
                .findFirst().orElseThrow();
    }

    /** @return the rods and wires */
    public RigidConstraints rods() {
        return (RigidConstraints) getSystem().getReactions().stream().filter(RigidConstraints.class::isInstance)
                .findFirst().orElseThrow();
    }

    /** @return the forces of all effects at the end, without reactions */
    public double[] effects() {
        double[] force = new double[getSystem().getStateSize()];
        getSystem().addUpEffects(getState(), getSystem().getTime(), force);
        return force;
    }

    /** @return whether static friction holds a particle */
    public boolean isHeld(int i) {
        return contacts().getContacts().getModes().isSticking(i);
    }

    /** @return how the first particle touches the first surface */
    public Mode mode() {
        return contacts().getContacts().getModes().get(0, 0);
    }

    public Scene getScene() {
        return scene;
    }

    public Simulation getSimulation() {
        return scene.simulation();
    }

    public ParticleSystem getSystem() {
        return scene.system();
    }

    /** @return the system's own state */
    public double[] getState() {
        return scene.system().getOwnState();
    }

    public EnergyLedger getLedger() {
        return ledger;
    }

    /** @return energy that no work explains (J) */
    public double getNumericalError() {
        return ledger.getNumericalError();
    }

    /** @return when rules changed something (s) */
    public List<Double> getTimes() {
        return times;
    }

    /** @return the states that rules left */
    public List<double[]> getStates() {
        return states;
    }

    /** @return the total energies that rules left (J) */
    public List<Double> getEnergies() {
        return energies;
    }

    /** @return the lowest height of the first particle (m) */
    public double getLowest() {
        return lowest;
    }
}
