package particles.teaching.measured;

import java.util.Arrays;
import java.util.Optional;
import particles.teaching.Finding;
import particles.teaching.Finding.Kind;
import particles.teaching.Formula;

/** What the check of a solver finds: the kind and the sentence of each mistake and note. */
public enum Phrase {
    // the class
    NOTHING_YET(Kind.UNWRITTEN, "the step does nothing yet: write it, then check again"),
    EXCEPTION(Kind.FAILURE, "stepState ends in an exception: %s"),
    NOT_FINITE(Kind.STATE, "the new state is NaN or infinite although state and derivative are finite"),
    NOT_REPEATABLE(Kind.METHOD, "two new solvers make different steps from the same place: something is random, or"
            + " static and shared by all solvers"),
    NO_DERIVATIVE(Kind.METHOD, "getStateDerivative is never called"),
    ARRAY_LENGTH(Kind.STATE, "an array of %s numbers was handed to a source whose state has %s: arrays have to be"
            + " source.getStateSize() long"),
    NEVER_SET(Kind.STATE, "the new state never reaches the source: setState(state) is missing"),
    LOOPS(Kind.FAILURE, "%s does not come back: an endless loop%s"),
    // clock and state
    CLOCK_STILL(Kind.TIME, "the clock never moves: incTime(deltaT) is missing"),
    CLOCK_FIXED(Kind.TIME, "the clock moves by %s s in every step, whatever deltaT is"),
    CLOCK_AT_REST(Kind.TIME, "where state and derivative are 0, the clock moves by %s s in a step of %s s"),
    CLOCK_ENDS(Kind.TIME, "%sthe clock ends at %s after a step of deltaT = %s s, and has to end at t + deltaT"),
    LENGTH(Kind.METHOD, "the step leads to %s, by the clock and by what a free particle moves, and has to lead to"
            + " t + deltaT"),
    LEFT_OUT(Kind.STATE, "these entries stay as they were: %s; the loop has to reach all %s of them"),
    LAYOUT(Kind.STATE, "entry %s of the new state changes with entry %s of the state or of the derivative, and has to"
            + " change with its own: the state is x, y, z, vx, vy, vz of one particle after the other"),
    ADDS(Kind.STATE, "where state and derivative are 0, entry %s is %s after a step: something is added that the source"
            + " does not say"),
    // motions that every method makes exactly
    FLIGHT_FIXED(Kind.METHOD, "without forces, a step moves a particle by v times %s s, whatever deltaT is"),
    FLIGHT(Kind.METHOD,
            "without forces, %s of deltaT = %s s moves a particle by %s v deltaT, and has to move it by %s v"
            + " deltaT"),
    FLIGHT_VELOCITY(Kind.METHOD, "without forces, the velocity is %s v after %s, and has to stay v"),
    FALL(Kind.METHOD,
            "with a constant acceleration a, from rest, the velocity after %s is %s a deltaT, and has to be %s"
            + " a deltaT; the position is %s a deltaT^2, and exactly %s a deltaT^2"),
    DIGITS(Kind.STATE, "digits get lost: without forces, a particle's step is off by %s of its length, as with float"
            + " or rounded numbers; all have to be double"),
    SEVEN_DIGITS(Kind.STATE,
            "digits get lost: this is %s, but its step is off by %s, as with float numbers; all have to be"
            + " double"),
    CUT_OFF(Kind.METHOD, "with velocities and accelerations of %s the step is not the one that it makes with those of"
            + " about 1: something is cut off, rounded, or depends on the size"),
    UNITS(Kind.METHOD,
            "entry %s of the new state, a %s, is off by %s if time is counted in half seconds: what is added to it"
            + " has another unit, as a velocity where an acceleration is meant, or deltaT once too often"),
    // the formula
    DIFFERS(Kind.METHOD, "%s %s; %s says %s: %s"),
    BY_DELTA_T(Kind.METHOD, "this is %s, but for one thing: %s %s, and here %s"),
    STEP(Kind.METHOD, "this is %s, but for one thing: %s"),
    ROW(Kind.METHOD, "%s; %s %s, and %s says %s"),
    STAGE_TIMES(Kind.TIME, "k%s is taken at %s; %s says %s: %s"),
    COUNT(Kind.METHOD, "%s; a step evaluates the derivative %s times, and %s does %s times"),
    OTHER_STEP(Kind.METHOD, "%s; after a step with a constant acceleration a, from rest, the position is %s a deltaT^2"
            + " and the velocity %s a deltaT; with %s they are %s and %s"),
    NO_BETTER(Kind.METHOD, "the order is %s with %s evaluations in a step, and it is not stable in longer steps than as"
            + " many steps of Euler's method"),
    PRINTED(Kind.STYLE, "the coefficients have about eight right digits: give them as fractions or formulas, such as"
            + " 1.0 / 6 or Math.sqrt(0.5), or with sixteen digits"),
    CONTRADICTS(Kind.NAME, "this is %s and not %s"),
    NOT_THE_METHOD(Kind.NAME, "its step is not that of %s: it is off by %s after a step of %s s"),
    EXPLICIT(Kind.NAME, "an explicit method with %s evaluations in a step: the equation of %s, new = %s, is not solved;"
            + " after a step of %s s it is off by %s"),
    NOTHING_EARLIER(Kind.NAME, "%s uses earlier steps; each step of this solver is the one that a new solver makes"),
    NO_CONTROL(Kind.NAME, "a step of 4 s and one of 1/4 s take as many evaluations: there is no step-size control"),
    // equations and earlier steps
    EQUATION(Kind.METHOD, "the new state solves new = %s; %s is new = %s"),
    EQUATION_OFF(Kind.METHOD, "the equation of %s, new = %s, is off by %s after a step of deltaT = %s s: it is not"
            + " solved, or another one is"),
    START(Kind.METHOD, "the formula of its later steps is right, of order %s, and the measured order is %s: the first"
            + " steps are not accurate enough"),
    STALE(Kind.STATE, "getStateDerivative is called in the first step only"),
    // measured
    NO_CONVERGENCE(Kind.METHOD, "the error does not go to 0 with deltaT%s: it is still %s with deltaT = %s s"),
    LOW_ORDER(Kind.METHOD, "the measured order is %s%s, and that of %s is %s%s"),
    OTHER_ORDER(Kind.METHOD, "the measured order is %s where bodies attract each other, and %s where a particle is on a"
            + " spring of its own"),
    STAGE_CLOCKS(Kind.TIME, "the error is %s where a force changes with the clock, with deltaT = %s s, and %s where the"
            + " same force is read off the state: some evaluations are at another clock than their states"),
    UNSTABLE(Kind.METHOD, "a step of %s s multiplies %s by %s: an implicit method has to be stable there"),
    UNCONTROLLED(Kind.METHOD,
            "sub-steps are made, and the error is still %s after a step of %s s, and %s after %s steps"
            + " over the same time"),
    LARGEST_ERROR(Kind.METHOD, "two springs swing alike, x of the first particle and z of the last, and after a step of"
            + " %s s they are %s apart: every loop, also over errors, has to reach all entries"),
    ABSOLUTE_ERROR(Kind.METHOD, "two springs start as mirror images, and after a step of %s s they differ by %s in more"
            + " than the sign: the size of an error counts, Math.abs"),
    DRAG(Kind.STYLE, "its order is %s, and %s where the acceleration depends on the velocity, as with drag"),
    DRAG_DIVERGES(Kind.METHOD,
            "where the acceleration depends on the velocity, as with drag, the error does not go to 0"
            + " with deltaT (order %s)"),
    DIVERGES(Kind.STYLE, "its iteration does not converge in a step of %s s of the spring x'' = -x"),
    // memory
    KEPT(Kind.STATE, "%s and after reset(), the step is not the one that a new solver makes: %s"),
    OTHER_SIZE(Kind.STATE, "after a source of %s numbers and reset(), a step of one of %s numbers ends in %s"),
    STATIC(Kind.STATE, "two solvers of this class step in turn, each its own source, and one disturbs the other:"
            + " something is static"),
    // every source, every deltaT
    SIZE(Kind.STATE, "with %s particles, %s: an array or a loop has a fixed length; source.getStateSize() is the"
            + " length"),
    BACK(Kind.STATE, "with deltaT = %s s, a step and one back end %s from the start, and the step alone is off by %s:"
            + " the sign of deltaT is lost"),
    CLOCK_BACK(Kind.TIME, "with deltaT = %s s the clock moves by %s s"),
    SWALLOWS(Kind.STATE, "the source threw an exception, and stepState returned as if nothing had happened: do not"
            + " catch it, so that the caller learns of it"),
    NAN_HIDDEN(Kind.STATE, "where the derivative is NaN, the new state is none, and nothing is said: the derivative has"
            + " to enter the new state whatever it is"),
    NOTHING_BACK(Kind.STYLE, "a step of negative deltaT does nothing, and says nothing"),
    MOVES_AT_ZERO(Kind.STATE, "a step of deltaT = 0 moves the state by %s"),
    ONLY_PARTICLES(Kind.STYLE, "it steps particles, six numbers each, and no source of two numbers: %s"),
    FOR_PARTICLES(Kind.STYLE, "it works on systems of positions and velocities only, such as particles, and refuses"
            + " others"),
    REFUSES_BACK(Kind.STYLE, "it refuses a negative deltaT (%s)"),
    REFUSES_ZERO(Kind.STYLE, "it refuses deltaT = 0 (%s); the built-in solvers change nothing then");

    private final Kind kind;
    private final String sentence;

    Phrase(Kind kind, String sentence) {
        this.kind = kind;
        this.sentence = sentence;
    }

    /** @return the finding if something holds */
    public Optional<Finding> when(boolean holds, Object... values) {
        return holds ? Optional.of(of(values)) : Optional.empty();
    }

    /** @return the finding; numbers with a fraction are written as people do */
    public Finding of(Object... values) {
        return new Finding(kind, this, Arrays.asList(values), Formula.text(sentence, values));
    }
}
