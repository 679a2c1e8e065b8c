package particles.experiments.runs;

import java.util.ArrayList;
import java.util.List;
import particles.Motion;
import particles.Observer;
import particles.ParticleSystem;

/**
 * Copies of the state at regular times, k / rate for k = 0, 1, 2 ...: the times of a film's frames, whatever the steps
 * are. Between two steps it uses the same cubic as the pictures.
 */
public final class FrameStates implements Observer {
    /** A clock this part of a frame's time early is rounding. */
    private static final double ROUNDING = 1e-9;

    private final double rate;
    private final List<double[]> states = new ArrayList<>();

    /** @param rate the number of copies per second of simulated time (1/s) */
    public FrameStates(double rate) {
        this.rate = rate;
    }

    @Override
    public void started(ParticleSystem system) {
        states.add(system.getOwnState().clone());
    }

    @Override
    public double getNextTime() {
        return states.size() / rate;
    }

    @Override
    public void moved(Motion motion) {
        while (getNextTime() <= motion.getEndTime()) {
            double[] between = new double[motion.getEndState().length];
            motion.interpolate(getNextTime(), between);
            states.add(between);
        }
    }

    @Override
    public void finished(ParticleSystem system) {
        if (states.size() <= system.getTime() * rate + ROUNDING) {
            states.add(system.getOwnState().clone());
        }
    }

    /** @return the states so far, the first one at the beginning */
    public List<double[]> getStates() {
        return states;
    }
}
