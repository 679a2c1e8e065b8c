package particles.teaching.solvers;

import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.function.ToDoubleFunction;
import java.util.stream.IntStream;
import particles.teaching.Finding;
import particles.teaching.Formula;

/**
 * The rules of every step with fixed weights, whatever its formula: where the clock ends, that a new state is set, and
 * that it follows deltaT.
 *
 * @param step  a step of deltaT
 * @param twice a step of 2 deltaT
 * @param back  a step of -deltaT, unless the solver refuses it
 * @param wrong receives the mistakes
 */
record StepRules(StepReading step, StepReading twice, Optional<StepReading> back, Consumer<Finding> wrong) {

    /** @return whether the clock can be compared further */
    boolean checkClock() {
        double h = step.h();
        double end = step.end() / h;
        boolean forward = Formula.sameTime(end, 1) && Formula.sameTime(twice.end() / (2 * h), 1);
        if (forward && back.stream().allMatch(reading -> Formula.sameTime(-reading.end() / h, 1))) {
            return true;
        }
        List<Double> moves = step.calls().clockMoves();
        double ahead = step.end() - h;
        if (forward) {
            double clock = back.orElseThrow().end();
            wrong.accept(Phrase.CLOCK_BACK.of(-h, clock, clock == h
                    ? ": the sign of deltaT is lost, and a step back goes forward" : ""));
        } else if (moves.isEmpty()) {
            wrong.accept(Phrase.CLOCK_STILL.of(""));
        } else if (Formula.same(twice.end(), step.end()) && step.end() != 0) {
            wrong.accept(Phrase.CLOCK_FIXED.of(step.end()));
        } else if (Math.abs(ahead) > 1e-3 && Formula.same(twice.end() - 2 * h, ahead)) {
            wrong.accept(Phrase.CLOCK_NEW_TIME.of(step.end(), h, ahead));
        } else if (Formula.same(end, step.moved() / h) && Formula.same(twice.moved() / h, 2 * end)) {
            wrong.accept(Phrase.PARTS.of(end));
        } else if (moves.stream().allMatch(move -> move == h)) {
            wrong.accept(Phrase.CLOCK_OFTEN.of(end, moves.size(), step.evaluations() > 2
                    ? "and all moves together have to make one deltaT" : "once is right"));
            return step.evaluations() <= 2;
        } else {
            wrong.accept(Phrase.CLOCK_PARTS.of(Formula.time(end), String.join(", then ", moves.stream().map(move ->
                    Formula.sum(new double[] {move / h}, List.of("deltaT"))).toList())));
            return true;
        }
        return false;
    }

    /** @return whether the new state can be compared further */
    boolean checkState(Scheme scheme) {
        if (!step.calls().everSet()) {
            wrong.accept(Phrase.NEVER_SET.of());
            return false;
        }
        if (!step.calls().setAfterLast() && !evaluatesTheNewState(scheme)) {
            wrong.accept(scheme.size() > 1 ? Phrase.LEFT_AT_TRIAL.of(
                    scheme.ends().get(scheme.ends().size() - 1).formula()) : Phrase.SET_TOO_EARLY.of());
            return false;
        }
        for (Combination row : scheme.isOfParticles() ? List.<Combination>of() : scheme.stages()) {
            if (!Formula.same(row.weight(0), 1)) {
                wrong.accept(Phrase.KEPT_STAGE.of(row.what(), row.weight(0)));
            }
        }
        for (Combination row : scheme.ends()) {
            double kept = row.weight(0);
            String what = row.what().replaceFirst("the new (.*) is", "$1");
            String letter = row.names().get(0);
            if (!Formula.same(kept, 1)) {
                wrong.accept(Arrays.stream(row.weights()).allMatch(weight -> weight == 0)
                        ? Phrase.LOST_FRACTIONS.of(what) : kept == 0 ? Phrase.LOST.of(what, row.formula(),
                        letter) : (scheme.isOfParticles() ? Phrase.DAMPED : Phrase.KEPT).of(what, kept, letter));
            }
        }
        return true;
    }

    /** A step may end with the derivative at its new state, kept for the next one (FSAL), or for nothing. */
    private boolean evaluatesTheNewState(Scheme scheme) {
        int last = step.evaluations() - 1;
        return last > 0 && !KnownMethods.isStagesOfAny(scheme) && Formula.same(step.clock(last), 1)
                && Formula.same(StepReading.derivatives(step.newVelocity()), step.h());
    }

    /** @return whether the step is made with deltaT, so that its weights can be compared */
    boolean checkDeltaT(Scheme scheme) {
        boolean particles = scheme.isOfParticles();
        IntStream.range(1, particles ? 1 : step.evaluations()).forEach(i -> fault(reading -> StepReading.derivatives(
                reading.positions()[i])).ifPresent(fault -> wrong.accept(Phrase.DELTA_T_IN_STAGE.of(scheme
                .stages().get(i).what(), fault))));
        Optional<String> velocity = fault(reading -> StepReading.derivatives(reading.newVelocity()));
        Optional<String> position = particles ? fault(StepReading::moved) : Optional.empty();
        velocity.or(() -> position).ifPresent(fault -> wrong.accept(Phrase.DELTA_T.of(particles ? velocity.isEmpty()
                ? "position" : "velocity" : "state", fault)));
        return velocity.isEmpty() && position.isEmpty();
    }

    /** The mistake behind the change of a weight when deltaT is doubled and when its sign changes. */
    private Optional<String> fault(ToDoubleFunction<StepReading> weight) {
        double once = weight.applyAsDouble(step);
        double doubled = weight.applyAsDouble(twice);
        double negative = back.map(weight::applyAsDouble).orElse(Double.NaN);
        double ratio = doubled / once;
        if (once == 0 || Formula.same(ratio, 2)) {
            return Optional.of("the sign of deltaT is lost, and a step back goes forward").filter(text -> once != 0
                    && Formula.same(negative, once));
        }
        if (Formula.same(ratio, 1)) {
            return Optional.of(Formula.same(once, 1) || Formula.same(once, 0.5)
                    ? "deltaT is ignored; the derivative has to be multiplied by deltaT"
                    : Formula.same(once, StepReading.START)
                    ? "its length is the time, source.getTime(), and deltaT is ignored"
                    : "a time step of " + Formula.number(once) + " s is hard-coded, and deltaT is ignored");
        }
        boolean part = Formula.same(negative, 2 * (2 * once - doubled) - once);
        return Optional.of(Formula.same(ratio, 0.5)
                ? "the derivative is divided by deltaT; it has to be multiplied by deltaT" : Formula.same(ratio, 4)
                ? "the increment is multiplied by deltaT twice" : "with twice the deltaT it moves "
                + Formula.number(ratio) + " times as far" + (part ? ", as a part of it is not multiplied by deltaT: are"
                + " brackets missing?" : ""));
    }

    /** @return whether it is no combination that follows deltaT, as with a difference quotient of the derivative */
    boolean isNoPower() {
        return IntStream.range(1, step.evaluations()).anyMatch(i -> {
            double once = step.newPosition()[2 + i];
            double ahead = StepReading.derivatives(step.positions()[i]);
            return once != 0 && ahead != 0 && Formula.same(twice.newPosition()[2 + i], 4 * once) && Formula.same(
                    StepReading.derivatives(twice.positions()[i]), ahead);
        });
    }
}
