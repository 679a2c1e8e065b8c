package particles.teaching.compared;

import static particles.teaching.compared.Changes.each;
import static particles.teaching.compared.Changes.eachAndAll;
import static particles.teaching.compared.Changes.inTurn;
import static particles.teaching.compared.Changes.moved;
import static particles.teaching.compared.Changes.scaled;

import java.util.Arrays;
import java.util.function.BiFunction;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import particles.teaching.declared.Scheme;
import particles.teaching.declared.Step;

/** The typical mistakes: each makes other steps of a known method's. The check compares a student's step with them. */
public enum Mistake {
    SIGN("the sign is wrong", (s, h) -> eachAndAll(s, -1)),
    DOUBLED("all of it is twice what it should be", (s, h) -> eachAndAll(s, 2)),
    HALVED("all of it is half of what it should be", (s, h) -> eachAndAll(s, 0.5)),
    NO_DERIVATIVE("no derivative is in it: is the state set, and is there 1/2 or 1/6 of whole numbers, 0 in"
            + " Java, for 1/2.0?",
            (s, h) -> eachAndAll(s, 0)),
    WHOLE_NUMBERS("1/2 and 1/6 of whole numbers are 0 in Java, 1/2.0 and 1/6.0 are not", (s, h) -> Stream.of(s.size(),
            s.rows().size()).map(to -> Changes.rows(s, to, r -> Arrays.stream(s.rows().get(r)).map(w -> (int) w)
            .toArray()))),
    NOT_SET("setState is missing before this getStateDerivative", (s, h) -> Stream.concat(each(s, r -> r == 0 || r
            >= s.size() ? Stream.empty() : Stream.of(s.rows().get(r - 1))), Stream.of(Changes.rows(s, s.size(), r ->
            s.rows().get(0))))),
    GOES_ON("it goes on from the state before and not from s (double[] trial = s makes no copy, s.clone() does)",
            (s, h) -> Stream.concat(each(s, r -> r == 0 ? Stream.empty() : Stream.of(Changes.from(s, r, s.rows().get(
            Math.min(r, s.size()) - 1)))), Stream.of(s.size(), s.size() + 1).map(to -> Changes.onAndOn(s, to)))),
    STATES_FOR_SLOPES("states are added up where derivatives are meant", Changes::ofStates),
    ONE_ARRAY("only the last derivative is in it: is one array used for all of them?",
            (s, h) -> each(s, r -> Stream.of(moved(s, r, c -> s.rows().get(r).length - 1)))),
    LEFT_AT_TRIAL("the last trial state is left there: setState with the new state is missing at the end",
            (s, h) -> Stream.of(s.with(s.size(), s.rows().get(s.size() - 1)))),
    OLD_STATE_LOST("the old state is not in it: += is meant", (s, h) -> each(s, r -> r == 0 ? Stream.empty()
            : Stream.of(scaled(s.rows().get(r),
            s.own(r), s.own(r) + 1, 0)))),
    REVERSED("the weights are the other way round", (s, h) -> each(s, r -> Stream.of(moved(s, r, c -> s.rows().get(r)
            .length - 1 - c + s.first())))),
    ALL_ALIKE("all weights are the same", (s, h) -> each(s, r -> Stream.of(Changes.alike(s.rows().get(r),
            s.first())))),
    OTHER_SLOPE("another derivative stands in it", (s, h) -> each(s, r -> Changes.columns(s, r).flatMap(from ->
            Changes.columns(s, r).map(to -> moved(s, r, c -> c == from ? to : c))))),
    WEIGHT("one weight is wrong", (s, h) -> each(s, r -> IntStream.range(s.own(r), s.rows().get(r).length).boxed()
            .flatMap(c -> Stream.of(-1.0, 0.0, 0.5, 2.0).map(factor -> scaled(s.rows().get(r), c, c + 1, factor))))),
    TURN("one kick or drift is wrong", Changes::turns),
    CLOCK_AT_END("the clock has to be moved with incTime before each evaluation, and not only at the end",
            (s, h) -> Stream.of(s.at(new double[s.size()]))),
    CLOCK("the clock is wrong there", Changes::clocks),
    BY_DELTA_T("it is multiplied by deltaT once too often or once too rarely", (s, h) -> Stream.of(h, 1 / h).flatMap(
            factor -> eachAndAll(s, factor))),
    TERM_BY_DELTA_T("a part of it is multiplied by deltaT once too often or once too rarely: are brackets missing?",
            (s, h) -> each(s, r -> IntStream.range(s.own(r) + 1, s.rows().get(r).length).boxed().flatMap(c -> Stream.of(
            h, 1 / h).flatMap(factor -> Stream.of(scaled(s.rows().get(r), c, c + 1, factor), scaled(s.rows().get(r), c,
            99, factor), scaled(s.rows().get(r), s.own(r) + 1, c + 1, factor)))))),
    TERM_DIVIDED("only a part of the sum is divided: brackets are missing", (s, h) -> each(s, r -> {
        double[] row = s.rows().get(r);
        double least = Arrays.stream(row).skip(s.first()).filter(w -> w > 0).min().orElse(1);
        return Stream.of(scaled(row, s.first(), row.length - 1, 1 / least), scaled(row, s.first() + 1, 99, 1 / least));
    })),
    ACCELERATION_FOR_VELOCITY("a position moves by entry i + 3 of the derivative, the acceleration, and not by entry"
            + " i", Changes.split((s, n) -> Stream.of(Changes.part(s, k -> true, k -> k % 6 < 3 ? k + 3 : k)))),
    VELOCITY_FOR_ACCELERATION("a velocity moves by entry i - 3 of the derivative, the velocity, and not by entry i",
            Changes.split((s, n) -> Stream.of(Changes.part(s, k -> true, k -> k % 6 < 3 ? k : k - 3)))),
    FROZEN("velocities stand still while positions make their step, and the other way round",
            Changes.split((s, n) -> Stream.concat(inTurn(s, 2, k -> k / 3 % 2), inTurn(s, 2, k -> 1 - k / 3 % 2)))),
    ENTRY_BY_ENTRY("each entry of the state makes its step after the one before, while the others stand still",
            Changes.split((s, n) -> inTurn(s, n, k -> k))),
    COORDINATE_BY_COORDINATE("x, y and z make their steps one after the other, while the others stand still",
            Changes.split((s, n) -> inTurn(s, 3, k -> k % 3))),
    BODY_BY_BODY("the particles make their steps one after the other, while the others stand still",
            Changes.split((s, n) -> inTurn(s, n / 6, k -> k / 6))),
    NEW_VELOCITY("the position moves by deltaT times the new velocity", Changes.split((s, n) -> Stream.of(
            Changes.drifted(s, 1, 0)))),
    OLD_VELOCITY("the position moves by deltaT times the old velocity", Changes.split((s, n) -> Stream.of(
            Changes.drifted(s, 0, 0), Changes.drifted(s, 0, 0.5)))),
    MEAN_VELOCITY("the position moves by deltaT times the mean of the old and the new velocity",
            Changes.split((s, n) -> Stream.of(Changes.drifted(s, 0.5, 0))));

    private final String label;
    private final BiFunction<Scheme, Double, Stream<Scheme>> schemes;
    private final BiFunction<Step, Integer, Stream<Step>> splits;

    Mistake(String label, BiFunction<Scheme, Double, Stream<Scheme>> schemes) {
        this.label = label;
        this.schemes = schemes;
        splits = (step, n) -> Stream.empty();
    }

    Mistake(String label, Changes.Split splits) {
        this.label = label;
        schemes = (scheme, deltaT) -> Stream.empty();
        this.splits = splits.steps();
    }

    /** @return whether deltaT stands in its weights */
    public boolean isOfDeltaT() {
        return this == BY_DELTA_T || this == TERM_BY_DELTA_T;
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
     * @return the schemes that it makes of a method's
     */
    public Stream<Scheme> schemes(Scheme method, double deltaT) {
        return schemes.apply(method, deltaT).filter(scheme -> scheme.unlike(method) >= 0 || !Arrays.equals(
                scheme.times(), method.times()));
    }

    /**
     * @param n the size of the state
     * @return the steps that it makes of a method's, other than by its weights
     */
    public Stream<Step> steps(Step method, int n) {
        return splits.apply(method, n);
    }
}
