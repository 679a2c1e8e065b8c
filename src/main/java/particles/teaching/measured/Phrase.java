package particles.teaching.measured;

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
    NOT_REPEATABLE(Kind.METHOD, "six steps end elsewhere if they are made again, with steps of another solver in"
            + " between: something is random, or static and shared by all solvers"),
    NO_DERIVATIVE(Kind.METHOD, "getStateDerivative is never called"),
    NEVER_SET(Kind.STATE, "the new state never reaches the source: setState(state) is missing"),
    // clock and state
    CLOCK(Kind.TIME, "after step %s of deltaT = %s s the clock is off by %s s: incTime has to move it to t + deltaT"),
    LAYOUT(Kind.STATE, "entry %s of the new state changes with entry %s of the state or of the derivative, and has to"
            + " change with its own: the state is x, y, z, vx, vy, vz of one particle after the other"),
    ADDS(Kind.STATE, "where state and derivative are 0, entry %s is %s after a step: something is added that"
            + " the source does not say"),
    ALIKE(Kind.STATE, "%s particles start alike, and after a step %s: loops and arrays have to reach all"
            + " source.getStateSize() entries"),
    // motions that every method makes exactly
    FLIGHT(Kind.METHOD, "without forces, after step %s of deltaT = %s s a particle with v = %s m/s along %s has moved"
            + " by %s v deltaT, and exactly by %s v deltaT; its velocity is %s v, and exactly 1 v"),
    FALL(Kind.METHOD, "with a constant acceleration, from rest, after step %s of deltaT = %s s a particle with a = %s"
            + " m/s^2 along %s has the velocity %s a deltaT, and exactly %s a deltaT; its position is %s a deltaT^2,"
            + " and exactly %s a deltaT^2"),
    UNITS(Kind.METHOD, "entry %s of the new state, a %s, is off by %s if time is counted in half seconds: a number"
            + " of seconds is in the class, or unlike units are added up, such as an acceleration and a velocity"),
    SEVEN_DIGITS(Kind.STATE, "digits get lost: this is %s, but its step is off by %s, as with float numbers;"
            + " all have to be double"),
    // the formula
    DIFFERS(Kind.METHOD, "%s %s; %s says %s: %s"),
    STEP(Kind.METHOD, "this is %s, but for one thing: %s"),
    ROW(Kind.METHOD, "%s; %s %s, and %s says %s"),
    ASTRAY(Kind.METHOD, "%s; %s"),
    OTHER_TIME(Kind.TIME, "%s; the measured order is %s"),
    EARLY_OR_LATE(Kind.STYLE, "%s; this does not lower the order, measured as %s"),
    OTHER_TIMES(Kind.STYLE, "the equation of %s is off by %s where a force changes with the clock: its derivatives"
            + " are at other times"),
    CONTRADICTS(Kind.NAME, "this is %s and not %s"),
    NOT_THE_METHOD(Kind.METHOD, "its step is not that of %s"),
    EXPLICIT(Kind.NAME, "it is explicit (evaluations per step: %s): nothing is solved, as in %s"),
    EQUATION(Kind.METHOD, "the equation of %s is off by %s after a step of deltaT = %s s: it is not solved, or"
            + " another one is"),
    NOTHING_EARLIER(Kind.NAME, "%s uses earlier steps; each step of this solver is the one that a new solver makes"),
    NO_CONTROL(Kind.NAME, "where the first particle stands still and another moves, a step of 4 s moves the clock"
            + " to %s times and one of 1/4 s to %s: there is no step-size control"),
    // measured
    NO_CONVERGENCE(Kind.METHOD, "the error does not go to 0 with deltaT%s: it is still %s with deltaT = %s s"),
    LOW_ORDER(Kind.METHOD, "the measured order is %s%s, and that of %s is %s%s"),
    OTHER_ORDER(Kind.METHOD, "the measured order is %s where bodies attract each other, and %s where a force changes"
            + " with the clock"),
    UNCONTROLLED(Kind.METHOD, "sub-steps are made, and the error is still %s after a step of %s s, and %s after %s"
            + " steps over the same time"),
    DRAG(Kind.STYLE, "its order is %s, and %s where the acceleration depends on the velocity, as with drag"),
    // earlier steps, steps back, and other sources
    KEPT(Kind.STATE, "after six steps and reset(), a step of a source of %s particles with deltaT = %s s %s, unlike"
            + " that of a new solver: something of earlier steps is kept"),
    BACK(Kind.STATE, "after a step of %s s and one back the state is off by %s and the clock by %s s, and the step"
            + " alone is off by %s: deltaT is negative in a step back"),
    SWALLOWS(Kind.STATE, "an exception of the source does not reach the caller: do not catch it"),
    NAN(Kind.STATE, "where the derivative is NaN, %s"),
    NOTHING_BACK(Kind.STYLE, "a step of negative deltaT does nothing"),
    ONLY_PARTICLES(Kind.STYLE, "it steps particles, six numbers each, and no source of two numbers: %s");

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
        return new Finding(kind, this, Formula.text(sentence, values));
    }
}
