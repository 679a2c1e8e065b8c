package hunts;

import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import particles.Motion;
import particles.Observer;
import particles.ParticleSystem;
import particles.Simulation;
import particles.SimulationException;
import particles.energy.EnergyRecorder;
import particles.law.DifferentiableEffect;
import particles.law.Effect;
import particles.law.Obstacle;
import particles.law.Reaction;
import particles.reactions.ContactSurface;
import particles.reactions.RestingContacts;
import particles.reactions.RigidConstraints;
import particles.scene.BlowUpMessage;
import particles.scene.Scene;
import particles.scene.format.SceneFormat;

/** One run of a scene as {@code gradle run} makes it, with what a judge of its physics asks. */
final class Trial implements Observer {
    private static final int STRIDE = 6;
    /** The round-off of g y in a long run (J/(kg m)). Measured: 2e-13 in 1,300 steps. */
    private static final double HEIGHTS = 1e-12;

    /** Ends a run that takes too many evaluations, or has made enough steps. */
    private static final class Enough extends RuntimeException {
        private static final long serialVersionUID = 1L;

        Enough() {
            super("enough", null, false, false);
        }
    }

    /** Exerts no force; counts the evaluations. */
    private static final class Meter implements DifferentiableEffect {
        private int left;

        Meter(int most) {
            left = most;
        }

        @Override
        public String getName() {
            return "meter";
        }

        @Override
        public void addForces(double[] state, double time, double[] force) {
            if (--left < 0) {
                throw new Enough();
            }
        }

        @Override
        public Set<Trait> getTraits() {
            return Set.of(Trait.INTERNAL, Trait.CONSERVATIVE);
        }

        @Override
        public boolean dependsOnVelocity() {
            return false;
        }
    }

    private final Scene scene;
    private final ParticleSystem system;
    private final EnergyRecorder energy;
    private final double[] start;
    private double[] end;
    private double speed;
    private boolean cut;
    private Optional<String> stopped = Optional.empty();

    /** Runs a scene, up to this number of evaluations of the forces. */
    Trial(Scene scene, int mostEvaluations) {
        this.scene = scene;
        system = scene.system();
        system.addEffect(new Meter(mostEvaluations));
        start = state();
        Simulation simulation = scene.simulation();
        energy = new EnergyRecorder(simulation, scene.energyEstimate(), 1);
        energy.attachTo(simulation, List.of(this));
        try {
            simulation.run();
        } catch (Enough e) {
            cut = true;
        } catch (SimulationException e) {
            stopped = Optional.of(new BlowUpMessage(scene, e, name -> "--" + name).lines());
        }
        end = state();
    }

    private double[] state() {
        return Arrays.copyOf(system.getOwnState(), system.getStateSize());
    }

    @Override
    public void moved(Motion motion) {
        speed = Math.max(speed, largest(motion.getEndState(), 3));
    }

    /** The largest position (from 0) or velocity (from 3). */
    private static double largest(double[] state, int from) {
        double most = 0;
        for (int k = 0; k < state.length; k++) {
            most = k % STRIDE / 3 * 3 == from ? Math.max(most, Math.abs(state[k])) : most;
        }
        return most;
    }

    /** The reason and the advice, if the run failed. */
    Optional<String> stopped() {
        return stopped;
    }

    Scene scene() {
        return scene;
    }

    boolean isWhole() {
        return !cut && stopped.isEmpty();
    }

    /** The impacts and changes of contact at their exact times. */
    long events() {
        return scene.simulation().getEvents();
    }

    /** Whether the run says that its steps may skip a force or an anchor's motion. */
    boolean skips() {
        return energy.getBrief().isPresent();
    }

    boolean struck() {
        return energy.getLedger().getWork().containsKey("impacts") || events() > 0;
    }

    /**
     * Whether there may be no motion from some moment on: friction acts on rods or wires (P. Painlev&eacute; 1895), or
     * an anchor moves while the rod from it to a bead stands across the bead's wire.
     */
    boolean mayJam() {
        List<Reaction> reactions = system.getReactions();
        return reactions.stream().anyMatch(RigidConstraints.class::isInstance) && reactions.stream()
                .anyMatch(reaction -> reaction instanceof RestingContacts resting
                        && resting.getContacts().getSurfaces().stream()
                                .anyMatch(surface -> surface.friction().coefficient() > 0))
                || system.getMovingAnchors().length > 0
                && reactions.stream().anyMatch(reaction -> reaction.getName().equals("rods and wires"));
    }

    boolean hasSurfaces() {
        return system.getReactions().stream().anyMatch(RestingContacts.class::isInstance);
    }

    /** How far the end is from that of another run, relative to its extent and largest speed. */
    double distance(Trial other) {
        if (end.length != other.end.length) {
            return Double.POSITIVE_INFINITY;            // a birth at the very end is in one of them only
        }
        double[] difference = end.clone();
        for (int k = 0; k < end.length; k++) {
            difference[k] -= other.end[k];
        }
        double fast = Math.max(1e-3, Math.max(speed, other.speed));     // a bead held by its rod has 1e-11 m/s
        return Math.max(largest(difference, 0) / Math.max(0.1, largest(other.end, 0)),
                largest(difference, 3) / fast);
    }

    /** The largest change of a rod's length, relative to it. */
    double rods() {
        double most = 0;
        for (Reaction reaction : system.getReactions()) {
            if (reaction instanceof RigidConstraints rods) {
                for (int r = 0; r < rods.springCount(); r++) {
                    most = Math.max(most, Math.abs(length(end, rods, r) / length(start, rods, r) - 1));
                }
            }
        }
        return most;
    }

    private static double length(double[] s, RigidConstraints rods, int r) {
        int a = STRIDE * rods.from(r);
        int b = STRIDE * rods.to(r);
        return Math.hypot(Math.hypot(s[a] - s[b], s[a + 1] - s[b + 1]), s[a + 2] - s[b + 2]);
    }

    /** How deep the deepest free particle is below a surface (m), or as a part of the radius of a sphere. */
    double depth() {
        double most = 0;
        for (Reaction reaction : system.getReactions()) {
            if (reaction instanceof RestingContacts contacts) {
                for (ContactSurface surface : contacts.getContacts().getSurfaces()) {
                    most = Math.max(most, depth(surface.obstacle()));
                }
            }
        }
        return most;
    }

    private double depth(Obstacle surface) {
        double most = 0;
        for (int x = 0; x < end.length; x += STRIDE) {
            if (!system.getParticles().isFixed(x / STRIDE)) {
                most = Math.max(most, -surface.distance(end, x) * (surface.isFlat() ? 1
                        : Math.abs(surface.curvature(end, x))));
            }
        }
        return most;
    }

    /** The change of momentum of a free system, relative to the sum of all sizes; 0 if something outside acts. */
    double momentum() {
        boolean free = scene.description().values().get(SceneFormat.WIRES).isEmpty() && !hasSurfaces()
                && system.getEffects().stream().allMatch(e -> e.getTraits().contains(Effect.Trait.INTERNAL));
        double[] change = new double[3];
        double size = 0;
        if (end.length != start.length) {
            return 0;                                   // births bring some
        }
        for (int k = 0; k < end.length; k++) {
            free &= !system.getParticles().isFixed(k / STRIDE);
            if (k % STRIDE >= 3) {
                double mass = system.getParticles().mass(k / STRIDE);
                change[k % 3] += mass * (end[k] - start[k]);
                size += mass * speed;
            }
        }
        return free && size > 0 ? largest(change, 0) / size : 0;
    }

    private double scale() {
        return Math.max(energy.getHistory().getScale(), 1e-9 * scene.energyEstimate());
    }

    /** The numerical error of the ledger without the round-off of heights, relative to the energy scale. */
    double ledger() {
        double rounding = 0;
        for (int i = 0; i < end.length / STRIDE; i++) {
            rounding += HEIGHTS * system.getParticles().mass(i) * largest(end, 0);
        }
        return Math.max(0, energy.getLedger().getLargestNumericalError() - rounding) / scale();
    }

    /** The energy that surfaces and dissipation add, relative to the energy scale; 0 with moving anchors. */
    double gain() {
        double gain = 0;
        for (Map.Entry<String, Double> work : energy.getLedger().getWork().entrySet()) {
            gain += work.getKey().matches("impacts|contact|.*dissipated.*") ? work.getValue() : 0;
        }
        return system.getMovingAnchors().length > 0 ? 0 : gain / scale();
    }
}
