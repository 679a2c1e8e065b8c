package particles;

import java.util.List;

/** The observers of a run; calls each one at the times that it asked for. */
final class Observers {
    private final List<Observer> observers;

    /** @param observers the observers; the list may grow */
    Observers(List<Observer> observers) {
        this.observers = observers;
    }

    /** Reports a motion to the observers whose next time is within it. */
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

    /** Whether any observer wants to see a motion that ends at this time (s). */
    boolean isInterested(double until) {
        for (Observer observer : observers) {
            if (observer.getNextTime() <= until) {
                return true;
            }
        }
        return false;
    }
}
