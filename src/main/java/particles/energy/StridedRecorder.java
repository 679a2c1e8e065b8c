package particles.energy;

import particles.Motion;
import particles.Observer;
import particles.ParticleSystem;
import particles.Rule;

/**
 * Base class of observers that record every n-th step of a run, the changes by rules after it, and the run's end.
 */
abstract class StridedRecorder implements Observer {
    private final long stride;
    private long step;

    StridedRecorder(long stride) {
        if (stride < 1) {
            throw new IllegalArgumentException("the stride has to be 1 or more, not " + stride);
        }
        this.stride = stride;
    }

    /** Records a state; by default nothing. */
    void record(ParticleSystem system, double[] state, double time) {
    }

    @Override
    public void started(ParticleSystem system) {
        record(system, system.getOwnState(), system.getTime());
    }

    @Override
    public void moved(Motion motion) {
        step++;
        if (step % stride == 0) {
            record(motion.getSystem(), motion.getEndState(), motion.getEndTime());
        }
    }

    @Override
    public void changed(ParticleSystem system, Rule rule) {
        if (step % stride == 0) {
            record(system, system.getOwnState(), system.getTime());
        }
    }

    @Override
    public void finished(ParticleSystem system) {
        if (step % stride != 0) {
            record(system, system.getOwnState(), system.getTime());
        }
    }
}
