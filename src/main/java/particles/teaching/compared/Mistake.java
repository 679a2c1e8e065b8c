package particles.teaching.compared;

import static particles.teaching.compared.Changes.each;
import static particles.teaching.compared.Changes.inTurn;

import java.util.function.Function;
import java.util.stream.Stream;
import particles.teaching.declared.Scheme;
import particles.teaching.declared.Step;

/** The typical mistakes: each makes other steps of a known method's. The check compares a student's step with them. */
public enum Mistake {
    NO_DERIVATIVE("no derivative is in it: is the state set? 1/2 and 1/6 are 0 in Java; write 1/2.0",
            s -> Stream.concat(each(s, r -> Stream.of(s.rows()[0])), Stream.of(s.size(), s.size() + 1).map(to ->
            Changes.rows(s, to, (all, r) -> s.rows()[0])))),
    NOT_SET("setState is missing before this getStateDerivative", s -> each(s, r -> r == 0 || r == s.size()
            ? Stream.empty() : Stream.of(s.rows()[r - 1]))),
    GOES_ON("it goes on from the state before and not from s (double[] trial = s makes no copy, s.clone() does)",
            s -> Stream.concat(each(s, r -> r == 0 ? Stream.empty() : Stream.of(Changes.onwards(s, r))), Stream.of(
            s.size(), s.size() + 1).map(to -> Changes.rows(s, to, Changes::onwards)))),
    LEFT_AT_TRIAL("the last trial state is left there: setState with the new state is missing at the end",
            s -> Stream.of(s.with(s.size(), s.rows()[s.size() - 1]))),
    FROZEN("velocities stand still while positions make their step, and the other way round",
            s -> s.particles() ? Stream.empty()         // they do so in a right step of these
                    : Stream.concat(inTurn(s, k -> k / 3 % 2), inTurn(s, k -> 1 - k / 3 % 2))),
    ENTRY_BY_ENTRY("each entry of the state makes its step after the one before, while the others stand still",
            s -> inTurn(s, k -> k)),
    COORDINATE_BY_COORDINATE("x, y and z make their steps one after the other, while the others stand still",
            s -> inTurn(s, k -> k % 3)),
    BODY_BY_BODY("the particles make their steps one after the other, while the others stand still",
            s -> inTurn(s, k -> k / 6)),
    NEW_VELOCITY("the position moves by deltaT times the new velocity", s -> Stream.of(Changes.drifted(s, 1, 0))),
    OLD_VELOCITY("the position moves by deltaT times the old velocity", s -> Stream.of(Changes.drifted(s, 0, 0),
            Changes.drifted(s, 0, 0.5))),
    MEAN_VELOCITY("the position moves by deltaT times the mean of the old and the new velocity",
            s -> Stream.of(Changes.drifted(s, 0.5, 0)));

    private final String label;
    private final Function<Scheme, Stream<? extends Step>> steps;

    Mistake(String label, Function<Scheme, Stream<? extends Step>> steps) {
        this.label = label;
        this.steps = steps;
    }

    @Override
    public String toString() {
        return label;
    }

    /** @return the steps that it makes of a method's */
    public Stream<? extends Step> steps(Scheme method) {
        return steps.apply(method).filter(step -> !(step instanceof Scheme changed) || changed.unlike(method) >= 0);
    }
}
