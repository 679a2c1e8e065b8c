package particles;

import java.util.List;

/** The observers of a run, and what they are told when. */
final class Observers {
    private final List<Observer> observers;

    /** @param observers who is told; the list may grow */
    Observers(List<Observer> observers) {
        this.observers = observers;
    }

    /** Tells a motion to those whose time comes within it. */
    void reportMotion(Motion motion) {
        for (Observer observer : observers) {
            if (observer.getNextTime() <= motion.getEndTime()) {
                observer.moved(motion);
            }
        }
    }

    void reportChange(ParticleSystem system, Rule rule) {
        for (Observer observer : observers) {
            observer.changed(system, rule);
        }
    }

    /** Whether anyone wants to see a motion until then (s). */
    boolean isInterested(double until) {
        for (Observer observer : observers) {
            if (observer.getNextTime() <= until) {
                return true;
            }
        }
        return false;
    }
}
