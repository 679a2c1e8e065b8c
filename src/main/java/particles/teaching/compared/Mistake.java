package particles.teaching.compared;

import static particles.teaching.compared.Changes.each;
import static particles.teaching.compared.Changes.inTurn;
import static particles.teaching.compared.Changes.moved;
import static particles.teaching.compared.Changes.multiplied;

import java.util.function.BiFunction;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import particles.teaching.declared.Scheme;
import particles.teaching.declared.Step;

/** The typical mistakes: each makes other steps of a known method's. The check compares a student's step with them. */
public enum Mistake {
    NO_DERIVATIVE("no derivative is in it: is the state set? 1/2 and 1/6 are 0 in Java; write 1/2.0",
            (s, h) -> Changes.increments(s, 0)),
    WEIGHT("a sign or a factor is wrong", (s, h) -> Stream.of(-1.0, 0.0, 0.5, 2.0).flatMap(factor -> multiplied(s,
            factor))),
    NOT_SET("setState is missing before this getStateDerivative", (s, h) -> Stream.concat(each(s, r -> r == 0 || r
            == s.size() ? Stream.empty() : Stream.of(s.rows()[r - 1])), Stream.of(Changes.rows(s, s.size(), (all, r) ->
            s.rows()[0])))),
    GOES_ON("it goes on from the state before and not from s (double[] trial = s makes no copy, s.clone() does)",
            (s, h) -> Stream.concat(each(s, r -> r == 0 ? Stream.empty() : Stream.of(Changes.onwards(s, r))), Stream.of(
            s.size(), s.size() + 1).map(to -> Changes.rows(s, to, Changes::onwards)))),
    ONE_ARRAY("only the last derivative is in it: is one array used for all of them?",
            (s, h) -> each(s, r -> r == 0 ? Stream.empty() : Stream.of(moved(s, r, j -> Math.min(r, s.size()) - 1)))),
    LEFT_AT_TRIAL("the last trial state is left there: setState with the new state is missing at the end",
            (s, h) -> Stream.of(s.with(s.size(), s.rows()[s.size() - 1]))),
    OTHER_SLOPE("another derivative stands in it", (s, h) -> each(s, r -> stages(s, r).flatMap(from -> stages(s, r).map(
            to -> moved(s, r, j -> j == from ? to : j))))),
    CLOCK("incTime has to move the clock there before the evaluation", (s, h) -> Changes.clocks(s)),
    BY_DELTA_T("deltaT is multiplied in twice, or not at all",
            (s, h) -> Stream.of(h, 1 / h).flatMap(factor -> multiplied(s, factor))),
    FROZEN("velocities stand still while positions make their step, and the other way round",
            (s, h) -> Stream.concat(inTurn(s, k -> k / 3 % 2), inTurn(s, k -> 1 - k / 3 % 2))),
    ENTRY_BY_ENTRY("each entry of the state makes its step after the one before, while the others stand still",
            (s, h) -> inTurn(s, k -> k)),
    COORDINATE_BY_COORDINATE("x, y and z make their steps one after the other, while the others stand still",
            (s, h) -> inTurn(s, k -> k % 3)),
    BODY_BY_BODY("the particles make their steps one after the other, while the others stand still",
            (s, h) -> inTurn(s, k -> k / 6)),
    NEW_VELOCITY("the position moves by deltaT times the new velocity", (s, h) -> Stream.of(
            Changes.drifted(s, 1, 0))),
    OLD_VELOCITY("the position moves by deltaT times the old velocity", (s, h) -> Stream.of(
            Changes.drifted(s, 0, 0), Changes.drifted(s, 0, 0.5))),
    MEAN_VELOCITY("the position moves by deltaT times the mean of the old and the new velocity",
            (s, h) -> Stream.of(Changes.drifted(s, 0.5, 0)));

    private static Stream<Integer> stages(Scheme s, int r) {
        return IntStream.range(0, Math.min(r, s.size())).boxed();
    }

    private final String label;
    private final BiFunction<Scheme, Double, Stream<? extends Step>> steps;

    Mistake(String label, BiFunction<Scheme, Double, Stream<? extends Step>> steps) {
        this.label = label;
        this.steps = steps;
    }

    /**
     * @return whether parts of the state make their steps while others stand still, at the cost of any
     * order above 1
     */
    public boolean isInTurn() {
        return this == ENTRY_BY_ENTRY || this == COORDINATE_BY_COORDINATE || this == BODY_BY_BODY || this == FROZEN;
    }

    @Override
    public String toString() {
        return label;
    }

    /**
     * @param deltaT the length of the step (s), which stands in the weights of some
     * @return the steps that it makes of a method's
     */
    public Stream<? extends Step> steps(Scheme method, double deltaT) {
        return steps.apply(method, deltaT).filter(step -> !(step instanceof Scheme changed) || changed.unlike(method)
                >= 0);
    }
}
