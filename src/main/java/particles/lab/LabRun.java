package particles.lab;

import deSolvers.catalog.SolverCatalog;
import java.util.List;
import java.util.function.BooleanSupplier;
import particles.Motion;
import particles.Observer;
import particles.ParticleSystem;
import particles.Simulation;
import particles.energy.EnergyRecorder;
import particles.lab.Frame.Structure;
import particles.scene.Scene;
import particles.scene.format.SceneDescription;

/** A run of a scene that is made a few steps at a time, and its history. */
public final class LabRun {
    private static final long HISTORY_BYTES = 64_000_000;
    /** The omega deltaT of the pointer's spring: yoshida4 with damping is stable up to 0.438. */
    private static final double BEARABLE = 0.4;

    private final Scene scene;
    private final Simulation simulation;
    private final ParticleSystem system;
    private final FrameRecorder frames;
    private final PointerSpring pointer;
    private boolean endless;
    private double wanted;
    private Frame shown;
    private Motion latest;
    private Structure latestStructure;

    /** @param scene a scene that is ready to run */
    public LabRun(Scene scene) {
        this.scene = scene;
        simulation = scene.simulation();
        system = scene.system();
        EnergyRecorder energy = new EnergyRecorder(simulation, scene.energyEstimate(), 1);
        frames = new FrameRecorder(scene, energy.getLedger(), HISTORY_BYTES);
        pointer = new PointerSpring(system.getParticles(), mostOmega(scene.description()));
        system.addEffect(pointer);
        simulation.addRule(pointer);
        energy.attachTo(simulation, List.of(frames, new Latest()));
        simulation.start();
        show();
    }

    /** A solver whose steps are limited by springs bears a vibration of this angular frequency (rad/s) at least. */
    private static double mostOmega(SceneDescription scene) {
        return SolverCatalog.find(scene.solver()).filter(solver -> solver.adaptive()
                || solver.imaginaryLimit() == Double.POSITIVE_INFINITY).isPresent() ? Double.POSITIVE_INFINITY
                : BEARABLE / scene.deltaT();
    }

    private final class Latest implements Observer {
        @Override
        public void moved(Motion motion) {
            latest = motion;
            latestStructure = frames.getStructure();
            if (motion.getStartTime() <= wanted && wanted < motion.getEndTime()) {
                showBetween();
            }
        }
    }

    /** Shows a time within the latest motion. */
    private void showBetween() {
        double[] between = new double[latest.getEndState().length];
        latest.interpolate(wanted, between);
        shown = frames.frame(between, wanted, latestStructure);
    }

    /**
     * Makes steps until the run reaches a time or is told to stop.
     *
     * @param time   the time to reach (s)
     * @param enough asked after every step whether to stop
     * @throws particles.SimulationException as a run of the scene ends with
     */
    public void advance(double time, BooleanSupplier enough) {
        wanted = time;
        boolean stop = false;
        while (!stop && system.getTime() < time && !isOver()) {
            makeStep();
            stop = enough.getAsBoolean();
        }
        if (system.getTime() <= time || latestStructure != frames.getStructure()) {
            show();                                     // or particles have come or gone since the motion
        } else if (latest.getStartTime() <= time) {
            showBetween();
        }
    }

    /** Makes one step. */
    public void step() {
        if (!isOver()) {
            makeStep();
        }
        show();
    }

    private void makeStep() {
        if (simulation.isOver()) {
            simulation.prolong();
        }
        simulation.advance();
    }

    /** Keeps and shows the present moment, the last of a run that cannot go on. */
    void end() {
        frames.finished(system);
        show();
    }

    /** @param endless whether the run goes on after the scene's duration */
    void setEndless(boolean endless) {
        this.endless = endless && simulation.getDuration() > 0;
    }

    private void show() {
        wanted = system.getTime();
        shown = frames.frame(system.getOwnState(), wanted, frames.getStructure());
    }

    /** @return whether the scene's duration is over, and the run does not go on */
    public boolean isOver() {
        return !endless && simulation.isOver();
    }

    /** @return the scene */
    public Scene getScene() {
        return scene;
    }

    PointerSpring getPointer() {
        return pointer;
    }

    Frame getShown() {
        return shown;
    }

    History getHistory() {
        return frames.getHistory();
    }

    FrameRecorder getFrames() {
        return frames;
    }
}
