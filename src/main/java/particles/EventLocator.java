package particles;

import deSolvers.DESolver;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import particles.EventRule.Event;

/**
 * Event location: finds the step length, from a given state, at which an event function is 0. Each trial is a step from
 * the same beginning with a separate solver, so that the state at the event is as accurate as any other step's end and
 * the run's solver keeps its memory.
 *
 * <p>The root is bracketed, and the bracket shrunk to the resolution of the clock by the Illinois variant of regula
 * falsi (M. Dowell, P. Jarratt 1971), of order 1.44.
 */
final class EventLocator {
    private static final int MOST_TRIALS = 200;

    private final DESolver solver;
    private double[] begin = {};
    private double beginTime;
    private double reached;                             // the length of the last trial; NaN if there was none (s)

    EventLocator(DESolver solver) {
        this.solver = solver;
    }

    /**
     * The first event of a motion.
     *
     * @param event the event
     * @param rule the rule that found it
     */
    record Found(Event event, EventRule rule) {
    }

    /**
     * Moves the end of a motion, and the system, back to its first event, if it has any.
     *
     * @param system the system, at the motion's end
     * @param motion the step as it was made
     * @param rules  the rules whose events are located
     * @return the event
     */
    Optional<Found> locateFirst(ParticleSystem system, Motion motion, List<EventRule> rules) {
        Optional<Found> first = Optional.empty();
        for (double end = Double.POSITIVE_INFINITY; motion.getEndTime() < end;) {
            end = motion.getEndTime();
            Optional<Found> found = locateOne(system, motion, rules);
            if (found.isPresent()) {
                first = found;
                motion.end();                           // look again for an earlier event
            }
        }
        return first;
    }

    /** Locates the earliest event that really happens; false events found on the cubic are skipped. */
    private Optional<Found> locateOne(ParticleSystem system, Motion motion, List<EventRule> rules) {
        List<Found> candidates = new ArrayList<>();
        for (EventRule rule : rules) {
            List<Event> events = new ArrayList<>();
            rule.findEvents(motion, events);
            events.forEach(event -> candidates.add(new Found(event, rule)));
        }
        candidates.sort(Comparator.comparingDouble(found -> found.event().time()));
        return candidates.stream().filter(candidate -> locate(system, motion, candidate.event())).findFirst();
    }

    /**
     * Moves the system to the event: to the last time before the function becomes negative, or the first after that.
     *
     * @param system  the system, in any state
     * @param motion  the step in which an event was found; trials begin at its beginning
     * @param event   the event
     * @return whether the event happens; if not, the system is back at the end of the motion, bit for bit
     */
    private boolean locate(ParticleSystem system, Motion motion, Event event) {
        begin = motion.getStartState();
        beginTime = motion.getStartTime();
        reached = Double.NaN;
        if (event.time() <= beginTime) {
            step(system, 0);
            return true;
        }
        double longest = motion.getEndTime() - beginTime;
        double first = Math.min(event.time() - beginTime, longest);
        double low = 0;
        double lowValue = valueAfter(system, event, 0);
        if (!(lowValue > 0)) {                          // the motion begins at the last event: positive only later
            low = first / 2;
            lowValue = valueAfter(system, event, low);
        }
        if (!(lowValue > 0)) {
            step(system, 0);
            return true;                                // the event is at once
        }
        double high = first;
        double highValue = valueAfter(system, event, high);
        for (double more = 1e-6 * longest; highValue > 0 && high < longest; more *= 4) {
            low = high;                                 // the guess from the cubic was too early
            lowValue = highValue;
            high = Math.min(longest, high + more);
            highValue = valueAfter(system, event, high);
        }
        if (highValue > 0) {
            system.setState(motion.getEndState());
            system.setTime(motion.getEndTime());
            return false;
        }
        double found = shrink(system, event, low, lowValue, high, highValue);
        if (found != reached) {
            step(system, found);
        }
        return true;
    }

    /** Shrinks the bracket to neighbouring times; returns the end where the event happens. */
    private double shrink(ParticleSystem system, Event event, double low, double lowValue, double high,
                          double highValue) {
        double resolution = Math.ulp(beginTime + high);
        int side = 0;
        if (event.happensAfter() && high - resolution > low) {      // when located again, high is already the time
            double value = valueAfter(system, event, high - resolution);
            if (value > 0) {
                return high;
            }
            high -= resolution;
            highValue = value;
        }
        for (int trial = 0; trial < MOST_TRIALS && high - low > resolution && highValue < 0; trial++) {
            double h = low + (high - low) * (lowValue / (lowValue - highValue));
            if (trial % 8 == 7 || !(h > low && h < high)) {
                h = low + (high - low) / 2;
            }
            if (h <= low || h >= high) {
                break;
            }
            double value = valueAfter(system, event, h);
            if (value > 0) {
                low = h;
                lowValue = value;
                highValue = side > 0 ? highValue / 2 : highValue;
                side = 1;
            } else {
                high = h;
                highValue = value;
                lowValue = side < 0 ? lowValue / 2 : lowValue;
                side = -1;
            }
        }
        return highValue == 0 || event.happensAfter() ? high : low;
    }

    private double valueAfter(ParticleSystem system, Event event, double h) {
        step(system, h);
        return event.function().getAsDouble();
    }

    private void step(ParticleSystem system, double h) {
        system.setState(begin);
        system.setTime(beginTime);
        solver.reset();
        solver.stepState(system, h);
        reached = h;
    }
}
