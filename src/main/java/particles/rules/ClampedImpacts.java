package particles.rules;

import java.util.ArrayList;
import java.util.BitSet;
import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import particles.Motion;
import particles.ParticleSystem;
import particles.law.Vector3;
import particles.reactions.BlockImpacts.Meeting;
import particles.reactions.ContactModes.Mode;
import particles.reactions.ContactSurface;
import particles.reactions.RestingContacts;
import particles.reactions.Tolerances;

/**
 * Collisions with planes and spheres at the end of the step (clamp), the slides' "Particle/Plane Collisions": at an
 * impact v_n' = -r v_n and v_t' = v_t. "Should back-off simulation until it's just on the plane. But usually don't
 * bother!" - this rule does not bother: after a step, a particle found below a surface is moved onto it.
 *
 * <p>It gets the speed that it had at the surface. If the normal acceleration a = delta v/deltaT is constant within the
 * step, the square of that speed is v_n&sup2; + 2 a depth, so a particle that is lifted against gravity loses speed. A
 * bounce thus multiplies the energy of the normal motion by r&sup2; and adds none. Each bounce comes late, by less than
 * deltaT; {@link ExactImpacts} finds the exact time.
 *
 * <p>A particle that would leave slower than the surface's rest speed, or slower than the speed it gained within the
 * step (a bounce too short for deltaT), stays in contact. There it slides; it sticks once it is slower than the
 * friction's threshold or has reversed within a step, if static friction can hold it. In a step in which Coulomb
 * friction may stop it, friction acts as an impulse, see {@link particles.reactions.Contacts#stopAfter}; where that
 * would let it slide visibly too far, the step is divided at the stop.
 */
public final class ClampedImpacts extends Impacts {
    private final Map<Integer, Double> stops = new LinkedHashMap<>();      // when friction stops a particle (s)
    private double stepEnd;
    private BitSet foreseen = new BitSet();             // particles that may stop within the next step
    private double foreseenStep = Double.NaN;           // its length (s)
    private int foreseenAt;                             // the modes' count of changes
    private double[] arrived = {};                      // the state at the end of the step, before clamping
    private final double[] entered;                     // when a particle flew into each surface, as part of the step

    /**
     * A particle that was free and is below a surface now.
     *
     * @param crossed when it crossed the surface, as a fraction of the step
     */
    private record Below(int surface, int particle, double crossed) {
    }

    /** @param resting the surfaces and the particles in contact with them */
    public ClampedImpacts(RestingContacts resting) {
        super(resting);
        entered = new double[surfaces.size()];
    }

    @Override
    public void beforeStep(ParticleSystem system, double deltaT) {
        boolean isForeseen = deltaT == foreseenStep && modes.getChanges() == foreseenAt;
        super.beforeStep(system, deltaT);
        forceKnown = isForeseen;
        foreseenStep = Double.NaN;
        BitSet stopping = isForeseen ? foreseen : resting.getQueries().findStopping(deltaT, this::forces);
        double[] state = system.getOwnState();
        stepEnd = system.getTime() + deltaT;
        stops.clear();
        for (int i = stopping.nextSetBit(0); i >= 0; i = stopping.nextSetBit(i + 1)) {
            double time = resting.isCoupled(i) ? deltaT : resting.getQueries().stoppingTime(i, state, forces());
            double farther = velocity(state, i).length() * (deltaT - time) / 2;
            boolean divides = time < deltaT && farther > Tolerances.FAR * (1 + Vector3.at(state, STRIDE * i).norm1());
            contacts.stopAfter(i, divides ? time : deltaT);
            if (divides) {
                stops.put(i, system.getTime() + time);
            }
        }
    }

    /** {@inheritDoc} Divides the step where a particle stops, if it would slide visibly farther otherwise. */
    @Override
    public void findEvents(Motion motion, List<Event> found) {
        stops.forEach((i, time) -> {
            if (time < motion.getEndTime()) {
                found.add(new Event(time, false, () -> time - system.getTime(), () -> stop(i)));
            }
        });
    }

    private void stop(int i) {
        forceKnown = false;
        if (holdMargin(i) >= 0) {
            stick(i, system.getOwnState());
        }
        beforeStep(system, stepEnd - system.getTime());
    }

    @Override
    public boolean afterStep(ParticleSystem system, double whole) {
        if (arrived.length != system.getStateSize()) {
            arrived = new double[system.getStateSize()];
        }
        system.getState(arrived);
        forceKnown = false;
        boolean changed = false;
        boolean coupledChanged = false;
        List<Below> below = new ArrayList<>();
        for (int i = 0; i < particles.count(); i++) {
            if (!particles.isFixed(i) && check(i, below)) {
                changed = true;
                coupledChanged |= resting.isCoupled(i);
            }
        }
        below.sort(Comparator.comparingDouble(Below::crossed));
        for (int from = 0, to; from < below.size(); from = to) {
            to = from;
            while (to < below.size() && below.get(to).crossed <= below.get(from).crossed + Tolerances.AT_ONCE) {
                to++;
            }
            answer(below.subList(from, to), deltaT);
        }
        if (coupledChanged) {
            resting.putBack();
        }
        forceKnown &= below.isEmpty() && !coupledChanged;
        // last, since a rod between two sticking particles could no longer be corrected
        for (int i = 0; i < modes.end(); i++) {
            changed |= slideOrStick(i);
        }
        foreseen = resting.getQueries().findStopping(whole, this::forces);
        foreseenStep = whole;
        foreseenAt = modes.getChanges();
        return !foreseen.isEmpty() || changed;          // friction as an impulse has a new direction in each step
    }

    /** Returns whether a particle has left a surface, or was or is below one. */
    private boolean check(int i, List<Below> below) {
        stopFlight(i);
        boolean changes = false;
        for (int p = 0; p < entered.length; p++) {
            changes |= modes.get(p, i) == Mode.FREE ? findBelow(p, i, below) : keepInContact(p, i);
        }
        return changes;
    }

    /** Finds out whether a particle that was free is below a surface now, and when it crossed it. */
    private boolean findBelow(int p, int i, List<Below> found) {
        ContactSurface surface = surfaces.get(p);
        double[] before = contacts.getStepBegin();
        boolean isBelow = surface.distance(system.getOwnState(), i) < 0;
        if (isBelow) {
            double crossed = surface.distance(before, i) > 0 ? firstBelow(surface, i) : 0;
            found.add(new Below(p, i, Double.isNaN(crossed) ? 1 : crossed));
        }
        return isBelow;
    }

    /** Lets particles that crossed surfaces at one moment bounce or rest there. */
    private void answer(List<Below> crossing, double deltaT) {
        double[] state = system.getOwnState();
        double[] before = contacts.getStepBegin();
        Map<Meeting, Double> slow = new LinkedHashMap<>();      // the speed below which the particle rests (m/s)
        Map<Integer, BitSet> under = new LinkedHashMap<>();
        for (Below each : crossing) {
            int i = each.particle;
            ContactSurface surface = surfaces.get(each.surface);
            double depth = -surface.distance(state, i);
            if (depth <= 0) {
                continue;                               // an impact on another surface has taken it out
            }
            under.computeIfAbsent(i, particle -> new BitSet()).set(each.surface);
            Vector3 normal = surface.normal(state, i);
            double speed = surface.normalSpeed(state, i);
            if (speed >= 0 && !surface.obstacle().isFlat() && isOn(surface, before, i)) {
                continue;                               // it has just left: below only by the error of its step
            }
            double gained = normal.dot(velocity(arrived, i).minus(velocity(before, i)));
            double atSurface = Math.sqrt(Math.max(0, speed * speed + 2 * gained / deltaT * depth));
            if (speed < 0) {
                double limit = slow(surface, Math.max(Math.abs(gained),
                        Math.abs(speed - normal.dot(velocity(before, i)))));
                double leaving = surface.bounce().restitution() * atSurface;
                boolean rests = leaving <= limit;
                // a particle that rests stays on others where it would be back in half a step
                Vector3 pull = rests && modes.isTouching(i) && !resting.isCoupled(i)
                        ? velocity(forces(), i).times(deltaT / 2 / particles.mass(i)) : Vector3.ZERO;
                slow.put(new Meeting(each.surface, i, rests ? 0 : leaving, pull), limit);
            } else if (!resting.isCoupled(i)) {
                moveAlong(normal, state, STRIDE * i + 3, atSurface - speed);
            }
        }
        under.forEach((i, some) -> resting.getImpacts().lift(i, some, state));
        resting.getImpacts().answer(List.copyOf(slow.keySet()), state);
        slow.forEach((meeting, limit) -> {
            int i = meeting.particle();
            if (surfaces.get(meeting.surface()).normalSpeed(state, i) <= limit) {
                rest(meeting.surface(), i);
                resting.putOnSurfaces(i, state);
                forceKnown = false;
            }
        });
    }

    /**
     * The speed below which a particle rests (m/s).
     *
     * @param gained what it gained within the step (m/s)
     */
    private static double slow(ContactSurface surface, double gained) {
        return surface.bounce().restitution() == 1 ? Tolerances.ELASTIC * gained
                : Math.max(surface.bounce().restSpeed(), gained);
    }

    /** Handles a particle that was in contact: it may leave, hit another surface, begin to slide or stop. */
    private boolean keepInContact(int p, int i) {
        double[] state = system.getOwnState();
        ContactSurface surface = surfaces.get(p);
        boolean isFlat = surface.obstacle().isFlat();
        double distance = isFlat ? surface.distance(state, i) : 0;
        boolean leaves = isFlat ? distance > slack(state, i) : pressure(p, i) < 0;
        boolean isBelow = distance < -slack(state, i);
        if (leaves) {
            modes.set(p, i, Mode.FREE);
        }
        if (!isFlat) {
            putOn(surface, state, i);                   // removes drift by the solver's error
        } else if (isBelow) {
            lift(surface, state, i);
            if (surface.normalSpeed(state, i) < 0) {
                stopAlong(surface.normal(state, i), state, i);
            }
        }
        return leaves || isBelow;
    }

    /**
     * A sticking particle begins to slide if friction cannot hold it; a sliding one that stops sticks if friction can.
     */
    private boolean slideOrStick(int i) {
        double[] state = system.getOwnState();
        boolean sticks = modes.isSticking(i);
        if (!modes.isTouching(i) || !sticks && !contacts.hasStopped(i, velocity(state, i))
                || holdMargin(i) >= 0 == sticks) {
            return false;
        }
        if (sticks) {
            modes.setWhereTouching(i, Mode.SLIDING);
        } else {
            stick(i, state);
        }
        return true;
    }

    /** Moves a particle that flew into balls within the step back to where it first did so, with its velocity there. */
    private void stopFlight(int i) {
        double[] state = system.getOwnState();
        double[] before = contacts.getStepBegin();
        crossing.begin(before, arrived, deltaT, i);
        double first = Double.POSITIVE_INFINITY;
        for (int p = 0; p < entered.length; p++) {
            ContactSurface surface = surfaces.get(p);
            // one that began on the surface or below has been put there by rods
            double distance = surface.obstacle().isFlat() || modes.get(p, i) != Mode.FREE ? 0
                    : surface.distance(before, i);
            boolean mayEnter = distance > slack(before, i) && distance <= crossing.reach();
            entered[p] = mayEnter ? firstBelow(surface, i) : Double.NaN;
            first = entered[p] < first ? entered[p] : first;
        }
        if (first < 1) {
            crossing.put(first, before, arrived, i, state);
        }
        for (int p = 0; first <= 1 && p < entered.length; p++) {
            if (entered[p] <= first + Tolerances.AT_ONCE) {
                moveAlong(surfaces.get(p).normal(state, i), state, STRIDE * i,
                        -surfaces.get(p).distance(state, i) - slack(state, i));
            }
        }
    }
}
