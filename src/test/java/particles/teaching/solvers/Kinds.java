package particles.teaching.solvers;

import static particles.teaching.solvers.PlantedSolvers.plus;
import static particles.teaching.solvers.PlantedSolvers.slope;
import static particles.teaching.solvers.PlantedSolvers.slopeAt;
import static particles.teaching.solvers.PlantedSolvers.state;

import deSolvers.DESolver;
import deSolvers.DEStateSource;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.function.IntPredicate;
import java.util.function.IntUnaryOperator;
import java.util.function.Supplier;
import particles.teaching.declared.Step;
import particles.teaching.measured.Phrase;

/** Kinds of solvers as students and public code write them, each with the verdict that a teacher would give. */
final class Kinds {
    private static final double[] STAGES = {0, 0.5, 0.5, 1};
    private static final double[] SIXTHS = {1.0 / 6, 1.0 / 3, 1.0 / 3, 1.0 / 6};

    private Kinds() {
    }

    /**
     * A solver.
     *
     * @param name    what its class is called
     * @param about   what it is
     * @param verdict what is wrong with it; empty for a right one
     * @param maker   makes a new one
     */
    record Kind(String name, String about, Optional<Phrase> verdict, Supplier<DESolver> maker) {
        static Kind right(String name, String about, Step step) {
            return new Kind(name, about, Optional.empty(), step::solver);
        }

        static Kind wrong(String name, String about, Phrase verdict, Step step) {
            return new Kind(name, about, Optional.of(verdict), step::solver);
        }
    }

    /** What may be wrong with sub-steps. */
    private enum Habit {
        KEEPS_REJECTED, LOOKS_AT_ONE, WAITS_FOR_NAN
    }

    /** A step from s. */
    private interface Body {
        void run(DEStateSource source, double h, double[] s);
    }

    private static Step from(Body body) {
        return (source, h) -> body.run(source, h, state(source));
    }

    /** RK4 of some entries, while the others stand still. */
    private static void rk4(DEStateSource source, double h, double[] s, IntPredicate moves, double[] end) {
        double t = source.getTime();
        double[] k = new double[s.length];
        for (int j = 0; j < 4; j++) {
            double[] trial = s.clone();
            for (int i = 0; i < s.length; i++) {
                trial[i] += moves.test(i) ? STAGES[j] * h * k[i] : 0;
            }
            source.incTime(t + STAGES[j] * h - source.getTime());
            k = slopeAt(source, trial);
            for (int i = 0; i < s.length; i++) {
                end[i] += moves.test(i) ? SIXTHS[j] * h * k[i] : 0;
            }
        }
    }

    private static Step inTurn(int groups, IntUnaryOperator group, boolean seen) {
        return from((source, h, s) -> {
            double t = source.getTime();
            double[] end = s.clone();
            for (int g = 0; g < groups; g++) {
                int mine = g;
                source.incTime(t - source.getTime());
                rk4(source, h, seen ? end.clone() : s, i -> group.applyAsInt(i) == mine, end);
            }
            source.setState(end);
        });
    }

    /** Of all positions: x += h v + half h^2 a; of all velocities: v += kick h a. */
    private static double[] move(double[] s, double h, double drift, double[] a, double half, double kick) {
        double[] next = s.clone();
        for (int p = 0; p < s.length; p += 6) {
            for (int i = p; i < p + 3; i++) {
                next[i] += drift * h * s[i + 3] + half * h * h * a[i + 3];
                next[i + 3] += kick * h * a[i + 3];
            }
        }
        return next;
    }

    private static Step verlet(double first, double second, double half) {
        return from((source, h, s) -> {
            double[] a = slope(source);
            double[] next = move(s, h, 1, a, half, first);
            source.incTime(h);
            double[] b = slopeAt(source, next);
            source.setState(move(next, h, 0, b, 0, second));
        });
    }

    /** Adams-Bashforth of order 2 with its weights, that begins with Heun's method; it may forget in reset(). */
    private static final class Adams extends DESolver {
        private final double newer;
        private final double older;
        private final boolean forgets;
        private double[] last;

        Adams(double newer, double older, boolean forgets) {
            this.newer = newer;
            this.older = older;
            this.forgets = forgets;
        }

        @Override
        public void stepState(DEStateSource source, double h) {
            double[] s = state(source);
            double[] f = slope(source);
            source.incTime(h);
            source.setState(last == null ? plus(s, h / 2, f, h / 2, slopeAt(source, plus(s, h, f)))
                    : plus(s, newer * h, f, older * h, last));
            last = f;
        }

        @Override
        public void reset() {
            last = forgets ? null : last;
        }
    }

    /** Verlet with the positions before: 2 x - x before + h^2 a. */
    private static final class Stoermer extends DESolver {
        private final double start;
        private final double half;
        private final boolean atEnd;
        private double[] before;

        /**
         * @param start the weight of v in the positions before the first
         * @param half  that of a
         * @param atEnd whether the velocity is that at the end, and not half a step before
         */
        Stoermer(double start, double half, boolean atEnd) {
            this.start = start;
            this.half = half;
            this.atEnd = atEnd;
        }

        @Override
        public void stepState(DEStateSource source, double h) {
            double[] s = state(source);
            double[] a = slope(source);
            double[] old = before == null ? move(s, -h, start, a, half, 0) : before;
            double[] next = s.clone();
            for (int i = 0; i < s.length; i += i % 6 == 2 ? 4 : 1) {
                next[i] = 2 * s[i] - old[i] + h * h * a[i + 3];
                next[i + 3] = (next[i] - s[i]) / h;
            }
            source.incTime(h);
            double[] b = slopeAt(source, next);
            source.setState(atEnd ? move(next, h, 0, b, 0, 0.5) : next);
            before = s;
        }

        @Override
        public void reset() {
            before = null;
        }
    }

    /** Leapfrog whose velocities stay half a step behind. */
    private static final class Behind extends DESolver {
        private boolean began;

        @Override
        public void stepState(DEStateSource source, double h) {
            double[] kicked = move(state(source), h, 0, slope(source), 0, began ? 1 : 0.5);
            source.setState(move(kicked, h, 1, kicked, 0, 0));
            source.incTime(h);
            began = true;
        }

        @Override
        public void reset() {
            began = false;
        }
    }

    /** Backward Euler by so many rounds of a simple iteration, for an equation with this part of deltaT. */
    private static Step backward(int rounds, double part) {
        return from((source, h, s) -> {
            double[] y = s;
            source.incTime(h);
            for (int round = 0; round < rounds; round++) {
                y = plus(s, part * h, slopeAt(source, y));
            }
            source.setState(y);
        });
    }

    /** y = s + deltaT f by a simple iteration, with f between s and y, and the clock at t + clock deltaT. */
    static Step implicit(double place, double clock) {
        return from((source, h, s) -> {
            double[] y = s;
            source.incTime(clock * h);
            for (int round = 0; round < 60; round++) {
                y = plus(s, h, slopeAt(source, plus(s, place, y, -place, s)));
            }
            source.setState(y);
            source.incTime(h - clock * h);
        });
    }

    /** Heun's method with sub-steps, forwards only. */
    private static Step adaptive(Habit... habits) {
        List<Habit> all = List.of(habits);
        return from((source, deltaT, s) -> {
            double t = source.getTime();
            double end = t + deltaT;
            double h = deltaT;
            double[] now = s;
            while (t < end) {
                h = Math.min(h, end - t);
                source.incTime(t - source.getTime());
                double[] k1 = slopeAt(source, now);
                source.incTime(h);
                double[] next = plus(now, h / 2, k1, h / 2, slopeAt(source, plus(now, h, k1)));
                double error = 0;
                for (int i = 0; i < (all.contains(Habit.LOOKS_AT_ONE) ? 6 : s.length); i++) {
                    error = Math.max(error, Math.abs(next[i] - now[i] - h * k1[i]));
                }
                boolean good = all.contains(Habit.WAITS_FOR_NAN) ? error <= 1e-5 : !(error > 1e-5);
                now = good || all.contains(Habit.KEEPS_REJECTED) ? next : now;
                t = !good ? t : h == end - t ? end : t + h;
                h *= Math.min(4, Math.max(0.2, 0.9 * Math.sqrt(1e-5 / (error + 1e-16))));
            }
            source.setState(now);
            source.incTime(end - source.getTime());
        });
    }

    static List<Kind> right() {
        return List.of(Kind.right("LeapfrogIntegrator", "particles, i += 6", verlet(0.5, 0.5, 0.5)),
                Kind.right("EulerCromer", "particles, i += 6", from((source, h, s) -> {
                    double[] kicked = move(s, h, 0, slope(source), 0, 1);
                    source.setState(move(kicked, h, 1, kicked, 0, 0));
                    source.incTime(h);
                })), Kind.right("RungeKutta4", "by entries", from((source, h, s) -> {
                    double[] end = s.clone();
                    rk4(source, h, s, i -> true, end);
                    source.setState(end);
                })), Kind.right("RK2Solver", "with 0.6", from((source, h, s) -> {
                    double[] k = slope(source);
                    source.incTime(0.6 * h);
                    double[] l = slopeAt(source, plus(s, 0.6 * h, k));
                    source.setState(plus(s, h - h / 1.2, k, h / 1.2, l));
                    source.incTime(0.4 * h);
                })), new Kind("AB2Solver", "if (last == null), reset", Optional.empty(), () -> new Adams(1.5, -0.5,
                        true)),
                new Kind("StoermerVerlet", "positions before", Optional.empty(), () -> new Stoermer(1, 0.5, true)),
                Kind.right("AdaptiveHeun", "nothing backwards", adaptive()),
                Kind.right("MySolver", "as the slides' loop, the clock first", from((source, h, s) -> {
                    source.incTime(h);
                    double[] kicked = move(s, h, 0, slope(source), 0, 1);
                    source.setState(move(kicked, h, 1, kicked, 0, 0));
                })), Kind.right("ImplicitEuler", "the clock last", implicit(1, 0)),
                Kind.right("BackwardEulerSolver", "NaN in stiff springs", backward(40, 1)));
    }

    static List<Kind> wrong() {
        return List.of(Kind.wrong("RK4Solver", "one coordinate after another", Phrase.STEP, inTurn(3, i -> i % 3,
                true)),
                Kind.wrong("Gravity", "one body after another", Phrase.STEP, inTurn(400, i -> i / 6, true)),
                Kind.wrong("RK4Solver", "x and v frozen for each other", Phrase.STEP, inTurn(2, i -> i / 3 % 2, false)),
                Kind.wrong("RK4Solver", "x += v h", Phrase.STEP, from((source, h, s) -> {
                    double[] end = s.clone();
                    rk4(source, h, s, i -> true, end);
                    for (int i = 0; i < s.length; i += i % 6 == 2 ? 4 : 1) {
                        end[i] = s[i] + h * end[i + 3];
                    }
                    source.setState(end);
                })), Kind.wrong("MidpointSolver", "new velocity", Phrase.STEP, from((source, h, s) -> {
                    double[] k = slope(source);
                    source.incTime(h / 2);
                    double[] end = plus(s, h, slopeAt(source, plus(s, h / 2, k)));
                    for (int i = 0; i < s.length; i += i % 6 == 2 ? 4 : 1) {
                        end[i] = s[i] + h * end[i + 3];
                    }
                    source.setState(end);
                    source.incTime(h / 2);
                })), Kind.wrong("RK4Solver", "stage states summed", Phrase.ROW, from((source, h, s) -> {
                    double t = source.getTime();
                    double[] end = new double[s.length];
                    double[] k = slope(source);
                    for (int j = 0; j < 4; j++) {
                        double[] y = plus(s, j == 2 || j == 3 ? h : h / 2, k);
                        end = plus(end, SIXTHS[j], y);
                        source.incTime(t + (j < 2 ? h / 2 : h) - source.getTime());
                        k = slopeAt(source, y);
                    }
                    source.setState(end);
                })), Kind.wrong("VelocityVerlet", "d[i] for d[i+3], with drag", Phrase.UNITS, from((source, h, s) -> {
                    double[] a = slope(source);
                    double[] trial = move(s, h, 1, a, 0.5, 0);
                    for (int i = 3; i < s.length; i += i % 6 == 5 ? 4 : 1) {
                        trial[i] += h * a[i - 3];
                    }
                    source.incTime(h);
                    double[] b = slopeAt(source, trial);
                    double[] end = move(s, h, 1, a, 0.5, 0.5);
                    source.setState(move(end, h, 0, b, 0, 0.5));
                })), Kind.wrong("RK4Solver", "an acceleration added to a position", Phrase.FLIGHT, from((source, h,
                        s) -> {
                    double[] end = s.clone();
                    rk4(source, h, s, i -> true, end);
                    double[] k = slope(source);
                    for (int i = 0; i < s.length; i += i % 6 == 2 ? 4 : 1) {
                        end[i] += h / 6 * (k[i + 3] - k[i]);
                    }
                    source.setState(end);
                })), Kind.wrong("VerletSolver", "one acceleration for both", Phrase.ROW, verlet(1, 0, 0.5)),
                Kind.wrong("VerletSolver", "half missing", Phrase.ROW, verlet(1, 1, 0.5)),
                new Kind("VerletSolver", "velocity half a step behind", Optional.of(Phrase.FALL), Behind::new),
                new Kind("VerletSolver", "begins without v", Optional.of(Phrase.FLIGHT), () -> new Stoermer(0, 0.5,
                        true)),
                new Kind("VerletSolver", "begins without a", Optional.of(Phrase.FALL), () -> new Stoermer(1, 0, true)),
                new Kind("VerletSolver", "(x - x before)/deltaT", Optional.of(Phrase.FALL), () -> new Stoermer(1, 0.5,
                        false)),
                new Kind("AB2Solver", "plus", Optional.of(Phrase.FLIGHT), () -> new Adams(1.5, 0.5, true)),
                new Kind("AB2Solver", "no reset", Optional.of(Phrase.KEPT), () -> new Adams(1.5, -0.5, false)),
                Kind.wrong("BackwardEulerSolver", "half of deltaT", Phrase.FLIGHT, backward(40, 0.5)),
                Kind.wrong("BackwardEulerSolver", "two rounds", Phrase.EXPLICIT, backward(2, 1)),
                Kind.wrong("TrapezoidalMidpoint", "the clock at the end", Phrase.LOW_ORDER, implicit(0.5, 1)),
                Kind.wrong("Fehlberg", "a row that belongs to another time", Phrase.ASTRAY, from((source, h, s) -> {
                    double[] k = slope(source);
                    source.incTime(h / 4);
                    double[] l = slopeAt(source, plus(s, h / 3, k));
                    source.setState(plus(s, -h, k, 2 * h, l));
                    source.incTime(h - h / 4);
                })), Kind.wrong("Mine", "the old state lost", Phrase.ASTRAY, from((source, h, s) -> {
                    double[] k = slope(source);
                    source.incTime(h);
                    source.setState(plus(new double[s.length], h / 2, k, h / 2, slopeAt(source, plus(s, h, k))));
                })),
                Kind.wrong("AdaptiveHeun", "moves the clock though it rejects", Phrase.ASTRAY, from((source, h, s) -> {
                    double[] k = slope(source);
                    source.incTime(h);
                    double[] l = slopeAt(source, plus(s, h, k));
                    source.setState(Math.abs(h * (l[0] - k[0])) < 1e-9 ? plus(s, h / 2, k, h / 2, l) : s);
                })),
                Kind.wrong("AdaptiveHeun", "keeps what it rejects", Phrase.FLIGHT, adaptive(Habit.KEEPS_REJECTED)),
                Kind.wrong("AdaptiveHeun", "error of one particle", Phrase.NO_CONTROL, adaptive(Habit.LOOKS_AT_ONE)),
                Kind.wrong("AdaptiveHeun", "an endless loop at NaN", Phrase.NAN, adaptive(Habit.WAITS_FOR_NAN)),
                Kind.wrong("AdaptiveEuler", "one step size", Phrase.NO_CONTROL, from((source, h, s) -> {
                    source.setState(plus(s, h, slope(source)));
                    source.incTime(h);
                })), Kind.wrong("EulerSolver", "0.01 s", Phrase.FLIGHT, from((source, h, s) -> {
                    source.setState(plus(s, 0.01, slope(source)));
                    source.incTime(h);
                })), Kind.wrong("EulerSolver", "no clock", Phrase.CLOCK, from((source, h, s) ->
                        source.setState(plus(
                        s, h, slope(source))))),
                Kind.wrong("EulerSolver", "never set", Phrase.NEVER_SET, from((source, h, s) -> {
                    slope(source);
                    source.incTime(h);
                })), Kind.wrong("EulerSolver", "float", Phrase.SEVEN_DIGITS, from((source, h, s) -> {
                    double[] end = plus(s, h, slope(source));
                    for (int i = 0; i < s.length; i++) {
                        end[i] = (float) end[i];
                    }
                    source.setState(end);
                    source.incTime(h);
                })), Kind.wrong("EulerSolver", "to n - 1", Phrase.ALIKE, from((source, h, s) -> {
                    double[] end = plus(s, h, slope(source));
                    end[s.length - 1] = s[s.length - 1];
                    source.setState(end);
                    source.incTime(h);
                })), Kind.wrong("EulerSolver", "gravity of its own", Phrase.ADDS, from((source, h, s) -> {
                    double[] end = plus(s, h, slope(source));
                    end[4] -= 9.81 * h;
                    source.setState(end);
                    source.incTime(h);
                })), Kind.wrong("EulerSolver", "a limit of the speed", Phrase.FLIGHT, from((source, h, s) -> {
                    double[] end = plus(s, h, slope(source));
                    for (int i = 3; i < s.length; i += i % 6 == 5 ? 4 : 1) {
                        end[i] = Math.max(-100, Math.min(100, end[i]));
                    }
                    source.setState(end);
                    source.incTime(h);
                })), Kind.wrong("EulerSolver", "the new velocity", Phrase.CONTRADICTS, from((source, h, s) -> {
                    double[] kicked = move(s, h, 0, slope(source), 0, 1);
                    source.setState(move(kicked, h, 1, kicked, 0, 0));
                    source.incTime(h);
                })), Kind.wrong("EulerSolver", "swallows exceptions", Phrase.SWALLOWS, from((source, h, s) -> {
                    try {
                        source.setState(plus(s, h, slope(source)));
                    } catch (IllegalStateException e) {
                        source.setState(s);
                    }
                    source.incTime(h);
                })), new Kind("EulerSolver", "keeps its array", Optional.of(Phrase.KEPT),
                        PlantedSolvers.KeptArray::new),
                new Kind("EulerSolver", "caches the size", Optional.of(Phrase.KEPT),
                        PlantedSolvers.CachedSize::new),
                new Kind("Mine", "a derivative once", Optional.of(Phrase.NO_CONVERGENCE),
                        PlantedSolvers.StaleDerivative::new),
                new Kind("EulerSolver", "keeps the first direction", Optional.of(Phrase.KEPT), () -> {
                    double[] first = {0};
                    return from((source, h, s) -> {
                        first[0] = first[0] == 0 ? h : first[0];
                        source.setState(plus(s, Math.copySign(h, first[0]), slope(source)));
                        source.incTime(h);
                    }).solver();
                }), Kind.wrong("EulerSolver", "NaN taken for 0", Phrase.NAN, from((source, h, s) -> {
                    double[] f = slope(source);
                    Arrays.setAll(f, i -> Double.isNaN(f[i]) ? 0 : f[i]);
                    source.setState(plus(s, h, f));
                    source.incTime(h);
                })), Kind.wrong("EulerSolver", "no clock where nothing moves", Phrase.CLOCK, from((source, h, s) -> {
                    double[] end = plus(s, h, slope(source));
                    source.setState(end);
                    source.incTime(Arrays.equals(s, end) ? 0 : h);
                })), Kind.wrong("Mine", "midpoint, the clock at the end", Phrase.ROW, atOldClock(0.5)),
                Kind.wrong("Mine", "with 0.6, the clock at the end", Phrase.OTHER_TIME, atOldClock(0.6)),
                Kind.wrong("AB2Solver", "a static array", Phrase.NOT_REPEATABLE, inAStaticArray(new double[1][])));
    }

    /** A method of order 2 with a trial step of this part of deltaT, but for the clock. */
    private static Step atOldClock(double part) {
        return from((source, h, s) -> {
            double[] k = slope(source);
            double[] l = slopeAt(source, plus(s, part * h, k));
            source.setState(plus(s, h - h / (2 * part), k, h / (2 * part), l));
            source.incTime(h);
        });
    }

    /** Adams-Bashforth of order 2 that keeps the last derivative there. */
    private static Step inAStaticArray(double[][] last) {
        return from((source, h, s) -> {
            double[] f = slope(source);
            double[] before = last[0] == null || last[0].length != f.length ? f : last[0];
            source.setState(plus(s, 1.5 * h, f, -0.5 * h, before));
            source.incTime(h);
            last[0] = f;
        });
    }
}
