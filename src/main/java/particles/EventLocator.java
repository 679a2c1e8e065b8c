package particles;

import deSolvers.DESolver;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;

/**
 * Finds when an event happens: the length of a step, from a given state, after which the event's function is 0. Each
 * trial is a step of a solver of its own from the same beginning, so that the state at the event is as accurate as any
 * other step's end; the step's solver keeps its memory.
 *
 * <p>The function is bracketed and the bracket shrunk by the Illinois variant of regula falsi (M. Dowell, P. Jarratt
 * 1971), of order 1.44 and always inside the bracket, down to the resolution of the clock.
 */
final class EventLocator {
    private static final int MOST_TRIALS = 200;

    private static final Comparator<Found> EARLIEST = Comparator.comparingDouble(found -> found.event().time());

    private final DESolver solver;
    private final List<Found> candidates = new ArrayList<>();
    private final List<EventRule.Event> ofRule = new ArrayList<>();
    private double[] begin = {};
    private double beginTime;

    EventLocator(DESolver solver) {
        this.solver = solver;
    }

    /**
     * What happened first.
     *
     * @param event what
     * @param rule  whose event it is
     */
    record Found(EventRule.Event event, EventRule rule) {
    }

    /**
     * Takes a motion back to its first event, if it has any. The motion and the system end there.
     *
     * @param system the system, at the motion's end
     * @param motion the step as it was made
     * @param rules  whose events are looked for
     * @return the event
     */
    Optional<Found> locateFirst(ParticleSystem system, Motion motion, List<EventRule> rules) {
        Optional<Found> first = Optional.empty();
        for (double end = Double.POSITIVE_INFINITY; motion.getEndTime() < end;) {
            end = motion.getEndTime();
            Optional<Found> found = locateOne(system, motion, rules);
            if (found.isPresent()) {
                first = found;
                motion.end();                           // and look again: may something else come before?
            }
        }
        return first;
    }

    /** The earliest that does happen: what the cubic says in vain must not hide what comes after it. */
    private Optional<Found> locateOne(ParticleSystem system, Motion motion, List<EventRule> rules) {
        candidates.clear();
        for (EventRule rule : rules) {
            ofRule.clear();
            rule.findEvents(motion, ofRule);
            for (EventRule.Event event : ofRule) {
                candidates.add(new Found(event, rule));
            }
        }
        candidates.sort(EARLIEST);
        for (Found candidate : candidates) {
            if (locate(system, motion, candidate.event())) {
                return Optional.of(candidate);
            }
        }
        return Optional.empty();
    }

    /**
     * Leaves the system at the event: at the last moment before the function becomes negative, or the first after that.
     *
     * @param system  the system, anywhere
     * @param motion  the step in which an event was found; its beginning is where trials begin
     * @param event   what was found in it
     * @return whether there is such a moment; if not, the system is back at the end of the motion, to the last bit
     */
    private boolean locate(ParticleSystem system, Motion motion, EventRule.Event event) {
        begin = motion.getStartState();
        beginTime = motion.getStartTime();
        if (event.time() <= beginTime) {
            step(system, 0);
            return true;
        }
        double longest = motion.getEndTime() - beginTime;
        double first = Math.min(event.time() - beginTime, longest);
        double low = 0;
        double lowValue = valueAfter(system, event, 0);
        if (!(lowValue > 0)) {                          // begins at the last event: positive only in between
            low = first / 2;
            lowValue = valueAfter(system, event, low);
        }
        if (!(lowValue > 0)) {
            step(system, 0);
            return true;                                // it happens right away
        }
        double high = first;
        double highValue = valueAfter(system, event, high);
        for (double more = 1e-6 * longest; highValue > 0 && high < longest; more *= 4) {
            low = high;                                 // the cubic said so a little too early
            lowValue = highValue;
            high = Math.min(longest, high + more);
            highValue = valueAfter(system, event, high);
        }
        if (highValue > 0) {
            system.setState(motion.getEndState());
            system.setTime(motion.getEndTime());
            return false;
        }
        step(system, shrink(system, event, low, lowValue, high, highValue));
        return true;
    }

    /** Shrinks the bracket to neighbouring times; returns the end where the event happens. */
    private double shrink(ParticleSystem system, EventRule.Event event, double low, double lowValue, double high,
                          double highValue) {
        double resolution = Math.ulp(beginTime + high);
        int side = 0;
        if (event.happensAfter() && high - resolution > low) {      // when found again, it is at the end already
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

    private double valueAfter(ParticleSystem system, EventRule.Event event, double h) {
        step(system, h);
        return event.value(system);
    }

    private void step(ParticleSystem system, double h) {
        system.setState(begin);
        system.setTime(beginTime);
        solver.reset();
        solver.stepState(system, h);
    }
}
