package particles.teaching.collection;

import static particles.teaching.solvers.PlantedSolvers.state;

import deSolvers.DESolver;
import deSolvers.DEStateSource;
import deSolvers.problems.PlainSource;
import java.util.Arrays;
import java.util.function.Function;
import java.util.function.Supplier;
import particles.teaching.solvers.PlantedSolvers;
import particles.teaching.solvers.PlantedSolvers.Step;

/** Named changes of a method: most are mistakes that students make, some are habits. */
final class Changes {
    /** What becomes of a state before it is set: of a stage, from 0, or of the new one, -1; null if it is not set. */
    interface Edit {
        double[] of(int stage, double[] old, double[] next);
    }

    private Changes() {
    }

    static void set(DEStateSource source, double[] state) {
        if (state != null) {
            source.setState(state);
        }
    }

    /** The method with its changes, separated by commas. */
    static Supplier<DESolver> solver(Function<Edit, Step> method, String changes) {
        Edit edit = (stage, old, next) -> next;
        for (String change : changes.split(",")) {
            edit = edit(edit, change.strip().split(" "));
        }
        Step step = method.apply(edit);
        for (String change : changes.split(",")) {
            step = changed(step, change.strip().split(" "));
        }
        Step made = step;
        return () -> PlantedSolvers.solver(made);
    }

    private static Edit edit(Edit before, String... words) {
        return switch (words[0]) {
            case "left-in-trials" -> (stage, old, next) -> left(stage >= 0, before.of(stage, old, next), old, words);
            case "left-at-end" -> (stage, old, next) -> left(stage < 0, before.of(stage, old, next), old, words);
            case "trials-not-set" -> (stage, old, next) -> stage >= 0 ? null : before.of(stage, old, next);
            case "end-not-set" -> (stage, old, next) -> stage < 0 ? null : before.of(stage, old, next);
            case "old-state-lost" -> (stage, old, next) -> stage < 0 ? Methods.plus(next, -1, old) : next;
            case "float" -> (stage, old, next) -> Arrays.stream(next).map(x -> (float) x).toArray();
            default -> before;
        };
    }

    /** Entries before the first one and from the last one on, or from so many before the end on, stay. */
    private static double[] left(boolean here, double[] next, double[] old, String... words) {
        int from = Integer.parseInt(words[1]);
        int to = Integer.parseInt(words[2]);
        double[] kept = next.clone();
        for (int i = 0; here && i < kept.length; i++) {
            kept[i] = i < from || i >= (to <= 0 ? kept.length + to : to) ? old[i] : next[i];
        }
        return kept;
    }

    private static Step changed(Step step, String... words) {
        double number = words.length > 1 && !words[0].startsWith("left") ? Double.parseDouble(words[1]) : 0;
        return switch (words[0]) {
            case "clock-still" -> (source, h) -> step.make(new StoppedClock(source), h);
            case "then-clock" -> then(step, (source, h) -> source.incTime(number * h));
            case "then-seconds" -> then(step, (source, h) -> source.incTime(number));
            case "then-new-time" -> then(step, (source, h) -> source.incTime(source.getTime() + h));
            case "then-float-clock" -> then(step, (source, h) -> source.incTime((float) h));
            case "length" -> (source, h) -> step.make(source, number * h);
            case "fixed-length", "state-forward" -> (source, h) -> {
                double end = source.getTime() + h;
                step.make(source, number > 0 ? number : Math.abs(h));
                Methods.clock(source, end);
            };
            case "sign-lost" -> (source, h) -> step.make(source, Math.abs(h));
            case "repeated" -> (source, h) -> {
                for (int i = 0; i < number; i++) {
                    step.make(source, h);
                }
            };
            case "eleventh" -> (source, h) -> {
                double end = source.getTime() + h;
                for (double t = 0; Math.abs(t) < Math.abs(h); t += h / 10) {
                    step.make(source, h / 10);
                }
                Methods.clock(source, end);
            };
            case "parts" -> (source, h) -> {
                for (int i = 0; i < number; i++) {
                    step.make(source, h / number);
                }
            };
            case "forward-only" -> (source, h) -> {
                if (h > 0) {
                    step.make(source, h);
                }
            };
            case "refuses-below" -> (source, h) -> {
                if (h < number) {
                    throw new IllegalArgumentException("deltaT is " + h);
                }
                step.make(source, h);
            };
            case "refuses-NaN" -> (source, h) -> {
                if (Double.isNaN(Arrays.stream(PlantedSolvers.slope(source)).sum())) {
                    throw new IllegalStateException("blow-up");
                }
                step.make(source, h);
            };
            case "swallows" -> (source, h) -> {
                try {
                    step.make(source, h);
                } catch (RuntimeException e) {
                    source.incTime(0);                  // and goes on
                }
            };
            case "damped" -> then(step, (source, h) -> {
                double[] s = state(source);
                for (int i = 3; i < s.length; i += i % 6 == 5 ? 4 : 1) {
                    s[i] *= number;
                }
                source.setState(s);
            });
            default -> step;
        };
    }

    private static Step then(Step step, Step more) {
        return (source, h) -> {
            step.make(source, h);
            more.make(source, h);
        };
    }

    /** A source whose clock shows what it should and stays. */
    private static final class StoppedClock extends PlainSource {
        StoppedClock(DEStateSource source) {
            super(source);
        }

        @Override
        public void incTime(double deltaT) {        // the mistake
        }
    }
}
