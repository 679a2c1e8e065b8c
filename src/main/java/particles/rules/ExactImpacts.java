package particles.rules;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.function.DoubleSupplier;
import java.util.function.ToDoubleFunction;
import particles.Motion;
import particles.ParticleSystem;
import particles.law.Obstacle;
import particles.law.Vector3;
import particles.reactions.BlockImpacts.Meeting;
import particles.reactions.ContactModes.Mode;
import particles.reactions.ContactSurface;
import particles.reactions.RestingContacts;
import particles.reactions.Tolerances;

/**
 * Collisions with planes and spheres at their exact times, by event location: the slides' "should back-off simulation
 * until it's just on the plane". At an impact v_n' = -r v_n and v_t' = v_t; a particle that would leave no faster than
 * the surface's rest speed while it is pressed on stays in contact. The end of a contact, of sliding and of sticking
 * are events too. Particles are never lifted, so no energy is added and the solver keeps its order.
 */
public final class ExactImpacts extends Impacts {
    /** Near a stop, a part of a step that is longer than this may be divided (relative to deltaT). */
    private static final double SHORTEST_PART = 0x1p-40;

    private Optional<Collisions> balls = Optional.empty();

    /**
     * The gap between a particle and a surface, or between two balls.
     *
     * @param solid  what the path enters when the gap closes: the surface, or for the path of one ball relative to
     *               another a sphere around the origin
     * @param height by how much the solid is raised (m)
     * @param size   the gap in a state (m), negative inside
     * @param rate   the rate at which it grows in a state (m/s)
     */
    record Gap(Obstacle solid, double height, ToDoubleFunction<double[]> size, ToDoubleFunction<double[]> rate) {
    }

    /** A particle that meets a surface. */
    private record Touch(int surface, int particle) {
    }

    /** @param resting the surfaces and the particles in contact with them */
    public ExactImpacts(RestingContacts resting) {
        super(resting);
        contacts.setHolding(true);
    }

    /** Answers impacts of balls together with those on surfaces. */
    void join(Collisions collisions) {
        balls = Optional.of(collisions);
    }

    /**
     * Removes the solver's error that would let particles drift off a curved surface; everything else happens at
     * events. The equations do not change, and no work is recorded.
     */
    @Override
    public boolean afterStep(ParticleSystem system, double deltaT) {
        double[] state = system.getOwnState();
        for (int p = 0; p < surfaces.size(); p++) {
            ContactSurface surface = surfaces.get(p);
            for (int i = 0; !surface.obstacle().isFlat() && i < particles.count(); i++) {
                if (modes.get(p, i) != Mode.FREE) {
                    putOn(surface, state, i);
                    if (!resting.isCoupled(i)) {
                        resting.settle(i, false, state);
                    }
                } else if (surface.distance(state, i) < 0 && surface.normalSpeed(state, i) >= 0
                        && !particles.isFixed(i)) {
                    lift(surface, state, i);
                }
            }
        }
        return false;
    }

    /** {@inheritDoc} Near a stop by friction much further: a solver steps across it before it can be located. */
    @Override
    public boolean mayDivide(double length, double deltaT) {
        return super.mayDivide(length, deltaT) || modes.isAnyTouching() && length > SHORTEST_PART * deltaT
                && resting.getQueries().mayStopWithin(length);
    }

    @Override
    public void findEvents(Motion motion, List<Event> found) {
        if (modes.isAnyTouching()) {
            double[] force = forces();
            int others = found.size();
            for (int i = 0; i < modes.end() && found.size() == others; i++) {   // any will do, not only the first
                findChange(i, motion, force, found);
            }
        }
        double size = -1;
        double h = motion.getEndTime() - motion.getStartTime();
        for (int i = 0; i < particles.count(); i++) {
            crossing.begin(motion.getStartState(), motion.getEndState(), h, i);
            for (int p = 0; p < surfaces.size() && !particles.isFixed(i); p++) {
                if (modes.get(p, i) == Mode.FREE) {
                    boolean begins = isOn(surfaces.get(p), motion.getStartState(), i);
                    size = begins && size < 0 ? size(motion) : size;
                    findMeeting(p, i, motion, begins ? size : Double.NaN, found);
                }
            }
        }
    }

    /** Finds out whether a contact ends within a motion, or sliding or sticking, by the signs at the motion's end. */
    private void findChange(int i, Motion motion, double[] force, List<Event> found) {
        double end = motion.getEndTime();
        double[] state = motion.getEndState();
        for (int p = 0; p < surfaces.size(); p++) {
            int surface = p;
            if (modes.get(p, i) != Mode.FREE && resting.getQueries().pressure(p, i, state, force) < 0) {
                found.add(new Event(end, true, () -> pressure(surface, i), () -> letGo(surface, i)));
                return;
            }
        }
        if (modes.isSticking(i)) {
            if (resting.getQueries().holdMargin(i, state, force) < 0) {
                found.add(new Event(end, true, () -> holdMargin(i), () -> slide(i)));
            }
            return;
        }
        Vector3 before = velocity(motion.getStartState(), i);
        double speed = before.length();
        double slow = speed > contacts.threshold(i) * (1 + Tolerances.ROUNDING) ? contacts.threshold(i) : 0;
        DoubleSupplier moving = () -> velocity(system.getOwnState(), i).dot(before) / speed - slow;
        if (speed != 0 && contacts.rubs(i) && moving.getAsDouble() < 0) {
            found.add(new Event(end, true, moving, () -> stop(i, speed)));
        }
    }

    /** Ends sticking; the particle starts from rest, and friction acts against the force that moves it. */
    private void slide(int i) {
        modes.setWhereTouching(i, Mode.SLIDING);
        contacts.beginStep();
    }

    /** Removes the normal velocity on a curved surface: it is the solver's error and would be taken for an impact. */
    private void letGo(int p, int i) {
        if (!surfaces.get(p).obstacle().isFlat()) {
            putOn(surfaces.get(p), system.getOwnState(), i);
        }
        modes.set(p, i, Mode.FREE);
    }

    private void findMeeting(int p, int i, Motion motion, double size, List<Event> found) {
        ContactSurface surface = surfaces.get(p);
        double radius = surface.obstacle().isFlat() ? 0 : 1 / surface.curvature(motion.getStartState(), i);
        Gap gap = new Gap(surface.obstacle(), surface.radius().applyAsDouble(i), state -> surface.distance(state, i),
                state -> surface.normalSpeed(state, i));
        findMeeting(motion, crossing, gap, Tolerances.DEEP * (size + radius), found, () -> meet(p, i));
    }

    /**
     * Finds when a gap first closes, on the cubic between the motion's ends. Where the motion begins in touch (after a
     * bounce, a release or a birth), the gap has the size of round-off; it closes again only if it becomes more
     * negative than that, by the solver's step and not only by the cubic. The cubic may dip falsely: a particle
     * released with no speed and no acceleration rises as t&sup3;, and at first the cubic's error of order t&sup2;
     * h&sup2; is larger than that.
     *
     * @param path   the path of the particle, or of one ball relative to the other
     * @param depth  round-off of the gap (m); NaN if the motion does not begin in touch
     * @param found  receives the event
     * @param action applies it
     */
    static void findMeeting(Motion motion, FirstCrossing path, Gap gap, double depth, List<Event> found,
            Runnable action) {
        boolean begins = !Double.isNaN(depth);
        double below = begins ? Math.max(0, depth - gap.size.applyAsDouble(motion.getStartState())) : 0;
        double u = path.into(gap.solid, gap.height - below);
        if (!Double.isNaN(u)) {
            DoubleSupplier function = () -> {
                double[] state = motion.getSystem().getOwnState();
                double above = gap.size.applyAsDouble(state) + below;
                return begins && !gap.solid.isFlat() ? Math.max(above, gap.rate.applyAsDouble(state)) : above;
            };
            double start = motion.getStartTime();
            double time = start + u * (motion.getEndTime() - start);
            found.add(new Event(begins ? Math.max(time, Math.nextUp(start)) : time, false, function, action));
        }
    }

    /**
     * The largest coordinate of any particle, or the path in this motion if that is longer (m): round-off in a spring's
     * force is relative to its length and, in a stable step, moves its ends by a few round-offs of that.
     */
    static double size(Motion motion) {
        double h = motion.getEndTime() - motion.getStartTime();
        double size = 0;
        for (double[] state : List.of(motion.getStartState(), motion.getEndState())) {
            for (int x = 0; x < state.length; x += STRIDE) {
                for (int c = x; c < x + 3; c++) {
                    size = Math.max(size, Math.max(Math.abs(state[c]), h * Math.abs(state[c + 3])));
                }
            }
        }
        return size;
    }

    /** A free particle meets a surface: it bounces, comes to rest, or leaves if it was below by round-off. */
    private void meet(int p, int i) {
        lift(surfaces.get(p), system.getOwnState(), i);
        if (surfaces.get(p).normalSpeed(system.getOwnState(), i) <= 0 || isPressedOn(p, i)) {
            answer(p, i);
        }
        contacts.beginStep();
    }

    /**
     * Answers all impacts of this moment, besides one that is known. Impacts that follow at once are answered in the
     * same call, as when a ball is caught in a closing gap.
     */
    final void answer(int p, int i) {
        double[] state = system.getOwnState();
        double[] before = state.clone();
        List<Touch> met = new ArrayList<>();
        if (p >= 0) {
            met.add(new Touch(p, i));
        }
        findMeetings(met);
        balls.ifPresent(Collisions::findTouching);
        do {
            resting.getImpacts().answer(meetings(met), state);
        } while (findMeetings(met) | balls.map(Collisions::findTouching).orElse(false));
        met.sort(Comparator.comparingInt(Touch::particle).thenComparingInt(Touch::surface));
        met.forEach(touch -> settle(touch.surface, touch.particle, velocity(before, touch.particle).length()));
        balls.ifPresent(Collisions::settle);
    }

    /** Lets a particle rest on a surface that it has struck, or leave it. */
    private void settle(int p, int i, double speedBefore) {
        double[] state = system.getOwnState();
        boolean rests = surfaces.get(p).normalSpeed(state, i) <= restSpeed(surfaces.get(p), i);
        boolean isAlone = !resting.isCoupled(i);
        if (rests) {
            rest(p, i);
        }
        resting.putOnSurfaces(i, state);
        if (rests || isAlone) {
            stickIfSlow(i, speedBefore);
        }
        resting.settle(i, false, state);
    }

    /** Finds the free particles that meet a surface now; returns whether there are any that had not met it. */
    private boolean findMeetings(List<Touch> met) {
        double[] state = system.getOwnState();
        int before = met.size();
        for (int i = 0; i < particles.count(); i++) {
            for (int p = 0; p < surfaces.size() && !particles.isFixed(i); p++) {
                ContactSurface surface = surfaces.get(p);
                if (modes.get(p, i) == Mode.FREE && Math.abs(surface.distance(state, i)) <= moment(state, i)
                        && surface.normalSpeed(state, i) < 0 && !met.contains(new Touch(p, i))) {
                    met.add(new Touch(p, i));
                    lift(surface, state, i);
                }
            }
        }
        return met.size() > before;
    }

    /** The meetings at the present speeds. */
    private List<Meeting> meetings(List<Touch> met) {
        return met.stream().map(touch -> {
            ContactSurface surface = surfaces.get(touch.surface);
            double leaving = -surface.bounce().restitution()
                    * surface.normalSpeed(system.getOwnState(), touch.particle);
            boolean bounces = leaving > restSpeed(surface, touch.particle);
            return new Meeting(touch.surface, touch.particle, bounces ? leaving : 0, Vector3.ZERO);
        }).toList();
    }

    /** How far apart two may be that meet at this moment: round-off of a place, and of the clock (m). */
    final double moment(double[] state, int i) {
        return Tolerances.PLACE * (1 + Vector3.at(state, STRIDE * i).norm1())
                + Tolerances.CLOCK * Math.ulp(system.getTime()) * velocity(state, i).norm1();
    }

    private boolean isPressedOn(int p, int i) {
        modes.set(p, i, Mode.SLIDING);
        boolean pressed = pressure(p, i) > 0;
        modes.set(p, i, Mode.FREE);
        return pressed;
    }
}
