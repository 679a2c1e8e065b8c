package particles.teaching.solvers;

import java.util.List;
import java.util.Optional;
import java.util.stream.IntStream;
import particles.teaching.Finding;
import particles.teaching.Formula;
import particles.teaching.contract.Phrase;

/**
 * The rules of every step with fixed weights, whatever its formula: that a new state is set, and that it follows
 * deltaT.
 *
 * @param step  a step of deltaT
 * @param twice a step of 2 deltaT
 * @param back  a step of -deltaT, unless the solver refuses it
 */
record StepRules(StepReading step, StepReading twice, Optional<StepReading> back) {

    /** @return the mistake of a new state that is not set */
    Optional<Finding> notSet() {
        Scheme scheme = step.scheme();
        Combination end = scheme.ends().get(0);
        return Phrase.NEVER_SET.when(!step.calls().isSet()).or(() -> (scheme.size() > 1 ? Phrase.LEFT_AT_TRIAL
                : Phrase.SET_TOO_EARLY).when(!step.calls().setAfterLast() && !evaluatesTheNewState(scheme),
                scheme.ends().get(scheme.ends().size() - 1).formula())).or(() -> IntStream.range(1, scheme.size())
                .filter(i -> Combination.same(scheme.rows().get(i), end.weights()) && !Formula.same(end.increment(), 1))
                .mapToObj(i -> Phrase.OLDER_STATE.of(end.formula(), scheme.slope(i))).findFirst());
    }

    /** @return the mistake of a state without the old one, or with a part of it */
    Optional<Finding> oldState() {
        boolean particles = step.scheme().isOfParticles();
        return step.scheme().states().stream().filter(row -> !Formula.same(row.ofOwn(), 1)).findFirst().map(row ->
                Phrase.OLD_STATE.of(row.what(), row.formula(), row.ofOwn(), row.state(), row.ofOwn() == 0
                ? "the old state is lost; add to it with += (and 1/3 of whole numbers is 0 in Java)" : particles
                ? "a factor is damping, which the equation does not have"
                : "the weights of the states in a mean have to add up to 1 (and 1/3 of whole numbers is 0 in Java)"));
    }

    /** A step may end with the derivative at its new state, kept for the next one (FSAL), or for nothing. */
    private boolean evaluatesTheNewState(Scheme scheme) {
        int last = step.evaluations() - 1;
        return last > 0 && KnownMethods.isAny(scheme, 0) == KnownMethods.isAny(scheme, 1)
                && Formula.same(scheme.times()[last], 1)
                && Formula.same(scheme.ends().get(0).increment(), 1);
    }

    /** @return the mistake of a step that is not made with deltaT */
    Optional<Finding> deltaT() {
        List<Combination> rows = step.scheme().states();
        return IntStream.range(0, rows.size()).boxed().flatMap(r -> fault(rows.get(r).moves(), twice.moves(r), back.map(
                reading -> reading.moves(r)).orElse(Double.NaN)).map(text -> Phrase.DELTA_T.of(rows.get(r).what(),
                rows.get(r).formula(), text)).stream()).findFirst();
    }

    /** The mistake behind the change of a weight, in units of deltaT, when deltaT is doubled and its sign changes. */
    private Optional<String> fault(double once, double doubled, double negative) {
        double ratio = doubled / once;
        double seconds = once * step.h();
        if (Formula.same(once, 0) || Formula.same(ratio, 1)) {
            return Optional.empty();
        }
        if (Formula.same(ratio, 0.5)) {
            return Optional.of(Formula.same(seconds, 1) || Formula.same(seconds, 0.5)
                    ? "deltaT is ignored; the derivative has to be multiplied by deltaT"
                    : Formula.same(seconds, StepReading.START)
                    ? "its length is the time, source.getTime(), and deltaT is ignored"
                    : "a time step of " + Formula.number(seconds) + " s is hard-coded, and deltaT is ignored");
        }
        return Optional.of(Formula.same(ratio, 0.25)
                ? "the derivative is divided by deltaT; it has to be multiplied by deltaT" : Formula.same(ratio, 2)
                ? "the increment is multiplied by deltaT twice" : "with twice the deltaT it moves "
                + Formula.number(2 * ratio) + " times as far" + (Formula.same(negative, 4 * doubled - 3 * once)
                ? ", as a part of it is not multiplied by deltaT: are brackets missing?" : ""));
    }
}
