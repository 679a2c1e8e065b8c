package particles.app.run;

import particles.Motion;
import particles.Observer;

/**
 * Ends a run after the step in which a stop was requested. It is the last observer, so the others have seen the step.
 */
record StopObserver(StopRequest request) implements Observer {
    @Override
    public void moved(Motion motion) {
        if (request.isWanted()) {
            throw new StoppedException();
        }
    }
}
