package particles.teaching.contract;

import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Collectors;
import particles.teaching.Finding;
import particles.teaching.Finding.Kind;
import particles.teaching.Formula;

/** The phrase book of the check: the sentences for mistakes and notes, with the kind of each. */
public enum Phrase {
    NOTHING_YET, NOT_FINITE, EXCEPTION, NOT_REPEATABLE, CLOCK_STILL, CLOCK_FIXED, CLOCK_NEW_TIME, CLOCK_BACK,
    CLOCK_ENDS, STAGE_TIMES, TIME_OF_STAGE, REJECTED_CLOCK, STAGE_CLOCKS, NO_DERIVATIVE, ARRAY_LENGTH, NEVER_SET,
    LEFT_AT_TRIAL, SET_TOO_EARLY, OLD_STATE, LEFT_OUT, DIGITS, CUT_OFF, ENTRY_BY_ENTRY, DELTA_T, MISSING, TOO_MANY,
    DIFFERS, CHANGED, PARTS, WEIGHTS_SUM, LOW_ORDER, OTHER_STEPS, CONTRADICTS, EXPLICIT, ROUNDS, OLD_VELOCITY,
    NEW_VELOCITY, NOT_ITERATED, NOTHING_EARLIER, NO_CONTROL, IRREVERSIBLE, NAME_ORDER, EQUATION, EQUATION_TIME,
    LOOSE, STALE, TOO_OLD, ONE_ARRAY, START, UNSTABLE, UNCONTROLLED, LARGEST_ERROR, ABSOLUTE_ERROR, ELSEWHERE,
    STAYS, STAYS_AT_GUESS, OLDER_STATE, MOMENT,
    LAYOUT, ADDS, DRAG, DRAG_DIVERGES, PRINTED, MATRIX, NO_CONVERGENCE, UNUSED, USES_STEPS_BEFORE, KEPT_ARRAY,
    KEPT_DERIVATIVE, KEPT_SOMETHING, OTHER_SOURCE, STATIC, DELTA_T_CHANGES, DELTA_T_KEPT, TURNS_BACK, CLOCK_IGNORED,
    SIZE_FAILS, SIZE_UNLIKE, NOTHING_BACK, STEP_BACK, LOOPS, MOVES_AT_ZERO, NAN_AT_ZERO, SWALLOWS, FOR_PARTICLES,
    REFUSES_BACK, REFUSES_ZERO, LEFT_WITHIN, NAN_UNNOTICED, NAN_UNSAID, NAN_HIDDEN, NAN_ENDS;

    private static final String BOOK = """
            # the class
            unwritten NOTHING_YET: the step does nothing yet: write it, then check again
            state NOT_FINITE: the new state is NaN or infinite although state and derivative are finite: look for \
                0/0, the root of a negative number, a division by something that is 0, or a matrix with a row of \
                zeros
            failure EXCEPTION: stepState ends in an exception: %s
            method NOT_REPEATABLE: two new solvers make different steps from the same place: something is random, or \
                static and shared by all solvers (a static field outlives a step and its solver)
            # the clock
            time CLOCK_STILL: %sthe clock never moves: incTime(deltaT) is missing
            time CLOCK_FIXED: the clock moves by %s s in every step, whatever deltaT is: it is hard-coded; \
                incTime(deltaT) is meant
            time CLOCK_NEW_TIME: the clock moves by %s s in a step of %s s that begins at %s s: incTime takes how \
                far the clock moves, deltaT, and not the new time
            time CLOCK_BACK: with deltaT = %s s the clock moves by %s s: the sign of deltaT is lost, or a part of the \
                move is missing
            time CLOCK_ENDS: %sthe clock ends at %s after a step of deltaT = %s s and has to end at t + deltaT: all \
                moves of the clock in a step together have to make deltaT
            time STAGE_TIMES: %s is evaluated at %s; %s says %s%s
            time TIME_OF_STAGE: %s %s while the clock is at %s; the state there is that of %s: \
                either the state or the clock is wrong
            time STAGE_CLOCKS: the error is %s where a force changes with the clock, with deltaT = %s s, and %s \
                where the same force is read off the state: some evaluations are at another clock than their states, \
                or the derivative with respect to time is missing in a method with a matrix
            time REJECTED_CLOCK: after a sub-step that is rejected the state is put back and the clock is not: the \
                clock may move only when a sub-step is accepted
            # the state
            method NO_DERIVATIVE: getStateDerivative is never called: without the derivative the solver cannot know \
                where to go
            state ARRAY_LENGTH: an array of %s numbers was handed to a source whose state has 24: arrays have to be \
                source.getStateSize() long
            state NEVER_SET: the new state never reaches the source: setState(state) is missing
            state LEFT_AT_TRIAL: the state is left at a trial state, %s, that of the last evaluation: setState with \
                the new state is missing at the end
            state OLDER_STATE: the new state is %s, the one at which %s is evaluated: an older array is set at the \
                end; set the one with the last sum
            state SET_TOO_EARLY: the state is set before the derivative is known, and never to the new state: \
                setState(state) is missing at the end
            state OLD_STATE: %s %s, with %s times %s in it instead of once: %s
            state LEFT_OUT: these entries stay as they were in %s: %s; the loop has to reach all %s, from 0 to \
                source.getStateSize() - 1
            state DIGITS: digits get lost: the new state is off by %s of its size, as in float arithmetic, or as if \
                numbers were rounded to some decimals on the way; all numbers have to be double, and only what is \
                printed may be rounded
            method CUT_OFF: with numbers up to %s the step is not the one that it makes with numbers up to 1: \
                something is cut off, or depends on the size
            state ENTRY_BY_ENTRY: getStateDerivative is called %s times per step, once for each entry: later entries \
                move along the derivative of a state that is half new. All entries have to be computed from one \
                derivative; setState belongs behind the loop
            # deltaT
            method DELTA_T: %s %s, which does not follow deltaT: %s
            # the formula
            method MISSING: %4$s is missing: the calls of getStateDerivative are %1$s, %2$s needs %3$s%5$s
            method TOO_MANY: there is an evaluation too many: the calls of getStateDerivative are %s, %s needs %s
            method DIFFERS: %s %s; %s says %s%s
            method CHANGED: this is nearly %s
            method PARTS: the parts of the step lead to %s, and have to lead to t + deltaT: is the step made \
                once only, and no part of it made once too often? \
                The last sub-step has to be cut to what is left of deltaT; lengths and signs of the other \
                parts have to be those of the book
            method WEIGHTS_SUM: the weights of the new state add up to %s; they have to add up to 1
            method MOMENT: the order is %s; %s: the new state is %s. For that order its weights, \
                each multiplied by its evaluation's (time/deltaT)^%s, have to add up to %s, and they add up to %s: \
                choose the weights with which the results are combined so that they do
            method LOW_ORDER: the order is %s with %s%s: %s %s; compare the coefficients and the weights with those \
                of the book
            method OTHER_STEPS: the measured order is %s, and the coefficients of a step are those of a method of \
                order %s: on other sources, or with another deltaT, it makes another step
            method MATRIX: a matrix solves a linear law in one go, and there the equation of %s is off by %s: the \
                matrix has to be I - deltaT J for backward Euler, I - deltaT/2 J for the trapezoidal rule and the \
                implicit midpoint method, with all of J, in row i the change of entry i of the derivative
            # the name
            name CONTRADICTS: this is %s and not %s, as its name says
            name EXPLICIT: this is %s, which is explicit, and not %s, as its name says: the equation for the new \
                state is not solved; an iteration has to go on until nothing changes
            name NOT_ITERATED: %s, as its name says, has to be solved for; here every evaluation is at the old state, \
                and no round of the iteration changes it: its increment was not added to the state that is set, or \
                1/2 is 0 in Java, as both are whole numbers, and 1/2.0 is meant
            method ROUNDS: the iteration for the new state ends too early, after %s: the equation of %s has to be \
                iterated until nothing changes any more
            name OLD_VELOCITY: the position is updated with the old velocity, which is the Euler method; the slides' \
                simple algorithm takes the new one: first v += a deltaT, then x += v deltaT with that v
            name NEW_VELOCITY: the position is updated with the new velocity; the slide's Euler method takes the old \
                one: all of the state moves along the derivative at its start. What is written is symplectic Euler, \
                the slides' simple algorithm
            name NOTHING_EARLIER: %s, as its name says, uses derivatives or states of earlier steps; each step of \
                this solver is the one that a new solver makes, and nothing of earlier steps is used
            name NO_CONTROL: the name promises step-size control, and all steps are made with one step size: is the \
                error estimate always 0? Is it compared with the tolerance, and the sub-step repeated when it is \
                larger?
            name IRREVERSIBLE: %s, as its name says, goes back the way that it came, and after a step of %s s and one \
                back the state is %s off: the parts of the step have to be the same from both ends
            name NAME_ORDER: the measured order is %s; %s: compare the coefficients with those of \
                the book, and the times of the stages
            # equations and earlier steps
            method EQUATION: the new state solves new = %s; %s is new = %s%s
            time EQUATION_TIME: the derivative at %s is taken at the clock %s; the clock has to \
                stand at %s then
            method LOOSE: the iteration ends too early: with a nonlinear law and deltaT = %s s the equation of the \
                step is off by %s; iterate until the change is below about 1e-10
            state STALE: the derivative is stale: getStateDerivative is called in the first step only, and each step \
                needs the derivative at its own start
            method TOO_OLD: the new state is %s; %s says %s: a derivative is kept too long, or twice. In each step \
                the oldest is dropped, then the others move by one place, the oldest of them first
            method ONE_ARRAY: the new state is %s, with the newest derivative only, as if all of them were one \
                array, which each evaluation writes over: keep a copy of each
            method START: the formula has order %s, and the measured order is %s: the first steps, before there is \
                enough to remember, are not accurate enough. Begin with a method of order %s or more, such as RK4
            # methods that are only measured
            method UNSTABLE: it evaluates the derivative once more for each entry, as methods that solve with a \
                matrix do, and is not stable as they are: a step of %s s multiplies %s by %s. Check the signs in the \
                matrix, such as I - deltaT J, or the function of it, that all of J is used (in row i the change of \
                entry i of the derivative), and the state of each stage
            method UNCONTROLLED: sub-steps are made, and the error is still %s after a step of %s s, and %s after %s \
                steps over the same time: a sub-step with too large an error has to be made again from the state \
                before it, with a shorter length
            method LARGEST_ERROR: two springs swing alike, x of the first particle and z of the last, and after \
                a step of %s s they are %s apart: every loop, also that of a matrix, has to reach \
                all entries, and the error of a sub-step has to be the largest of all entries
            method ABSOLUTE_ERROR: two springs start as mirror images, and after a step of %s s they differ \
                by %s in more than the sign: an error may be negative, and its size counts, Math.abs
            method ELSEWHERE: after a step of %s s the state is that of %s: either the weights add up to %s and not \
                to 1, or a part of the step is missing or made once too often (count sub-steps with an int, as sums \
                of fractions are rounded)
            method STAYS: a step of %s s leaves the state where it was, and a longer one moves it: the number of \
                sub-steps is cut to 0, or what is left after whole sub-steps is not made
            method STAYS_AT_GUESS: a step of %s s leaves the state where it was, and a longer one moves it: the \
                iteration ends at its guess, the old state, as its tolerance is larger than all that the step moves; \
                iterate until the change is below about 1e-10
            state LAYOUT: entry %s of the new state changes with entry %s of the state or of the derivative, and has \
                to change with its own: an index is wrong. The state is (x1, v1, x2, v2, ...), three \
                positions and three velocities for each particle in turn
            state ADDS: where state and derivative are 0, entry %s is %s after a step: something is added that the \
                source does not say. Forces, such as gravity, belong to the source
            method NO_CONVERGENCE: the error does not go to 0 with deltaT: it is still %s with deltaT \
                = %s s. Check that each evaluation is at its own state and time, and that the weights add up to 1
            # memory
            state USES_STEPS_BEFORE: %s and the step afterwards still uses the steps before it. FORGET
            state KEPT_ARRAY: %s and the step afterwards does not start there: an array is kept from the step before. \
                getState has to be called in every step, and the arrays filled anew
            state KEPT_DERIVATIVE: %s and the step afterwards begins with a derivative that was kept from the step \
                before, as none is asked for at the new state. It may be kept only while state and time are what the \
                last step left
            state KEPT_SOMETHING: %s and the step afterwards is not the one that a new solver makes: something is \
                kept from the step before. FORGET
            state OTHER_SOURCE: the solver stepped a source of %s numbers and then one of %s, and %s
            state STATIC: two solvers of this class step in turn, each its own source, and one disturbs the other: \
                something is static, and shared by all of them
            state DELTA_T_CHANGES: deltaT changes from one step to the next, and the step is not the one that a new \
                solver makes with it. FORGET
            state DELTA_T_KEPT: deltaT changes from one step to the next, and the step is not the one that a new \
                solver makes with it: deltaT of an earlier step is kept. It is an argument of each call, and may \
                differ in each
            state TURNS_BACK: after steps forward, a step of negative deltaT is not the one that a new solver makes: \
                a length of sub-steps or a direction that is kept from the step before still has the old sign
            style CLOCK_IGNORED: what is remembered of earlier steps is used although the clock was set from outside: \
                compare source.getTime() as well, since forces may depend on the time
            # every source, every deltaT
            state SIZE_FAILS: with a source of %s numbers, stepState ends in %s: %s
            state SIZE_UNLIKE: with a source of %s numbers, entry %s of a state is %s and entry %s is %s, though \
                they have to be alike: %s
            state NOTHING_BACK: a step of negative deltaT does nothing, and says nothing: step backwards, or throw an \
                exception that says why not
            state STEP_BACK: with deltaT = %s s, a step and one back end %s from the start, and the step alone is off \
                by %s only: the sign of deltaT is lost, so that a step back goes forward, or a loop ends too early \
                for want of Math.abs
            failure LOOPS: %s does not come back, an endless loop: %s
            state MOVES_AT_ZERO: a step of deltaT = 0 moves the state by %s; it has to change nothing
            state NAN_AT_ZERO: a step of deltaT = 0 makes the state NaN or infinite; it has to change nothing. Is \
                something divided by deltaT?
            state SWALLOWS: the source threw an exception, and stepState returned as if nothing had happened: do not \
                catch it, so that the caller learns of it
            state NAN_HIDDEN: this check made the derivative NaN on purpose, and the new state has no NaN: the \
                derivative has to enter the new state whatever it is, or an exception has to say that it is no number
            # style
            style DRAG: its order is %s, and %s where the acceleration depends on the velocity, as with drag: there \
                the velocity in each kick has to be iterated, or predicted to the time of the kick
            style PRINTED: the coefficients are those of %s to eight digits: give them as fractions or \
                formulas, such as 1.0 / 6 or Math.sqrt(0.5), or with sixteen digits
            method DRAG_DIVERGES: where the acceleration depends on the velocity, as with drag, the error does not go \
                to 0 with deltaT (order %s): the state of each evaluation has to have the velocities of its time, \
                not 0, and each round of a kick has to begin with the velocity before it
            style UNUSED: an evaluation of the step enters nothing, and could be left out
            style FOR_PARTICLES: it works on systems of positions and velocities only, such as particles, and refuses \
                others
            style REFUSES_BACK: it refuses a negative deltaT (%s)
            style REFUSES_ZERO: it refuses deltaT = 0 (%s); the built-in solvers change nothing then
            style LEFT_WITHIN: when the source fails within a step, state and time stay where they were then; \
                deSolvers.FixedStepSolver puts them back
            style NAN_UNNOTICED: this check made the derivative NaN on purpose, and the NaN goes unnoticed into the \
                state; deSolvers.FixedStepSolver reports it
            style NAN_ENDS: this check made the derivative NaN on purpose, and the iteration ends early, as \
                comparisons with NaN are false: the new state has no NaN, and nothing is said; \
                deSolvers.FixedStepSolver reports it
            style NAN_UNSAID: this check made the derivative NaN on purpose, and the exception that the solver throws \
                says nothing
            """.replaceAll(" +", " ").replace("FORGET", "What is remembered of earlier steps may be used only while"
            + " source, time, state and deltaT are what the last step left, and has to be forgotten in reset()");
    private static final Map<String, String[]> TEXTS = BOOK.lines().filter(line -> !line.startsWith("#"))
            .map(line -> line.split(" ", 3)).collect(Collectors.toMap(parts -> parts[1], parts -> parts));

    /** @return the finding if something holds */
    public Optional<Finding> when(boolean holds, Object... values) {
        return holds ? Optional.of(of(values)) : Optional.empty();
    }

    /** @return the finding; numbers with a fraction are written as people do */
    public Finding of(Object... values) {
        String[] parts = TEXTS.get(name() + ":");
        return new Finding(Kind.valueOf(parts[0].toUpperCase(Locale.ROOT)), Formula.text(parts[2], values));
    }
}
