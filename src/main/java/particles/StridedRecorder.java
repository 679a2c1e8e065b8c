package particles;

/**
 * Base class of observers that record states: the first one, that after every n-th step, after the changes by rules at
 * its end, and the last one.
 */
public abstract class StridedRecorder implements Observer {
    private final long stride;
    private long step;

    /** Creates a recorder of every step. */
    protected StridedRecorder() {
        this(1);
    }

    /** @param stride the number of steps from one record to the next, 1 or more */
    protected StridedRecorder(long stride) {
        if (stride < 1) {
            throw new IllegalArgumentException("the stride has to be 1 or more, not " + stride);
        }
        this.stride = stride;
    }

    /** Records a state; by default nothing. */
    protected void record(ParticleSystem system, double[] state, double time) {
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
